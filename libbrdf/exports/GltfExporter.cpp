#include <brdf/Version.h>
#include <brdf/base/Text.h>
#include <brdf/exports/Approximation.h>
#include <brdf/exports/BuiltInExporters.h>

#include <nlohmann/json.hpp>

namespace brdf {
namespace {

constexpr const char* kModel = "GltfMetallicRoughness";

std::string refusal(const LobeSum& material) {
  if (material.lobes().size() != 1 || material.lobes()[0].model->name() != kModel)
    return std::string("glTF has one material model, ") + kModel;
  const Lobe& lobe = material.lobes()[0];
  if (!sameInAllChannels(lobe.scale) || lobe.scale[0] != 1) return "glTF's material has no factor";
  return differsBetweenChannels(lobe, {"baseColor"});
}

std::string write(const LobeSum& material, const ExportText& text) {
  using Json = nlohmann::ordered_json;
  const Lobe& lobe = material.lobes()[0];
  const std::array<double, 3> colour = colourOf(lobe.parameters[lobe.model->parameterIndex("baseColor")]);
  Json json = {{"name", text.name},
               {"pbrMetallicRoughness",
                {{"baseColorFactor", {colour[0], colour[1], colour[2], 1.0}},
                 {"metallicFactor", parameterOf(lobe, "metallic")},
                 {"roughnessFactor", parameterOf(lobe, "roughness")}}}};
  std::vector<std::string> used;
  const auto extend = [&](const char* extension, const char* key, const char* parameter, double standard) {
    const double value = parameterOf(lobe, parameter);
    if (value == standard) return;
    used.emplace_back(extension);
    json["extensions"][extension] = {{key, value}};
  };
  extend("KHR_materials_anisotropy", "anisotropyStrength", "anisotropy", 0);
  extend("KHR_materials_ior", "ior", "ior", 1.5);
  extend("KHR_materials_specular", "specularFactor", "specular", 1);
  json["extras"] = {{"comments", text.comments}};
  Json document = {{"asset", {{"version", "2.0"}, {"generator", "BRDFLab " BRDF_VERSION}}}};
  if (!used.empty()) document["extensionsUsed"] = used;
  document["materials"] = Json::array({json});
  return document.dump(2) + "\n";
}

std::shared_ptr<const LobeSum> approximate(const Brdf& target, const FitOptions& options) {
  std::vector<std::shared_ptr<const LobeSum>> candidates;
  // A metal, a dielectric of any index or strength, and a blend with the common dielectric.
  const std::vector<std::vector<std::string>> kinds = {{"metallic=1", "ior=1.5", "specular=1"},
                                                       {"metallic=0", "specular=1"},
                                                       {"metallic=0", "ior=1.5"},
                                                       {"ior=1.5", "specular=1"}};
  for (std::vector<std::string> hold : kinds) {
    hold.emplace_back("scale=1");
    if (target.symmetry() != Symmetry::Anisotropic) hold.emplace_back("anisotropy=0");
    candidates.push_back(fitColours(target, kModel, options, {std::string(kModel) + ".baseColor"}, hold));
  }
  return nearest(target, options, candidates);
}

}  // namespace

Exporter gltfExporter() {
  Exporter exporter;
  exporter.name = "gltf";
  exporter.title = "glTF 2.0 document with a metallic-roughness material";
  exporter.extension = ".gltf";
  exporter.refusal = refusal;
  exporter.approximate = approximate;
  exporter.write = write;
  exporter.notes = {
      "roughness is the square root of alpha, baseColorFactor linear; the model is that of appendix B of glTF 2.0 and "
      "of KHR_materials_ior, _specular and _anisotropy where they are used",
      "the highlight is widened along the tangent; a mesh needs TANGENT for it"};
  return exporter;
}

}  // namespace brdf
