#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/Image.h>
#include <brdf/io/OctahedralMap.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace brdf {

/// Light from far away: radiance by direction in linear sRGB, kept as an equirectangular picture.
///
/// Orientation: the vertical is world +y. Row 0 is the zenith (+y), the last row the nadir. The middle of the picture
/// is -z, which a camera looking along -z (VTK's default) has before it; columns run to the right (+x) as seen from
/// inside, so that the left and right edges are +z. A direction d lies at
///   u = 1/2 + atan2(d.x, -d.z) / (2 pi),   v = acos(d.y) / pi,   (u, v) = (0, 0) the upper left corner.
class BRDF_EXPORT EnvironmentMap {
 public:
  using Rgb = std::array<double, 3>;

  /// Pixels with values that no light can have; those values are set to zero when a map is made.
  struct Defects {
    std::uint64_t negative = 0;
    std::uint64_t notFinite = 0;
  };

  /// Takes an equirectangular picture of 1, 3 or 4 channels (alpha is dropped). Throws Error::Kind::Value when it is
  /// not twice as wide as high.
  explicit EnvironmentMap(const Image& picture);
  /// The same radiance from everywhere.
  static EnvironmentMap constant(const Rgb& radiance);

  /// How directions lie in a picture.
  enum class Mapping {
    Equirectangular,  ///< as above
    /// Light probe of P. Debevec (1998; angmap.cal of "Rendering with Natural Light"): a direction d lies at
    /// (u, v) = r (d.x, d.y), r = acos(d.z) / (pi sqrt(d.x^2 + d.y^2)), with u and v from -1 to 1 to the right and
    /// upwards. The centre is +z, the way back to a camera that looks along -z at a mirror ball, right +x, top +y, and
    /// the whole rim of the circle -z. What is outside the circle is not used.
    Angular
  };
  /// The mapping called "equirectangular" or "angular". Throws Error::Kind::Value.
  static Mapping mapping(std::string_view name);
  /// Takes an angular map of 1, 3 or 4 channels, resampled to an equirectangular picture as high as it is: half a pixel
  /// of the angular map a texel. Throws Error::Kind::Value when it is not square.
  static EnvironmentMap fromAngular(const Image& picture);
  /// Reads an OpenEXR or Radiance picture. Throws as readImage and the constructors do, naming the file.
  static EnvironmentMap read(const std::filesystem::path& path, Mapping mapping = Mapping::Equirectangular);

  std::size_t width() const { return picture_.width; }
  std::size_t height() const { return picture_.height; }
  const Image& picture() const { return picture_; }  ///< three channels
  const Defects& defects() const { return defects_; }

  /// Radiance seen in a unit direction, interpolated bilinearly between the centres of texels.
  Rgb radiance(const Direction& direction) const;
  /// Direction of the centre of a texel.
  Direction direction(std::size_t column, std::size_t row) const;
  /// Solid angle in sr of a texel of `row`: exact.
  double solidAngle(std::size_t row) const;
  /// Integral of radiance over the sphere, every texel of constant radiance.
  Rgb totalPower() const;
  /// Irradiance of a surface facing `normal`: the sum of radiance * max(0, cosine) * solid angle over all texels.
  Rgb irradiance(const Direction& normal) const;

  /// Size of an octahedral map that resolves the picture: the power of two at or above 0.73 width (its coarsest texels
  /// are as wide as the picture's at the horizon), at most `maximum`.
  std::size_t mapSize(std::size_t maximum = 2048) const;
  /// Radiance as an octahedral map with all levels. Energy is kept level by level; the total power is that of the
  /// picture within 1e-3 (tests/image/EnvironmentMapTest.cpp).
  OctahedralMap radianceMap(std::size_t size) const;
  /// Light reflected by a white Lambertian, irradiance / pi, as a picture of R, G, B, 1: 128 columns around the
  /// vertical (column i at phi = 2 pi i / 128 - pi, from -z as above), 65 rows from pole to pole (row j at theta = pi j
  /// / 64). Interpolated bilinearly it is within 0.2 % of its largest value for the shipped maps (measured: same test);
  /// the error is largest where a small bright source rises over the horizon.
  Image diffuseMap() const;

 private:
  EnvironmentMap() = default;

  Image picture_;
  Defects defects_;
};

}  // namespace brdf
