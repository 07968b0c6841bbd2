#pragma once
#include <brdf/brdf_export.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace brdf {

/// A function on [0, 1)^n, n = 3 or 4, constant on the cells of a tree: a node is a cell, or is halved along every
/// dimension into 2^n children; bit i of a child's number says that it is the upper half of dimension i.
class BRDF_EXPORT TensorTree {
 public:
  using Node = std::uint32_t;                  ///< 0 is the root
  using Point = std::array<std::uint32_t, 4>;  ///< coordinates as fixedPoint() gives them; n are used
  static constexpr int kMaximumDepth = 31;     ///< halvings of the root
  static constexpr std::size_t kMaximumNodes = std::size_t{1} << 31;

  /// A coordinate in units of 2^-32; what is below 0 or not below 1 becomes the nearest that is within.
  static std::uint32_t fixedPoint(double x) {
    if (!(x > 0)) return 0;
    return x < 1 ? static_cast<std::uint32_t>(x * 4294967296.0) : 0xffffffffu;
  }

  /// One cell of `channels` values 0. `rank` is n.
  TensorTree(int rank, std::size_t channels);

  int rank() const { return rank_; }
  std::size_t channels() const { return channels_; }
  std::size_t children() const { return std::size_t{1} << rank_; }
  std::size_t cells() const { return values_.size() / channels_; }
  std::size_t nodes() const { return nodes_.size(); }
  bool isCell(Node node) const { return (nodes_[node] & kCell) != 0; }
  Node child(Node node, std::size_t number) const { return nodes_[node] + static_cast<Node>(number); }
  /// The index of the cell that a node is; cells are numbered in the order in which they were made.
  std::size_t cell(Node node) const { return nodes_[node] & ~kCell; }
  double* values(std::size_t cell) { return values_.data() + cell * channels_; }
  const double* values(std::size_t cell) const { return values_.data() + cell * channels_; }

  /// The cell that holds a point.
  std::size_t find(const Point& point) const;

  // ----- building: from the root on, children get made before grandchildren -----------------------------------------

  /// Makes a node that is a cell a branch, whose children are cells: the first child takes its values over, the others
  /// are 0. Returns the first. Throws Error::Kind::Value beyond kMaximumNodes.
  Node divide(Node node);
  /// Makes a node that is a cell a regular grid of 2^(n levels) cells. `values` holds as many, the last dimension
  /// fastest, one channel.
  void divideIntoGrid(Node node, int levels, std::span<const double> values);

  /// Levels below the node where all of its cells lie at the same depth; -1 where they do not.
  int uniformDepth(Node node) const;
  /// The cells below a node of uniform depth `levels` as the grid that divideIntoGrid() makes, the last dimension
  /// fastest.
  std::vector<std::size_t> gridCells(Node node, int levels) const;
  /// The same function with dimension i reversed for each bit i of `dimensions`: f(.., 1 - x_i, ..).
  TensorTree reversed(unsigned dimensions) const;
  /// The trees (of one rank) on their coarsest common refinement, the channels of all one after another.
  static TensorTree merged(std::span<const TensorTree> trees);

 private:
  static constexpr std::uint32_t kCell = 0x80000000u;
  template <int rank>
  std::size_t findOfRank(const Point& point) const;
  void fillGrid(Node node, int levels, int total, std::size_t first, std::span<const double> values);
  void listGrid(Node node, int levels, int total, std::size_t first, std::vector<std::size_t>& cells) const;
  /// What child `number` of a node with `levels` below it adds to the index of a cell in a grid of `total` levels.
  std::size_t gridOffset(std::size_t number, int levels, int total) const;

  int rank_;
  std::size_t channels_;
  std::vector<std::uint32_t> nodes_;  ///< first child, or kCell and the cell's index
  std::vector<double> values_;        ///< the channels of a cell together
};

/// The mean of a weight (>= 0, one a cell) over some dimensions of a tree, the free ones, for every node and as a
/// function of the others, the fixed ones; and draws from the conditional distribution that it is the density of.
class BRDF_EXPORT TreeMarginal {
 public:
  /// Bits of `freeDimensions` say which of the tree's are free: two of them. `tree` must outlive this.
  TreeMarginal(const TensorTree& tree, unsigned freeDimensions, std::span<const double> weights);

  /// The mean over the free dimensions where the fixed ones are those of `point`.
  double mean(const TensorTree::Point& point) const { return meanOf(0, point, 31); }
  /// The largest such mean where the coordinate of dimension `dimension`, a fixed one, is below `limit` (0 to 1).
  double largestMean(int dimension, double limit) const;

  /// Draws the free coordinates, in increasing order of dimension, in [0, 1), with density weight/mean, from two
  /// numbers in [0, 1). The mean must be positive.
  std::array<double, 2> draw(const TensorTree::Point& point, double u, double v) const;

 private:
  struct Entry {
    std::uint32_t first = 0;  ///< child; 0 for a mean
    double mean = 0;
  };
  double meanOf(TensorTree::Node node, const TensorTree::Point& point, int shift) const;
  unsigned fixedChild(const TensorTree::Point& point, int shift) const;
  std::uint32_t build(TensorTree::Node node, std::span<const double> weights);
  void average(std::span<const std::uint32_t> from, std::uint32_t to);
  double largest(std::uint32_t entry, int bit, double size, double low, double limit) const;

  const TensorTree& tree_;
  std::vector<int> free_, fixed_;     ///< dimensions
  std::vector<std::uint32_t> roots_;  ///< entry of each node of the tree
  std::vector<Entry> entries_;        ///< trees over the fixed dimensions
};

}  // namespace brdf
