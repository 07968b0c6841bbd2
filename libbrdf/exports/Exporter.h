#pragma once
#include <brdf/brdf_export.h>
#include <brdf/color/ColourSettings.h>
#include <brdf/fit/Fit.h>
#include <brdf/material/LobeSum.h>

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

struct ExportOptions {
  std::string name = "material";  ///< of the material in the file; letters, digits and '_', starting with a letter
  bool uniforms = false;          ///< GLSL: parameters and scales are uniforms with these values, not constants
  std::string metric = "log";     ///< that an approximation makes least (metricNames())
  double maximumTheta = 80;       ///< degrees; directions above count neither for the approximation nor for its error
  ColourSettings colour{};        ///< of spectral materials, where the target takes none
};

/// How far what the target evaluates is from the material.
struct ExportError {
  Comparison comparison;  ///< compare(evaluated, material, maximumTheta)
  /// The pair of the largest |difference| of any channel (1/sr), among the material's own samples, or, where it has
  /// none, pairs over the hemispheres and about highlights.
  double worstDifference = 0;
  double worstEvaluated = 0, worstMaterial = 0;  ///< the two values there, 1/sr
  std::array<double, 3> wi{}, wo{};
};

struct ExportResult {
  std::string text;  ///< the whole file
  /// What the target evaluates, as a material of ours: the text holds its numbers, and nothing else.
  std::shared_ptr<const LobeSum> evaluated;
  bool exact = false;  ///< `evaluated` is the material itself, lobe for lobe
  std::string reason;  ///< why it is not exact; empty where it is
  ExportError error;
  std::vector<std::string> notes;  ///< one sentence each: conventions, what the target does with what it gets
};

/// What an exporter's text is written from.
struct ExportText {
  std::string name;
  std::vector<std::string> comments;  ///< lines for the head of the file: what this is, and the error
  bool uniforms = false;
};

/// One program or format that takes materials. All but GLSL's get linear sRGB or one channel.
struct Exporter {
  std::string name;       ///< short, lower case: "mitsuba"
  std::string title;      ///< "Mitsuba 3, a <bsdf> element"
  std::string extension;  ///< with the dot
  bool spectral = false;  ///< takes any channels
  /// Empty where the target evaluates exactly this sum, else the reason why not.
  std::function<std::string(const LobeSum& material)> refusal;
  /// The nearest sum that the target has. `target` is of one channel or RGB and has samples.
  std::function<std::shared_ptr<const LobeSum>(const Brdf& target, const FitOptions& options)> approximate;
  /// The file, for a sum that is not refused.
  std::function<std::string(const LobeSum& material, const ExportText& text)> write;
  std::vector<std::string> notes;  ///< for every file: conventions
};

/// All exporters; ours first, then those registered from outside.
BRDF_EXPORT std::span<const Exporter> allExporters();
/// Adds an exporter; replaces one of the same name.
BRDF_EXPORT void registerExporter(Exporter exporter);
/// The exporter called `name`; throws Error::Kind::Value with the allowed names.
BRDF_EXPORT const Exporter& findExporter(std::string_view name);

/// The material as the exporter's target gets it: exactly where the target has its lobes, else the best approximation
/// in the target's own. Throws Error::Kind::Value for a name that is no identifier.
BRDF_EXPORT ExportResult exportMaterial(const BrdfPointer& material, const Exporter& exporter,
                                        const ExportOptions& options = {});

}  // namespace brdf
