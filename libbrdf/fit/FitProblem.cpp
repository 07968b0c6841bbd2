#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/FitProblem.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// A hard lower bound that a logarithm can take: a parameter that may be 0 stops at this part of its soft range.
double positiveMinimum(const Parameter& parameter) {
  return parameter.minimum > 0 ? parameter.minimum : 1e-6 * std::max(parameter.softMinimum, 1e-6);
}

}  // namespace

double ShapeCoordinate::toCoordinate(double value) const { return logarithmic ? std::log(value) : value; }
double ShapeCoordinate::toValue(double x) const { return logarithmic ? std::exp(x) : x; }

FitProblem::FitProblem(const std::vector<LobeRequest>& requests, Symmetry targetSymmetry) {
  if (requests.empty()) throw Error(Error::Kind::Value, {"there is no lobe to fit", "lobes", "none", "at least one"});
  for (const LobeRequest& request : requests) {
    const Model& model = *request.model;
    const std::size_t lobeIndex = lobes_.size(), count = model.parameters().size();
    FitLobe lobe;
    lobe.model = request.model;
    lobe.base = model.defaults();
    lobe.fixed.resize(count);
    const auto set = [&](const std::string& name, double value, bool hold) {
      const bool ownParameter =
          std::ranges::any_of(model.parameters(), [&](const Parameter& p) { return p.name == name; });
      if (hold && name == "scale" && !ownParameter) {
        if (!(value >= 0) || !std::isfinite(value))
          throw Error(Error::Kind::Value,
                      {"scale out of bounds", model.name(), formatNumber(value), "finite and at least 0"});
        lobe.fixedScale = value;
        return;
      }
      const std::size_t parameter = model.parameterIndex(name);
      model.checkBounds(parameter, value);
      lobe.base[parameter] = value;
      if (hold) lobe.fixed[parameter] = true;
    };
    for (const auto& [name, value] : request.start) set(name, value, false);
    for (const auto& [name, value] : request.fixed) set(name, value, true);

    std::vector<std::size_t> leader(count);
    for (std::size_t p = 0; p < count; ++p) leader[p] = p;
    for (const auto& [name, leaderName] : request.tied) {
      const std::size_t follower = model.parameterIndex(name), first = model.parameterIndex(leaderName);
      if (follower == first || leader[first] != first || lobe.fixed[follower])
        throw Error(Error::Kind::Value, {"a parameter cannot be tied to itself, to a tied one, or while it is fixed",
                                         model.name(),
                                         name + "=" + leaderName,
                                         {}});
      if (lobe.fixed[first]) lobe.fixed[follower] = true;
      lobe.base[follower] = lobe.base[first];
      model.checkBounds(follower, lobe.base[follower]);
      leader[follower] = first;
    }
    if (targetSymmetry != Symmetry::Anisotropic)
      for (std::size_t p = 0; p < count; ++p) {
        const Parameter& parameter = model.parameters()[p];
        if (parameter.follows.empty() || leader[p] != p || request.fixed.contains(parameter.name)) continue;
        const std::size_t first = leader[model.parameterIndex(parameter.follows)];
        if (first == p) continue;
        leader[p] = first;
        lobe.base[p] = lobe.base[first];
        model.checkBounds(p, lobe.base[p]);
        if (lobe.fixed[first]) lobe.fixed[p] = true;
        std::string note = parameter.name + " of " + model.name() + " is held equal to " +
                           model.parameters()[first].name + ": the target does not change when it is turned";
        if (std::ranges::find(notes_, note) == notes_.end()) notes_.push_back(std::move(note));
      }

    for (std::size_t p = 0; p < count; ++p) {
      if (lobe.fixed[p] || leader[p] != p) continue;
      const Parameter& parameter = model.parameters()[p];
      ShapeCoordinate coordinate;
      coordinate.lobe = lobeIndex;
      coordinate.logarithmic = parameter.scale == Parameter::Scale::Logarithmic;
      double low = coordinate.logarithmic ? positiveMinimum(parameter) : parameter.minimum, high = parameter.maximum;
      for (std::size_t q = 0; q < count; ++q)
        if (leader[q] == p) {
          coordinate.parameters.push_back(q);
          low = std::max(low, model.parameters()[q].minimum);
          high = std::min(high, model.parameters()[q].maximum);
          lobe.which.push_back(q);
          lobe.coordinate.push_back(coordinates_.size());
        }
      coordinate.lower = coordinate.toCoordinate(low);
      coordinate.upper = coordinate.toCoordinate(high);
      coordinate.softLower = coordinate.toCoordinate(std::clamp(parameter.softMinimum, low, high));
      coordinate.softUpper = coordinate.toCoordinate(std::clamp(parameter.softMaximum, low, high));
      coordinate.start = coordinate.toCoordinate(std::clamp(lobe.base[p], low, high));
      lower_.push_back(coordinate.lower);
      upper_.push_back(coordinate.upper);
      coordinates_.push_back(std::move(coordinate));
    }
    lobes_.push_back(std::move(lobe));
  }
}

std::vector<double> FitProblem::start() const {
  std::vector<double> x;
  for (const ShapeCoordinate& coordinate : coordinates_) x.push_back(coordinate.start);
  return x;
}

SearchBox FitProblem::searchBox(std::span<const double> x) const {
  SearchBox box;
  for (std::size_t k = 0; k < coordinates_.size(); ++k) {
    box.lower.push_back(std::min(coordinates_[k].softLower, x[k]));
    box.upper.push_back(std::max(coordinates_[k].softUpper, x[k]));
  }
  return box;
}

std::vector<std::vector<double>> FitProblem::parameters(std::span<const double> x) const {
  std::vector<std::vector<double>> values;
  for (const FitLobe& lobe : lobes_) values.push_back(lobe.base);
  for (std::size_t k = 0; k < coordinates_.size(); ++k)
    for (const std::size_t p : coordinates_[k].parameters) {
      // exp(log(bound)) may leave the bounds by one rounding.
      const Parameter& parameter = model(coordinates_[k].lobe).parameters()[p];
      values[coordinates_[k].lobe][p] = std::clamp(coordinates_[k].toValue(x[k]), parameter.minimum, parameter.maximum);
    }
  return values;
}

void FitProblem::evaluate(const DirectionPairs<double>& pairs, const std::vector<std::vector<double>>& parameters,
                          bool derivatives, std::vector<double>& scratch, double* columns) const {
  const std::size_t count = pairs.count;
  if (derivatives) std::fill_n(columns + lobes_.size() * count, coordinates_.size() * count, 0.0);
  for (std::size_t l = 0; l < lobes_.size(); ++l) {
    const FitLobe& lobe = lobes_[l];
    if (!derivatives || lobe.which.empty()) {
      lobe.model->evaluate(pairs, parameters[l], columns + l * count);
      continue;
    }
    scratch.resize((lobe.which.size() + 1) * count);
    lobe.model->evaluateWithDerivatives(pairs, parameters[l], lobe.which, scratch.data());
    std::copy_n(scratch.data(), count, columns + l * count);
    for (std::size_t k = 0; k < lobe.which.size(); ++k) {
      const double slope = coordinates_[lobe.coordinate[k]].slope(parameters[l][lobe.which[k]]);
      const double* in = scratch.data() + (k + 1) * count;
      double* out = columns + (lobes_.size() + lobe.coordinate[k]) * count;
      for (std::size_t i = 0; i < count; ++i) out[i] += slope * in[i];
    }
  }
}

}  // namespace brdf
