#pragma once
#include <cstddef>
#include <functional>
#include <vector>

namespace brdf {

class PolarTable;

/// Draws from a density on a polar chart (x, phi) by one look-up instead of searches: kRows x kColumns cells, the
/// column of two numbers (u, v) being floor(kColumns v), the row floor(kRows (1 - sqrt(1 - u))). Rows grow thinner
/// toward u = 1, so that the long tail of a sharp peak has cells of its own; in a row every cell has the same share.
/// Within a cell the density is constant: that of row r is (2 (kRows - r) - 1) / (kRows^2 kColumns) over its extent.
struct PolarWarp {
  static constexpr std::size_t kRows = 32, kColumns = 32;
  /// For every cell, row by row, x, its extent in x, phi, its extent in phi; no extent is 0.
  std::vector<float> texels;
  double mass = 0;  ///< integral of the density per solid angle of the chart, d omega = 2 dx dphi

  /// Of `share` times the density of `table`, which may be empty, plus `more` (per solid angle of the chart, not
  /// negative), on [0, maximumX] x [0, 2 pi). A uniform part of a hundredth reaches what both miss.
  PolarWarp(const PolarTable& table, double share, double maximumX,
            const std::function<double(double x, double phi)>& more);
};

}  // namespace brdf
