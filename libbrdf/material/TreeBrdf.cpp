#include <brdf/base/Error.h>
#include <brdf/geometry/Directions.h>
#include <brdf/geometry/DiskSquare.h>
#include <brdf/material/TreeBrdf.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr double kCosineShare = 0.1;         ///< of the draws of rank 3
constexpr std::uint32_t kMiddle = 1u << 31;  ///< 1/2 as a fixed-point coordinate
constexpr double kMirrorTolerance = 1e-9;

/// x0 of rank 3 for a sine of the incident polar angle; at the normal just below 1/2.
std::uint32_t radialCoordinate(double x, double y) {
  return std::min(TensorTree::fixedPoint(0.5 - 0.5 * std::hypot(x, y)), kMiddle - 1);
}

/// (x, y) turned by minus the azimuth of (ax, ay), which counts as 0 at the pole.
std::array<double, 2> turnedBack(double x, double y, double ax, double ay) {
  const double length = std::hypot(ax, ay);
  if (!(length > 0)) return {x, y};
  const double c = ax / length, s = ay / length;
  return {c * x + s * y, c * y - s * x};
}

void putSquare(TensorTree::Point& point, std::size_t first, double x, double y) {
  const auto square = diskToSquare(x, y);
  point[first] = TensorTree::fixedPoint(square[0]);
  point[first + 1] = TensorTree::fixedPoint(square[1]);
}

Direction lifted(double x, double y) { return {x, y, std::sqrt(std::max(0.0, 1 - x * x - y * y))}; }

/// The values on both sides of the plane of incidence, in two trees on one refinement, agree.
bool sameOnBothSides(const TensorTree& tree) {
  const TensorTree pair[] = {tree, tree.reversed(4)};
  const TensorTree both = TensorTree::merged(pair);
  for (std::size_t cell = 0; cell < both.cells(); ++cell)
    for (std::size_t c = 0; c < tree.channels(); ++c) {
      const double a = both.values(cell)[c], b = both.values(cell)[tree.channels() + c];
      if (std::abs(a - b) > kMirrorTolerance * std::max(std::abs(a), std::abs(b))) return false;
    }
  return true;
}

}  // namespace

TensorTree::Point treePoint(int rank, const Direction& wi, const Direction& wo) {
  TensorTree::Point point{};
  if (rank == 4) {
    putSquare(point, 0, -wi[0], -wi[1]);
    putSquare(point, 2, wo[0], wo[1]);
    return point;
  }
  point[0] = radialCoordinate(wi[0], wi[1]);
  const auto turned = turnedBack(wo[0], wo[1], -wi[0], -wi[1]);
  putSquare(point, 1, turned[0], turned[1]);
  return point;
}

TreeBrdf::TreeBrdf(TensorTree tree, Channels channels, std::string description)
    : tree_(std::move(tree)),
      channels_(std::move(channels)),
      description_(std::move(description)),
      symmetry_(Symmetry::Anisotropic) {
  if ((tree_.rank() != 3 && tree_.rank() != 4) || tree_.channels() != channels_.count())
    throw Error(Error::Kind::Value, {"wrong rank or number of channels", "tensor tree",
                                     std::to_string(tree_.rank()) + " and " + std::to_string(tree_.channels()),
                                     "3 or 4, and " + std::to_string(channels_.count())});
  magnitude_.resize(tree_.cells());
  for (std::size_t cell = 0; cell < tree_.cells(); ++cell) {
    double sum = 0;
    for (std::size_t c = 0; c < channels_.count(); ++c) {
      double& value = tree_.values(cell)[c];
      if (!std::isfinite(value)) value = 0;
      sum += std::abs(value);
    }
    magnitude_[cell] = sum / static_cast<double>(channels_.count());
  }
  if (tree_.rank() == 3) symmetry_ = sameOnBothSides(tree_) ? Symmetry::Isotropic : Symmetry::Bilateral;
}

TreeBrdf::~TreeBrdf() = default;

double TreeBrdf::largestAlbedo(std::span<const double> channelWeights) const {
  std::vector<double> weights(tree_.cells(), 0.0);
  for (std::size_t cell = 0; cell < weights.size(); ++cell)
    for (std::size_t c = 0; c < channelWeights.size(); ++c) weights[cell] += channelWeights[c] * tree_.values(cell)[c];
  const bool isotropic = tree_.rank() == 3;
  return kPi * TreeMarginal(tree_, isotropic ? 6 : 12, weights).largestMean(0, isotropic ? 0.5 : 1);
}

void TreeBrdf::evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  const std::size_t channels = channels_.count();
  if (valid) std::fill_n(valid, pairs.count, std::uint8_t{1});
  for (std::size_t k = 0; k < pairs.count; ++k) {
    const bool above = pairs.wi[2][k] > 0 && pairs.wo[2][k] > 0;
    const double* found = nullptr;
    if (above)
      found = tree_.values(tree_.find(treePoint(tree_.rank(), {pairs.wi[0][k], pairs.wi[1][k], pairs.wi[2][k]},
                                                {pairs.wo[0][k], pairs.wo[1][k], pairs.wo[2][k]})));
    for (std::size_t c = 0; c < channels; ++c) values[c * pairs.count + k] = found ? found[c] : 0;
  }
}

const TreeMarginal& TreeBrdf::sampler() const {
  // The free coordinates are those that the sampled direction has: of rank 3 the outgoing ones, the roles exchanged.
  std::call_once(
      once_, [&] { sampler_ = std::make_unique<const TreeMarginal>(tree_, tree_.rank() == 3 ? 6u : 3u, magnitude_); });
  return *sampler_;
}

void TreeBrdf::sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
                      const std::array<double*, 3>& wi, std::size_t count) const {
  const TreeMarginal& marginal = sampler();
  const bool isotropic = tree_.rank() == 3;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = wo[0][k], y = wo[1][k];
    TensorTree::Point point{};
    if (isotropic)
      point[0] = radialCoordinate(x, y);
    else
      putSquare(point, 2, x, y);
    double u0 = u[0][k];
    const bool empty = !(marginal.mean(point) > 0);
    const double cosineShare = empty ? 1 : isotropic ? kCosineShare : 0;
    if (u0 < cosineShare) {
      const double first = u0 / cosineShare, radius = std::sqrt(first), phi = 2 * kPi * u[1][k];
      wi[0][k] = radius * std::cos(phi);
      wi[1][k] = radius * std::sin(phi);
      wi[2][k] = std::sqrt(std::max(0.0, 1 - first));
      continue;
    }
    u0 = (u0 - cosineShare) / (1 - cosineShare);
    const auto square = marginal.draw(point, u0, u[1][k]);
    const auto disk = squareToDisk(square[0], square[1]);
    // Back to the surface's frame: turned by the azimuth of (-wo.x, -wo.y), or negated.
    const auto turned = isotropic ? turnedBack(disk[0], disk[1], -x, y) : std::array{-disk[0], -disk[1]};
    const Direction drawn = lifted(turned[0], turned[1]);
    for (std::size_t axis = 0; axis < 3; ++axis) wi[axis][k] = drawn[axis];
  }
}

void TreeBrdf::pdf(const DirectionPairs<double>& pairs, double* density) const {
  const TreeMarginal& marginal = sampler();
  const bool isotropic = tree_.rank() == 3;
  for (std::size_t k = 0; k < pairs.count; ++k) {
    const Direction wi{pairs.wi[0][k], pairs.wi[1][k], pairs.wi[2][k]};
    const Direction wo{pairs.wo[0][k], pairs.wo[1][k], pairs.wo[2][k]};
    density[k] = 0;
    if (!(wi[2] > 0 && wo[2] > 0)) continue;
    const TensorTree::Point point = isotropic ? treePoint(3, wo, wi) : treePoint(4, wi, wo);
    const double mean = marginal.mean(point);
    const double cosineShare = !(mean > 0) ? 1 : isotropic ? kCosineShare : 0;
    const double own = mean > 0 ? magnitude_[tree_.find(point)] / mean : 0;
    density[k] = wi[2] / kPi * (cosineShare + (1 - cosineShare) * own);
  }
}

}  // namespace brdf
