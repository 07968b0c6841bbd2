#include <brdf/check/Normalisation.h>
#include <brdf/check/ValueChecks.h>
#include <brdf/sampling/SampledBrdf.h>

#include <algorithm>

namespace brdf {
namespace {

/// Sums and roots cost hundreds of terms a value, in 50 digits above all.
bool isCostly(const Model& model) {
  return model.equation().find("sum(") != std::string::npos || model.equation().find("solve(") != std::string::npos;
}

/// Turning rounds the directions; the lobe magnifies that by its slope.
void tallyTurning(const Model& model, const ParameterCase& parameters, const CheckPairs& set, const std::string& label,
                  Tally& tally) {
  const double c = std::cos(1.234), s = std::sin(1.234);
  const auto turn = [&](const Direction& w) { return Direction{c * w[0] - s * w[1], s * w[0] + c * w[1], w[2]}; };
  DirectionPairBuffer<double> turned;
  for (std::size_t k = 0; k < set.size(); ++k) turned.push(turn(set.wi(k)), turn(set.wo(k)));
  std::vector<double> here(set.size()), there(set.size());
  model.evaluate(set.pairs.view(), parameters.values, here.data());
  model.evaluate(turned.view(), parameters.values, there.data());
  for (std::size_t k = 0; k < set.size(); ++k) {
    const double size = std::max(std::fabs(here[k]), std::fabs(there[k]));
    if (!std::isfinite(size) || !(size > 1e-280)) continue;
    tally.offer(std::fabs(here[k] - there[k]) / size,
                [&] { return label + " " + directionText(set.wi(k), set.wo(k)); });
  }
}

}  // namespace

std::vector<Check> checkCases(const Model& model, const std::vector<ParameterCase>& cases,
                              const CheckOptions& options) {
  const bool costly = isCostly(model);
  const CheckPairs extremes = adversarialPairs(scaled(costly ? 20 : 100, options, 4), options.seed, true);
  const CheckPairs exact = adversarialPairs(scaled(costly ? 1 : 5, options), options.seed + 1, !costly);
  const CheckPairs exactAbove = adversarialPairs(scaled(costly ? 1 : 5, options), options.seed + 2, false);
  const CheckPairs slopes = adversarialPairs(scaled(costly ? 1 : 3, options), options.seed + 3, false);

  Tally finite("finite", 0), negative("non_negative", 0), derivative("derivative", 1);
  const Declaration notReciprocal{"reciprocity", kAnything, "not reciprocal"};
  Tally reciprocity("reciprocity", 1e-12, model.reciprocal() ? nullptr : &notReciprocal);
  Tally normalisation("normalisation", 1e-6, model.declared("normalisation"));
  Tally turning("turning", model.isotropic() ? 1e-9 : kAnything, model.isotropic() ? "" : "anisotropic");
  AccuracyTallies accuracy(model);
  const auto softCount =
      static_cast<std::size_t>(std::count_if(cases.begin(), cases.end(), [](const auto& one) { return one.soft; }));
  SamplerTallies sampler(softCount, model.declared("energy"));

  const auto* const formula = dynamic_cast<const FormulaModel*>(&model);
  std::size_t softSeen = 0, hardSeen = 0;
  for (const ParameterCase& one : cases) {
    const std::string label = parameterText(model, one.values) + " (" + one.name + ")";
    const auto lobe = std::make_shared<const OneLobe>(model, one.values);
    for (std::size_t k = 0; formula && k < formula->distributions().size(); ++k)
      normalisation.offer(std::fabs(distributionIntegral(*formula, k, one.values) - 1),
                          [&] { return formula->distributions()[k] + " of " + label; });
    tallyExtremes(*lobe, extremes, label, finite, negative);
    // At the hard bounds a few cases suffice against 50 digits, which are slow.
    if (one.soft ? !costly || softSeen < 3 : hardSeen++ < (costly ? 1 : 5))
      tallyAgainstExtended(model, one, exact, exactAbove, label, accuracy);
    if (!one.soft) continue;
    if (softSeen++ < (costly ? 1 : 3)) tallyDerivative(model, one, slopes, derivative);
    tallyReciprocity(*lobe, extremes, label, 0, reciprocity);
    if (one.name == "defaults" || cases.size() == 1) tallyTurning(model, one, exact, label, turning);
    tallySampler(model.namesSampler() ? *lobe : *withSampler(lobe), *lobe, label, options, sampler);
  }
  std::vector<Check> checks;
  for (const Tally* tally : {&finite, &negative, &accuracy.wide, &accuracy.narrow, &accuracy.conditioning,
                             &accuracy.parameters, &derivative, &reciprocity, &turning})
    checks.push_back(tally->result());
  for (Check& check : checks) {
    if (check.passed) continue;
    if (check.name == "turning") check.note = "a record says isotropic=\"no\" where turning matters";
    if (check.name == "reciprocity") check.note = "a record says reciprocal=\"no\" where it is meant";
  }
  if (formula && !formula->distributions().empty()) checks.push_back(normalisation.result());
  sampler.into(checks);
  return checks;
}

Audit checkModel(const Model& model, const CheckOptions& options) {
  std::vector<ParameterCase> cases = softCases(model, scaled(2, options), options.seed);
  for (ParameterCase& one : hardCases(model, scaled(4, options), options.seed + 1)) cases.push_back(std::move(one));
  return {model.name(), "model", checkCases(model, cases, options)};
}

}  // namespace brdf
