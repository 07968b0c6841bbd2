#pragma once
// The innermost loops of Program, one set an instruction set. Internal to libbrdf/formula.
#include <brdf/formula/Graph.h>

namespace brdf::formula {

/// Lanes that one kernel call covers: 512 bytes a register, so that the live registers of a lobe stay in L1.
template <class T>
inline constexpr std::size_t kLanes = 512 / sizeof(T);

/// dst[i] = op(a[i], b[i], c[i]) for kLanes<T> lanes. `dst` is aligned to 64 bytes or not, as the others; it may be one
/// of the operands. Operands that the kernel takes as scalars are read at [0] only.
template <class T>
using Kernel = void (*)(T* dst, const T* a, const T* b, const T* c);

/// kernels[op][mask]: bit k of the mask says that operand k is a scalar. Operands that are all scalars occur only for
/// Copy.
template <class T>
struct KernelTable {
  Kernel<T> kernels[static_cast<std::size_t>(Op::Count)][8];
};

/// Addresses of functions of whole vectors, V f(V) at [op], V f(V, V) at [Op::Count + op], for the operations that take
/// a call; null for the others. They have the platform's calling convention for V.
using VectorFunction = void (*)();

struct KernelSet {
  const char* name;
  const KernelTable<float>* floats;
  const KernelTable<double>* doubles;
  /// What machine code (NativeCode.h) needs: bytes of a vector, 0 where there is no machine code, and VectorFunction
  /// tables for float and double.
  std::size_t vectorBytes = 0;
  const void *floatFunctions = nullptr, *doubleFunctions = nullptr;
};

extern const KernelSet kKernelsGeneric;
#if defined(__x86_64__)
extern const KernelSet kKernelsSse2, kKernelsAvx2, kKernelsAvx512;
extern const KernelSet kKernelsAvx2Alone, kKernelsAvx512Alone;  ///< without machine code
#endif

}  // namespace brdf::formula
