#include <brdf/simulate/gpu/BoxTree.h>

#include <algorithm>
#include <numeric>

namespace brdf {
namespace {

constexpr std::size_t kLeaf = 4;  ///< primitives at most
constexpr std::size_t kBins = 16;
constexpr int kHalvesFrom = 20;  ///< depth; 2^24 primitives are then 24 halvings from single ones

struct Builder {
  std::span<const FloatBox> boxes;
  std::vector<std::uint32_t>& order;
  std::vector<std::array<float, 4>> nodes{};

  float centre(std::uint32_t k, std::size_t axis) const { return 0.5F * (boxes[k].least[axis] + boxes[k].most[axis]); }

  FloatBox boxOf(std::size_t first, std::size_t last) const {
    FloatBox box;
    for (std::size_t k = first; k < last; ++k) box.add(boxes[order[k]]);
    return box;
  }

  /// Where to part [first, last): the index of the second part's first.
  std::size_t part(std::size_t first, std::size_t last, int depth) {
    std::array<float, 3> least{1e30F, 1e30F, 1e30F}, most{-1e30F, -1e30F, -1e30F};
    for (std::size_t k = first; k < last; ++k)
      for (std::size_t a = 0; a < 3; ++a) {
        least[a] = std::min(least[a], centre(order[k], a));
        most[a] = std::max(most[a], centre(order[k], a));
      }
    std::size_t longest = 0;
    for (std::size_t a = 1; a < 3; ++a)
      if (most[a] - least[a] > most[longest] - least[longest]) longest = a;
    const auto begin = order.begin();
    const auto at = [&](std::size_t k) { return begin + static_cast<std::ptrdiff_t>(k); };
    const std::size_t middle = (first + last) / 2;
    const auto halve = [&] {
      std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(centre(a, longest), a) < std::pair(centre(b, longest), b);
      });
      return middle;
    };
    if (depth >= kHalvesFrom || !(most[longest] > least[longest])) return halve();

    float best = 1e38F;
    std::size_t bestAxis = longest, bestBin = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      if (!(most[a] > least[a])) continue;
      std::array<FloatBox, kBins> bins{};
      std::array<std::size_t, kBins> counts{};
      for (std::size_t k = first; k < last; ++k) {
        const std::size_t bin = binOf(centre(order[k], a), least[a], most[a]);
        bins[bin].add(boxes[order[k]]);
        ++counts[bin];
      }
      std::array<float, kBins> after{};
      FloatBox box;
      std::size_t count = 0;
      for (std::size_t b = kBins; b-- > 1;) {
        box.add(bins[b]);
        count += counts[b];
        after[b - 1] = box.area() * static_cast<float>(count);
      }
      box = {};
      count = 0;
      for (std::size_t b = 0; b + 1 < kBins; ++b) {
        box.add(bins[b]);
        count += counts[b];
        const float cost = box.area() * static_cast<float>(count) + after[b];
        if (count > 0 && count < last - first && cost < best) {
          best = cost;
          bestAxis = a;
          bestBin = b;
        }
      }
    }
    if (best == 1e38F) return halve();
    const auto split = std::partition(at(first), at(last), [&](std::uint32_t k) {
      return binOf(centre(k, bestAxis), least[bestAxis], most[bestAxis]) <= bestBin;
    });
    return static_cast<std::size_t>(split - begin);
  }

  static std::size_t binOf(float value, float least, float most) {
    const float place = (value - least) / (most - least) * static_cast<float>(kBins);
    return std::min(static_cast<std::size_t>(std::max(place, 0.0F)), kBins - 1);
  }

  /// Writes one child of a node.
  void child(std::size_t node, std::size_t side, std::size_t first, std::size_t last, int depth) {
    FloatBox box = boxOf(first, last);
    if (first == last) box.least = box.most = {1e30F, 1e30F, 1e30F};  // no ray reaches that far
    const bool leaf = last - first <= kLeaf;
    const std::size_t link = leaf ? first : make(first, last, depth + 1);
    const std::size_t at = 4 * node + 2 * side;
    nodes[at] = {box.least[0], box.least[1], box.least[2], static_cast<float>(link)};
    nodes[at + 1] = {box.most[0], box.most[1], box.most[2], leaf ? static_cast<float>(last - first) : 0.0F};
  }

  std::size_t make(std::size_t first, std::size_t last, int depth) {
    const std::size_t node = nodes.size() / 4;
    nodes.resize(nodes.size() + 4);
    const std::size_t split = last - first > 1 ? part(first, last, depth) : last;
    child(node, 0, first, split, depth);
    child(node, 1, split, last, depth);
    return node;
  }
};

}  // namespace

void FloatBox::add(const FloatBox& other) {
  for (std::size_t a = 0; a < 3; ++a) {
    least[a] = std::min(least[a], other.least[a]);
    most[a] = std::max(most[a], other.most[a]);
  }
}

float FloatBox::area() const {
  if (least[0] > most[0]) return 0;
  const float x = most[0] - least[0], y = most[1] - least[1], z = most[2] - least[2];
  return x * y + y * z + z * x;
}

std::vector<std::array<float, 4>> makeBoxTree(std::span<const FloatBox> boxes, std::vector<std::uint32_t>& order) {
  order.resize(boxes.size());
  std::iota(order.begin(), order.end(), 0U);
  Builder builder{boxes, order};
  builder.make(0, boxes.size(), 0);
  return std::move(builder.nodes);
}

}  // namespace brdf
