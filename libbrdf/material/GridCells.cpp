#include <brdf/base/Parallel.h>
#include <brdf/material/GridCells.h>
#include <brdf/material/GridKernels.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace brdf {
namespace {

/// Memory for random access: in huge pages where there are any, because tables are larger than the processor's
/// translation buffers reach with small ones.
void* allocateForLookups(std::size_t bytes) {
  constexpr std::size_t page = std::size_t{2} << 20;
  const std::size_t alignment = bytes >= page ? page : 64;
  const std::size_t size = (bytes + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, size);
  if (!memory) throw std::bad_alloc();
#if defined(__linux__)
  if (bytes >= page) ::madvise(memory, size, MADV_HUGEPAGE);
#endif
  return memory;
}

}  // namespace

template <class T>
const T* GridCells::packed(Packed<T>& store) const {
  std::call_once(store.once, [&] {
    const std::size_t each = width();
    T* const memory = static_cast<T*>(allocateForLookups(cells_ * each * sizeof(T)));
    store.cells = {memory, std::free};
    parallelFor(cells_, 65536, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        T* cell = memory + i * each;
        for (std::size_t k = 0; k < each; ++k) cell[k] = k < channels_ ? static_cast<T>(values_[k * cells_ + i]) : T(0);
        cell[each - 1] = states_[i] != 0;
      }
    });
  });
  return store.cells.get();
}

template <class T>
void GridCells::interpolatePacked(const GridLocator& locator, const DirectionPairs<T>& pairs, T* values,
                                  std::uint8_t* valid) const {
  const T* const cells = packedAs(values);
  const std::size_t each = width();
  const GridKernel<T> kernel = gridKernel<T>(locator.dimensions(), each);
  // While a block waits for its cells, the next one is located.
  struct Part {
    DirectionPairs<T> pairs;
    GridLocator::Block<T> block;
    std::array<const std::int32_t*, 4> step;
    std::array<const T*, 4> weight;
  };
  std::array<Part, 2> parts;
  for (Part& part : parts)
    for (std::size_t a = 0; a < 4; ++a)
      part.step[a] = part.block.step[a].data(), part.weight[a] = part.block.weight[a].data();
  const auto begin = [&](std::size_t start, Part& part) {
    if (start >= pairs.count) return;
    part.pairs = pairs.slice(start, std::min(GridLocator::kBlock, pairs.count - start));
    locator.locate(part.pairs, part.block);
    kernel.request(cells, part.block.base.data(), part.step.data(), part.pairs.count);
  };
  alignas(64) std::array<T, 4 * GridLocator::kBlock> sums;
  begin(0, parts[0]);
  for (std::size_t start = 0, which = 0; start < pairs.count; start += GridLocator::kBlock, which = 1 - which) {
    begin(start + GridLocator::kBlock, parts[1 - which]);
    const GridLocator::Block<T>& block = parts[which].block;
    const DirectionPairs<T>& part = parts[which].pairs;
    kernel.interpolate(cells, block.base.data(), parts[which].step.data(), parts[which].weight.data(), part.count,
                       sums.data());
    std::array<T, GridLocator::kBlock> scale;
    for (std::size_t i = 0; i < part.count; ++i) {
      const T total = sums[i * each + each - 1];
      const bool above = part.wi[2][i] > 0 && part.wo[2][i] > 0, known = total > 0 && !block.outside[i];
      scale[i] = above && known ? 1 / total : T(0);
      if (valid) valid[start + i] = known || !above;
    }
    for (std::size_t channel = 0; channel < channels_; ++channel) {
      T* const out = values + channel * pairs.count + start;
      for (std::size_t i = 0; i < part.count; ++i) out[i] = sums[i * each + channel] * scale[i];
    }
  }
}

template <class T, int dimensions>
void GridCells::interpolatePlanar(const GridLocator& locator, const DirectionPairs<T>& pairs, T* values,
                                  std::uint8_t* valid) const {
  constexpr int corners = 1 << dimensions;
  GridLocator::Block<T> block;
  for (std::size_t start = 0; start < pairs.count; start += GridLocator::kBlock) {
    const auto part = pairs.slice(start, std::min(GridLocator::kBlock, pairs.count - start));
    locator.locate(part, block);
    for (std::size_t i = 0; i < part.count; ++i) {
      // The corners and their weights: each dimension doubles them.
      std::array<std::uint32_t, corners> cell;
      std::array<double, corners> weight;
      cell[0] = block.base[i];
      weight[0] = 1;
      for (int a = 0, have = 1; a < dimensions; ++a, have *= 2)
        for (int k = 0; k < have; ++k) {
          cell[have + k] = cell[k] + static_cast<std::uint32_t>(block.step[static_cast<std::size_t>(a)][i]);
          weight[have + k] = weight[k] * static_cast<double>(block.weight[static_cast<std::size_t>(a)][i]);
          weight[k] -= weight[have + k];
        }
      double total = 0;
      for (int k = 0; k < corners; ++k) {
        if (!states_[cell[k]]) weight[k] = 0;
        total += weight[k];
      }
      const bool above = part.wi[2][i] > 0 && part.wo[2][i] > 0, known = total > 0 && !block.outside[i];
      const double scale = above && known ? 1 / total : 0;
      for (std::size_t channel = 0; channel < channels_; ++channel) {
        const double* plane = values_ + channel * cells_;
        double sum = 0;
        for (int k = 0; k < corners; ++k) sum += weight[k] * plane[cell[k]];
        values[channel * pairs.count + start + i] = static_cast<T>(sum * scale);
      }
      if (valid) valid[start + i] = known || !above;
    }
  }
}

template <class T>
void GridCells::interpolate(const GridLocator& locator, const DirectionPairs<T>& pairs, T* values,
                            std::uint8_t* valid) const {
  if (locator.dimensions() == 0) return nearest(locator, pairs, values, valid);
  if (channels_ <= 3) return interpolatePacked(locator, pairs, values, valid);
  switch (locator.dimensions()) {
    case 1:
      return interpolatePlanar<T, 1>(locator, pairs, values, valid);
    case 2:
      return interpolatePlanar<T, 2>(locator, pairs, values, valid);
    case 3:
      return interpolatePlanar<T, 3>(locator, pairs, values, valid);
    default:
      return interpolatePlanar<T, 4>(locator, pairs, values, valid);
  }
}

template <class T>
void GridCells::nearest(const GridLocator& locator, const DirectionPairs<T>& pairs, T* values,
                        std::uint8_t* valid) const {
  GridLocator::Block<T> block;
  for (std::size_t start = 0; start < pairs.count; start += GridLocator::kBlock) {
    const auto part = pairs.slice(start, std::min(GridLocator::kBlock, pairs.count - start));
    locator.locate(part, block);
    for (std::size_t channel = 0; channel < channels_; ++channel)
      for (std::size_t i = 0; i < part.count; ++i) __builtin_prefetch(values_ + channel * cells_ + block.base[i]);
    for (std::size_t i = 0; i < part.count; ++i) {
      const bool above = part.wi[2][i] > 0 && part.wo[2][i] > 0, known = states_[block.base[i]] && !block.outside[i];
      for (std::size_t channel = 0; channel < channels_; ++channel)
        values[channel * pairs.count + start + i] =
            above && known ? static_cast<T>(values_[channel * cells_ + block.base[i]]) : T(0);
      if (valid) valid[start + i] = known || !above;
    }
  }
}

template void GridCells::interpolate(const GridLocator&, const DirectionPairs<float>&, float*, std::uint8_t*) const;
template void GridCells::interpolate(const GridLocator&, const DirectionPairs<double>&, double*, std::uint8_t*) const;
template void GridCells::nearest(const GridLocator&, const DirectionPairs<float>&, float*, std::uint8_t*) const;
template void GridCells::nearest(const GridLocator&, const DirectionPairs<double>&, double*, std::uint8_t*) const;

}  // namespace brdf
