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
bool ShapeCoordinate::moves(const LobeParameter& parameter) const {
  return std::ranges::find(parameters, parameter) != parameters.end();
}

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
    std::vector<std::optional<LobeParameter>> elsewhere(count);
    for (const auto& [name, other] : request.tiedElsewhere) {
      const std::size_t p = model.parameterIndex(name);
      if (other.lobe >= lobeIndex || leader[p] != p || lobe.fixed[p])
        throw Error(Error::Kind::Value,
                    {"a parameter can be tied to one of a lobe before it, when it is neither fixed nor "
                     "tied within its lobe",
                     model.name(),
                     name + "=" + other.parameter + " of lobe " + std::to_string(other.lobe + 1),
                     {}});
      elsewhere[p] = LobeParameter{other.lobe, lobes_[other.lobe].model->parameterIndex(other.parameter)};
      lobe.base[p] = lobes_[other.lobe].base[elsewhere[p]->parameter];
      model.checkBounds(p, lobe.base[p]);
      lobe.fixed[p] = lobes_[other.lobe].fixed[elsewhere[p]->parameter];
      for (std::size_t q = 0; q < count; ++q)
        if (leader[q] == p) {
          lobe.base[q] = lobe.base[p];
          lobe.fixed[q] = lobe.fixed[p];
        }
    }
    if (targetSymmetry != Symmetry::Anisotropic)
      for (std::size_t p = 0; p < count; ++p) {
        const Parameter& parameter = model.parameters()[p];
        if (parameter.follows.empty() || leader[p] != p || elsewhere[p] || request.fixed.contains(parameter.name))
          continue;
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

    lobes_.push_back(lobe);
    for (std::size_t p = 0; p < count; ++p) {
      if (lobe.fixed[p] || leader[p] != p) continue;
      std::size_t k = coordinates_.size();
      if (elsewhere[p]) {
        const auto moved = [&](const ShapeCoordinate& coordinate) { return coordinate.moves(*elsewhere[p]); };
        k = static_cast<std::size_t>(std::ranges::find_if(coordinates_, moved) - coordinates_.begin());
      } else {
        const Parameter& parameter = model.parameters()[p];
        ShapeCoordinate coordinate;
        coordinate.lobe = lobeIndex;
        coordinate.logarithmic = parameter.scale == Parameter::Scale::Logarithmic;
        coordinate.lower =
            coordinate.toCoordinate(coordinate.logarithmic ? positiveMinimum(parameter) : parameter.minimum);
        coordinate.upper = coordinate.toCoordinate(parameter.maximum);
        coordinate.softLower =
            coordinate.toCoordinate(std::max(parameter.softMinimum, coordinate.toValue(coordinate.lower)));
        coordinate.softUpper = coordinate.toCoordinate(parameter.softMaximum);
        coordinate.start = coordinate.toCoordinate(std::max(lobe.base[p], coordinate.toValue(coordinate.lower)));
        coordinates_.push_back(std::move(coordinate));
      }
      for (std::size_t q = 0; q < count; ++q)
        if (leader[q] == p) attach(k, {lobeIndex, q});
    }
  }
  for (const ShapeCoordinate& coordinate : coordinates_) {
    lower_.push_back(coordinate.lower);
    upper_.push_back(coordinate.upper);
  }
  addDerivativeColumns();
}

void FitProblem::attach(std::size_t k, const LobeParameter& which) {
  ShapeCoordinate& coordinate = coordinates_[k];
  const Parameter& parameter = model(which.lobe).parameters()[which.parameter];
  coordinate.parameters.push_back(which);
  const double low = coordinate.logarithmic ? std::max(parameter.minimum, 1e-300) : parameter.minimum;
  coordinate.lower = std::max(coordinate.lower, coordinate.toCoordinate(low));
  coordinate.upper = std::min(coordinate.upper, coordinate.toCoordinate(parameter.maximum));
  for (double* inside : {&coordinate.softLower, &coordinate.softUpper, &coordinate.start})
    *inside = std::clamp(*inside, coordinate.lower, coordinate.upper);
}

void FitProblem::addDerivativeColumns() {
  for (std::size_t l = 0; l < lobes_.size(); ++l)
    for (std::size_t k = 0; k < coordinates_.size(); ++k) {
      const std::size_t column = derivativeColumns_.size();
      for (const LobeParameter& moved : coordinates_[k].parameters) {
        if (moved.lobe != l) continue;
        if (derivativeColumns_.size() == column) derivativeColumns_.push_back({k, l});
        lobes_[l].which.push_back(moved.parameter);
        lobes_[l].column.push_back(column);
      }
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
    for (const auto& [l, p] : coordinates_[k].parameters) {
      // exp(log(bound)) may leave the bounds by one rounding.
      const Parameter& parameter = model(l).parameters()[p];
      values[l][p] = std::clamp(coordinates_[k].toValue(x[k]), parameter.minimum, parameter.maximum);
    }
  return values;
}

void FitProblem::evaluate(const DirectionPairs<double>& pairs, const std::vector<std::vector<double>>& parameters,
                          bool derivatives, std::vector<double>& scratch, double* columns) const {
  const std::size_t count = pairs.count;
  if (derivatives) std::fill_n(columns + lobes_.size() * count, derivativeColumns_.size() * count, 0.0);
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
      const ShapeCoordinate& coordinate = coordinates_[derivativeColumns_[lobe.column[k]].coordinate];
      const double slope = coordinate.slope(parameters[l][lobe.which[k]]);
      const double* in = scratch.data() + (k + 1) * count;
      double* out = columns + (lobes_.size() + lobe.column[k]) * count;
      for (std::size_t i = 0; i < count; ++i) out[i] += slope * in[i];
    }
  }
}

}  // namespace brdf
