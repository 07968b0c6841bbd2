#pragma once
#include <brdf/brdf_export.h>

#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// How a value f_r (1/sr) becomes a length. Negative values count as 0.
enum class LobeTransform {
  None,      ///< f_r
  CubeRoot,  ///< cbrt(f_r)
  Log,       ///< ln(1 + f_r)
  LogFloor   ///< log10(max(f_r, floor) / floor): decades above the floor
};

struct LobeScale {
  LobeTransform transform = LobeTransform::None;
  double floor = 1e-3;  ///< of LogFloor, 1/sr, above 0: by default a third of a percent of a white diffuser
};

BRDF_EXPORT double transformed(const LobeScale& scale, double value);
/// "none", "cuberoot", "log" or "logfloor"; throws Error::Kind::Value for another name.
BRDF_EXPORT LobeTransform parseLobeTransform(std::string_view name);
BRDF_EXPORT std::vector<std::string> lobeTransformNames();
/// What the length is, with its unit, e.g. "cube root of f_r (sr^-1/3)".
BRDF_EXPORT std::string lobeScaleLabel(const LobeScale& scale);

}  // namespace brdf
