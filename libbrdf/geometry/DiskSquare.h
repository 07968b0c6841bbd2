#pragma once
#include <brdf/brdf_export.h>

#include <array>

namespace brdf {

// The concentric map between the square [0, 1]^2 and the unit disk (P. Shirley and K. Chiu 1997, "A Low Distortion Map
// Between Disk and Square", Journal of Graphics Tools 2(3), 45-52, DOI 10.1080/10867651.1997.10487479): squares about
// the centre (1/2, 1/2) become circles, the side u = 1 faces +x and the side v = 1 faces +y. Areas keep their ratio,
// pi. A direction above the horizon stands on the disk at its x and y, where area is projected solid angle.

/// The point of the disk; u and v in [0, 1].
BRDF_EXPORT std::array<double, 2> squareToDisk(double u, double v);
/// Its inverse; points outside the disk give coordinates outside [0, 1].
BRDF_EXPORT std::array<double, 2> diskToSquare(double x, double y);

}  // namespace brdf
