#include <brdf/geometry/Directions.h>
#include <brdf/geometry/DiskSquare.h>

#include <cmath>

namespace brdf {

std::array<double, 2> squareToDisk(double u, double v) {
  const double a = 2 * u - 1, b = 2 * v - 1;
  if (a == 0 && b == 0) return {0, 0};
  // The sector about the x or the y axis that the point lies in; the angle is measured from that axis.
  const bool aboutX = std::abs(a) > std::abs(b);
  const double radius = aboutX ? a : b;
  const double angle = kPi / 4 * (aboutX ? b / a : a / b);
  const double along = radius * std::cos(angle), across = radius * std::sin(angle);
  return aboutX ? std::array{along, across} : std::array{across, along};
}

std::array<double, 2> diskToSquare(double x, double y) {
  const bool aboutX = std::abs(x) > std::abs(y);
  const double along = aboutX ? x : y, across = aboutX ? y : x;
  const double radius = std::copysign(std::hypot(x, y), along);
  const double other = along == 0 ? 0 : radius * std::atan(across / along) * (4 / kPi);
  const double a = aboutX ? radius : other, b = aboutX ? other : radius;
  return {(a + 1) / 2, (b + 1) / 2};
}

}  // namespace brdf
