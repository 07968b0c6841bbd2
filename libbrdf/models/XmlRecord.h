#pragma once
// Reading of the XML records in models/. Internal to libbrdf/models.
#include <brdf/models/Declaration.h>
#include <brdf/models/Parameter.h>

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// The document's root element; throws Error::Kind::Format with `where`, the byte offset and what the parser found.
pugi::xml_node xmlRoot(pugi::xml_document& document, std::string_view text, const std::string& where,
                       std::string_view expectedRoot);

/// The attribute, which must be there and not be empty.
std::string requiredAttribute(const pugi::xml_node& node, const char* name, const std::string& where);
/// The attribute as a number, or `otherwise` when it is missing; throws when it is there and no number.
double numberAttribute(const pugi::xml_node& node, const char* name, double otherwise, const std::string& where);
/// The attribute as yes or no.
bool flagAttribute(const pugi::xml_node& node, const char* name, bool otherwise, const std::string& where);

/// "a, b" as {"a", "b"}; "" as {}. Commas inside parentheses do not separate.
std::vector<std::string> splitArguments(std::string_view text);

std::vector<Reference> readReferences(const pugi::xml_node& node);
/// The <declares> elements; throws for an unknown check, one without a reason, and an accuracy without `allowed`.
std::vector<Declaration> readDeclarations(const pugi::xml_node& node, const std::string& where);
Parameter readParameter(const pugi::xml_node& node, const std::string& where);

}  // namespace brdf
