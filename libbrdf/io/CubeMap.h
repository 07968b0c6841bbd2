#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>

#include <cstddef>
#include <vector>

namespace brdf {

/// A cube map with its mip levels, as OpenGL takes it: six faces in the order +x, -x, +y, -y, +z, -z, each size x size
/// texels of R, G, B, 1 (linear), the first row at texture coordinate t = 0 (OpenGL 4.6 specification, table 8.19).
/// The texels of a level hold means over their solid angle, so that every level has the same total power.
class BRDF_EXPORT CubeMap {
 public:
  /// One resolution: 6 * size * size texels of four floats.
  struct Level {
    std::size_t size = 0;
    std::vector<float> texels;

    explicit Level(std::size_t n) : size(n), texels(6 * n * n * 4) {}
    float* texel(std::size_t face, std::size_t row, std::size_t column) {
      return texels.data() + 4 * ((face * size + row) * size + column);
    }
    const float* texel(std::size_t face, std::size_t row, std::size_t column) const {
      return texels.data() + 4 * ((face * size + row) * size + column);
    }
    const float* face(std::size_t index) const { return texel(index, 0, 0); }
  };

  /// The mip chain of `finest`, whose size is a power of two, down to one texel a face: each coarser texel is the mean
  /// of its four children weighted by solid angle.
  static CubeMap withMipLevels(Level finest);
  /// Without mip levels.
  static CubeMap single(Level level);

  const std::vector<Level>& levels() const { return levels_; }

  /// Direction (not normalised) through the point (s, t), each in [0, 1], of a face.
  static Direction direction(std::size_t face, double s, double t);
  /// Solid angle in sr of the texel at `row`, `column` of any face of `size` texels.
  static double solidAngle(std::size_t size, std::size_t row, std::size_t column);
  /// Integral of radiance over the sphere, from one level: R, G, B.
  std::vector<double> totalPower(std::size_t level) const;

 private:
  std::vector<Level> levels_;
};

}  // namespace brdf
