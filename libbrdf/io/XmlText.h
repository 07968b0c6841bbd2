#pragma once
// What the readers and writers of material XML share. Internal to libbrdf/io.
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>

#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <string_view>

namespace brdf {

/// The name of the root element of an XML text, empty when there is none; looks past a byte order mark, declarations,
/// DOCTYPE and comments.
std::string_view xmlRootName(std::string_view text);

/// The document's root element. Throws Error::Kind::Format with the byte where the parser stopped.
pugi::xml_node parseXml(pugi::xml_document& document, std::string_view text, const std::string& where);

/// The text as a number; throws Error::Kind::Format naming `what`.
double xmlNumber(std::string_view text, const std::string& what, const std::string& where);

/// The document with two blanks a level.
std::string xmlText(const pugi::xml_document& document);

}  // namespace brdf
