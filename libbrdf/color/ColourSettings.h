#pragma once
#include <brdf/brdf_export.h>
#include <brdf/color/Illuminant.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace brdf {

/// Whose eye: colour-matching functions of the CIE.
enum class Observer {
  Cie1931,  ///< 2 degrees, the default: what sRGB is defined with
  Cie1964   ///< 10 degrees
};

/// What becomes of the illuminant's own colour on a display whose white is D65.
enum class Adaptation {
  Bradford,  ///< an eye adapted to the illuminant: a perfect white stays white (the default)
  None       ///< none: a perfect white has the illuminant's colour
};

/// How spectral data become colours for display; data that are colours already are not touched. The same record goes to
/// every function that makes colours (Colorimetry.h, material/ChannelView.h).
struct ColourSettings {
  /// Not set: D65 for colours, and equal energy for luminance, which fits and comparisons mean by it.
  std::optional<Illuminant> illuminant{};
  Observer observer = Observer::Cie1931;
  Adaptation adaptation = Adaptation::Bradford;

  bool operator==(const ColourSettings&) const = default;
};

/// The settings as the user writes them: on the command line, in VTK's properties.
struct ColourNames {
  std::string illuminant{};             ///< empty (not set), a name (illuminantNames()), or the path of a spectrum
  std::string observer = "2";           ///< degrees: "2" or "10"
  std::string adaptation = "bradford";  ///< or "none"

  bool operator==(const ColourNames&) const = default;
};

/// Reads them. Throws Error::Kind::Usage naming what is allowed, and what readIlluminant throws.
BRDF_EXPORT ColourSettings colourSettings(const ColourNames& names);

/// The settings for colours in words: "D65", or "A, 10-degree observer, adapted to D65 (Bradford)".
BRDF_EXPORT std::string describe(const ColourSettings& settings);

/// The observer's colour-matching functions xBar, yBar, zBar at a wavelength (nm), linear between the 5 nm of the
/// tables (CieTables.h), 0 outside 380 to 780 nm.
BRDF_EXPORT std::array<double, 3> colourMatching(Observer observer, double wavelength);

}  // namespace brdf
