#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/PatchBrdf.h>
#include <brdf/material/TreeBrdf.h>

#include <memory>

namespace brdf {

// Any BRDF as its means over patches or over the cells of a tree, weighted by projected solid angle, so that reflected
// energy is kept. On all threads.

/// What averaging cost.
struct AverageReport {
  /// Estimated error of the quadrature: for an incident patch or cell the sum of the errors over the outgoing ones, of
  /// all channels, relative to what is reflected; the largest of all incident ones.
  double error = 0;
  std::size_t pairs = 0;    ///< pairs of patches, or cells at full resolution
  std::size_t invalid = 0;  ///< of those: without a valid value, now 0
};

struct PatchAverageOptions {
  /// Share of the energy reflected from an incident patch that the errors of its pairs may come to, about: midpoints of
  /// 4^4 a pair of patches, of 8^4 and so on where the last doubling changed the mean by more than an even share of it.
  double tolerance = 1e-3;
  int maximumPoints = 8;  ///< along each of the four dimensions; 16 costs up to 16 times as much
};
BRDF_EXPORT std::shared_ptr<const PatchBrdf> averageOverPatches(const Brdf& brdf, const PatchBasis& incident,
                                                                const PatchBasis& outgoing,
                                                                const PatchAverageOptions& options,
                                                                AverageReport& report);

struct TreeAverageOptions {
  int levels = 0;  ///< the finest cell is 2^-levels wide; 1 to 8 for rank 3, 1 to 6 for rank 4; 0: 6 and 5
  /// Cells are joined where no channel differs from their mean by more than this share of it (or, where the mean is
  /// small, a thousandth of this share of the mean over all cells); 0 keeps what is constant only.
  double tolerance = 0.01;
  int points = 2;  ///< midpoints along each dimension of a cell
};
/// `rank` 3 keeps what depends on the difference of the azimuths; of other BRDFs it keeps the light's azimuth 180
/// degrees. Throws Error::Kind::Value for levels out of range.
BRDF_EXPORT std::shared_ptr<const TreeBrdf> averageOverTree(const Brdf& brdf, int rank,
                                                            const TreeAverageOptions& options, AverageReport& report);

}  // namespace brdf
