// Autodesk's standard_surface, as its MaterialX graph evaluates it: a dielectric over diffuse reflection, which is
// OpenPBR's where neither is rough in its own way, or a metal, which is MaterialX's conductor with its index given by
// two colours (O. Gulbrandsen 2014, Artist Friendly Metallic Fresnel, JCGT 3(4), equations 2 to 5).
#include <brdf/base/Text.h>
#include <brdf/exports/Approximation.h>
#include <brdf/exports/BuiltInExporters.h>
#include <brdf/exports/MaterialXDocument.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr const char *kDielectric = "OpenPBR", *kMetal = "MaterialXConductor";
constexpr double kMostReflectivity = 0.99;  ///< of the node artistic_ior
constexpr double kMostAnisotropy = 0.98;    ///< of the node roughness_anisotropy

/// The index of a metal as colours: reflectance at normal incidence, and where between its bounds the index lies.
struct Artistic {
  double reflectivity = 0, edge = 0;
};

/// Bounds of the real index for a reflectance r: equations 3.
double leastIndex(double r) { return (1 - r) / (1 + r); }
double mostIndex(double r) { return (1 + std::sqrt(r)) / (1 - std::sqrt(r)); }

Artistic artistic(double eta, double k) {
  const double below = (eta + 1) * (eta + 1) + k * k, r = ((eta - 1) * (eta - 1) + k * k) / below;
  const double span = mostIndex(r) - leastIndex(r);
  return {r, span > 0 ? (mostIndex(r) - eta) / span : 1};
}

/// Equations 2 and 5.
std::array<double, 2> indexOf(const Artistic& colours) {
  const double r = colours.reflectivity;
  const double eta = mostIndex(r) + (leastIndex(r) - mostIndex(r)) * colours.edge;
  const double k2 = (r * (eta + 1) * (eta + 1) - (eta - 1) * (eta - 1)) / (1 - r);
  return {eta, std::sqrt(std::max(k2, 0.0))};
}

std::size_t channelsOf(const Lobe& lobe) {
  std::size_t channels = 1;
  for (const std::vector<double>& values : lobe.parameters) channels = std::max(channels, values.size());
  return channels;
}

std::string refusal(const LobeSum& material) {
  if (material.lobes().size() != 1) return "standard_surface is one model, not a sum";
  const Lobe& lobe = material.lobes()[0];
  if (!sameInAllChannels(lobe.scale) || lobe.scale[0] != 1) return "standard_surface has no factor";
  if (lobe.model->name() == kDielectric) {
    for (const char* name : {"base_metalness", "base_diffuse_roughness", "specular_roughness_anisotropy"})
      if (parameterOf(lobe, name) != 0) return std::string(name) + " has no exact counterpart in standard_surface";
    return differsBetweenChannels(lobe, {"base_color"});
  }
  if (lobe.model->name() != kMetal) return "standard_surface has OpenPBR's dielectric and MaterialXConductor alone";
  const double across = parameterOf(lobe, "alpha_y") / parameterOf(lobe, "alpha");
  if (std::min(across, 1 / across) < 1 - kMostAnisotropy) return "the metal is too anisotropic";
  for (std::size_t c = 0; c < channelsOf(lobe); ++c) {
    const Artistic colours = artistic(parameterOf(lobe, "eta", c), parameterOf(lobe, "k", c));
    if (colours.reflectivity > kMostReflectivity || !(colours.edge >= 0 && colours.edge <= 1))
      return "no colours make the metal's index";
  }
  return differsBetweenChannels(lobe, {"eta", "k"});
}

std::string write(const LobeSum& material, const ExportText& text) {
  const Lobe& lobe = material.lobes()[0];
  MaterialXDocument document(text);
  pugi::xml_node node = document.node("standard_surface", text.name + "_surface", "surfaceshader");
  const auto number = [&](const char* name, double value) {
    MaterialXDocument::value(node, name, "float", formatNumber(value));
  };
  const auto colour = [&](const char* name, const std::array<double, 3>& value) {
    MaterialXDocument::value(node, name, "color3", colourText(value, ", "));
  };
  const bool metal = lobe.model->name() == kMetal;
  number("base", 1);
  number("diffuse_roughness", 0);
  number("metalness", metal ? 1 : 0);
  number("specular", 1);
  if (metal) {
    std::array<double, 3> base{}, edge{};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t channel = std::min(c, channelsOf(lobe) - 1);
      const Artistic colours = artistic(parameterOf(lobe, "eta", channel), parameterOf(lobe, "k", channel));
      base[c] = colours.reflectivity;
      edge[c] = colours.edge;
    }
    colour("base_color", base);
    colour("specular_color", edge);
    const double ax = parameterOf(lobe, "alpha"), ay = parameterOf(lobe, "alpha_y");
    number("specular_roughness", std::sqrt(std::sqrt(ax * ay)));
    number("specular_anisotropy", 1 - std::min(ax, ay) / std::max(ax, ay));
    number("specular_rotation", ay > ax ? 0.25 : 0);
  } else {
    colour("base_color", colourOf(lobe.parameters[lobe.model->parameterIndex("base_color")]));
    colour("specular_color", {1, 1, 1});
    number("specular_roughness", parameterOf(lobe, "specular_roughness"));
    number("specular_IOR", parameterOf(lobe, "specular_ior"));
  }
  return document.finish(text.name, text.name + "_surface");
}

/// A fitted metal, its index moved to the nearest that two colours make, and its anisotropy held.
std::shared_ptr<const LobeSum> withinReach(const LobeSum& fitted) {
  std::vector<Lobe> lobes = fitted.lobes();
  for (Lobe& lobe : lobes) {
    const auto values = [&](const char* name) -> std::vector<double>& {
      return lobe.parameters[lobe.model->parameterIndex(name)];
    };
    const std::size_t channels = channelsOf(lobe);
    std::vector<double> eta(channels), k(channels);
    for (std::size_t c = 0; c < channels; ++c) {
      Artistic colours = artistic(parameterOf(lobe, "eta", c), parameterOf(lobe, "k", c));
      // A little inside, so that the way back to the index and here again does not lead out.
      colours.reflectivity = std::min(colours.reflectivity, kMostReflectivity - 1e-9);
      colours.edge = std::clamp(colours.edge, 1e-9, 1 - 1e-9);
      const auto index = indexOf(colours);
      eta[c] = index[0];
      k[c] = index[1];
    }
    const double alpha = parameterOf(lobe, "alpha"), least = 1 - kMostAnisotropy;
    values("alpha_y") = {std::clamp(parameterOf(lobe, "alpha_y"), alpha * least * (1 + 1e-9), alpha / least)};
    values("eta") = std::move(eta);
    values("k") = std::move(k);
  }
  return std::make_shared<LobeSum>(std::move(lobes), fitted.channels());
}

std::shared_ptr<const LobeSum> approximate(const Brdf& target, const FitOptions& options) {
  const auto dielectric =
      fitColours(target, kDielectric, options, {"OpenPBR.base_color"},
                 {"scale=1", "base_metalness=0", "base_diffuse_roughness=0", "specular_roughness_anisotropy=0"});
  const auto metal =
      fitColours(target, kMetal, options, {"MaterialXConductor.eta", "MaterialXConductor.k"}, {"scale=1"});
  return nearest(target, options, {dielectric, withinReach(*metal)});
}

}  // namespace

Exporter standardSurfaceExporter() {
  Exporter exporter;
  exporter.name = "standard_surface";
  exporter.title = "MaterialX document with a standard_surface";
  exporter.extension = ".mtlx";
  exporter.refusal = refusal;
  exporter.approximate = approximate;
  exporter.write = write;
  exporter.notes = {
      "evaluated as standard_surface's MaterialX graph says, base and specular only, a dielectric or a metal",
      "a metal's index is given as base_color and specular_color through the node artistic_ior",
      "specular_roughness is the square root of alpha"};
  return exporter;
}

}  // namespace brdf
