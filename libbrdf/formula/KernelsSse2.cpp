// Compiled for SSE2; see CMakeLists.txt.
#include <brdf/formula/Kernels.h>
#include <brdf/formula/KernelsX86.inl>

namespace brdf::formula {
const KernelSet kKernelsSse2 = {"sse2", &kFloats, &kDoubles};
}
