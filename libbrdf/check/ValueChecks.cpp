// Values and derivatives of a model against 50-digit arithmetic.
#include <brdf/check/ValueChecks.h>
#include <brdf/formula/Extended.h>
#include <brdf/models/FormulaModel.h>

#include <algorithm>

namespace brdf {
namespace {

formula::InputLane lane(const Direction& wi, const Direction& wo) { return {wi[0], wi[1], wi[2], wo[0], wo[1], wo[2]}; }

/// The allowed error at one place: relative to the value, more by a unit of the last place for each unit of an
/// exponential's argument, which is ln(peak/value) at most.
double allowedAt(double relative, double perExponent, double truth, double peak, double tiny) {
  return relative + perExponent * std::max(0.0, std::log(peak / std::max(truth, tiny)));
}

template <class T>
void tallyAccuracy(const std::vector<double>& exact, const std::vector<T>& got, const CheckPairs& pairs,
                   const std::string& label, double relative, bool crossesZero, Tally& tally) {
  constexpr bool narrow = sizeof(T) == sizeof(float);
  double peak = 0;
  for (const double value : exact)
    if (std::isfinite(value)) peak = std::max(peak, std::fabs(value));
  // Below, the format has no digits left; float's exponentials underflow before a large factor brings them back.
  const double tiny = narrow ? std::max(1e-30, 1e-16 * peak) : 1e-290;
  const double rounding = crossesZero ? std::numeric_limits<T>::epsilon() * peak : 0;
  for (std::size_t k = 0; k < got.size(); ++k) {
    const double value = got[k], truth = exact[k];
    // Values that are not finite are another check's matter.
    if (!std::isfinite(value) || !std::isfinite(truth)) continue;
    if (std::max(std::fabs(value), std::fabs(truth)) <= tiny) continue;
    const double error = std::max(0.0, std::fabs(value - truth) - rounding) / std::max(std::fabs(truth), tiny);
    const double allowed = allowedAt(relative, narrow ? 1e-6 : 1e-14, std::fabs(truth), peak, tiny);
    tally.offer(error / allowed, [&] { return label + " " + directionText(pairs.wi(k), pairs.wo(k)); });
  }
}

double exactValue(const Model& model, const Direction& wi, const Direction& wo, const std::vector<double>& parameters) {
  if (const auto* formulaModel = dynamic_cast<const FormulaModel*>(&model))
    return formula::evaluateExtended(formulaModel->graph(), {formulaModel->valueNode()}, lane(wi, wo), parameters)[0];
  return model.evaluateExtended(wi, wo, parameters)[0];
}

std::vector<double> exactValues(const Model& model, const CheckPairs& pairs, const std::vector<double>& parameters) {
  std::vector<double> values;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    values.push_back(exactValue(model, pairs.wi(k), pairs.wo(k), parameters));
  return values;
}

/// By a difference where there is a graph; else by the model's own extended derivative.
double exactSlope(const Model& model, const Direction& wi, const Direction& wo, const std::vector<double>& parameters,
                  std::size_t which) {
  if (const auto* formulaModel = dynamic_cast<const FormulaModel*>(&model))
    return formula::differenceExtended(formulaModel->graph(), formulaModel->valueNode(), lane(wi, wo), parameters,
                                       which);
  return model.evaluateExtended(wi, wo, parameters)[which + 1];
}

double allowedBy(const Model& model, const char* check, double usual) {
  const Declaration* const declaration = model.declared(check);
  return declaration ? declaration->allowed : usual;
}

/// A tally of errors as shares of what is allowed, marked where the model declares that.
Tally shareTally(const Model& model, const char* check) {
  if (const Declaration* const declaration = model.declared(check)) {
    const Declaration share{check, 1, declaration->reason};
    return {check, 1, &share};
  }
  return {check, 1};
}

}  // namespace

AccuracyTallies::AccuracyTallies(const Model& model)
    : allowedWide(allowedBy(model, "double_accuracy", 1e-12)),
      allowedNarrow(allowedBy(model, "float_accuracy", 1e-5)),
      crossesZero(model.declared("zero_crossing") != nullptr),
      wide(shareTally(model, "double_accuracy")),
      narrow(shareTally(model, "float_accuracy")),
      conditioning("conditioning", kAnything,
                   "a property of the formula: what rounding the directions to float changes"),
      parameters("parameter_conditioning", kAnything,
                 "a property of the formula: what rounding the parameters to float changes") {}

void tallyAgainstExtended(const Model& model, const ParameterCase& parameters, const CheckPairs& pairs,
                          const CheckPairs& aboveHorizon, const std::string& label, AccuracyTallies& tallies) {
  std::vector<double> wide(pairs.size());
  model.evaluate(pairs.pairs.view(), parameters.values, wide.data());
  tallyAccuracy(exactValues(model, pairs, parameters.values), wide, pairs, label, tallies.allowedWide,
                tallies.crossesZero, tallies.wide);

  const CheckPairs rounded = aboveHorizon.rounded();
  const DirectionPairBuffer<float> narrow = aboveHorizon.narrow();
  std::vector<float> floats(narrow.size());
  model.evaluate(narrow.view(), parameters.values, floats.data());
  const std::vector<double> atRounded = exactValues(model, rounded, parameters.values);
  if (parameters.soft)
    tallyAccuracy(atRounded, floats, rounded, label, tallies.allowedNarrow, tallies.crossesZero, tallies.narrow);

  std::vector<double> roundedParameters;
  for (const double value : parameters.values) roundedParameters.push_back(static_cast<float>(value));
  for (std::size_t k = 0; k < aboveHorizon.size(); ++k) {
    const Direction wi = aboveHorizon.wi(k), wo = aboveHorizon.wo(k);
    const double here = exactValue(model, wi, wo, parameters.values);
    if (!std::isfinite(here) || !(std::fabs(here) > 1e-30)) continue;
    const auto offer = [&](double there, Tally& tally) {
      if (std::isfinite(there))
        tally.offer(std::fabs(there - here) / std::fabs(here), [&] { return label + " " + directionText(wi, wo); });
    };
    offer(atRounded[k], tallies.conditioning);
    if (parameters.soft) offer(exactValue(model, wi, wo, roundedParameters), tallies.parameters);
  }
}

void tallyDerivative(const Model& model, const ParameterCase& parameters, const CheckPairs& pairs, Tally& tally) {
  const std::size_t parameterCount = model.parameters().size(), count = pairs.size();
  if (parameterCount == 0) return;
  // A difference needs both sides, and outside the hard bounds a model promises nothing.
  std::vector<double> values = parameters.values;
  std::vector<std::size_t> which(parameterCount);
  for (std::size_t k = 0; k < parameterCount; ++k) {
    const Parameter& p = model.parameters()[k];
    const double inside = 1e-6 * (p.maximum - p.minimum);
    values[k] = std::min(values[k], p.maximum - inside);
    if (values[k] == p.minimum && p.minimum != 0) values[k] += inside;
    which[k] = k;
  }
  std::vector<double> got((parameterCount + 1) * count);
  model.evaluateWithDerivatives(pairs.pairs.view(), values, which, got.data());
  double peak = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (std::isfinite(got[i])) peak = std::max(peak, std::fabs(got[i]));
  const bool kink = model.declared("zero_crossing") != nullptr;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(got[i]) || (kink && std::fabs(got[i]) < 1e-12 * peak)) continue;
    for (std::size_t k = 0; k < parameterCount; ++k) {
      const double truth = exactSlope(model, pairs.wi(i), pairs.wo(i), values, k);
      const double slope = got[(k + 1) * count + i];
      // Relative to the derivative, with a floor of 1e-9 of value / parameter.
      const double floor = 1e-9 * std::fabs(got[i]) / std::max(std::fabs(values[k]), 1e-3) + 1e-290;
      tally.offer(std::fabs(slope - truth) / (1e-7 * std::fabs(truth) + floor), [&] {
        return "d/d" + model.parameters()[k].name + " " + parameterText(model, values) + " " +
               directionText(pairs.wi(i), pairs.wo(i));
      });
    }
  }
}

}  // namespace brdf
