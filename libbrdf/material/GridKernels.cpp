#include <brdf/formula/Program.h>
#include <brdf/material/GridKernels.h>

#include <brdf/material/GridKernels.inl>

namespace brdf {

const GridKernelTable<float> kGridFloats = makeTable<float>();
const GridKernelTable<double> kGridDoubles = makeTable<double>();

namespace {

bool avx2() { return formula::instructionSet() == "avx2" || formula::instructionSet() == "avx512"; }

}  // namespace

template <>
GridKernel<float> gridKernel(std::size_t dimensions, std::size_t width) {
#if defined(__x86_64__)
  if (avx2()) return kGridFloatsAvx2.kernels[dimensions - 1][width == 4];
#endif
  return kGridFloats.kernels[dimensions - 1][width == 4];
}

template <>
GridKernel<double> gridKernel(std::size_t dimensions, std::size_t width) {
#if defined(__x86_64__)
  if (avx2()) return kGridDoublesAvx2.kernels[dimensions - 1][width == 4];
#endif
  return kGridDoubles.kernels[dimensions - 1][width == 4];
}

}  // namespace brdf
