#include <brdf/Version.h>
#include <brdf/base/Error.h>
#include <brdf/base/Plugins.h>
#include <brdf/base/Text.h>
#include <brdf/exports/Approximation.h>
#include <brdf/exports/BuiltInExporters.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/ChannelView.h>

#include <algorithm>

namespace brdf {
namespace {

std::vector<Exporter>& registry() {
  plugins();
  static std::vector<Exporter> exporters{glslExporter(),    gltfExporter(),           materialXExporter(),
                                         mitsubaExporter(), openPbrExporter(),        oslExporter(),
                                         pbrtExporter(),    standardSurfaceExporter()};
  return exporters;
}

bool isIdentifier(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && letter(name[0]) && name.find("__") == std::string_view::npos && name.back() != '_' &&
         std::ranges::all_of(name, [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

std::string anglesText(const std::array<double, 3>& direction) {
  const Spherical s = toSpherical(direction);
  return "(" + formatNumber(degrees(s.theta), 4) + ", " + formatNumber(degrees(s.phi), 4) + ")";
}

/// Text that no comment syntax ends or nests in: '*' followed by '/' and "--" are broken up, lines joined.
std::string plain(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n' || text[i] == '\r') text[i] = ' ';
    if (i > 0 && text[i - 1] == '*' && text[i] == '/') text.insert(i, " ");
    if (i > 0 && text[i - 1] == '-' && text[i] == '-') text.insert(i, " ");
  }
  return text;
}

std::vector<std::string> headLines(const Brdf& material, const Exporter& exporter, const ExportResult& result,
                                   double maximumTheta) {
  std::vector<std::string> lines = {exporter.title + ", written by BRDFLab " BRDF_VERSION,
                                    "material: " + material.description()};
  if (result.exact) {
    lines.push_back("exact: the target evaluates these lobes, in its own arithmetic");
  } else {
    const ExportError& e = result.error;
    const auto metric = [&](const char* name) {
      return std::string(name) + " " + formatNumber(e.comparison.metrics.at(name), 4) +
             " (of the answer 0: " + formatNumber(e.comparison.zeroModel.at(name), 4) + ")";
    };
    lines.push_back("approximation: " + result.reason);
    lines.push_back("the target evaluates: " + result.evaluated->description());
    lines.push_back("error up to " + formatNumber(maximumTheta) + " degrees: " + metric("rms") + " 1/sr, " +
                    metric("rms_cos") + ", " + metric("log") + "; " + e.comparison.sampling);
    lines.push_back("worst: " + formatNumber(e.worstEvaluated, 4) + " instead of " + formatNumber(e.worstMaterial, 4) +
                    " 1/sr at light (theta, phi) " + anglesText(e.wi) + ", viewer " + anglesText(e.wo) + " degrees");
  }
  for (const std::string& note : result.notes) lines.push_back("note: " + note);
  for (std::string& line : lines) line = plain(line);
  return lines;
}

}  // namespace

std::span<const Exporter> allExporters() { return registry(); }

void registerExporter(Exporter exporter) {
  auto& exporters = registry();
  const auto same = std::ranges::find(exporters, exporter.name, &Exporter::name);
  if (same != exporters.end())
    *same = std::move(exporter);
  else
    exporters.push_back(std::move(exporter));
}

const Exporter& findExporter(std::string_view name) {
  std::vector<std::string> names;
  for (const Exporter& exporter : registry()) {
    if (exporter.name == name) return exporter;
    names.push_back(exporter.name);
  }
  throw Error(Error::Kind::Value, {"unknown export format", "format", std::string(name), joined(names)});
}

ExportResult exportMaterial(const BrdfPointer& material, const Exporter& exporter, const ExportOptions& options) {
  if (!isIdentifier(options.name))
    throw Error(Error::Kind::Value, {"not an identifier", "name of the material", options.name,
                                     "letters, digits and single '_' between them, a letter first"});
  ExportResult result;
  result.notes = exporter.notes;
  BrdfPointer seen = material;
  auto lobes = std::dynamic_pointer_cast<const LobeSum>(material);
  if (material->channels().kind == Channels::Kind::Spectral && !exporter.spectral) {
    result.notes.push_back("the spectrum was reduced to linear sRGB under " + describe(options.colour));
    if (lobes) lobes = lobesAsRgb(*lobes, options.colour);
    seen = lobes ? lobes : asRgb(material, options.colour);
  }
  result.reason = lobes ? exporter.refusal(*lobes) : "the material is no sum of lobes";
  result.exact = result.reason.empty();
  if (result.exact) {
    result.evaluated = lobes;
  } else {
    FitOptions fit;
    fit.metric = options.metric;
    fit.maximumTheta = options.maximumTheta;
    fit.tolerance = 1e-6;
    result.evaluated = exporter.approximate(*sampledForExport(seen), fit);
  }
  result.error = exportError(*result.evaluated, *seen, options.maximumTheta);
  result.text =
      exporter.write(*result.evaluated,
                     {options.name, headLines(*material, exporter, result, options.maximumTheta), options.uniforms});
  return result;
}

}  // namespace brdf
