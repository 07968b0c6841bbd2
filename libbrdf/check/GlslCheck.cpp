#include <brdf/check/Tally.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// Values below 1e-16 of the peak count as zero: shaders flush exp(-88) to 0 before a large factor can bring it back.
void tallyShader(const char* what, std::span<const float> got, const std::vector<double>& exact,
                 const CheckPairs& pairs, const std::string& label, double relative, Tally& tally) {
  double peak = 0;
  for (const double value : exact)
    if (std::isfinite(value)) peak = std::max(peak, std::fabs(value));
  const double zero = std::max(1e-36, 1e-16 * peak);
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const double value = got[k];
    if (!std::isfinite(exact[k]) || (std::fabs(exact[k]) < zero && std::fabs(value) < 2 * zero)) continue;
    tally.offer(std::fabs(value - exact[k]) / (relative * std::max(std::fabs(exact[k]), zero)),
                [&] { return std::string(what) + " " + label + " " + directionText(pairs.wi(k), pairs.wo(k)); });
  }
}

Tally tallyCases(const Model& model, std::vector<ParameterCase> cases, const GlslRunner& run,
                 const CheckOptions& options, Tally tally) {
  const CheckPairs pairs = adversarialPairs(scaled(80, options, 4), options.seed + 4, false).rounded();
  const DirectionPairBuffer<float> narrow = pairs.narrow();
  for (ParameterCase& one : cases)
    for (std::size_t k = 0; k < one.values.size(); ++k) {
      // As shaders get them, so that rounding a parameter is not held against the formula.
      const Parameter& p = model.parameters()[k];
      const double rounded = static_cast<double>(p.shaderValue(one.values[k]));
      one.values[k] = p.isLogarithmInShaders() ? std::exp(rounded) : rounded;
    }

  // All cases in one run: parameters are columns too.
  std::vector<GlslColumn> columns;
  std::string arguments = "(vec3(ix, iy, iz), vec3(ox, oy, oz)";
  for (std::size_t k = 0; k < model.parameters().size(); ++k) {
    columns.push_back({"p" + std::to_string(k), {}});
    arguments += ", " + columns.back().name;
    for (const ParameterCase& one : cases)
      columns.back().values.insert(columns.back().values.end(), pairs.size(),
                                   model.parameters()[k].shaderValue(one.values[k]));
  }
  arguments += ")";
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const auto& [letter, component] : {std::pair{"i", &narrow.wi[axis]}, std::pair{"o", &narrow.wo[axis]}}) {
      columns.push_back({letter + std::string(1, "xyz"[axis]), {}});
      for (std::size_t k = 0; k < cases.size(); ++k)
        columns.back().values.insert(columns.back().values.end(), component->begin(), component->end());
    }
  const std::string name = "brdf_" + model.name();
  const auto got = run(Model::glslPrelude() + model.glsl(), columns, {name + arguments, name + "_pdf" + arguments});

  const Declaration* const looser = model.declared("float_accuracy");
  const double relative = std::max(1e-4, looser ? looser->allowed : 0);
  std::vector<double> values(pairs.size()), density(pairs.size());
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const std::string label = parameterText(model, cases[k].values);
    model.evaluate(pairs.pairs.view(), cases[k].values, values.data());
    model.pdf(pairs.pairs.view(), cases[k].values, density.data());
    const std::size_t first = k * pairs.size();
    tallyShader("value", std::span(got.at(0)).subspan(first, pairs.size()), values, pairs, label, relative, tally);
    tallyShader("density", std::span(got.at(1)).subspan(first, pairs.size()), density, pairs, label, relative, tally);
  }
  return tally;
}

bool insideSoftBounds(const Model& model, const std::vector<double>& values) {
  for (std::size_t k = 0; k < values.size(); ++k)
    if (values[k] < model.parameters()[k].softMinimum || values[k] > model.parameters()[k].softMaximum) return false;
  return true;
}

}  // namespace

Check checkGlsl(const Model& model, const GlslRunner& run, const CheckOptions& options) {
  std::vector<ParameterCase> cases = softCases(model, scaled(2, options), options.seed);
  // The ends of the soft bounds are where float itself has no four digits left.
  std::erase_if(cases, [](const ParameterCase& one) { return one.name.starts_with("soft m"); });
  return tallyCases(model, std::move(cases), run, options, {"glsl", 1}).result();
}

std::vector<Check> checkGlsl(const LobeSum& material, const GlslRunner& run, const CheckOptions& options) {
  std::vector<Check> checks;
  for (const Lobe& lobe : material.lobes()) {
    const std::vector<ParameterCase> cases = channelCases(lobe, material.channels().count());
    const bool usual =
        std::ranges::all_of(cases, [&](const ParameterCase& one) { return insideSoftBounds(*lobe.model, one.values); });
    Tally tally("lobe " + std::to_string(checks.size() + 1) + ": glsl", usual ? 1 : kAnything,
                usual ? "" : "parameters outside the soft bounds, where float may have no four digits");
    checks.push_back(tallyCases(*lobe.model, cases, run, options, std::move(tally)).result());
  }
  return checks;
}

}  // namespace brdf
