#pragma once
#include <brdf/fit/FitData.h>
#include <brdf/fit/FitProblem.h>
#include <brdf/fit/Optimizer.h>

#include <limits>
#include <vector>

namespace brdf {

/// Channels first .. first + count - 1 of the data.
struct ChannelRange {
  std::size_t first = 0, count = 0;
};

/// Scale factors: of lobe l in channel c (counted from the range's first) at [c * lobes + l].
using Scales = std::vector<double>;

/// Scales of a start: 0, or what the problem holds fixed.
BRDF_EXPORT Scales initialScales(const FitProblem& problem, std::size_t channels);

/// The squared error as a function of the shape alone, the scale factors solved by non-negative least squares (variable
/// projection, Golub and Pereyra 1973, on the lobes whose factor is positive). For quadratic metrics. One pass over the
/// samples gives the Gram matrix of lobes, their derivatives and the residual; everything else follows from it, and the
/// shape is evaluated once for all channels. No Jacobian of the data is kept.
class BRDF_EXPORT SeparableCost : public CostFunction {
 public:
  SeparableCost(const FitProblem& problem, const FitData& data, ChannelRange channels);

  const std::vector<double>& lower() const override { return problem_.lower(); }
  const std::vector<double>& upper() const override { return problem_.upper(); }
  double squaredError(std::span<const double> x) override;
  NormalEquations normalEquations(std::span<const double> x) override;
  double scale() const override { return zeroError_; }
  /// The soft bounds of every shape coordinate, and the start.
  SearchBox searchBox(std::span<const double> start) const override { return problem_.searchBox(start); }

  /// The scale factors at the best shape evaluated so far.
  const Scales& bestScales() const { return bestScales_; }

 private:
  struct Sums;
  /// The sums over channels that share their factors.
  Sums accumulate(std::span<const double> x, bool derivatives, ChannelRange range) const;
  NormalEquations evaluate(std::span<const double> x, bool derivatives);
  /// Moves the scales of these channels to their minimum and adds the channels to the equations.
  void project(const Sums& sums, ChannelRange range, NormalEquations& equations);

  const FitProblem& problem_;
  const FitData& data_;
  ChannelRange channels_;
  double zeroError_;
  Scales scales_;  ///< the sums are taken of the residual at these, which keeps the digits that y'y would lose
  Scales bestScales_;
  double bestError_ = std::numeric_limits<double>::infinity();
};

/// The squared error as a function of the shape and the scale factors, for any metric: x is the shape coordinates, then
/// the free scale factors, channel by channel.
class BRDF_EXPORT JointCost : public CostFunction {
 public:
  JointCost(const FitProblem& problem, const FitData& data, ChannelRange channels);

  const std::vector<double>& lower() const override { return lower_; }
  const std::vector<double>& upper() const override { return upper_; }
  double squaredError(std::span<const double> x) override;
  NormalEquations normalEquations(std::span<const double> x) override;
  double scale() const override { return zeroError_; }
  /// As in the separable cost; a scale factor from 0 to ten times the largest that its lobe has at the start (any lobe
  /// where that is 0, 1 where all are): hard upper bounds they have none.
  SearchBox searchBox(std::span<const double> start) const override;

  std::vector<double> join(std::span<const double> shape, const Scales& scales) const;
  Scales scalesOf(std::span<const double> x) const;
  /// The lobe and the channel (counted from the range's first) of each scale factor in x, in order.
  const std::vector<std::pair<std::size_t, std::size_t>>& freeScales() const { return freeScales_; }

 private:
  const FitProblem& problem_;
  const FitData& data_;
  ChannelRange channels_;
  double zeroError_;
  std::vector<double> lower_, upper_;
  std::vector<std::pair<std::size_t, std::size_t>> freeScales_;
};

}  // namespace brdf
