// Body of the kernel sets of GridKernels.h. Keep this free of standard library code: a function compiled here for a
// newer instruction set must not be merged by the linker with one that older machines run.

namespace {

using brdf::GridKernelTable;
using Index = std::uint32_t;

template <class T, int width>
using Vector [[gnu::vector_size(width * sizeof(T)), gnu::may_alias]] = T;

/// One axis after the other, the last one outermost.
template <class T, int dimensions, int width>
struct Interpolant {
  [[gnu::always_inline]] static inline void at(const T* cells, const Index* step, const T* weight, Index cell,
                                               Vector<T, width>& result) {
    Vector<T, width> high;
    Interpolant<T, dimensions - 1, width>::at(cells, step, weight, cell, result);
    Interpolant<T, dimensions - 1, width>::at(cells, step, weight, cell + step[dimensions - 1], high);
    result += weight[dimensions - 1] * (high - result);
  }
};
template <class T, int width>
struct Interpolant<T, 0, width> {
  [[gnu::always_inline]] static inline void at(const T* cells, const Index*, const T*, Index cell,
                                               Vector<T, width>& result) {
    result = *reinterpret_cast<const Vector<T, width>*>(cells + static_cast<std::size_t>(cell) * width);
  }
};

template <class T, int dimensions, int width>
void kernel(const T* cells, const std::uint32_t* base, const std::int32_t* const* step, const T* const* weight,
            std::size_t count, T* out) {
  // Corners are asked for some pairs ahead, so that the cache misses of the pairs overlap.
  constexpr std::size_t ahead = 32;
  const auto ask = [&](std::size_t i) {
    for (int k = 0; k < 1 << dimensions; ++k) {
      Index cell = base[i];
      for (int a = 0; a < dimensions; ++a)
        if (k >> a & 1) cell += static_cast<Index>(step[a][i]);
      __builtin_prefetch(cells + static_cast<std::size_t>(cell) * width);
    }
  };
  for (std::size_t i = 0; i < (count < ahead ? count : ahead); ++i) ask(i);
  for (std::size_t i = 0; i < count; ++i) {
    if (i + ahead < count) ask(i + ahead);
    Index steps[dimensions];
    T weights[dimensions];
    for (int a = 0; a < dimensions; ++a) {
      steps[a] = static_cast<Index>(step[a][i]);
      weights[a] = weight[a][i];
    }
    Vector<T, width> sum;
    Interpolant<T, dimensions, width>::at(cells, steps, weights, base[i], sum);
    *reinterpret_cast<Vector<T, width>*>(out + i * width) = sum;
  }
}

template <class T>
constexpr GridKernelTable<T> makeTable() {
  return {{{kernel<T, 1, 2>, kernel<T, 1, 4>},
           {kernel<T, 2, 2>, kernel<T, 2, 4>},
           {kernel<T, 3, 2>, kernel<T, 3, 4>},
           {kernel<T, 4, 2>, kernel<T, 4, 4>}}};
}

}  // namespace
