#pragma once
#include <brdf/fit/Cost.h>

#include <vector>

namespace brdf {

/// The scale factors that minimise one channel's error at a given shape, in the metric itself: non-negative linear
/// least squares where it is quadratic, else Gauss-Newton from the better of two linear solutions. `columns`: values of
/// the lobes (1/sr) at the samples of the block; `scales`: in, the lobes held (see `held`); out, all. Returns the
/// squared error.
double solveScales(const ResidualBlock& block, const std::vector<const double*>& columns, const std::vector<bool>& held,
                   std::vector<double>& scales);

/// Scale factors of all lobes for every channel of the range at shape coordinates x, by solveScales on one chunk.
BRDF_EXPORT Scales solveScales(const FitProblem& problem, const FitData& data, ChannelRange channels,
                               std::span<const double> x);

/// The coordinates that move a lobe, as indices of problem.coordinates().
std::vector<std::size_t> coordinatesOf(const FitProblem& problem, std::size_t lobe);

/// Shapes that differ from x in the coordinates of one lobe: a low-discrepancy set over their soft bounds, 32 of one
/// coordinate, 128 of two, 256 of more.
std::vector<std::vector<double>> lowDiscrepancyShapes(const FitProblem& problem, std::size_t lobe,
                                                      const std::vector<double>& x);

struct Start {
  std::vector<double> x;
  double squaredError = 0;  ///< on the data of the scan
};

/// Starting shapes that do not depend on luck: for one lobe after the other, a low-discrepancy set of shapes over the
/// soft bounds (every coordinate finely stratified), scales solved in the metric; with several lobes the scans are
/// repeated with the others at their best. The request's own start is among the result. The best `keep` that differ,
/// best first. `data` has one channel and one chunk.
BRDF_EXPORT std::vector<Start> scanShapes(const FitProblem& problem, const FitData& data, std::size_t keep);

/// A Latin hypercube of shapes over the soft bounds (McKay, Beckman, Conover 1979); the same for the same seed
/// everywhere.
BRDF_EXPORT std::vector<std::vector<double>> latinHypercube(const FitProblem& problem, std::size_t count,
                                                            std::uint64_t seed);

}  // namespace brdf
