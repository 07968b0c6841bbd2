#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/geometry/Directions.h>
#include <brdf/geometry/DiskSquare.h>
#include <brdf/material/Averages.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brdf {
namespace {

constexpr double kSmallShare = 1e-3;  ///< of the mean over all cells: the least that a tolerance refers to

Direction onDisk(double u, double v) {
  const auto disk = squareToDisk(u, v);
  return {disk[0], disk[1], std::sqrt(std::max(0.0, 1 - disk[0] * disk[0] - disk[1] * disk[1]))};
}

/// The cells of the finest level: a row a cell of the incident coordinates, in it the outgoing cells, last dimension
/// fastest.
class FineCells {
 public:
  FineCells(const Brdf& brdf, int rank, int levels, int points)
      : rank_(rank),
        channels_(brdf.channels().count()),
        size_(std::size_t{1} << levels),
        points_(static_cast<std::size_t>(points)),
        rows_(rank == 3 ? size_ / 2 : size_ * size_),
        means_(rows_ * size_ * size_ * channels_, 0.0),
        errors_(rows_, 0.0),
        invalid_(rows_, 0) {
    parallelFor(rows_, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t row = first; row < last; ++row) fillRow(brdf, row);
    });
  }

  const double* cell(std::size_t index) const { return means_.data() + index * channels_; }
  std::size_t count() const { return rows_ * size_ * size_; }
  double largestError() const { return *std::max_element(errors_.begin(), errors_.end()); }
  std::size_t invalid() const { return std::accumulate(invalid_.begin(), invalid_.end(), std::size_t{0}); }
  double meanMagnitude() const {
    double sum = 0;
    for (const double mean : means_) sum += std::abs(mean);
    return sum / static_cast<double>(means_.size());
  }

 private:
  double middle(std::size_t cell, std::size_t point) const {
    return (static_cast<double>(cell) + (static_cast<double>(point) + 0.5) / static_cast<double>(points_)) /
           static_cast<double>(size_);
  }

  std::vector<Direction> lights(std::size_t row) const {
    std::vector<Direction> result;
    for (std::size_t p = 0; p < points_; ++p) {
      if (rank_ == 3) {
        const double radius = 1 - 2 * middle(row, p);
        result.push_back({-radius, 0, std::sqrt(std::max(0.0, 1 - radius * radius))});
        continue;
      }
      for (std::size_t q = 0; q < points_; ++q) {
        const Direction travel = onDisk(middle(row / size_, p), middle(row % size_, q));
        result.push_back({-travel[0], -travel[1], travel[2]});
      }
    }
    return result;
  }

  void fillRow(const Brdf& brdf, std::size_t row) {
    const std::vector<Direction> wi = lights(row);
    const std::size_t each = wi.size() * points_ * points_, count = size_ * each;
    DirectionPairBuffer<double> pairs(count);
    std::vector<double> values(count * channels_);
    std::vector<std::uint8_t> valid(count);
    double change = 0, energy = 0;
    for (std::size_t a = 0; a < size_; ++a) {
      std::size_t at = 0;
      for (std::size_t b = 0; b < size_; ++b)
        for (std::size_t p = 0; p < points_ * points_; ++p) {
          const Direction wo = onDisk(middle(a, p / points_), middle(b, p % points_));
          for (const Direction& light : wi) pairs.set(at++, light, wo);
        }
      brdf.evaluate(pairs.view(), values.data(), valid.data());
      for (std::size_t b = 0; b < size_; ++b) {
        double* means = means_.data() + ((row * size_ + a) * size_ + b) * channels_;
        std::size_t used = 0;
        for (std::size_t i = b * each; i < (b + 1) * each; ++i) used += valid[i];
        invalid_[row] += used == 0;
        for (std::size_t c = 0; c < channels_ && used > 0; ++c) {
          // The halves of the points, as the fields of a chequerboard, tell the error.
          double half[2] = {0, 0};
          std::size_t share[2] = {0, 0};
          for (std::size_t i = b * each; i < (b + 1) * each; ++i) {
            if (!valid[i]) continue;
            const std::size_t field = parity(i - b * each, wi.size());
            half[field] += values[c * count + i];
            ++share[field];
          }
          means[c] = (half[0] + half[1]) / static_cast<double>(used);
          if (share[0] > 0 && share[1] > 0)
            change += std::abs(half[0] / static_cast<double>(share[0]) - half[1] / static_cast<double>(share[1])) / 2;
          energy += std::abs(means[c]);
        }
      }
    }
    if (energy > 0) errors_[row] = change / energy;
  }

  std::size_t parity(std::size_t point, std::size_t lights) const {
    const std::size_t light = point % lights, viewer = point / lights;
    return (light / points_ + light % points_ + viewer / points_ + viewer % points_) % 2;
  }

  int rank_;
  std::size_t channels_, size_, points_, rows_;
  std::vector<double> means_;
  std::vector<double> errors_;
  std::vector<std::size_t> invalid_;
};

/// Joins fine cells into a tree.
class Joiner {
 public:
  Joiner(const FineCells& cells, int rank, int levels, std::size_t channels, double tolerance)
      : cells_(cells),
        levels_(levels),
        tolerance_(tolerance),
        floor_(kSmallShare * cells.meanMagnitude()),
        tree_(rank, channels),
        mean_(channels),
        low_(channels),
        high_(channels) {
    grow(0, levels, {});
  }
  TensorTree take() { return std::move(tree_); }

 private:
  using Corner = std::array<std::size_t, 4>;

  void grow(TensorTree::Node node, int level, const Corner& corner) {
    if (unused(corner)) return;  // the zeros of a new cell
    if (level == 0 || alike(level, corner)) {
      if (level == 0) std::copy_n(cells_.cell(index(corner)), mean_.size(), mean_.data());
      std::copy(mean_.begin(), mean_.end(), tree_.values(tree_.cell(node)));
      return;
    }
    const TensorTree::Node first = tree_.divide(node);
    for (std::size_t c = 0; c < tree_.children(); ++c) {
      Corner next = corner;
      for (std::size_t i = 0; i < static_cast<std::size_t>(tree_.rank()); ++i)
        if (c >> i & 1u) next[i] += std::size_t{1} << (level - 1);
      grow(first + static_cast<TensorTree::Node>(c), level - 1, next);
    }
  }

  bool unused(const Corner& corner) const { return tree_.rank() == 3 && corner[0] >= std::size_t{1} << (levels_ - 1); }

  std::size_t index(const Corner& corner) const {
    std::size_t result = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(tree_.rank()); ++i) result = (result << levels_) + corner[i];
    return result;
  }

  /// Whether the box is constant within the tolerance; mean_ is then its mean.
  bool alike(int level, const Corner& corner) {
    if (tree_.rank() == 3 && level == levels_) return false;  // half of the root is not used
    std::fill(mean_.begin(), mean_.end(), 0.0);
    std::fill(low_.begin(), low_.end(), HUGE_VAL);
    std::fill(high_.begin(), high_.end(), -HUGE_VAL);
    const std::size_t side = std::size_t{1} << level;
    const std::size_t outer = tree_.rank() == 4 ? side : 1;
    for (std::size_t a = 0; a < outer; ++a)
      for (std::size_t b = 0; b < side; ++b)
        for (std::size_t c = 0; c < side; ++c)
          for (std::size_t d = 0; d < side; ++d) {
            Corner at = corner;
            const std::size_t last = static_cast<std::size_t>(tree_.rank()) - 1;
            at[last] += d;
            at[last - 1] += c;
            at[last - 2] += b;
            if (outer > 1) at[0] += a;
            const double* values = cells_.cell(index(at));
            for (std::size_t channel = 0; channel < mean_.size(); ++channel) {
              mean_[channel] += values[channel];
              low_[channel] = std::min(low_[channel], values[channel]);
              high_[channel] = std::max(high_[channel], values[channel]);
            }
          }
    const double count = static_cast<double>(outer * side * side * side);
    for (std::size_t channel = 0; channel < mean_.size(); ++channel) {
      mean_[channel] /= count;
      const double allowed = tolerance_ * std::max(std::abs(mean_[channel]), floor_);
      if (high_[channel] - mean_[channel] > allowed || mean_[channel] - low_[channel] > allowed) {
        if (high_[channel] != low_[channel]) return false;
      }
      if (high_[channel] == low_[channel]) mean_[channel] = high_[channel];
    }
    return true;
  }

  const FineCells& cells_;
  int levels_;
  double tolerance_, floor_;
  TensorTree tree_;
  std::vector<double> mean_, low_, high_;
};

}  // namespace

std::shared_ptr<const TreeBrdf> averageOverTree(const Brdf& brdf, int rank, const TreeAverageOptions& options,
                                                AverageReport& report) {
  const int most = rank == 3 ? 8 : 6, levels = options.levels == 0 ? (rank == 3 ? 6 : 5) : options.levels;
  if (levels < 1 || levels > most)
    throw Error(Error::Kind::Value, {"wrong number of levels", "tensor tree of rank " + std::to_string(rank),
                                     std::to_string(levels), "1 to " + std::to_string(most)});
  const FineCells cells(brdf, rank, levels, std::max(1, options.points));
  report = {cells.largestError(), cells.count(), cells.invalid()};
  Joiner joiner(cells, rank, levels, brdf.channels().count(), options.tolerance);
  return std::make_shared<const TreeBrdf>(joiner.take(), brdf.channels(), brdf.description());
}

}  // namespace brdf
