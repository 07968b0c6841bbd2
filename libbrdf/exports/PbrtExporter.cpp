#include <brdf/base/Text.h>
#include <brdf/exports/Approximation.h>
#include <brdf/exports/BuiltInExporters.h>

#include <algorithm>

namespace brdf {
namespace {

/// pbrt's TrowbridgeReitzDistribution takes a lobe as a mirror when both alphas are below this.
constexpr double kSmooth = 1e-3;

bool isDielectric(const std::string& name) { return name == "GGX" || name == "Microfacet_GGX_Dielectric_Smith"; }
bool isConductor(const std::string& name) { return name == "GGXConductor" || name == "Microfacet_GGX_Conductor_Smith"; }

std::string refusal(const LobeSum& material) {
  double sum = 0;
  for (const Lobe& lobe : material.lobes()) {
    const std::string& name = lobe.model->name();
    sum += largestScale(lobe);
    if (name == "Lambertian") continue;
    if (!isDielectric(name) && !isConductor(name)) return "pbrt has no material for " + name;
    std::vector<std::string_view> colours;
    if (isConductor(name)) colours = {"eta", "k"};
    if (const std::string reason = differsBetweenChannels(lobe, colours); !reason.empty()) return reason;
    if (!sameInAllChannels(lobe.scale)) return "pbrt cannot colour " + name + " by a factor";
    if (std::max(parameterOf(lobe, "alpha"), parameterOf(lobe, "alpha_y")) < kSmooth)
      return "pbrt takes alpha below 0.001 as a mirror";
  }
  if (sum > 1 + 1e-12)
    return "pbrt adds materials by mixing, whose weights cannot exceed 1 in all: the factors sum to " +
           formatNumber(sum, 4);
  return {};
}

std::string roughness(const Lobe& lobe) {
  return "    \"float uroughness\" [ " + formatNumber(parameterOf(lobe, "alpha")) + " ] \"float vroughness\" [ " +
         formatNumber(parameterOf(lobe, "alpha_y")) + " ] \"bool remaproughness\" [ false ]\n";
}

/// The parameters of a lobe's material. `weight` is its share of the mix.
std::string definition(const Lobe& lobe, double weight) {
  const std::string& name = lobe.model->name();
  if (name == "Lambertian") {
    std::array<double, 3> reflectance = colourOf(lobe.scale);
    for (double& r : reflectance) r = weight > 0 ? std::min(r / weight, 1.0) : 0;
    return "\"diffuse\"\n    \"rgb reflectance\" [ " + colourText(reflectance) + " ]\n";
  }
  // Over black, a coated diffuse material is its coat alone.
  if (isDielectric(name))
    return "\"coateddiffuse\"\n    \"rgb reflectance\" [ 0 0 0 ] \"float eta\" [ " +
           formatNumber(parameterOf(lobe, "ior")) + " ]\n" + roughness(lobe);
  std::string text = "\"conductor\"\n";
  for (const char* index : {"eta", "k"})
    text += std::string("    \"rgb ") + index + "\" [ " +
            colourText(colourOf(lobe.parameters[lobe.model->parameterIndex(index)])) + " ]\n";
  return text + roughness(lobe);
}

/// `definition` of a material is what stands between MakeNamedMaterial's name and its parameters.
std::string named(const std::string& name, const std::string& definition) {
  return "MakeNamedMaterial \"" + name + "\"\n    \"string type\" " + definition;
}

std::string write(const LobeSum& material, const ExportText& text) {
  std::string out;
  for (const std::string& line : text.comments) out += "# " + line + "\n";
  // Each highlight has its factor as weight; the diffuse lobes share the rest.
  struct Part {
    std::string definition;
    double weight;
  };
  std::vector<Part> parts;
  double diffuseNeed = 0, others = 0;
  for (const Lobe& lobe : material.lobes())
    (lobe.model->name() == "Lambertian" ? diffuseNeed : others) += largestScale(lobe);
  for (const Lobe& lobe : material.lobes()) {
    if (largestScale(lobe) == 0) continue;
    const bool diffuse = lobe.model->name() == "Lambertian";
    const double weight = largestScale(lobe) * (diffuse ? (1 - others) / diffuseNeed : 1);
    parts.push_back({definition(lobe, weight), weight});
  }
  if (parts.empty() || (diffuseNeed == 0 && others < 1))
    parts.push_back({"\"diffuse\"\n    \"rgb reflectance\" [ 0 0 0 ]\n", 1 - others});

  double remaining = 1;
  std::string mixes, rest = parts.size() == 1 ? text.name : text.name + "_" + std::to_string(parts.size() - 1);
  out += named(rest, parts.back().definition);
  remaining = parts.back().weight;
  // From the last: each mix holds one part more; its amount is the weight of its second material.
  for (std::size_t k = parts.size() - 1; k-- > 0;) {
    const std::string part = text.name + "_" + std::to_string(k),
                      mix = k == 0 ? text.name : text.name + "_mix" + std::to_string(k);
    const double total = remaining + parts[k].weight;
    out += named(part, parts[k].definition);
    mixes += named(mix, "\"mix\"\n    \"string materials\" [ \"" + part + "\" \"" + rest + "\" ] \"float amount\" [ " +
                            formatNumber(total > 0 ? remaining / total : 0) + " ]\n");
    rest = mix;
    remaining = total;
  }
  return out + mixes + "# NamedMaterial \"" + text.name + "\"\n";
}

std::shared_ptr<const LobeSum> approximate(const Brdf& target, const FitOptions& options) {
  const auto largestOf = [](const LobeSum& sum, std::string_view model) {
    double largest = 0;
    for (const Lobe& lobe : sum.lobes())
      if (lobe.model->name() == model) largest = std::max(largest, largestScale(lobe));
    return largest;
  };
  std::vector<std::shared_ptr<const LobeSum>> candidates;
  const auto offer = [&](std::shared_ptr<const LobeSum> fitted, double weight) {
    fitted = withScaleAtMost(*fitted, "Lambertian", 1 - weight);
    if (refusal(*fitted).empty()) candidates.push_back(std::move(fitted));
  };
  const auto free = fitLobes(target, "Lambertian + GGX", options);
  const double base = std::min(largestOf(*free, "Lambertian"), 0.98), gloss = largestOf(*free, "GGX");
  // The highlight's weight held: at what the base leaves, and at what it would have, where that is less.
  for (const double weight : {1 - base, std::min(gloss, 1 - base)}) {
    offer(fitLobes(target, "Lambertian + GGX", options, {"GGX.scale=" + formatNumber(weight)}), weight);
    offer(fitColours(target, "Lambertian + GGXConductor", options, {"GGXConductor.eta", "GGXConductor.k"},
                     {"GGXConductor.scale=" + formatNumber(weight)}),
          weight);
    if (gloss >= 1 - base) break;
  }
  if (candidates.empty())
    offer(fitLobes(target, "Lambertian + GGX", options, {"GGX.alpha=0.001", "GGX.scale=" + formatNumber(1 - base)}),
          1 - base);
  return nearest(target, options, candidates);
}

}  // namespace

Exporter pbrtExporter() {
  Exporter exporter;
  exporter.name = "pbrt";
  exporter.title = "pbrt-v4 named materials";
  exporter.extension = ".pbrt";
  exporter.refusal = refusal;
  exporter.approximate = approximate;
  exporter.write = write;
  exporter.notes = {
      "uroughness and vroughness are the widths of the slopes (remaproughness is off); shadowing is height-correlated "
      "Smith",
      "sums are mix materials, which pbrt evaluates by choosing one of them at random at each point: the same mean, "
      "more "
      "noise",
      "pbrt turns RGB reflectances and indices into smooth spectra; greys stay as they are"};
  return exporter;
}

}  // namespace brdf
