#pragma once
// Reading of the XML records in models/. Internal to libbrdf/models.
#include <brdf/formula/Parser.h>
#include <brdf/models/Declaration.h>
#include <brdf/models/Parameter.h>

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// The text of a record and the name of its file: where things are, for errors. `text` must outlive it.
class XmlSource {
 public:
  XmlSource(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  const std::string& file() const { return file_; }
  std::string_view text() const { return text_; }
  /// "FILE, line 3, column 5" of a byte of the text.
  std::string at(std::ptrdiff_t byte) const;
  /// The same of an element's name and of an attribute's value; the file alone where they are not from the text.
  std::string at(const pugi::xml_node& node) const;
  std::string at(const pugi::xml_node& node, const char* attribute) const;
  /// Of the first character of an element's text that is no blank, and of an attribute's value.
  formula::Position textStart(const pugi::xml_node& node) const;
  formula::Position valueStart(const pugi::xml_node& node, const char* attribute) const;

 private:
  formula::Position position(std::ptrdiff_t byte) const;

  std::string_view text_;
  std::string file_;
};

/// The document's root element; throws Error::Kind::Format with the place and what the parser found.
pugi::xml_node xmlRoot(pugi::xml_document& document, const XmlSource& source, std::string_view expectedRoot);

/// Throws Error::Kind::Format when the element has an attribute or a child element that is none of these.
void allowOnly(const pugi::xml_node& node, const std::vector<std::string>& attributes,
               const std::vector<std::string>& children, const XmlSource& source);

/// The attribute, which must be there and not be empty.
std::string requiredAttribute(const pugi::xml_node& node, const char* name, const XmlSource& source);
/// The same, a name that formulas and shaders can use: a letter, then letters, digits and '_'.
std::string identifierAttribute(const pugi::xml_node& node, const char* name, const XmlSource& source);
/// The attribute as a number, or `otherwise` when it is missing; throws when it is there and no number.
double numberAttribute(const pugi::xml_node& node, const char* name, double otherwise, const XmlSource& source);
/// The attribute as yes or no.
bool flagAttribute(const pugi::xml_node& node, const char* name, bool otherwise, const XmlSource& source);

/// "a, b" as {"a", "b"}; "" as {}. Commas inside parentheses do not separate.
std::vector<std::string> splitArguments(std::string_view text);

std::vector<Reference> readReferences(const pugi::xml_node& node, const XmlSource& source);
/// The <declares> elements; throws for an unknown check, one without a reason, and an accuracy without `allowed`.
std::vector<Declaration> readDeclarations(const pugi::xml_node& node, const XmlSource& source);
Parameter readParameter(const pugi::xml_node& node, const XmlSource& source);

}  // namespace brdf
