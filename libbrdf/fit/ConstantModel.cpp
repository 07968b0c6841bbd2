#include <brdf/base/Parallel.h>
#include <brdf/fit/ConstantModel.h>
#include <brdf/fit/StartSearch.h>
#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// Sums over the samples of one channel at a constant f.
struct ConstantSums {
  double squared = 0;    ///< residuals squared
  double gradient = 0;   ///< residual times slope
  double curvature = 0;  ///< slope squared
};

ConstantSums sumsAt(const FitData& data, std::size_t channel, double constant) {
  std::vector<ConstantSums> parts(data.chunks.size());
  parallelFor(parts.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const ResidualBlock block = data.block(data.chunks[k], channel);
      const std::vector<double> f(block.pairs.count, constant);
      std::vector<double> residual(f.size()), slope(f.size());
      block.residual(f.data(), residual.data());
      block.slope(f.data(), slope.data());
      for (std::size_t i = 0; i < f.size(); ++i) {
        parts[k].squared += residual[i] * residual[i];
        parts[k].gradient += residual[i] * slope[i];
        parts[k].curvature += slope[i] * slope[i];
      }
    }
  });
  ConstantSums sums;
  for (const ConstantSums& part : parts) {
    sums.squared += part.squared;
    sums.gradient += part.gradient;
    sums.curvature += part.curvature;
  }
  return sums;
}

/// The constant whose picture is nearest: a pixel's residual is no function of one pair's value.
ConstantModel bestConstantPicture(const FitData& picture) {
  const FitProblem problem({{findModel("Lambertian"), {}, {}, {}}}, Symmetry::Isotropic);
  JointCost cost(problem, picture, {0, picture.channels});
  const OptimizerResult result = levenbergMarquardt(cost, cost.join({}, Scales(picture.channels, 0.5)), {});
  ConstantModel model;
  for (const double albedo : cost.scalesOf(result.x)) model.values.push_back(albedo / kPi);
  model.error = std::sqrt(result.squaredError / (picture.totalWeight * static_cast<double>(picture.channels)));
  return model;
}

}  // namespace

ConstantModel bestConstant(const FitData& data) {
  if (data.pairsAResidual > 1) return bestConstantPicture(data);
  ConstantModel model;
  const FitData few = data.subset(FitData::kChunkLength);
  const std::vector<double> ones(few.samples, 1.0);
  double squared = 0;
  for (std::size_t c = 0; c < data.channels; ++c) {
    std::vector<double> constant{0};
    solveScales(few.block(few.chunks.front(), c), {ones.data()}, {false}, constant);
    ConstantSums sums = sumsAt(data, c, constant[0]);
    for (int step = 0; step < (data.metric->quadratic() ? 1 : 2) && sums.curvature > 0; ++step) {
      const double next = std::max(0.0, constant[0] - sums.gradient / sums.curvature);
      const ConstantSums there = sumsAt(data, c, next);
      if (!(there.squared < sums.squared)) break;
      constant[0] = next;
      sums = there;
    }
    model.values.push_back(constant[0]);
    squared += sums.squared;
  }
  model.error = std::sqrt(squared / (data.totalWeight * static_cast<double>(data.channels)));
  return model;
}

}  // namespace brdf
