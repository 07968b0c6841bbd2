#pragma once
// The innermost loops of GridCells, one set an instruction set. Internal to libbrdf/material.
#include <cstddef>
#include <cstdint>

namespace brdf {

/// For `count` pairs in packed cells of `width` numbers each. `base` is the cell below a pair on all axes; step[a]
/// leads to the next on axis a.
template <class T>
struct GridKernel {
  /// Asks the memory for the cells around each pair.
  void (*request)(const T* cells, const std::uint32_t* base, const std::int32_t* const* step, std::size_t count);
  /// The multilinear interpolant, out[i * width + k]; weight[a] is the weight of the next cell on axis a.
  void (*interpolate)(const T* cells, const std::uint32_t* base, const std::int32_t* const* step,
                      const T* const* weight, std::size_t count, T* out);
};

/// The best kernel for this machine (formula::instructionSet()): 1 to 4 dimensions, width 2 or 4.
template <class T>
GridKernel<T> gridKernel(std::size_t dimensions, std::size_t width);

template <class T>
struct GridKernelTable {
  GridKernel<T> kernels[4][2];  ///< [dimensions - 1][width == 4]
};
extern const GridKernelTable<float> kGridFloats;
extern const GridKernelTable<double> kGridDoubles;
#if defined(__x86_64__)
extern const GridKernelTable<float> kGridFloatsAvx2;
extern const GridKernelTable<double> kGridDoublesAvx2;
#endif

}  // namespace brdf
