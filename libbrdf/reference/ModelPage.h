#pragma once
#include <brdf/brdf_export.h>
#include <brdf/models/Model.h>

#include <map>
#include <string>
#include <vector>

namespace brdf {

/// The share of light from one polar angle that a model reflects, measured.
struct MeasuredAlbedo {
  double degrees = 0;  ///< polar angle of the light; its azimuth is 0
  double value = 0;
  double bound = 0;  ///< three standard errors, rounded up to 1, 2 or 5 times a power of ten

  /// "0.0401 +- 0.0001", with as many decimals as the bound has; `sign` stands between the two.
  BRDF_EXPORT std::string text(const std::string& sign) const;
};

/// Directional albedo at the defaults, for light from 0 and 60 degrees (sampling/DirectionalAlbedo.h). The same figures
/// on every machine.
BRDF_EXPORT std::vector<MeasuredAlbedo> measuredAlbedos(const ModelPointer& model);

/// What the model declares not to keep of what `brdf check` demands, one sentence each; empty for one held to all of
/// it.
BRDF_EXPORT std::vector<std::string> declaredBreaks(const Model& model);

/// One line: authors, year, title, venue, equations, DOI.
BRDF_EXPORT std::string citation(const Reference& reference);

/// The model's page for a terminal.
BRDF_EXPORT std::string modelPageText(const ModelPointer& model);
/// The same in Markdown, with LaTeX (as GitHub and many others render it).
BRDF_EXPORT std::string modelPageMarkdown(const ModelPointer& model);

/// The whole reference in Markdown, as path -> content: "models.md" (the list), "models/<name>.md" for every registered
/// model, "models/terms.md" (what Microfacet(D=..., F=..., G=...) is composed of), "models/functions.md" and
/// "models/samplers.md".
BRDF_EXPORT std::map<std::string, std::string> modelReference();

}  // namespace brdf
