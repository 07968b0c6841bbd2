#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/formula/GlslPrinter.h>
#include <brdf/models/FormulaModel.h>
#include <brdf/models/Model.h>

#include <algorithm>

#include "lobeFiles.h"

namespace brdf {
namespace {

const std::vector<ModelPointer>& registry() {
  static const std::vector<ModelPointer> models = [] {
    std::vector<ModelPointer> result;
    for (const EmbeddedFile& file : lobeFiles())
      result.push_back(std::make_shared<FormulaModel>(file.text, std::string(file.name)));
    std::sort(result.begin(), result.end(),
              [](const ModelPointer& a, const ModelPointer& b) { return a->name() < b->name(); });
    return result;
  }();
  return models;
}

}  // namespace

Model::~Model() = default;

std::size_t Model::parameterIndex(std::string_view name) const {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    if (parameters_[k].name == name) return k;
    names.push_back(parameters_[k].name);
  }
  throw Error(Error::Kind::Value, {"unknown parameter", name_, "'" + std::string(name) + "'",
                                   names.empty() ? "none, " + name_ + " has no parameters" : joined(names)});
}

std::vector<double> Model::defaults() const {
  std::vector<double> values;
  for (const Parameter& parameter : parameters_) values.push_back(parameter.defaultValue);
  return values;
}

void Model::checkBounds(std::size_t parameter, double value) const {
  const Parameter& p = parameters_[parameter];
  if (value >= p.minimum && value <= p.maximum) return;  // false for NaN
  throw Error(Error::Kind::Value, {"parameter out of bounds", name_ + "." + p.name, formatNumber(value),
                                   formatNumber(p.minimum) + " to " + formatNumber(p.maximum)});
}

std::string Model::glslPrelude() { return formula::glslPrelude(); }

std::vector<ModelPointer> allModels() { return registry(); }

ModelPointer findModel(std::string_view name) {
  std::vector<std::string> names;
  for (const ModelPointer& model : registry()) {
    if (model->name() == name) return model;
    names.push_back(model->name());
  }
  const std::string nearest = closestName(name, names);
  throw Error(Error::Kind::Value, {"unknown lobe",
                                   {},
                                   "'" + std::string(name) + "'",
                                   joined(names) + (nearest.empty() ? "" : " (did you mean " + nearest + "?)")});
}

}  // namespace brdf
