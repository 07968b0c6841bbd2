#include <brdf/base/Text.h>
#include <brdf/exports/Approximation.h>
#include <brdf/exports/BuiltInExporters.h>

namespace brdf {
namespace {

/// The closure that evaluates a lobe with the parameters of one channel, or empty.
std::string closure(const Lobe& lobe, std::size_t channel) {
  const std::string& name = lobe.model->name();
  const auto p = [&](std::string_view parameter) { return formatNumber(parameterOf(lobe, parameter, channel)); };
  if (name == "Lambertian") return "diffuse(N)";
  if (name == "OrenNayar") return "oren_nayar(N, " + p("sigma") + ")";
  const bool ggx = name == "GGX" || name == "Microfacet_GGX_Dielectric_Smith", beckmann = name == "CookTorranceHeitz";
  if (!ggx && !beckmann) return {};
  return std::string("microfacet(\"") + (ggx ? "ggx" : "beckmann") + "\", N, T, " + p("alpha") + ", " + p("alpha_y") +
         ", " + p("ior") + ", 0)";
}

std::string refusal(const LobeSum& material) {
  for (const Lobe& lobe : material.lobes())
    if (closure(lobe, 0).empty()) return "OSL has no closure for " + lobe.model->name();
  return {};
}

std::string write(const LobeSum& material, const ExportText& text) {
  std::string out;
  for (const std::string& line : text.comments) out += "// " + line + "\n";
  out += "surface " + text.name + "() {\n  vector T = normalize(dPdu);\n  Ci = 0;\n";
  for (const Lobe& lobe : material.lobes()) {
    const std::array<double, 3> scale = colourOf(lobe.scale);
    const std::size_t shapes = lobe.channelIndependent() ? 1 : material.channels().count();
    for (std::size_t c = 0; c < shapes; ++c) {
      std::array<double, 3> weight = scale;
      if (shapes > 1)
        for (std::size_t other = 0; other < 3; ++other) weight[other] = other == c ? scale[c] : 0;
      out += "  Ci += color(" + colourText(weight, ", ") + ") * " + closure(lobe, c) + ";\n";
    }
  }
  return out + "}\n";
}

}  // namespace

Exporter oslExporter() {
  Exporter exporter;
  exporter.name = "osl";
  exporter.title = "Open Shading Language surface shader";
  exporter.extension = ".osl";
  exporter.refusal = refusal;
  exporter.approximate = [](const Brdf& target, const FitOptions& options) {
    return nearest(target, options,
                   {fitLobes(target, "Lambertian + GGX", options), fitLobes(target, "OrenNayar + GGX", options),
                    fitLobes(target, "Lambertian + CookTorranceHeitz", options),
                    fitLobes(target, "Lambertian + GGX + GGX", options)});
  };
  exporter.write = write;
  exporter.notes = {
      "closures diffuse, oren_nayar and microfacet of stdosl.h, evaluated as OSL's own testrender does: alpha is the "
      "width of the slopes, shadowing height-correlated Smith, exact dielectric Fresnel; other renderers may differ",
      "metals are microfacets of a high index: OSL's conductor_bsdf leaves its energy compensation to the renderer",
      "the tangent is dPdu"};
  return exporter;
}

}  // namespace brdf
