#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/color/Colorimetry.h>

#include <algorithm>
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

const std::array<double, 3> kDisplayWhite = fromChromaticity(0.3127, 0.3290);

Matrix3 product(const Matrix3& a, const Matrix3& b) {
  Matrix3 result{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k) result[r][c] += a[r][k] * b[k][c];
  return result;
}

std::array<double, 3> product(const Matrix3& m, const std::array<double, 3>& v) {
  std::array<double, 3> result{};
  for (std::size_t r = 0; r < 3; ++r) result[r] = m[r][0] * v[0] + m[r][1] * v[1] + m[r][2] * v[2];
  return result;
}

const Illuminant& lightOf(const ColourSettings& settings) {
  static const Illuminant d65 = illuminantNamed("D65");
  return settings.illuminant ? *settings.illuminant : d65;
}

/// Light and eye are the ones that sRGB itself is defined with.
bool isDisplays(const ColourSettings& settings) {
  return settings.observer == Observer::Cie1931 && lightOf(settings) == lightOf({});
}

/// Calls `add(i, weight)` for the wavelengths (ascending) that `wavelength` lies between, or the nearest at the ends.
template <class Add>
void distribute(std::span<const double> wavelengths, double wavelength, Add add) {
  const auto above = std::ranges::upper_bound(wavelengths, wavelength);
  const auto i = static_cast<std::size_t>(above - wavelengths.begin());
  if (i == 0 || i == wavelengths.size()) return add(i == 0 ? 0 : i - 1, 1.0);
  const double t = (wavelength - wavelengths[i - 1]) / (wavelengths[i] - wavelengths[i - 1]);
  add(i - 1, 1 - t);
  add(i, t);
}

/// For each wavelength its share in the sums over light times xBar, yBar, zBar.
std::array<std::vector<double>, 3> shares(std::span<const double> wavelengths, const Illuminant& light,
                                          Observer observer) {
  std::array<std::vector<double>, 3> xyz;
  for (auto& weights : xyz) weights.resize(wavelengths.size());
  if (light.smooth) {
    const std::vector<double> width = intervals(wavelengths);
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
      const auto matching = colourMatching(observer, wavelengths[i]);
      const double power = width[i] * light.at(wavelengths[i]);
      for (std::size_t k = 0; k < 3; ++k) xyz[k][i] = power * matching[k];
    }
    return xyz;
  }
  if (std::ranges::none_of(wavelengths, [](double w) { return w >= 380 && w <= 780; })) return xyz;
  const std::vector<double> width = intervals(light.wavelengths);
  for (std::size_t j = 0; j < light.wavelengths.size(); ++j) {
    const auto matching = colourMatching(observer, light.wavelengths[j]);
    distribute(wavelengths, light.wavelengths[j], [&](std::size_t i, double weight) {
      for (std::size_t k = 0; k < 3; ++k) xyz[k][i] += weight * width[j] * light.power[j] * matching[k];
    });
  }
  return xyz;
}

/// The shares, each of the three summing to 1.
std::array<std::vector<double>, 3> relativeToWhite(std::span<const double> wavelengths,
                                                   const ColourSettings& settings) {
  auto xyz = shares(wavelengths, lightOf(settings), settings.observer);
  if (!normalize(xyz[1])) failInvisible(wavelengths);
  if (!normalize(xyz[0])) xyz[0] = xyz[1];
  if (!normalize(xyz[2])) xyz[2] = xyz[1];
  return xyz;
}

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
    const double scale =
        solve[c][0] * kDisplayWhite[0] + solve[c][1] * kDisplayWhite[1] + solve[c][2] * kDisplayWhite[2];
    for (std::size_t r = 0; r < 3; ++r) result[r][c] = columns[r][c] * scale;
  }
  return result;
}

Matrix3 xyzToLinearSrgb() { return inverse(linearSrgbToXyz()); }

std::array<double, 3> whitePoint(const ColourSettings& settings) {
  if (isDisplays(settings)) return kDisplayWhite;
  const Illuminant& light = lightOf(settings);
  const std::vector<double> width = intervals(light.wavelengths);
  std::array<double, 3> sum{};
  for (std::size_t j = 0; j < light.wavelengths.size(); ++j) {
    const auto matching = colourMatching(settings.observer, light.wavelengths[j]);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += width[j] * light.power[j] * matching[k];
  }
  return {sum[0] / sum[1], 1, sum[2] / sum[1]};
}

Matrix3 bradford(const std::array<double, 3>& from, const std::array<double, 3>& to) {
  constexpr Matrix3 cones{{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
  const auto before = product(cones, from), after = product(cones, to);
  Matrix3 scaled = cones;
  for (std::size_t r = 0; r < 3; ++r)
    for (double& entry : scaled[r]) entry *= after[r] / before[r];
  return product(inverse(cones), scaled);
}

std::vector<double> luminanceWeights(std::span<const double> wavelengths, const ColourSettings& settings) {
  static const Illuminant equalEnergy = illuminantNamed("E");
  auto xyz = shares(wavelengths, settings.illuminant ? *settings.illuminant : equalEnergy, settings.observer);
  if (!normalize(xyz[1])) failInvisible(wavelengths);
  return std::move(xyz[1]);
}

std::vector<double> xyzWeights(std::span<const double> wavelengths, const ColourSettings& settings) {
  const auto xyz = relativeToWhite(wavelengths, settings);
  const auto white = whitePoint(settings);
  std::vector<double> weights;
  weights.reserve(3 * wavelengths.size());
  for (std::size_t k = 0; k < 3; ++k)
    for (const double share : xyz[k]) weights.push_back(white[k] * share);
  return weights;
}

std::vector<double> rgbWeights(std::span<const double> wavelengths, const ColourSettings& settings) {
  const std::size_t count = wavelengths.size();
  const auto xyz = relativeToWhite(wavelengths, settings);
  const auto white = whitePoint(settings);
  const bool adapted = isDisplays(settings) || settings.adaptation == Adaptation::Bradford;
  Matrix3 matrix = xyzToLinearSrgb();
  if (adapted && !isDisplays(settings)) matrix = product(matrix, bradford(white, kDisplayWhite));
  std::vector<double> rgb(3 * count);
  for (std::size_t r = 0; r < 3; ++r) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      double weight = 0;
      for (std::size_t k = 0; k < 3; ++k) weight += matrix[r][k] * white[k] * xyz[k][i];
      rgb[r * count + i] = weight;
      sum += weight;
    }
    for (std::size_t i = 0; adapted && i < count; ++i) rgb[r * count + i] /= sum;  // 1 but for rounding
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
