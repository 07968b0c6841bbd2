#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/models/XmlRecord.h>

#include <algorithm>
#include <cmath>

namespace brdf {

namespace {

/// Where an attribute's value begins in the parsed text, whose strings lie in one buffer; -1 where it is not from
/// there.
std::ptrdiff_t valueByte(const pugi::xml_node& node, const char* name) {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute || node.offset_debug() < 0) return -1;
  return attribute.value() - (node.name() - node.offset_debug());
}

std::string listed(const std::vector<std::string>& names, const std::string& found) {
  const std::string nearest = closestName(found, names);
  return joined(names) + (nearest.empty() ? "" : " (did you mean " + nearest + "?)");
}

}  // namespace

formula::Position XmlSource::position(std::ptrdiff_t byte) const {
  formula::Position position;
  for (const char c : text_.substr(0, static_cast<std::size_t>(std::max<std::ptrdiff_t>(byte, 0)))) {
    ++position.column;
    if (c == '\n') position = {position.line + 1, 1};
  }
  return position;
}

std::string XmlSource::at(std::ptrdiff_t byte) const {
  if (byte < 0) return file_;
  const formula::Position place = position(byte);
  return file_ + ", line " + std::to_string(place.line) + ", column " + std::to_string(place.column);
}

std::string XmlSource::at(const pugi::xml_node& node) const { return at(node.offset_debug()); }

std::string XmlSource::at(const pugi::xml_node& node, const char* attribute) const {
  const std::ptrdiff_t byte = valueByte(node, attribute);
  return byte < 0 ? at(node) : at(byte);
}

formula::Position XmlSource::textStart(const pugi::xml_node& node) const {
  for (const pugi::xml_node child : node.children())
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
      const std::size_t from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(child.offset_debug(), 0));
      return position(static_cast<std::ptrdiff_t>(std::min(text_.find_first_not_of(" \t\r\n", from), text_.size())));
    }
  return {};
}

formula::Position XmlSource::valueStart(const pugi::xml_node& node, const char* attribute) const {
  return position(valueByte(node, attribute));
}

pugi::xml_node xmlRoot(pugi::xml_document& document, const XmlSource& source, std::string_view expectedRoot) {
  const pugi::xml_parse_result result = document.load_buffer(source.text().data(), source.text().size());
  if (!result)
    throw Error(Error::Kind::Format, {"not well-formed XML", source.at(result.offset), result.description(), {}});
  const pugi::xml_node root = document.document_element();
  if (root.name() != expectedRoot)
    throw Error(Error::Kind::Format, {"wrong root element", source.at(root), "<" + std::string(root.name()) + ">",
                                      "<" + std::string(expectedRoot) + ">"});
  return root;
}

void allowOnly(const pugi::xml_node& node, const std::vector<std::string>& attributes,
               const std::vector<std::string>& children, const XmlSource& source) {
  for (const pugi::xml_attribute attribute : node.attributes())
    if (const std::string name = attribute.name(); std::ranges::find(attributes, name) == attributes.end())
      throw Error(Error::Kind::Format, {"unknown attribute of <" + std::string(node.name()) + ">",
                                        source.at(node, attribute.name()), "'" + name + "'", listed(attributes, name)});
  for (const pugi::xml_node child : node.children())
    if (const std::string name = child.name();
        child.type() == pugi::node_element && std::ranges::find(children, name) == children.end())
      throw Error(Error::Kind::Format, {"unknown element in <" + std::string(node.name()) + ">", source.at(child),
                                        "<" + name + ">", children.empty() ? "text" : listed(children, name)});
}

std::string requiredAttribute(const pugi::xml_node& node, const char* name, const XmlSource& source) {
  const std::string value = node.attribute(name).value();
  if (value.empty())
    throw Error(Error::Kind::Format,
                {"missing attribute '" + std::string(name) + "' of <" + node.name() + ">", source.at(node), {}, {}});
  return value;
}

std::string identifierAttribute(const pugi::xml_node& node, const char* name, const XmlSource& source) {
  const std::string value = requiredAttribute(node, name, source);
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (!letter(value[0]) ||
      !std::ranges::all_of(value, [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; }))
    throw Error(Error::Kind::Format,
                {"attribute '" + std::string(name) + "' of <" + node.name() + "> is no identifier",
                 source.at(node, name), "'" + value + "'", "a letter, then letters, digits and '_'"});
  return value;
}

double numberAttribute(const pugi::xml_node& node, const char* name, double otherwise, const XmlSource& source) {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute) return otherwise;
  const auto value = parseNumber(attribute.value());
  if (!value)
    throw Error(Error::Kind::Format, {"attribute '" + std::string(name) + "' of <" + node.name() + "> is no number",
                                      source.at(node, name),
                                      "'" + std::string(attribute.value()) + "'",
                                      {}});
  return *value;
}

bool flagAttribute(const pugi::xml_node& node, const char* name, bool otherwise, const XmlSource& source) {
  const std::string_view value = node.attribute(name).value();
  if (value.empty()) return otherwise;
  if (value == "yes") return true;
  if (value == "no") return false;
  throw Error(Error::Kind::Format, {"attribute '" + std::string(name) + "' of <" + node.name() + ">",
                                    source.at(node, name), "'" + std::string(value) + "'", "yes, no"});
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

std::vector<Reference> readReferences(const pugi::xml_node& node, const XmlSource& source) {
  std::vector<Reference> references;
  for (const pugi::xml_node child : node.children("reference")) {
    allowOnly(child, {"authors", "year", "title", "venue", "doi", "equations"}, {}, source);
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

std::vector<Declaration> readDeclarations(const pugi::xml_node& node, const XmlSource& source) {
  const std::vector<std::string> known{"energy", "normalisation", "double_accuracy", "float_accuracy", "zero_crossing"};
  std::vector<Declaration> declarations;
  for (const pugi::xml_node child : node.children("declares")) {
    allowOnly(child, {"check", "allowed"}, {}, source);
    Declaration declaration;
    declaration.check = requiredAttribute(child, "check", source);
    if (std::ranges::find(known, declaration.check) == known.end())
      throw Error(Error::Kind::Format, {"unknown check", source.at(child, "check"), "'" + declaration.check + "'",
                                        listed(known, declaration.check)});
    if (declaration.check.ends_with("_accuracy")) requiredAttribute(child, "allowed", source);
    declaration.allowed = numberAttribute(child, "allowed", declaration.allowed, source);
    declaration.reason = std::string(trimmed(child.text().get()));
    if (declaration.reason.empty())
      throw Error(Error::Kind::Format, {"missing reason in <declares>", source.at(child), {}, "text"});
    declarations.push_back(std::move(declaration));
  }
  return declarations;
}

Parameter readParameter(const pugi::xml_node& node, const XmlSource& source) {
  allowOnly(node,
            {"name", "label", "symbol", "unit", "default", "min", "max", "softMin", "softMax", "scale", "follows"}, {},
            source);
  Parameter parameter;
  parameter.name = identifierAttribute(node, "name", source);
  const auto fail = [&](const char* what, const char* attribute, const std::string& found, const char* allowed) {
    throw Error(Error::Kind::Format,
                {"parameter " + parameter.name + ": " + what, source.at(node, attribute), found, allowed});
  };
  parameter.label = node.attribute("label").as_string(parameter.name.c_str());
  parameter.symbol = node.attribute("symbol").as_string(parameter.name.c_str());
  parameter.unit = node.attribute("unit").as_string("1");
  parameter.description = std::string(trimmed(node.text().get()));
  parameter.follows = node.attribute("follows").value();
  for (const char* name : {"default", "min", "max"}) requiredAttribute(node, name, source);
  parameter.defaultValue = numberAttribute(node, "default", 0, source);
  parameter.minimum = numberAttribute(node, "min", 0, source);
  parameter.maximum = numberAttribute(node, "max", 1, source);
  parameter.softMinimum = numberAttribute(node, "softMin", parameter.minimum, source);
  parameter.softMaximum = numberAttribute(node, "softMax", parameter.maximum, source);
  const std::string scale = node.attribute("scale").as_string("linear");
  if (scale != "linear" && scale != "log") fail("unknown scale", "scale", "'" + scale + "'", "linear, log");
  parameter.scale = scale == "log" ? Parameter::Scale::Logarithmic : Parameter::Scale::Linear;
  for (const char* name : {"min", "max"})
    if (!std::isfinite(numberAttribute(node, name, 0, source)))
      fail("hard bound", name, "'" + std::string(node.attribute(name).value()) + "'", "a finite number");
  const bool ordered = parameter.minimum <= parameter.softMinimum && parameter.softMinimum <= parameter.softMaximum &&
                       parameter.softMaximum <= parameter.maximum && parameter.minimum <= parameter.defaultValue &&
                       parameter.defaultValue <= parameter.maximum;
  if (!ordered) fail("bounds out of order", "default", {}, "min <= softMin <= softMax <= max, min <= default <= max");
  if (scale == "log" && (parameter.minimum < 0 || parameter.softMinimum <= 0))
    fail("bounds", "scale",
         "scale log with min " + formatNumber(parameter.minimum) + ", softMin " + formatNumber(parameter.softMinimum),
         "min from 0, softMin above 0");
  return parameter;
}

}  // namespace brdf
