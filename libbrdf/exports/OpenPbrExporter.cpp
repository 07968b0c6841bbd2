#include <brdf/base/Text.h>
#include <brdf/exports/Approximation.h>
#include <brdf/exports/BuiltInExporters.h>
#include <brdf/exports/MaterialXDocument.h>

namespace brdf {
namespace {

std::string refusal(const LobeSum& material) {
  if (material.lobes().size() != 1 || material.lobes()[0].model->name() != "OpenPBR")
    return "OpenPBR is one model, and the material is not of it";
  const Lobe& lobe = material.lobes()[0];
  if (!sameInAllChannels(lobe.scale) || lobe.scale[0] != 1) return "OpenPBR has no factor";
  return differsBetweenChannels(lobe, {"base_color"});
}

std::string write(const LobeSum& material, const ExportText& text) {
  const Lobe& lobe = material.lobes()[0];
  MaterialXDocument document(text);
  pugi::xml_node node = document.node("open_pbr_surface", text.name + "_surface", "surfaceshader");
  for (const Parameter& parameter : lobe.model->parameters()) {
    const char* name = parameter.name.c_str();
    if (parameter.name == "base_color")
      MaterialXDocument::value(node, name, "color3",
                               colourText(colourOf(lobe.parameters[lobe.model->parameterIndex(name)]), ", "));
    else
      MaterialXDocument::value(node, name, "float", formatNumber(parameterOf(lobe, name)));
  }
  return document.finish(text.name, text.name + "_surface");
}

std::shared_ptr<const LobeSum> approximate(const Brdf& target, const FitOptions& options) {
  std::vector<std::shared_ptr<const LobeSum>> candidates;
  const std::vector<std::vector<std::string>> kinds = {
      {"base_metalness=1", "specular_ior=1.5", "base_diffuse_roughness=0"}, {"base_metalness=0"}, {"specular_ior=1.5"}};
  for (std::vector<std::string> hold : kinds) {
    hold.emplace_back("scale=1");
    if (target.symmetry() != Symmetry::Anisotropic) hold.emplace_back("specular_roughness_anisotropy=0");
    candidates.push_back(fitColours(target, "OpenPBR", options, {"OpenPBR.base_color"}, hold));
  }
  return nearest(target, options, candidates);
}

}  // namespace

Exporter openPbrExporter() {
  Exporter exporter;
  exporter.name = "openpbr";
  exporter.title = "MaterialX document with an open_pbr_surface";
  exporter.extension = ".mtlx";
  exporter.refusal = refusal;
  exporter.approximate = approximate;
  exporter.write = write;
  exporter.notes = {
      "evaluated as OpenPBR's MaterialX graph says, base and specular only: layering by the directional albedo of the "
      "specular lobe at the viewer, here with Schlick's Fresnel term at the same normal reflectance",
      "specular_roughness is the square root of alpha"};
  return exporter;
}

}  // namespace brdf
