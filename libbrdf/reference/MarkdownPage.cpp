#include <brdf/base/Text.h>
#include <brdf/check/Cases.h>
#include <brdf/models/FormulaModel.h>
#include <brdf/reference/Markdown.h>
#include <brdf/reference/ModelPage.h>

namespace brdf {
namespace {

using namespace markdown;

std::string formulaSection(const Model& model) {
  std::string text = "## Formula\n\n";
  text += mathBlock(model.equation(), "f_r", symbolsOf(model.parameters()), model.name()) + "\n";
  const auto* record = dynamic_cast<const FormulaModel*>(&model);
  if (record != nullptr && !record->functionsUsed().empty()) {
    text += "with\n\n";
    for (const std::string& name : record->functionsUsed()) {
      const LibraryFunction& entry = functionCalled(name);
      text += "- [`" + name + "`](functions.md#" + anchor(name) + "): " + escaped(entry.title) + "\n\n";
      text += mathBlock(entry.function.body, functionHead(entry), usualSymbols(), name) + "\n";
    }
  }
  return text + "As written in its file:\n\n" + codeBlock(model.equation()) + "\n";
}

std::string samplerSection(const Model& model) {
  const auto* record = dynamic_cast<const FormulaModel*>(&model);
  if (record == nullptr) return {};
  std::string text = "## Sampler\n\n";
  for (const FormulaModel::SamplerPart& part : record->samplerParts()) {
    const Sampler& used = findSampler(part.sampler, model.name());
    if (!part.share.empty()) text += "\n\nFor a share of `" + part.share + "` of the draws instead ";
    text += "[`" + used.name + "(" + joined(part.arguments) + ")`](samplers.md#" + anchor(used.name) +
            "): " + escaped(used.title) + ".";
  }
  return text + "\n\n";
}

}  // namespace

std::string modelPageMarkdown(const ModelPointer& model) { return page(*model, measuredAlbedos(model)); }

std::string markdown::page(const Model& model, const std::vector<MeasuredAlbedo>& albedos) {
  std::string text = "# " + model.name() + "\n\n" + escaped(model.title()) + ".\n\n";
  if (!model.description().empty()) text += escaped(model.description()) + "\n\n";
  text += std::string(model.isotropic() ? "Isotropic" : "Anisotropic") + ", " +
          (model.reciprocal() ? "reciprocal" : "not reciprocal") +
          "; the value is in 1/sr without the cosine, and 0 below the horizon. At its defaults: `" +
          parameterText(model, model.defaults()) + "`.\n\n";
  text += formulaSection(model);
  text += "## Parameters\n\n";
  text += model.parameters().empty() ? "None but the scale factor.\n\n" : parameterTable(model.parameters()) + "\n";
  text += "## Directional albedo\n\nMeasured at the defaults:\n\n" +
          header({"light at", "share reflected (± three standard errors)"});
  for (const MeasuredAlbedo& albedo : albedos) text += row({number(albedo.degrees) + "°", albedo.text("±")});
  text += "\n" + samplerSection(model);
  text += "## What it does not keep\n\n";
  const auto breaks = declaredBreaks(model);
  if (breaks.empty()) text += "Nothing: it is held to every check of [`brdf check`](../checks.md).\n";
  for (const std::string& one : breaks) text += "- " + escaped(one) + "\n";
  text += "\n## Sources\n\n";
  for (const Reference& reference : model.references()) text += "- " + markdown::citation(reference) + "\n";
  return text;
}

}  // namespace brdf
