#include <brdf/base/Text.h>
#include <brdf/exports/Approximation.h>
#include <brdf/exports/BuiltInExporters.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

namespace brdf {
namespace {

/// How a lobe of ours is written, or no plug-in.
struct Plugin {
  const char* type = nullptr;
  const char* distribution = nullptr;
  const char* parameters[2] = {nullptr, nullptr};  ///< eta, k or ior; none: a mirror of reflectance 1
};

Plugin pluginOf(const std::string& name) {
  if (name == "Lambertian") return {"diffuse"};
  if (name == "GGXWalter" || name == "Microfacet_GGX_Dielectric_SmithSeparable")
    return {"roughdielectric", "ggx", {"ior", nullptr}};
  if (name == "CookTorranceWalter" || name == "Microfacet_Beckmann_Dielectric_SmithSeparable")
    return {"roughdielectric", "beckmann", {"ior", nullptr}};
  if (name == "Microfacet_GGX_Conductor_SmithSeparable") return {"roughconductor", "ggx", {"eta", "k"}};
  if (name == "Microfacet_Beckmann_Conductor_SmithSeparable") return {"roughconductor", "beckmann", {"eta", "k"}};
  return {};
}

/// Whether the plug-in can hold any factor: one number for all colours of a rough lobe may exceed 1, a reflectance or a
/// colour may not.
bool unbounded(const Lobe& lobe) {
  return lobe.model->name() != "Lambertian" && sameInAllChannels(lobe.scale) && lobe.scale[0] > 0;
}

/// Least weight that a lobe of a bounded factor needs.
double need(const Lobe& lobe) { return unbounded(lobe) ? 0 : largestScale(lobe); }

std::string refusal(const LobeSum& material) {
  double sum = 0;
  bool others = false;
  for (const Lobe& lobe : material.lobes()) {
    const Plugin plugin = pluginOf(lobe.model->name());
    if (!plugin.type) return "Mitsuba has no plug-in for " + lobe.model->name();
    std::vector<std::string_view> colours;
    if (plugin.parameters[1]) colours = {"eta", "k"};
    if (const std::string reason = differsBetweenChannels(lobe, colours); !reason.empty()) return reason;
    sum += need(lobe);
    others = others || unbounded(lobe);
  }
  if (sum > 1 + 1e-12 || (others && sum > 0.999))
    return "Mitsuba adds lobes by blending, whose weights cannot exceed 1 in all: the factors of the diffuse and the "
           "coloured lobes sum to " +
           formatNumber(sum, 4);
  return {};
}

/// Weights that sum to 1: what each lobe needs, the rest shared out.
std::vector<double> blendWeights(const LobeSum& material) {
  double needed = 0, free = 0;
  for (const Lobe& lobe : material.lobes()) {
    needed += need(lobe);
    free += unbounded(lobe) ? lobe.scale[0] : 0;
  }
  std::vector<double> weights;
  for (const Lobe& lobe : material.lobes())
    weights.push_back(unbounded(lobe) ? (1 - needed) * lobe.scale[0] / free
                      : free > 0      ? need(lobe)
                      : needed > 0    ? need(lobe) / needed
                                      : 1 / static_cast<double>(material.lobes().size()));
  return weights;
}

void add(pugi::xml_node parent, const char* element, const char* name, const std::string& value) {
  pugi::xml_node node = parent.append_child(element);
  node.append_attribute("name") = name;
  node.append_attribute("value") = value.c_str();
}

/// A factor, or an index of refraction: one number where the colours agree.
void addSpectrum(pugi::xml_node parent, const char* name, const std::array<double, 3>& colour) {
  const bool grey = colour[0] == colour[1] && colour[1] == colour[2];
  add(parent, grey ? "spectrum" : "rgb", name, grey ? formatNumber(colour[0]) : colourText(colour, ", "));
}

void writeLobe(pugi::xml_node bsdf, const Lobe& lobe, double weight) {
  const Plugin plugin = pluginOf(lobe.model->name());
  std::array<double, 3> factor = colourOf(lobe.scale);
  for (double& f : factor) f = weight > 0 ? f / weight : 0;
  bsdf.append_attribute("type") = plugin.type;
  if (!plugin.distribution) {
    add(bsdf, "rgb", "reflectance", colourText(factor, ", "));
    return;
  }
  add(bsdf, "string", "distribution", plugin.distribution);
  add(bsdf, "float", "alpha_u", formatNumber(parameterOf(lobe, "alpha")));
  add(bsdf, "float", "alpha_v", formatNumber(parameterOf(lobe, "alpha_y")));
  if (plugin.parameters[1]) {
    for (const char* name : {"eta", "k"})
      addSpectrum(bsdf, name, colourOf(lobe.parameters[lobe.model->parameterIndex(name)]));
  } else {
    add(bsdf, "float", "int_ior", formatNumber(parameterOf(lobe, "ior")));
    add(bsdf, "float", "ext_ior", "1");
    addSpectrum(bsdf, "specular_transmittance", {0, 0, 0});
  }
  addSpectrum(bsdf, "specular_reflectance", factor);
}

/// Lobes first .. last as nested blends: weight w evaluates (1 - w) times the first plus w times the second.
void writeBlend(pugi::xml_node bsdf, const LobeSum& material, const std::vector<double>& weights, std::size_t first,
                double remaining) {
  if (first + 1 == material.lobes().size()) return writeLobe(bsdf, material.lobes()[first], weights[first]);
  const double rest = remaining - weights[first];
  bsdf.append_attribute("type") = "blendbsdf";
  add(bsdf, "float", "weight", formatNumber(remaining > 0 ? rest / remaining : 0));
  writeLobe(bsdf.append_child("bsdf"), material.lobes()[first], weights[first]);
  writeBlend(bsdf.append_child("bsdf"), material, weights, first + 1, rest);
}

std::string write(const LobeSum& material, const ExportText& text) {
  pugi::xml_document document;
  std::string comment = "\n";
  for (const std::string& line : text.comments) comment += line + "\n";
  document.append_child(pugi::node_comment).set_value(comment.c_str());
  pugi::xml_node bsdf = document.append_child("bsdf");
  // The outermost plug-in carries the id by which shapes refer to it.
  bsdf.append_attribute("id") = text.name.c_str();
  writeBlend(bsdf, material, blendWeights(material), 0, 1);
  std::ostringstream out;
  document.save(out, "  ", pugi::format_indent | pugi::format_no_declaration);
  return out.str();
}

std::shared_ptr<const LobeSum> approximate(const Brdf& target, const FitOptions& options) {
  std::vector<std::shared_ptr<const LobeSum>> candidates;
  for (const char* lobes : {"Lambertian + GGXWalter", "Lambertian + CookTorranceWalter",
                            "Lambertian + Microfacet_GGX_Conductor_SmithSeparable"}) {
    const bool metal = std::string_view(lobes).ends_with("SmithSeparable");
    // A metal's factor and index do the same: the index is tried with the factor held.
    auto fitted =
        metal ? fitColours(target, lobes, options,
                           {"Microfacet_GGX_Conductor_SmithSeparable.eta", "Microfacet_GGX_Conductor_SmithSeparable.k"},
                           {"Microfacet_GGX_Conductor_SmithSeparable.scale=1"})
              : fitLobes(target, lobes, options);
    fitted = withScaleAtMost(*fitted, "Lambertian", 0.999);
    // A coloured highlight beside a bright base exceeds what blending holds: a grey one does not.
    if (!refusal(*fitted).empty()) {
      const Lobe& gloss = fitted->lobes().back();
      double mean = 0;
      for (const double scale : gloss.scale) mean += scale / static_cast<double>(gloss.scale.size());
      fitted = fitLobes(target, lobes, options, {gloss.model->name() + ".scale=" + formatNumber(mean)});
      fitted = withScaleAtMost(*fitted, "Lambertian", 0.999);
    }
    if (refusal(*fitted).empty()) candidates.push_back(fitted);
  }
  return nearest(target, options, candidates);
}

}  // namespace

Exporter mitsubaExporter() {
  Exporter exporter;
  exporter.name = "mitsuba";
  exporter.title = "Mitsuba 3 <bsdf> element";
  exporter.extension = ".xml";
  exporter.refusal = refusal;
  exporter.approximate = approximate;
  exporter.write = write;
  exporter.notes = {
      "alpha_u and alpha_v are the widths of the slopes, as here; shadowing is separable Smith (Walter's rational fit "
      "for Beckmann)",
      "sums are nested blendbsdf; roughdielectric has specular_transmittance 0, so it reflects only",
      "one side reflects: wrap a material without roughdielectric in twosided to have both"};
  return exporter;
}

}  // namespace brdf
