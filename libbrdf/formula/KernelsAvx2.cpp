// Compiled for AVX2; see CMakeLists.txt.
#include <brdf/formula/Kernels.h>
#include <brdf/formula/KernelsX86.inl>

namespace brdf::formula {
namespace {
constexpr FunctionTable<float> kFloatFunctions = makeFunctions<float>();
constexpr FunctionTable<double> kDoubleFunctions = makeFunctions<double>();
}  // namespace
const KernelSet kKernelsAvx2 = {"avx2", &kFloats, &kDoubles, 32, &kFloatFunctions, &kDoubleFunctions};
const KernelSet kKernelsAvx2Alone = {"avx2_kernels", &kFloats, &kDoubles};
}  // namespace brdf::formula
