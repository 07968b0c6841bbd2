#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/models/XmlRecord.h>

#include <algorithm>

namespace brdf {

pugi::xml_node xmlRoot(pugi::xml_document& document, std::string_view text, const std::string& where,
                       std::string_view expectedRoot) {
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result)
    throw Error(Error::Kind::Format,
                {"not well-formed XML", where + ", byte " + std::to_string(result.offset), result.description(), {}});
  const pugi::xml_node root = document.document_element();
  if (root.name() != expectedRoot)
    throw Error(Error::Kind::Format, {"wrong root element", where, "<" + std::string(root.name()) + ">",
                                      "<" + std::string(expectedRoot) + ">"});
  return root;
}

std::string requiredAttribute(const pugi::xml_node& node, const char* name, const std::string& where) {
  const std::string value = node.attribute(name).value();
  if (value.empty())
    throw Error(Error::Kind::Format,
                {"missing attribute '" + std::string(name) + "' of <" + node.name() + ">", where, {}, {}});
  return value;
}

double numberAttribute(const pugi::xml_node& node, const char* name, double otherwise, const std::string& where) {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute) return otherwise;
  const auto value = parseNumber(attribute.value());
  if (!value)
    throw Error(Error::Kind::Format, {"attribute '" + std::string(name) + "' of <" + node.name() + "> is no number",
                                      where,
                                      "'" + std::string(attribute.value()) + "'",
                                      {}});
  return *value;
}

bool flagAttribute(const pugi::xml_node& node, const char* name, bool otherwise, const std::string& where) {
  const std::string_view value = node.attribute(name).value();
  if (value.empty()) return otherwise;
  if (value == "yes") return true;
  if (value == "no") return false;
  throw Error(Error::Kind::Format, {"attribute '" + std::string(name) + "' of <" + node.name() + ">", where,
                                    "'" + std::string(value) + "'", "yes, no"});
}

std::vector<std::string> splitArguments(std::string_view text) {
  std::vector<std::string> arguments;
  if (trimmed(text).empty()) return arguments;
  std::size_t start = 0;
  int depth = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i < text.size() && text[i] == '(') ++depth;
    if (i < text.size() && text[i] == ')') --depth;
    if (i == text.size() || (text[i] == ',' && depth == 0)) {
      arguments.emplace_back(trimmed(text.substr(start, i - start)));
      start = i + 1;
    }
  }
  return arguments;
}

std::vector<Reference> readReferences(const pugi::xml_node& node) {
  std::vector<Reference> references;
  for (const pugi::xml_node child : node.children("reference")) {
    Reference reference;
    reference.authors = child.attribute("authors").value();
    reference.year = child.attribute("year").as_int();
    reference.title = child.attribute("title").value();
    reference.venue = child.attribute("venue").value();
    reference.doi = child.attribute("doi").value();
    reference.equations = child.attribute("equations").value();
    references.push_back(std::move(reference));
  }
  return references;
}

std::vector<Declaration> readDeclarations(const pugi::xml_node& node, const std::string& where) {
  const std::vector<std::string> known{"energy", "normalisation", "double_accuracy", "float_accuracy", "zero_crossing"};
  std::vector<Declaration> declarations;
  for (const pugi::xml_node child : node.children("declares")) {
    Declaration declaration;
    declaration.check = requiredAttribute(child, "check", where);
    const std::string here = where + ", declaration of " + declaration.check;
    if (std::find(known.begin(), known.end(), declaration.check) == known.end())
      throw Error(Error::Kind::Format, {"unknown check", here, "'" + declaration.check + "'", joined(known)});
    if (declaration.check.ends_with("_accuracy")) requiredAttribute(child, "allowed", here);
    declaration.allowed = numberAttribute(child, "allowed", declaration.allowed, here);
    declaration.reason = std::string(trimmed(child.text().get()));
    if (declaration.reason.empty()) throw Error(Error::Kind::Format, {"missing reason", here, {}, {}});
    declarations.push_back(std::move(declaration));
  }
  return declarations;
}

Parameter readParameter(const pugi::xml_node& node, const std::string& where) {
  Parameter parameter;
  parameter.name = requiredAttribute(node, "name", where);
  const std::string here = where + ", parameter " + parameter.name;
  parameter.label = node.attribute("label").as_string(parameter.name.c_str());
  parameter.symbol = node.attribute("symbol").as_string(parameter.name.c_str());
  parameter.unit = node.attribute("unit").as_string("1");
  parameter.description = std::string(trimmed(node.text().get()));
  parameter.follows = node.attribute("follows").value();
  requiredAttribute(node, "default", here);
  requiredAttribute(node, "min", here);
  requiredAttribute(node, "max", here);
  parameter.defaultValue = numberAttribute(node, "default", 0, here);
  parameter.minimum = numberAttribute(node, "min", 0, here);
  parameter.maximum = numberAttribute(node, "max", 1, here);
  parameter.softMinimum = numberAttribute(node, "softMin", parameter.minimum, here);
  parameter.softMaximum = numberAttribute(node, "softMax", parameter.maximum, here);
  const std::string scale = node.attribute("scale").as_string("linear");
  if (scale != "linear" && scale != "log")
    throw Error(Error::Kind::Format, {"unknown scale", here, "'" + scale + "'", "linear, log"});
  parameter.scale = scale == "log" ? Parameter::Scale::Logarithmic : Parameter::Scale::Linear;
  const bool ordered = parameter.minimum <= parameter.softMinimum && parameter.softMinimum <= parameter.softMaximum &&
                       parameter.softMaximum <= parameter.maximum && parameter.minimum <= parameter.defaultValue &&
                       parameter.defaultValue <= parameter.maximum;
  if (!ordered)
    throw Error(Error::Kind::Format,
                {"bounds out of order", here, {}, "min <= softMin <= softMax <= max, min <= default <= max"});
  return parameter;
}

}  // namespace brdf
