#pragma once
#include <brdf/geometry/Directions.h>

#include <array>
#include <cstddef>

namespace brdf {

/// Point `index` of the R2 sequence (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences"), shifted
/// by (u, v), in [0, 1)^2: any run of points covers the square evenly.
inline std::array<double, 2> r2(std::size_t index, double u, double v) {
  constexpr double plastic = 1.32471795724474602596;
  double whole;
  return {std::modf(u + static_cast<double>(index + 1) / plastic, &whole),
          std::modf(v + static_cast<double>(index + 1) / (plastic * plastic), &whole)};
}

/// The same in four dimensions, in [0, 1)^4: the powers of the root of x^5 = x + 1.
inline std::array<double, 4> r4(std::size_t index, const std::array<double, 4>& shift) {
  constexpr double root = 1.16730397826141868426;
  std::array<double, 4> numbers{};
  double power = 1, whole;
  for (std::size_t k = 0; k < 4; ++k) {
    power *= root;
    numbers[k] = std::modf(shift[k] + static_cast<double>(index + 1) / power, &whole);
  }
  return numbers;
}

/// A cosine-weighted direction from two numbers in [0, 1); above the horizon.
inline Direction cosineDirection(double u, double v) {
  const double r = std::sqrt(u), phi = 2 * kPi * v;
  return {r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u)};
}

}  // namespace brdf
