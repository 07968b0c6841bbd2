// Compiled for AVX512; see CMakeLists.txt.
#include <brdf/formula/Kernels.h>
#include <brdf/formula/KernelsX86.inl>

namespace brdf::formula {
const KernelSet kKernelsAvx512 = {"avx512", &kFloats, &kDoubles};
}
