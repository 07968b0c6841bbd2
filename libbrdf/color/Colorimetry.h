#pragma once
#include <brdf/brdf_export.h>

#include <array>
#include <span>
#include <vector>

namespace brdf {

using Matrix3 = std::array<std::array<double, 3>, 3>;  ///< rows first

/// Weights w, one for each wavelength (nanometres, ascending), summing to 1: the luminance of a spectral BRDF f under
/// equal-energy light is sum(w f) = sum(f yBar) / sum(yBar), yBar the CIE 1931 2-degree table. Where the wavelengths
/// are unevenly spaced each also counts by its share of the spectrum (half way to its neighbours). Throws
/// Error::Kind::Value when none of the wavelengths is visible (380 to 780 nm).
BRDF_EXPORT std::vector<double> luminanceWeights(std::span<const double> wavelengths);

/// Weights that map a spectral reflectance to linear sRGB under D65: row r (red, green, blue) for wavelength i at
/// `[r * n + i]`. Tristimulus values are taken relative to those of a perfect white over the same wavelengths and
/// illuminant (so that gaps and a short range do not tint it), then go through the sRGB matrix: every row sums to 1,
/// and a white (f = 1 everywhere) is (1, 1, 1) exactly. Colours outside the sRGB gamut get negative components, which
/// are kept. Where the wavelengths do not reach xBar or zBar, yBar stands in. Throws as luminanceWeights does.
BRDF_EXPORT std::vector<double> rgbWeights(std::span<const double> wavelengths);

/// CIE XYZ (white Y = 1) to linear sRGB, from the primaries and white point of IEC 61966-2-1 (ITU-R BT.709-6):
/// R (0.64, 0.33), G (0.30, 0.60), B (0.15, 0.06), white (0.3127, 0.3290).
BRDF_EXPORT Matrix3 xyzToLinearSrgb();
/// The inverse of xyzToLinearSrgb.
BRDF_EXPORT Matrix3 linearSrgbToXyz();

/// Luminance of linear sRGB: these are the weights of ITU-R BT.709-6.
constexpr std::array<double, 3> kRgbLuminanceWeights{0.2126, 0.7152, 0.0722};
constexpr double luminance(double red, double green, double blue) {
  return kRgbLuminanceWeights[0] * red + kRgbLuminanceWeights[1] * green + kRgbLuminanceWeights[2] * blue;
}

/// The sRGB transfer function (IEC 61966-2-1): a linear component to a display value, both 0 to 1; values outside are
/// clamped, NaN becomes 0.
BRDF_EXPORT double encodeSrgb(double linear);
/// The inverse of encodeSrgb.
BRDF_EXPORT double decodeSrgb(double encoded);

}  // namespace brdf
