#pragma once
#include <brdf/brdf_export.h>
#include <brdf/color/ColourSettings.h>

#include <array>
#include <span>
#include <vector>

namespace brdf {

using Matrix3 = std::array<std::array<double, 3>, 3>;  ///< rows first

/// Weights w, one for each wavelength (nanometres, ascending), summing to 1: the luminance of a spectral BRDF f is
/// sum(w f) = sum(S f yBar) / sum(S yBar), yBar the observer's table (CIE 1931 2-degree by default) and S the
/// illuminant, equal-energy light where none is set. Where the wavelengths are unevenly spaced each also counts by its
/// share of the spectrum (half way to its neighbours). Throws Error::Kind::Value when none of the wavelengths is
/// visible (380 to 780 nm) or lit.
///
/// That samples the light at the data's wavelengths. An illuminant that is not smooth is summed over its own
/// wavelengths instead, f being linear between the data's and constant beyond them (as with the weighting factors of
/// ASTM E308).
BRDF_EXPORT std::vector<double> luminanceWeights(std::span<const double> wavelengths,
                                                 const ColourSettings& settings = {});

/// Weights that map a spectral reflectance to tristimulus values relative to a perfect white of Y = 1: row r (X, Y, Z)
/// for wavelength i at `[r * n + i]`. They are taken relative to those of a perfect white over the same wavelengths and
/// illuminant, so that gaps and a short range do not tint it, and scaled by the illuminant's whitePoint(): every row
/// sums to its component. Where the wavelengths do not reach xBar or zBar, yBar stands in. Throws as luminanceWeights
/// does.
BRDF_EXPORT std::vector<double> xyzWeights(std::span<const double> wavelengths, const ColourSettings& settings = {});

/// Weights that map a spectral reflectance to linear sRGB for display, rows red, green, blue: xyzWeights, adapted to
/// the display's white as the settings say (bradford()), and through the sRGB matrix. Adapted, every row sums to 1, and
/// a white (f = 1 everywhere) is (1, 1, 1) but for rounding; not adapted, it has the illuminant's colour, which may lie
/// outside sRGB. Colours outside the sRGB gamut get negative components, which are kept. Throws as luminanceWeights
/// does.
BRDF_EXPORT std::vector<double> rgbWeights(std::span<const double> wavelengths, const ColourSettings& settings = {});

/// XYZ of a perfect white, Y = 1: the sums of S xBar, S yBar, S zBar over the illuminant's wavelengths. For D65 and the
/// 2-degree observer that of IEC 61966-2-1, (0.3127, 0.3290), which is the sum's to its digits.
BRDF_EXPORT std::array<double, 3> whitePoint(const ColourSettings& settings = {});

/// XYZ under an eye adapted to the white `from` to XYZ of the same appearance under `to`: the linear Bradford
/// transform, as ICC.1 annex E defines it.
BRDF_EXPORT Matrix3 bradford(const std::array<double, 3>& from, const std::array<double, 3>& to);

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
