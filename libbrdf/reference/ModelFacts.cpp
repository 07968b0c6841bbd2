// What a page says of a model beyond its record: what was measured, and what it declares.
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/LobeSum.h>
#include <brdf/models/FormulaModel.h>
#include <brdf/reference/Markdown.h>
#include <brdf/reference/ModelPage.h>
#include <brdf/sampling/DirectionalAlbedo.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace brdf {
namespace {

constexpr std::size_t kFewestPoints = 1 << 11, kMostPoints = 1 << 16;  // of each of the 8 copies
constexpr double kRelativeBound = 2.5e-4;                              // where it is reached, points are not doubled

/// 1, 2 or 5 times a power of ten.
double roundedUp(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * power * (1 + 1e-9)) return step * power;
  return 10 * power;
}

MeasuredAlbedo measured(const Brdf& brdf, double angle) {
  MeasuredAlbedo result{angle, 0, 0};
  for (std::size_t points = kFewestPoints; points <= kMostPoints; points *= 2) {
    const Albedo albedo = directionalAlbedo(brdf, radians(angle), points);
    result.value = albedo.value[0];
    // At least a unit of the fifth decimal: further ones would differ among instruction sets.
    result.bound = roundedUp(std::max(3 * albedo.error[0], 1e-5 * std::max(1.0, result.value)));
    if (result.bound <= kRelativeBound * result.value) break;
  }
  return result;
}

}  // namespace

std::string MeasuredAlbedo::text(const std::string& sign) const {
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(bound) + 1e-9)));
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  std::string text = buffer;
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, bound);
  return text + " " + sign + " " + buffer;
}

std::vector<MeasuredAlbedo> measuredAlbedos(const ModelPointer& model) {
  Lobe lobe{model, {}, {1.0}};
  for (const double value : model->defaults()) lobe.parameters.push_back({value});
  const LobeSum brdf({lobe}, Channels::monochrome());
  return {measured(brdf, 0), measured(brdf, 60)};
}

std::vector<std::string> declaredBreaks(const Model& model) {
  std::vector<std::string> breaks;
  if (!model.reciprocal()) breaks.push_back("Not reciprocal: light and viewer may not change places.");
  if (const auto* formula = dynamic_cast<const FormulaModel*>(&model); formula != nullptr && formula->clamped())
    breaks.push_back("Its formula goes below 0 in places; such values are replaced by 0.");
  for (const Declaration& one : model.declarations()) {
    const std::string within = std::isinf(one.allowed) ? "" : " (" + markdown::number(one.allowed) + " is allowed)";
    const std::string law = one.check == "energy"            ? "May reflect more than it receives"
                            : one.check == "normalisation"   ? "Its distribution is not normalised"
                            : one.check == "double_accuracy" ? "Loses digits in double"
                            : one.check == "float_accuracy"  ? "Loses digits in float"
                                                             : "Near its zeros errors are measured against its peak";
    breaks.push_back(law + within + ": " + one.reason + ".");
  }
  return breaks;
}

std::string citation(const Reference& reference) {
  std::string text = reference.authors;
  if (reference.year != 0) text += (text.empty() ? "" : " ") + std::to_string(reference.year);
  for (const std::string* part : {&reference.title, &reference.venue})
    if (!part->empty()) text += ", " + *part;
  if (!reference.equations.empty()) text += ", eq. " + reference.equations;
  if (!reference.doi.empty()) text += ", doi:" + reference.doi;
  return text;
}

}  // namespace brdf
