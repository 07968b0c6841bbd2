#include <brdf/base/Error.h>
#include <brdf/material/TensorTree.h>

#include <algorithm>

namespace brdf {

TensorTree::TensorTree(int rank, std::size_t channels)
    : rank_(rank), channels_(channels), nodes_{kCell}, values_(channels, 0.0) {}

template <int rank>
std::size_t TensorTree::findOfRank(const Point& point) const {
  std::uint32_t entry = nodes_[0];
  for (int shift = 31; !(entry & kCell); --shift) {
    std::uint32_t number = 0;
    for (int i = 0; i < rank; ++i) number |= ((point[static_cast<std::size_t>(i)] >> shift) & 1u) << i;
    entry = nodes_[entry + number];
  }
  return entry & ~kCell;
}

std::size_t TensorTree::find(const Point& point) const {
  return rank_ == 3 ? findOfRank<3>(point) : findOfRank<4>(point);
}

TensorTree::Node TensorTree::divide(Node node) {
  const std::size_t first = nodes_.size(), cells = this->cells();
  if (first + children() > kMaximumNodes)
    throw Error(Error::Kind::Value,
                {"too many nodes", "tensor tree", std::to_string(first), std::to_string(kMaximumNodes)});
  nodes_.resize(first + children());
  nodes_[first] = nodes_[node];
  for (std::size_t c = 1; c < children(); ++c) nodes_[first + c] = kCell | static_cast<Node>(cells + c - 1);
  nodes_[node] = static_cast<Node>(first);
  values_.resize(values_.size() + (children() - 1) * channels_, 0.0);
  return static_cast<Node>(first);
}

void TensorTree::divideIntoGrid(Node node, int levels, std::span<const double> values) {
  fillGrid(node, levels, levels, 0, values);
}

void TensorTree::fillGrid(Node node, int levels, int total, std::size_t first, std::span<const double> values) {
  if (levels == 0) {
    this->values(cell(node))[0] = values[first];
    return;
  }
  const Node child = divide(node);
  for (std::size_t number = 0; number < children(); ++number)
    fillGrid(child + static_cast<Node>(number), levels - 1, total, first + gridOffset(number, levels, total), values);
}

std::vector<std::size_t> TensorTree::gridCells(Node node, int levels) const {
  std::vector<std::size_t> cells(std::size_t{1} << (rank_ * levels));
  listGrid(node, levels, levels, 0, cells);
  return cells;
}

void TensorTree::listGrid(Node node, int levels, int total, std::size_t first, std::vector<std::size_t>& cells) const {
  if (levels == 0) {
    cells[first] = cell(node);
    return;
  }
  for (std::size_t number = 0; number < children(); ++number)
    listGrid(child(node, number), levels - 1, total, first + gridOffset(number, levels, total), cells);
}

std::size_t TensorTree::gridOffset(std::size_t number, int levels, int total) const {
  std::size_t offset = 0;
  for (int i = 0; i < rank_; ++i)
    if (number >> i & 1u) offset += std::size_t{1} << (levels - 1 + total * (rank_ - 1 - i));
  return offset;
}

int TensorTree::uniformDepth(Node node) const {
  if (isCell(node)) return 0;
  const int depth = uniformDepth(child(node, 0));
  for (std::size_t c = 1; depth >= 0 && c < children(); ++c)
    if (uniformDepth(child(node, c)) != depth) return -1;
  return depth < 0 ? -1 : depth + 1;
}

TensorTree TensorTree::reversed(unsigned dimensions) const {
  TensorTree result = *this;
  for (std::size_t first = 1; first < nodes_.size(); first += children())
    for (std::size_t c = 0; c < children(); ++c) result.nodes_[first + c] = nodes_[first + (c ^ dimensions)];
  return result;
}

namespace {

/// A node of each tree that covers the same box; one that is a cell stays when the box gets smaller.
using Nodes = std::vector<TensorTree::Node>;

void mergeInto(TensorTree& result, TensorTree::Node to, std::span<const TensorTree> trees, const Nodes& from) {
  const auto isCell = [&](std::size_t t) { return trees[t].isCell(from[t]); };
  bool all = true;
  for (std::size_t t = 0; t < trees.size(); ++t) all = all && isCell(t);
  if (all) {
    double* values = result.values(result.cell(to));
    for (std::size_t t = 0; t < trees.size(); ++t)
      values = std::copy_n(trees[t].values(trees[t].cell(from[t])), trees[t].channels(), values);
    return;
  }
  const TensorTree::Node first = result.divide(to);
  for (std::size_t c = 0; c < result.children(); ++c) {
    Nodes next = from;
    for (std::size_t t = 0; t < trees.size(); ++t)
      if (!isCell(t)) next[t] = trees[t].child(from[t], c);
    mergeInto(result, first + static_cast<TensorTree::Node>(c), trees, next);
  }
}

}  // namespace

TensorTree TensorTree::merged(std::span<const TensorTree> trees) {
  std::size_t channels = 0;
  for (const TensorTree& tree : trees) channels += tree.channels();
  TensorTree result(trees[0].rank(), channels);
  mergeInto(result, 0, trees, Nodes(trees.size(), 0));
  return result;
}

}  // namespace brdf
