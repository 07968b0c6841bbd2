#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace brdf {

/// Radiance by direction on the square of the octahedral projection, with coarser and coarser levels, as one picture
/// that any bilinear 2-D texture unit can read.
///
/// Projection (E. Praun and H. Hoppe, "Spherical parametrization and remeshing", SIGGRAPH 2003): d / (|x| + |y| + |z|)
/// lies on the octahedron; its upper half (y >= 0) is seen from above, (x, z), its lower half folded outward over the
/// edges of that diamond. (u, v) = ((x, z) + 1) / 2 is in [0, 1]^2, the zenith in the middle, the nadir in all corners.
/// A texel of side 2 / n of the square [-1, 1]^2 covers (2 / n)^2 (|x| + |y| + |z|)^3 steradian, d being unit: between
/// 1 and 5.2 times (2 / n)^2.
///
/// Levels: n x n texels of R, G, B, 1 (linear), then n/2, n/4, ... 1, each the mean over solid angle of its four
/// children, so that every level has the same total power. Around each level lies a border of one texel that continues
/// it across the folded edges: bilinear interpolation needs no special case. In the picture the finest level is at
/// (0, 0); level k >= 1 at (n + 2, n - 2 n_k + 2 (k - 1)), n_k = n / 2^k, borders included.
class BRDF_EXPORT OctahedralMap {
 public:
  /// From the finest level: n * n texels of R, G, B, row by row (v), n a power of two.
  OctahedralMap(std::size_t size, const std::vector<float>& texels);

  std::size_t size() const { return size_; }  ///< n
  std::size_t levels() const { return levels_; }
  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  const std::vector<float>& picture() const { return picture_; }  ///< width * height * 4

  /// What a bilinear look-up reads, packed so that it is one fetch of four integers.
  struct Footprints {
    /// Levels below each other in rows of n + 1 footprints: that of level k at column and row, each in [0, n_k], is the
    /// four words from 4 ((2 (n - n_k) + k + row) (n + 1) + column) on. They hold the colours of the texels (column -
    /// 1, row - 1), (column, row - 1), (column - 1, row) and (column, row).
    std::vector<std::uint32_t> words;
    /// A word holds R, G, B in 9 bits each from the lowest on and an exponent e above: each colour is its 9 bits times
    /// 2^(e - 31) times this: within 1/256 of the largest of the three, in the mean over neighbours far nearer.
    float unit = 1;
  };
  Footprints footprints() const;

  /// The texel of a level at column and row, each in [-1, n_k] with the border.
  const float* texel(std::size_t level, std::ptrdiff_t column, std::ptrdiff_t row) const;
  /// Bilinear look-up in a unit direction, as the texture unit does it.
  std::array<double, 3> radiance(const Direction& direction, std::size_t level) const;
  /// Integral over the sphere of one level, texels of constant radiance.
  std::array<double, 3> totalPower(std::size_t level) const;

  /// Unit direction at (u, v) and back.
  static Direction direction(double u, double v);
  static std::array<double, 2> project(const Direction& direction);
  /// Solid angle in sr of a texel of an n x n level: exact.
  static double solidAngle(std::size_t n, std::size_t column, std::size_t row);

 private:
  float* texel(std::size_t level, std::ptrdiff_t column, std::ptrdiff_t row);
  void fillBorder(std::size_t level);

  std::size_t size_, levels_, width_, height_;
  std::vector<float> picture_;
};

}  // namespace brdf
