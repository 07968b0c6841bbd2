#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/formula/GlslPrinter.h>
#include <brdf/models/Model.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {

bool Parameter::isLogarithmInShaders() const {
  using Limits = std::numeric_limits<float>;
  return scale == Scale::Logarithmic && minimum > 0 && (maximum > Limits::max() || minimum < Limits::min());
}

float Parameter::shaderValue(double value) const {
  return static_cast<float>(isLogarithmInShaders() ? std::log(value) : value);
}
Model::~Model() = default;

const Declaration* Model::declared(std::string_view check) const {
  const auto found = std::find_if(declarations_.begin(), declarations_.end(),
                                  [&](const Declaration& declaration) { return declaration.check == check; });
  return found == declarations_.end() ? nullptr : &*found;
}

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

}  // namespace brdf
