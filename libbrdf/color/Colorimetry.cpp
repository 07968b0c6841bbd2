#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/color/CieTables.h>
#include <brdf/color/Colorimetry.h>

#include <cmath>

namespace brdf {
namespace {

/// The part of the spectrum that each wavelength stands for; all 1 for a single one.
std::vector<double> intervals(std::span<const double> wavelengths) {
  const std::size_t count = wavelengths.size();
  std::vector<double> width(count, 1.0);
  if (count < 2) return width;
  width.front() = wavelengths[1] - wavelengths[0];
  width.back() = wavelengths[count - 1] - wavelengths[count - 2];
  for (std::size_t i = 1; i + 1 < count; ++i) width[i] = (wavelengths[i + 1] - wavelengths[i - 1]) / 2;
  return width;
}

/// `weights` scaled to sum 1; false when the sum is 0.
bool normalize(std::vector<double>& weights) {
  double sum = 0;
  for (double weight : weights) sum += weight;
  if (!(sum > 0)) return false;
  for (double& weight : weights) weight /= sum;
  return true;
}

[[noreturn]] void failInvisible(std::span<const double> wavelengths) {
  const std::string found = wavelengths.empty()
                                ? "no wavelength"
                                : formatNumber(wavelengths.front()) + " to " + formatNumber(wavelengths.back()) + " nm";
  throw Error(Error::Kind::Value, {"no wavelength is visible", "colour of a spectrum", found, "380 to 780 nm"});
}

Matrix3 inverse(const Matrix3& m) {
  Matrix3 result{};
  const auto cofactor = [&](std::size_t r, std::size_t c) {
    const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) result[c][r] = cofactor(r, c) / determinant;
  return result;
}

/// XYZ of chromaticity (x, y) at Y = 1.
std::array<double, 3> fromChromaticity(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

const std::array<double, 3> whitePoint = fromChromaticity(0.3127, 0.3290);

}  // namespace

Matrix3 linearSrgbToXyz() {
  const std::array<std::array<double, 3>, 3> primaries{fromChromaticity(0.64, 0.33), fromChromaticity(0.30, 0.60),
                                                       fromChromaticity(0.15, 0.06)};
  Matrix3 columns{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) columns[r][c] = primaries[c][r];
  // Scale the primaries so that (1, 1, 1) is the white.
  const Matrix3 solve = inverse(columns);
  Matrix3 result{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double scale = solve[c][0] * whitePoint[0] + solve[c][1] * whitePoint[1] + solve[c][2] * whitePoint[2];
    for (std::size_t r = 0; r < 3; ++r) result[r][c] = columns[r][c] * scale;
  }
  return result;
}

Matrix3 xyzToLinearSrgb() { return inverse(linearSrgbToXyz()); }

std::vector<double> luminanceWeights(std::span<const double> wavelengths) {
  std::vector<double> weights = intervals(wavelengths);
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] *= cieAt(wavelengths[i]).yBar;
  if (!normalize(weights)) failInvisible(wavelengths);
  return weights;
}

std::vector<double> rgbWeights(std::span<const double> wavelengths) {
  const std::size_t count = wavelengths.size();
  const std::vector<double> width = intervals(wavelengths);
  std::array<std::vector<double>, 3> xyz;
  for (auto& weights : xyz) weights.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const CieSample line = cieAt(wavelengths[i]);
    xyz[0][i] = width[i] * line.d65 * line.xBar;
    xyz[1][i] = width[i] * line.d65 * line.yBar;
    xyz[2][i] = width[i] * line.d65 * line.zBar;
  }
  if (!normalize(xyz[1])) failInvisible(wavelengths);
  if (!normalize(xyz[0])) xyz[0] = xyz[1];
  if (!normalize(xyz[2])) xyz[2] = xyz[1];

  const Matrix3 matrix = xyzToLinearSrgb();
  std::vector<double> rgb(3 * count);
  for (std::size_t r = 0; r < 3; ++r) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      double weight = 0;
      for (std::size_t k = 0; k < 3; ++k) weight += matrix[r][k] * whitePoint[k] * xyz[k][i];
      rgb[r * count + i] = weight;
      sum += weight;
    }
    for (std::size_t i = 0; i < count; ++i) rgb[r * count + i] /= sum;  // 1 but for rounding
  }
  return rgb;
}

double encodeSrgb(double linear) {
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 1;
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double decodeSrgb(double encoded) {
  if (!(encoded > 0)) return 0;
  if (encoded >= 1) return 1;
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace brdf
