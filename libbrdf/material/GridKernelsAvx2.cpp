// Compiled for AVX2; see CMakeLists.txt.
#include <brdf/material/GridKernels.h>

#include <brdf/material/GridKernels.inl>

namespace brdf {
extern const GridKernelTable<float> kGridFloatsAvx2 = makeTable<float>();
extern const GridKernelTable<double> kGridDoublesAvx2 = makeTable<double>();
}  // namespace brdf
