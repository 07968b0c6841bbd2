// For processors without a set of their own: one lane at a time, by the language's own definition of each operation.
#include <brdf/formula/Kernels.h>

namespace brdf::formula {
namespace {

template <class T, Op op, int mask>
void kernel(T* dst, const T* a, const T* b, const T* c) {
  constexpr bool two = op >= Op::Add && op < Op::Copy, three = op >= Op::Select && op < Op::Copy;
  for (std::size_t i = 0; i < kLanes<T>; ++i)
    dst[i] = static_cast<T>(
        applyOp(op, a[(mask & 1) ? 0 : i], two ? b[(mask & 2) ? 0 : i] : 0, three ? c[(mask & 4) ? 0 : i] : 0));
}

template <class T, std::size_t... ops>
constexpr KernelTable<T> makeTable(std::index_sequence<ops...>) {
  return {{{kernel<T, Op(ops), 0>, kernel<T, Op(ops), 1>, kernel<T, Op(ops), 2>, kernel<T, Op(ops), 3>,
            kernel<T, Op(ops), 4>, kernel<T, Op(ops), 5>, kernel<T, Op(ops), 6>, kernel<T, Op(ops), 7>}...}};
}

using AllOps = std::make_index_sequence<static_cast<std::size_t>(Op::Count)>;
constexpr KernelTable<float> kFloats = makeTable<float>(AllOps{});
constexpr KernelTable<double> kDoubles = makeTable<double>(AllOps{});

}  // namespace

const KernelSet kKernelsGeneric = {"generic", &kFloats, &kDoubles};

}  // namespace brdf::formula
