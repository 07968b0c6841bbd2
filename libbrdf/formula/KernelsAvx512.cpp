// Compiled for AVX512; see CMakeLists.txt.
#include <brdf/formula/Kernels.h>
#include <brdf/formula/KernelsX86.inl>

namespace brdf::formula {
namespace {
constexpr FunctionTable<float> kFloatFunctions = makeFunctions<float>();
constexpr FunctionTable<double> kDoubleFunctions = makeFunctions<double>();
}  // namespace
const KernelSet kKernelsAvx512 = {"avx512", &kFloats, &kDoubles, 64, &kFloatFunctions, &kDoubleFunctions};
const KernelSet kKernelsAvx512Alone = {"avx512_kernels", &kFloats, &kDoubles};
}  // namespace brdf::formula
