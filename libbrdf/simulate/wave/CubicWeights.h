#pragma once
// Internal to libbrdf/simulate/wave.
#include <array>

namespace brdf::wave {

/// Weights at t of the cubic through four points at -1, 0, 1, 2.
inline std::array<double, 4> cubicWeights(double t) {
  const double a = t + 1, b = t - 1, c = t - 2;
  return {-t * b * c / 6, a * b * c / 2, -a * t * c / 2, a * t * b / 6};
}

}  // namespace brdf::wave
