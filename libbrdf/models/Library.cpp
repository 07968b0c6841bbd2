#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/formula/Table.h>
#include <brdf/models/Library.h>
#include <brdf/models/XmlRecord.h>

#include <sstream>

#include "functionFiles.h"
#include "samplerFiles.h"
#include "tableFiles.h"

namespace brdf {
namespace {

std::vector<LibraryFunction> readFunctions() {
  std::vector<LibraryFunction> functions;
  for (const EmbeddedFile& file : functionFiles()) {
    pugi::xml_document document;
    const XmlSource source(file.text, std::string(file.name));
    for (const pugi::xml_node node : xmlRoot(document, source, "functions").children("function")) {
      LibraryFunction entry;
      entry.function.name = requiredAttribute(node, "name", source);
      entry.function.arguments = splitArguments(node.attribute("arguments").value());
      entry.function.body = node.child_value("body");
      entry.function.where = "function " + entry.function.name + " (" + source.file() + ")";
      entry.title = requiredAttribute(node, "title", source);
      entry.references = readReferences(node, source);
      functions.push_back(std::move(entry));
    }
  }
  return functions;
}

/// <table name="" nx="" ny="" x0="" x1="" y0="" y1="">numbers, x fastest</table>
std::shared_ptr<const formula::Table> readTable(const XmlSource& source) {
  pugi::xml_document document;
  const pugi::xml_node node = xmlRoot(document, source, "table");
  auto table = std::make_shared<formula::Table>();
  table->name = requiredAttribute(node, "name", source);
  table->nx = static_cast<std::size_t>(numberAttribute(node, "nx", 2, source));
  table->ny = static_cast<std::size_t>(numberAttribute(node, "ny", 1, source));
  table->x0 = numberAttribute(node, "x0", 0, source);
  table->x1 = numberAttribute(node, "x1", 1, source);
  table->y0 = numberAttribute(node, "y0", 0, source);
  table->y1 = numberAttribute(node, "y1", 1, source);
  std::istringstream numbers(node.child_value("values"));
  for (std::string word; numbers >> word;)
    if (const auto value = parseNumber(word)) table->values.push_back(*value);
  if (table->nx < 2 || table->ny < 1 || table->values.size() != table->nx * table->ny)
    throw Error(Error::Kind::Format, {"wrong number of values", source.at(node), std::to_string(table->values.size()),
                                      std::to_string(table->nx * table->ny)});
  return table;
}

std::vector<Sampler> readSamplers() {
  std::vector<Sampler> samplers;
  for (const EmbeddedFile& file : samplerFiles()) {
    pugi::xml_document document;
    const XmlSource source(file.text, std::string(file.name));
    for (const pugi::xml_node node : xmlRoot(document, source, "samplers").children("sampler")) {
      Sampler sampler;
      sampler.name = requiredAttribute(node, "name", source);
      sampler.arguments = splitArguments(node.attribute("arguments").value());
      sampler.draw = node.child_value("draw");
      sampler.density = node.child_value("density");
      sampler.title = requiredAttribute(node, "title", source);
      sampler.references = readReferences(node, source);
      samplers.push_back(std::move(sampler));
    }
  }
  return samplers;
}

}  // namespace

const std::vector<LibraryFunction>& libraryFunctions() {
  static const std::vector<LibraryFunction> functions = readFunctions();
  return functions;
}

const formula::FunctionTable& functionTable() {
  static const formula::FunctionTable table = [] {
    formula::FunctionTable result;
    for (const LibraryFunction& entry : libraryFunctions()) result.emplace(entry.function.name, entry.function);
    return result;
  }();
  return table;
}

const formula::TableMap& tableMap() {
  static const formula::TableMap tables = [] {
    formula::TableMap result;
    for (const EmbeddedFile& file : tableFiles()) {
      auto table = readTable({file.text, std::string(file.name)});
      result[table->name] = std::move(table);
    }
    return result;
  }();
  return tables;
}

const formula::FunctionTable& legacyFunctionTable() {
  static const formula::FunctionTable table = [] {
    const std::pair<const char*, const char*> bodies[] = {
        {"log", "ln(x) / ln(10)"},
        {"log10", "ln(x) / ln(10)"},
        {"log2", "ln(x) / ln(2)"},
        {"asinh", "x < 0 ? -log1p(-x + x * x / (1 + sqrt(x * x + 1))) : log1p(x + x * x / (1 + sqrt(x * x + 1)))"},
        {"acosh", "ln(x + sqrt((x - 1) * (x + 1)))"},
        {"atanh", "0.5 * log1p(2 * x / (1 - x))"},
        {"sign", "x < 0 ? -1 : (x > 0 ? 1 : 0)"},
        {"rint", "floor(x + 0.5)"}};
    formula::FunctionTable result;
    for (const auto& [name, body] : bodies) result.emplace(name, formula::Function{name, {"x"}, body, {}});
    return result;
  }();
  return table;
}

const std::vector<Sampler>& samplers() {
  static const std::vector<Sampler> all = readSamplers();
  return all;
}

const Sampler& findSampler(std::string_view name, const std::string& where) {
  std::vector<std::string> names;
  for (const Sampler& sampler : samplers()) {
    if (sampler.name == name) return sampler;
    names.push_back(sampler.name);
  }
  throw Error(Error::Kind::Value, {"unknown sampler", where, "'" + std::string(name) + "'", joined(names)});
}

}  // namespace brdf
