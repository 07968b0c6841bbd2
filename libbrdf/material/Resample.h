#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/GridBrdf.h>

#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// A grid for a BRDF of this symmetry and reciprocity, of cells `step` degrees wide (0.1 to 45; half as wide in the
/// square root of theta_h and specular_theta near 0, see AxisScale::SquareRoot). Outgoing directions come first. What
/// the BRDF assumes, the grid uses: azimuths of an isotropic one cover half a turn, phi_d of a reciprocal one as well;
/// only an anisotropic one gets a fourth axis.
BRDF_EXPORT GridLayout gridFor(const Brdf& brdf, Parametrisation parametrisation, double step);

/// `text` as a layout for `brdf`: "merl" (90 x 90 x 180 cells, or 360 where it is not reciprocal), or "spherical",
/// "half_difference" or "specular" with a step in degrees, as in "spherical:5". Throws Error::Kind::Value.
BRDF_EXPORT GridLayout parseGridLayout(std::string_view text, const Brdf& brdf);

struct Resampled {
  std::shared_ptr<const GridBrdf> brdf;
  std::vector<std::string> losses;  ///< one sentence each: anisotropy, validity, reciprocity
};
/// Tabulates `brdf` on `layout` and says what that cannot keep; regionErrors(*result.brdf, brdf) says how far it is.
BRDF_EXPORT Resampled resample(const Brdf& brdf, const GridLayout& layout);

}  // namespace brdf
