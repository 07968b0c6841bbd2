#pragma once
#include <brdf/brdf_export.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// A light by its relative spectral power over the visible range, 380 to 780 nm.
struct Illuminant {
  std::string name;                 ///< "D65", or the path of a file
  std::vector<double> wavelengths;  ///< nanometres, ascending, at most 5 nm apart
  std::vector<double> power;        ///< in any unit, at each of them; linear between them, 0 outside
  /// Whether the power varies little within some 10 nm: then light and reflectance may be sampled at the same
  /// wavelengths. Lamps with lines must be summed line by line (Colorimetry.h).
  bool smooth = true;

  BRDF_EXPORT double at(double wavelength) const;
  bool operator==(const Illuminant&) const = default;
};

/// Names that illuminantNamed takes: E, A, D50, D55, D65, D75, F2, F7, F11.
BRDF_EXPORT std::span<const std::string_view> illuminantNames();

/// An illuminant of the CIE; A and the daylights are 100 at 560 nm. Throws Error::Kind::Value.
/// - E: equal energy, 1.
/// - A: Planck's law at 2848 K with c2 = 1.435e-2 m K (ISO/CIE 11664-2; CIE 15:2004, section 3.1).
/// - D50, D55, D75: daylight(5000, 5500, 7500 K times 1.4388 / 1.4380: the temperature scale changed after the names).
/// - D65: the standard's table (CieTables.h), which daylight() of 6500 K agrees with to 0.001.
/// - F2, F7, F11: the table of CIE 15:2004 (CieTables.h).
BRDF_EXPORT Illuminant illuminantNamed(std::string_view name);

/// CIE daylight S0 + M1 S1 + M2 S2 of a correlated colour temperature in kelvin, 4000 to 25000, every 5 nm (CIE
/// 15:2004, section 3.1: chromaticity, factors rounded to three decimals, and the table of components). Throws
/// Error::Kind::Value outside the range.
BRDF_EXPORT Illuminant daylight(double temperature);

/// A spectrum of the user's: text of two columns, wavelength (nm, strictly ascending) and power (any unit, at least 0),
/// separated by blanks, a comma, a semicolon or a tab; '#' starts a comment. Throws Error::Kind::File, Kind::Format
/// with the line, and Kind::Value when there is no power between 380 and 780 nm.
BRDF_EXPORT Illuminant readIlluminant(const std::filesystem::path& path);

/// The same from text; `where` names it in errors.
BRDF_EXPORT Illuminant parseIlluminant(std::string_view text, const std::string& where);

}  // namespace brdf
