// Compiled for AVX2; see CMakeLists.txt.
#include <brdf/formula/Kernels.h>
#include <brdf/formula/KernelsX86.inl>

namespace brdf::formula {
const KernelSet kKernelsAvx2 = {"avx2", &kFloats, &kDoubles};
}
