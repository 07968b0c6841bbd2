#pragma once
#include <brdf/brdf_export.h>

#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// A published fit of a measured material that ships with the library (datasets/presets.xml).
struct Preset {
  std::string name;        ///< "ngan-ward-nickel": source, lobe, material
  std::string expression;  ///< material expression, one line
  std::string measured;    ///< the measured material it was fitted to, as the MERL database names it
  std::string citation;    ///< authors, year, title, venue, DOI in one line
  std::string doi;
  std::string conversion;  ///< what was changed between the published figures and the expression
};

/// All presets, in the file's order.
BRDF_EXPORT const std::vector<Preset>& presets();

/// The preset called `name`; throws Error::Kind::Value with the known names when there is none.
BRDF_EXPORT const Preset& findPreset(std::string_view name);

}  // namespace brdf
