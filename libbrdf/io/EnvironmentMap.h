#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/CubeMap.h>
#include <brdf/io/Image.h>

#include <array>
#include <cstdint>
#include <filesystem>

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
  /// Reads an OpenEXR or Radiance picture. Throws as readImage and the constructor do, naming the file.
  static EnvironmentMap read(const std::filesystem::path& path);

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

  /// Face size that resolves the picture: the power of two at or above width / pi, at most `maximum`.
  std::size_t faceSize(std::size_t maximum = 1024) const;
  /// Radiance as a cube map with mip levels, for `faceSize` texels a side (a power of two). Energy is kept level by
  /// level; the total power is that of the picture within 1e-3 (tests/image/EnvironmentMapTest.cpp).
  CubeMap radianceCube(std::size_t faceSize) const;
  /// Light reflected by a white Lambertian, irradiance / pi, as a cube map of `faceSize` texels a side. Interpolated
  /// linearly it is within 0.2 % of its largest value at 32 texels for the shipped maps (measured: same test); the
  /// error is largest where a small bright source rises over the horizon.
  CubeMap diffuseCube(std::size_t faceSize = 32) const;

 private:
  EnvironmentMap() = default;

  Image picture_;
  Defects defects_;
};

}  // namespace brdf
