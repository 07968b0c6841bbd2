#pragma once
#include <cstddef>
#include <functional>
#include <vector>

namespace brdf {

/// A density on part of the sphere in polar coordinates x = sin^2(theta/2) and phi, constant in each cell of a grid
/// whose lines lie where the tabulated function changes. Drawing and density are exact inverses of each other.
class PolarTable {
 public:
  /// Writes the function to tabulate, not negative, at `count` points.
  using Function = std::function<void(const double* x, const double* phi, double* values, std::size_t count)>;

  PolarTable() = default;
  /// Over x in [0, maximumX] and all phi. For a function F, constant cells add sum(m d^2 / 12) to the relative variance
  /// of an estimate, m the share and d the change of log F of a cell; the lines along an axis are spaced by
  /// (m g^2)^(1/3), g = d log F, which makes that sum least, and are as many as make it `tolerance`, but at most 256
  /// by 192 and `maximumCells` in all.
  PolarTable(const Function& function, double maximumX, double tolerance, std::size_t maximumCells);

  /// Integral of the function per solid angle; 0 leaves the table empty.
  double mass() const { return mass_; }
  std::size_t cells() const { return rowEnds_.size() < 2 ? 0 : (rowEnds_.size() - 1) * (columnEnds_.size() - 1); }
  std::size_t bytes() const;

  std::size_t rows() const { return rowEnds_.empty() ? 0 : rowEnds_.size() - 1; }
  std::size_t columns() const { return columnEnds_.empty() ? 0 : columnEnds_.size() - 1; }
  /// Lines between rows in x and between columns in phi, ascending; none where the table is empty.
  const std::vector<double>& rowEnds() const { return rowEnds_; }
  const std::vector<double>& columnEnds() const { return columnEnds_; }
  /// Appends the table as texels of four floats, for shaders/brdf_sampler.glsl: for each row its two ends in x and the
  /// cumulated share of the rows at them, (x, share, next x, next share); then, row by row, each cell likewise, (phi,
  /// share of the row, next phi, next share). Neighbours share their ends exactly, so that draw and density of the
  /// rounded table are exact inverses again; cells that rounding leaves without width hold no share.
  void appendTexels(std::vector<float>& texels) const;

  /// A point from two numbers in [0, 1). The table must not be empty.
  void draw(double u, double v, double& x, double& phi) const;
  /// Density of `draw` per solid angle d omega = 2 dx dphi; 0 outside of the table.
  double density(double x, double phi) const;

 private:
  std::vector<double> rowEnds_, columnEnds_;  ///< cell ends along x and phi
  std::vector<double> rowShare_;              ///< cumulated share of the rows, 0 to 1
  std::vector<double> cellShare_;             ///< row by row, the cumulated share of the row's cells, 0 to 1
  double mass_ = 0;
};

}  // namespace brdf
