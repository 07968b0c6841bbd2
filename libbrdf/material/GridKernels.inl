// Body of the kernel sets of GridKernels.h. Keep this free of standard library code: a function compiled here for a
// newer instruction set must not be merged by the linker with one that older machines run.

namespace {

using brdf::GridKernel;
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
void request(const T* cells, const std::uint32_t* base, const std::int32_t* const* step, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    for (int k = 0; k < 1 << dimensions; ++k) {
      Index cell = base[i];
      for (int a = 0; a < dimensions; ++a)
        if (k >> a & 1) cell += static_cast<Index>(step[a][i]);
      __builtin_prefetch(cells + static_cast<std::size_t>(cell) * width, 0, 2);  // to the second-level cache
    }
}

template <class T, int dimensions, int width>
void interpolate(const T* cells, const std::uint32_t* base, const std::int32_t* const* step, const T* const* weight,
                 std::size_t count, T* out) {
  for (std::size_t i = 0; i < count; ++i) {
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

template <class T, int dimensions, int width>
constexpr GridKernel<T> both() {
  return {request<T, dimensions, width>, interpolate<T, dimensions, width>};
}

template <class T>
constexpr GridKernelTable<T> makeTable() {
  return {{{both<T, 1, 2>(), both<T, 1, 4>()},
           {both<T, 2, 2>(), both<T, 2, 4>()},
           {both<T, 3, 2>(), both<T, 3, 4>()},
           {both<T, 4, 2>(), both<T, 4, 4>()}}};
}

}  // namespace
