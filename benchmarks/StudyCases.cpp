#include "StudyCases.h"

#include <brdf/base/Text.h>
#include <brdf/fit/Compare.h>
#include <brdf/measured/Format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "../tests/fit/SyntheticTarget.h"

namespace brdf::study {
namespace {

/// HeTorrance takes tens of microseconds a value, EPD a few, where the others take a tenth of one.
std::size_t sampleCount(const Model& model) {
  return model.name() == "HeTorrance" ? 40 : model.name() == "EPD" ? 200 : 2000;
}

double rounded(double value) { return parseNumber(formatNumber(value, 3)).value(); }

/// The request with the parameters that the data determine: those with a standard error in a fit from the truth.
void judgeParameters(Case& one) {
  std::vector<LobeRequest> atTruth = one.lobes;
  for (LobeRequest& request : atTruth) request.start.clear();
  for (const auto& [name, value] : one.truth) atTruth.back().start[name] = value;
  FitOptions options;
  options.scan = false;
  const FitReport report = fit(*one.target, atTruth, options);
  std::erase_if(one.truth, [&](const auto& entry) {
    return std::ranges::none_of(report.parameters, [&](const FittedParameter& fitted) {
      return fitted.lobeIndex + 1 == atTruth.size() && fitted.name == entry.first && fitted.standardError;
    });
  });
}

Case recoveryCase(const ModelPointer& model, int place) {
  LobeRequest request{model, {}, {}, {}};
  const FitProblem problem({request}, place == 1 ? Symmetry::Isotropic : Symmetry::Anisotropic);
  const std::size_t dimension = problem.coordinates().size();
  double phi = 2;
  for (int k = 0; k < 60; ++k) phi = std::pow(1 + phi, 1.0 / static_cast<double>(dimension + 1));

  Case one;
  std::string values;
  for (std::size_t j = 0; j < dimension; ++j) {
    const ShapeCoordinate& coordinate = problem.coordinates()[j];
    const Parameter& parameter = model->parameters()[coordinate.parameters.front().parameter];
    const double place01 = 0.5 + place * std::pow(phi, -static_cast<double>(j + 1));
    const double part = 0.15 + 0.7 * (place01 - std::floor(place01));
    const auto at = [&](double fraction) {
      const double value = coordinate.toValue(std::lerp(coordinate.softLower, coordinate.softUpper, fraction));
      return std::clamp(rounded(value), parameter.minimum, parameter.maximum);
    };
    values += (j == 0 ? "" : ", ") + parameter.name + "=" + formatNumber(at(part), 3);
    one.truth.emplace_back(parameter.name, at(part));
    request.start[parameter.name] = at(part < 0.5 ? 0.95 : 0.05);
  }
  const std::string lobe = model->name() + (values.empty() ? "" : "(" + values + ")");
  one.name = lobe;
  one.label = model->name() + " " + std::to_string(place);
  one.metric = "rms";
  const bool alone = model->name() == "Lambertian";
  const std::string expression = alone ? "0.3*" + lobe : "0.3*Lambertian + 0.7*" + lobe;
  one.target = std::make_shared<ScatteredBrdf>(synthesize(*parseMaterialExpression(expression), sampleCount(*model)),
                                               expression);
  if (!alone) one.lobes.push_back({findModel("Lambertian"), {}, {}, {}});
  one.lobes.push_back(std::move(request));
  one.wantedError = 1e-4 * compare(*parseMaterialExpression("0*Lambertian"), *one.target).zeroModel.at("rms");
  judgeParameters(one);
  for (const auto& [name, value] : one.truth) {
    const auto coordinate = std::ranges::find_if(problem.coordinates(), [&](const ShapeCoordinate& c) {
      return model->parameters()[c.parameters.front().parameter].name == name;
    });
    const double change = 0.01 * (coordinate->softUpper - coordinate->softLower);
    one.tolerance.push_back(coordinate->logarithmic ? value * std::expm1(change) : change);
  }
  return one;
}

}  // namespace

std::vector<Case> referenceCases(const std::filesystem::path& shared) {
  std::ifstream file(shared / "reference/best_fits.json");
  if (!file) return {};
  std::vector<Case> cases;
  const nlohmann::json best = nlohmann::json::parse(file);
  for (const auto& [material, metrics] : best["materials"].items()) {
    const std::filesystem::path path = shared / "data/measured" / (material + ".brdf");
    if (!std::filesystem::exists(path)) return {};
    const BrdfPointer target = selectChannels(readMeasured(path).brdf, {FitChannels::Kind::Luminance, {}});
    for (const auto& [metric, lobes] : metrics.items())
      for (const auto& [lobe, found] : lobes.items()) {
        if (lobe == "zero_model") continue;
        Case one;
        one.name = one.label = material + " " + metric + " " + lobe;
        one.metric = metric;
        one.target = target;
        one.lobes = {{findModel("Lambertian"), {}, {}, {}}, {findModel(lobe), {}, {}, {}}};
        one.wantedError = 1.02 * found["error"].get<double>();
        cases.push_back(std::move(one));
      }
  }
  return cases;
}

std::vector<Case> recoveryCases() {
  std::vector<Case> cases;
  for (const ModelPointer& model : allModels())
    for (int place = 1; place <= 2; ++place) {
      if (place == 2 && model->parameters().empty()) continue;
      cases.push_back(recoveryCase(model, place));
    }
  return cases;
}

bool parametersFound(const Case& one, const std::vector<std::vector<double>>& parameters) {
  const Model& model = *one.lobes.back().model;
  for (std::size_t k = 0; k < one.truth.size(); ++k) {
    const double found = parameters.back()[model.parameterIndex(one.truth[k].first)];
    if (!(std::abs(found - one.truth[k].second) <= one.tolerance[k])) return false;
  }
  return true;
}

}  // namespace brdf::study
