#include <brdf/base/Text.h>
#include <brdf/exports/Approximation.h>
#include <brdf/exports/BuiltInExporters.h>
#include <brdf/exports/MaterialXDocument.h>

#include <algorithm>

namespace brdf {
namespace {

/// What stands for a lobe: the node, and the parameters of ours that are colours there.
struct Node {
  const char* category = nullptr;
  std::vector<std::string_view> colours;
};

Node nodeOf(const std::string& name) {
  if (name == "Lambertian" || name == "OrenNayar") return {"oren_nayar_diffuse_bsdf", {}};
  if (name == "EON") return {"oren_nayar_diffuse_bsdf", {"rho"}};
  if (name == "MaterialXDielectric") return {"dielectric_bsdf", {}};
  if (name == "MaterialXConductor") return {"conductor_bsdf", {"eta", "k"}};
  if (name == "MaterialXSchlick") return {"generalized_schlick_bsdf", {"F0"}};
  return {};
}

std::string refusal(const LobeSum& material) {
  for (const Lobe& lobe : material.lobes()) {
    const std::string& name = lobe.model->name();
    const Node node = nodeOf(name);
    if (!node.category) return "MaterialX has no node for " + name;
    if (const std::string reason = differsBetweenChannels(lobe, node.colours); !reason.empty()) return reason;
    if (name == "OrenNayar" && parameterOf(lobe, "sigma") > 1) return "MaterialX's Oren-Nayar has a roughness up to 1";
  }
  return {};
}

void writeLobe(MaterialXDocument& document, const Lobe& lobe, const std::string& nodeName) {
  const std::string& name = lobe.model->name();
  pugi::xml_node node = document.node(nodeOf(name).category, nodeName, "BSDF");
  const auto colour = [&](const char* input, const char* parameter) {
    MaterialXDocument::value(node, input, "color3",
                             colourText(colourOf(lobe.parameters[lobe.model->parameterIndex(parameter)]), ", "));
  };
  const auto number = [&](const char* input, const char* parameter) {
    MaterialXDocument::value(node, input, "float", formatNumber(parameterOf(lobe, parameter)));
  };
  if (name == "Lambertian" || name == "OrenNayar") {
    MaterialXDocument::value(node, "color", "color3", "1, 1, 1");
    if (name == "Lambertian")
      MaterialXDocument::value(node, "roughness", "float", "0");
    else
      number("roughness", "sigma");
    MaterialXDocument::value(node, "energy_compensation", "boolean", "false");
    return;
  }
  if (name == "EON") {
    colour("color", "rho");
    number("roughness", "r");
    MaterialXDocument::value(node, "energy_compensation", "boolean", "true");
    return;
  }
  MaterialXDocument::value(
      node, "roughness", "vector2",
      formatNumber(parameterOf(lobe, "alpha")) + ", " + formatNumber(parameterOf(lobe, "alpha_y")));
  if (name == "MaterialXConductor") {
    colour("ior", "eta");
    colour("extinction", "k");
  } else {
    if (name == "MaterialXDielectric") {
      number("ior", "ior");
    } else {
      colour("color0", "F0");
      MaterialXDocument::value(node, "color90", "color3", "1, 1, 1");
      MaterialXDocument::value(node, "exponent", "float", "5");
    }
    MaterialXDocument::value(node, "scatter_mode", "string", "R");
  }
  MaterialXDocument::value(node, "distribution", "string", "ggx");
}

std::string write(const LobeSum& material, const ExportText& text) {
  MaterialXDocument document(text);
  std::string sum;
  for (std::size_t l = 0; l < material.lobes().size(); ++l) {
    const Lobe& lobe = material.lobes()[l];
    const std::string base = text.name + "_" + std::to_string(l), scaled = base + "_scaled";
    writeLobe(document, lobe, base);
    pugi::xml_node multiply = document.node("multiply", scaled, "BSDF");
    MaterialXDocument::connect(multiply, "in1", "BSDF", base);
    MaterialXDocument::value(multiply, "in2", "color3", colourText(colourOf(lobe.scale), ", "));
    if (l == 0) {
      sum = scaled;
      continue;
    }
    const std::string total = base + "_sum";
    pugi::xml_node add = document.node("add", total, "BSDF");
    MaterialXDocument::connect(add, "in1", "BSDF", sum);
    MaterialXDocument::connect(add, "in2", "BSDF", scaled);
    sum = total;
  }
  pugi::xml_node surface = document.node("surface", text.name + "_surface", "surfaceshader");
  MaterialXDocument::connect(surface, "bsdf", "BSDF", sum);
  return document.finish(text.name, text.name + "_surface");
}

std::shared_ptr<const LobeSum> approximate(const Brdf& target, const FitOptions& options) {
  std::vector<std::shared_ptr<const LobeSum>> candidates = {
      fitLobes(target, "Lambertian + MaterialXDielectric", options),
      fitLobes(target, "Lambertian + MaterialXDielectric + MaterialXDielectric", options),
      fitColours(target, "Lambertian + MaterialXConductor", options, {"MaterialXConductor.eta", "MaterialXConductor.k"},
                 {"MaterialXConductor.scale=1"}),
      fitColours(target, "Lambertian + MaterialXSchlick", options, {"MaterialXSchlick.F0"},
                 {"MaterialXSchlick.scale=1"})};
  return nearest(target, options, candidates);
}

}  // namespace

Exporter materialXExporter() {
  Exporter exporter;
  exporter.name = "materialx";
  exporter.title = "MaterialX document of pbrlib nodes";
  exporter.extension = ".mtlx";
  exporter.refusal = refusal;
  exporter.approximate = approximate;
  exporter.write = write;
  exporter.notes = {
      "roughness is the width of the slopes, for the tangent and across it; evaluated as MaterialX 1.39's "
      "specification "
      "of the nodes says: GGX, height-correlated Smith of the mean roughness, energy compensation after Turquin",
      "the specification leaves the energy compensation to the renderer; one without it is darker at high roughness"};
  return exporter;
}

}  // namespace brdf
