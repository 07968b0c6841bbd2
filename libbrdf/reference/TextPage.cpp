#include <brdf/base/Text.h>
#include <brdf/base/TextTable.h>
#include <brdf/formula/MathPrinter.h>
#include <brdf/models/FormulaModel.h>
#include <brdf/reference/Markdown.h>
#include <brdf/reference/ModelPage.h>

#include <algorithm>

namespace brdf {
namespace {

constexpr std::size_t kColumns = 100;

/// `text` broken between words, each line after `indent`, further ones after `further`.
std::string wrapped(std::string_view text, const std::string& indent, const std::string& further) {
  std::string result, line = indent;
  bool empty = true;
  for (const std::string_view word : split(text, ' ')) {
    if (!empty && line.size() + 1 + word.size() > kColumns) {
      result += line + "\n";
      line = further;
      empty = true;
    }
    line += (empty ? "" : " ") + std::string(word);
    empty = false;
  }
  return result + line + "\n";
}

std::string parameters(const Model& model) {
  if (model.parameters().empty()) return "  none but the scale factor\n";
  TextTable table({"  name", "default", "hard bounds", "usual", "scale", "unit", "meaning"});
  for (const Parameter& p : model.parameters())
    table.row({"  " + p.name, markdown::number(p.defaultValue),
               markdown::number(p.minimum) + " to " + markdown::number(p.maximum),
               markdown::number(p.softMinimum) + " to " + markdown::number(p.softMaximum),
               p.scale == Parameter::Scale::Logarithmic ? "log" : "linear", p.unit,
               p.description + (p.follows.empty() ? "" : " Follows " + p.follows + ".")});
  return table.text() + "\n";
}

std::string mathLines(const std::string& formula, const std::string& value,
                      const std::map<std::string, std::string>& symbols) {
  std::string text;
  for (const auto& statement : formula::printMath(formula, formula::MathStyle::Unicode, symbols, "formula"))
    text += "  " + (statement.target.empty() ? value : statement.target) + " = " + statement.expression + "\n";
  return text;
}

std::string formulaText(const Model& model) {
  std::string text = mathLines(model.equation(), "f", markdown::symbolsOf(model.parameters()));
  const auto* record = dynamic_cast<const FormulaModel*>(&model);
  if (record != nullptr && !record->functionsUsed().empty()) {
    text += "\nWhere\n";
    for (const std::string& name : record->functionsUsed()) {
      const LibraryFunction& entry = markdown::functionCalled(name);
      text += "  " + name + "(" + joined(entry.function.arguments) + "): " + entry.title + "\n";
      for (const std::string& line : markdown::unindented(entry.function.body)) text += "      " + line + "\n";
    }
  }
  text += "\nAs written in its file\n";
  for (const std::string& line : markdown::unindented(model.equation())) text += "  " + line + "\n";
  return text;
}

std::string sampler(const Model& model) {
  const auto* record = dynamic_cast<const FormulaModel*>(&model);
  if (record == nullptr) return "  its own\n";
  std::string text;
  for (const FormulaModel::SamplerPart& part : record->samplerParts()) {
    const Sampler& used = findSampler(part.sampler, model.name());
    text += wrapped((part.share.empty() ? "" : "for a share of " + part.share + " of the draws instead: ") +
                        used.title + ": " + used.name + "(" + joined(part.arguments) + ")",
                    "  ", "    ");
    for (const Reference& reference : used.references) text += wrapped(citation(reference), "    ", "      ");
  }
  return text;
}

}  // namespace

std::string modelPageText(const ModelPointer& model) {
  std::string text = model->name() + ": " + model->title() + "\n\n";
  if (!model->description().empty()) text += wrapped(model->description(), "", "") + "\n";
  text += std::string(model->isotropic() ? "Isotropic" : "Anisotropic") + ", " +
          (model->reciprocal() ? "reciprocal" : "not reciprocal") +
          "; in 1/sr without the cosine, 0 below the horizon.\n";
  text += "\nParameters\n" + parameters(*model);
  text += "\nFormula\n" + formulaText(*model);
  text += "\nDirectional albedo at the defaults (and three standard errors)\n";
  for (const MeasuredAlbedo& albedo : measuredAlbedos(model))
    text += "  light at " + markdown::number(albedo.degrees) + " degrees: " + albedo.text("±") + "\n";
  text += "\nSampler\n" + sampler(*model);
  if (const auto breaks = declaredBreaks(*model); !breaks.empty()) {
    text += "\nDeclares not to keep\n";
    for (const std::string& one : breaks) text += wrapped(one, "  ", "    ");
  }
  if (!model->references().empty()) text += "\nSource\n";
  for (const Reference& reference : model->references()) text += wrapped(citation(reference), "  ", "    ");
  return text;
}

}  // namespace brdf
