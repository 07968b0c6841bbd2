#pragma once
#include <cstddef>
#include <vector>

namespace brdf {

/// What the components of a BRDF's value mean.
struct Channels {
  enum class Kind {
    Monochrome,  ///< one value, no colour
    Rgb,         ///< three values, linear sRGB primaries unless the data say otherwise
    Spectral     ///< one value for each wavelength
  };

  Kind kind = Kind::Monochrome;
  std::vector<double> wavelengths;  ///< nanometres, ascending; Spectral only

  std::size_t count() const {
    switch (kind) {
      case Kind::Rgb: return 3;
      case Kind::Spectral: return wavelengths.size();
      default: return 1;
    }
  }
  friend bool operator==(const Channels&, const Channels&) = default;

  static Channels monochrome() { return {}; }
  static Channels rgb() { return {Kind::Rgb, {}}; }
  static Channels spectral(std::vector<double> nanometres) { return {Kind::Spectral, std::move(nanometres)}; }
};

}  // namespace brdf
