#include <brdf/base/Error.h>
#include <brdf/io/ImageDifference.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace brdf {
namespace {

std::string shape(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + ", " + std::to_string(image.channels) +
         " channels";
}

/// Distance of two numbers in units of the tolerance; 0 for the same not-a-number or infinity in both.
double distance(double a, double b, const ImageTolerance& tolerance) {
  if (!std::isfinite(a) || !std::isfinite(b)) {
    const bool same = a == b || (std::isnan(a) && std::isnan(b));
    return same ? 0 : std::numeric_limits<double>::infinity();
  }
  const double apart = std::abs(a - b);
  return apart == 0 ? 0 : apart / (tolerance.absolute + tolerance.relative * std::abs(b));
}

}  // namespace

ImageDifference imageDifference(const Image& a, const Image& b, const ImageTolerance& tolerance) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels)
    throw Error(Error::Kind::Value, {"pictures of different size", "", shape(a), shape(b)});
  if (b.values.empty()) throw Error(Error::Kind::Value, {"empty pictures", "", shape(b), "a pixel at least"});
  if (!(tolerance.absolute >= 0) || !(tolerance.relative >= 0) || !(tolerance.outliers >= 0 && tolerance.outliers <= 1))
    throw Error(Error::Kind::Value,
                {"tolerance of pictures out of range", "",
                 "absolute " + std::to_string(tolerance.absolute) + ", relative " + std::to_string(tolerance.relative) +
                     ", outliers " + std::to_string(tolerance.outliers),
                 "0 or more; outliers 0 to 1"});
  ImageDifference found;
  double squares = 0;
  std::size_t finite = 0;
  for (std::size_t y = 0; y < b.height; ++y)
    for (std::size_t x = 0; x < b.width; ++x) {
      double farthest = 0;
      for (std::size_t channel = 0; channel < b.channels; ++channel) {
        const double first = a.pixel(x, y)[channel], second = b.pixel(x, y)[channel];
        farthest = std::max(farthest, distance(first, second, tolerance));
        if (!std::isfinite(first) || !std::isfinite(second)) continue;
        squares += (first - second) * (first - second);
        ++finite;
      }
      found.outliers += farthest > 1;
      if (farthest > found.worst) {
        found.worst = farthest;
        found.worstX = x;
        found.worstY = y;
      }
    }
  found.rms = finite > 0 ? std::sqrt(squares / static_cast<double>(finite)) : 0;
  found.within = static_cast<double>(found.outliers) <= tolerance.outliers * static_cast<double>(b.width * b.height);
  return found;
}

}  // namespace brdf
