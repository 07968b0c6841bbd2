#include <brdf/material/TensorTree.h>

#include <algorithm>

namespace brdf {

using Node = TensorTree::Node;

TreeMarginal::TreeMarginal(const TensorTree& tree, unsigned freeDimensions, std::span<const double> weights)
    : tree_(tree), roots_(tree.nodes()), entries_(1) {
  for (int i = 0; i < tree.rank(); ++i) (freeDimensions >> i & 1u ? free_ : fixed_).push_back(i);
  build(0, weights);
}

std::uint32_t TreeMarginal::build(Node node, std::span<const double> weights) {
  const auto own = static_cast<std::uint32_t>(entries_.size());
  if (tree_.isCell(node)) {
    entries_.push_back({0, weights[tree_.cell(node)]});
    return roots_[node] = own;
  }
  for (std::size_t c = 0; c < tree_.children(); ++c) build(tree_.child(node, c), weights);
  const auto entry = static_cast<std::uint32_t>(entries_.size());
  const auto first = entry + 1;
  const std::size_t fixedChildren = std::size_t{1} << fixed_.size();
  entries_.resize(entries_.size() + 1 + fixedChildren);
  entries_[entry].first = first;
  for (std::size_t f = 0; f < fixedChildren; ++f) {
    std::array<std::uint32_t, 4> from;
    for (std::size_t a = 0; a < 4; ++a) {
      std::size_t number = (a & 1u) << free_[0] | (a >> 1 & 1u) << free_[1];
      for (std::size_t i = 0; i < fixed_.size(); ++i) number |= (f >> i & 1u) << fixed_[i];
      from[a] = roots_[tree_.child(node, number)];
    }
    average(from, first + static_cast<std::uint32_t>(f));
  }
  return roots_[node] = entry;
}

void TreeMarginal::average(std::span<const std::uint32_t> from, std::uint32_t to) {
  bool all = true;
  double sum = 0;
  for (const std::uint32_t entry : from) {
    all = all && entries_[entry].first == 0;
    sum += entries_[entry].mean;
  }
  if (all) {
    entries_[to].mean = sum / static_cast<double>(from.size());
    return;
  }
  const auto first = static_cast<std::uint32_t>(entries_.size());
  const std::size_t fixedChildren = std::size_t{1} << fixed_.size();
  entries_.resize(entries_.size() + fixedChildren);
  entries_[to].first = first;
  for (std::size_t f = 0; f < fixedChildren; ++f) {
    std::array<std::uint32_t, 4> next;
    for (std::size_t a = 0; a < from.size(); ++a)
      next[a] = entries_[from[a]].first == 0 ? from[a] : entries_[from[a]].first + static_cast<std::uint32_t>(f);
    average(std::span(next).first(from.size()), first + static_cast<std::uint32_t>(f));
  }
}

unsigned TreeMarginal::fixedChild(const TensorTree::Point& point, int shift) const {
  unsigned number = 0;
  for (std::size_t i = 0; i < fixed_.size(); ++i)
    number |= ((point[static_cast<std::size_t>(fixed_[i])] >> shift) & 1u) << i;
  return number;
}

double TreeMarginal::meanOf(Node node, const TensorTree::Point& point, int shift) const {
  std::uint32_t entry = roots_[node];
  for (; entries_[entry].first != 0; --shift) entry = entries_[entry].first + fixedChild(point, shift);
  return entries_[entry].mean;
}

std::array<double, 2> TreeMarginal::draw(const TensorTree::Point& point, double u, double v) const {
  Node node = 0;
  double lowA = 0, lowB = 0, size = 1;
  // Takes the lower half with the share of its weight, and stretches the number over the half taken.
  const auto upper = [](double& number, double low, double high) {
    const double share = low / (low + high);
    const bool taken = !(number < share);
    number = taken ? (number - share) / (1 - share) : number / share;
    number = std::clamp(number, 0.0, 0x1.fffffffffffffp-1);
    return taken;
  };
  for (int shift = 31; !tree_.isCell(node); --shift) {
    std::array<Node, 4> child;
    std::array<double, 4> mean;
    std::size_t fixedPart = 0;
    for (const int i : fixed_)
      fixedPart |= static_cast<std::size_t>((point[static_cast<std::size_t>(i)] >> shift) & 1u) << i;
    for (std::size_t a = 0; a < 4; ++a) {
      child[a] = tree_.child(node, fixedPart | (a & 1u) << free_[0] | (a >> 1 & 1u) << free_[1]);
      mean[a] = meanOf(child[a], point, shift - 1);
    }
    const bool upperA = upper(u, mean[0] + mean[2], mean[1] + mean[3]);
    const bool upperB = upper(v, mean[upperA ? 1 : 0], mean[upperA ? 3 : 2]);
    size /= 2;
    lowA += upperA ? size : 0;
    lowB += upperB ? size : 0;
    node = child[(upperA ? 1u : 0u) + (upperB ? 2u : 0u)];
  }
  return {lowA + size * u, lowB + size * v};
}

double TreeMarginal::largestMean(int dimension, double limit) const {
  const auto bit = static_cast<int>(std::find(fixed_.begin(), fixed_.end(), dimension) - fixed_.begin());
  return largest(roots_[0], bit, 1, 0, limit);
}

double TreeMarginal::largest(std::uint32_t entry, int bit, double size, double low, double limit) const {
  if (entries_[entry].first == 0) return entries_[entry].mean;
  double most = 0;
  for (std::size_t f = 0; f < std::size_t{1} << fixed_.size(); ++f) {
    const double start = low + ((f >> bit & 1u) ? size / 2 : 0);
    if (start < limit)
      most =
          std::max(most, largest(entries_[entry].first + static_cast<std::uint32_t>(f), bit, size / 2, start, limit));
  }
  return most;
}

}  // namespace brdf
