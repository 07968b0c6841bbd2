// Body of the kernel sets. A file that includes this defines, in an unnamed namespace, `template <class T> struct Simd`
// with the vector type V, its `width` in lanes, and one static function an operation that arithmetic operators do not
// give. Keep this free of standard library code: a function compiled here for a newer instruction set must not be
// merged by the linker with one that older machines run.

namespace {

using brdf::formula::Kernel;
using brdf::formula::KernelTable;
using brdf::formula::kLanes;
using brdf::formula::Op;

template <Op op, class T>
inline typename Simd<T>::V apply(typename Simd<T>::V a, typename Simd<T>::V b, typename Simd<T>::V c) {
  using S = Simd<T>;
  using V = typename S::V;
  const V one = S::fill(1), zero = S::fill(0);
  if constexpr (op == Op::Neg)
    return -a;
  else if constexpr (op == Op::Abs)
    return S::abs(a);
  else if constexpr (op == Op::Sqrt)
    return S::sqrt(a);
  else if constexpr (op == Op::Exp)
    return S::exp(a);
  else if constexpr (op == Op::Expm1)
    return S::expm1(a);
  else if constexpr (op == Op::Log)
    return S::log(a);
  else if constexpr (op == Op::Log1p)
    return S::log1p(a);
  else if constexpr (op == Op::Sin)
    return S::sin(a);
  else if constexpr (op == Op::Cos)
    return S::cos(a);
  else if constexpr (op == Op::Tan)
    return S::tan(a);
  else if constexpr (op == Op::Asin)
    return S::asin(S::clampToOne(a));
  else if constexpr (op == Op::Acos)
    return S::acos(S::clampToOne(a));
  else if constexpr (op == Op::Atan)
    return S::atan(a);
  else if constexpr (op == Op::Sinh)
    return S::sinh(a);
  else if constexpr (op == Op::Cosh)
    return S::cosh(a);
  else if constexpr (op == Op::Tanh)
    return S::tanh(a);
  else if constexpr (op == Op::Erf)
    return S::erf(a);
  else if constexpr (op == Op::Erfc)
    return S::erfc(a);
  else if constexpr (op == Op::Lgamma)
    return S::lgamma(a);
  else if constexpr (op == Op::Digamma)
    return S::digamma(a);
  else if constexpr (op == Op::Trigamma)
    return S::each(brdf::formula::trigamma, a);
  else if constexpr (op == Op::BesselJ0)
    return S::each(brdf::formula::besselJ0, a);
  else if constexpr (op == Op::BesselJ1)
    return S::each(brdf::formula::besselJ1, a);
  else if constexpr (op == Op::BesselI0)
    return S::each(brdf::formula::besselI0, a);
  else if constexpr (op == Op::BesselI1)
    return S::each(brdf::formula::besselI1, a);
  else if constexpr (op == Op::BesselK0)
    return S::each(brdf::formula::besselK0, a);
  else if constexpr (op == Op::BesselK1)
    return S::each(brdf::formula::besselK1, a);
  else if constexpr (op == Op::Floor)
    return S::floor(a);
  else if constexpr (op == Op::Not)
    return a == zero ? one : zero;
  else if constexpr (op == Op::Add)
    return a + b;
  else if constexpr (op == Op::Sub)
    return a - b;
  else if constexpr (op == Op::Mul)
    return a * b;
  else if constexpr (op == Op::Div)
    return S::divide(a, b);
  else if constexpr (op == Op::Pow)
    return S::pow(a, b);
  else if constexpr (op == Op::Min)
    return b < a ? b : a;
  else if constexpr (op == Op::Max)
    return b > a ? b : a;
  else if constexpr (op == Op::Atan2)
    return S::atan2(a, b);
  else if constexpr (op == Op::GammaP)
    return S::each(brdf::formula::gammaP, a, b);
  else if constexpr (op == Op::GammaQ)
    return S::each(brdf::formula::gammaQ, a, b);
  else if constexpr (op == Op::GammaPDa)
    return S::each(brdf::formula::gammaPDa, a, b);
  else if constexpr (op == Op::Less)
    return a < b ? one : zero;
  else if constexpr (op == Op::LessEqual)
    return a <= b ? one : zero;
  else if constexpr (op == Op::Equal)
    return a == b ? one : zero;
  else if constexpr (op == Op::And)
    return a != zero ? (b != zero ? one : zero) : zero;
  else if constexpr (op == Op::Or)
    return a != zero ? one : (b != zero ? one : zero);
  else if constexpr (op == Op::Select)
    return a != zero ? b : c;
  else if constexpr (op == Op::MulAdd)
    return S::mulAdd(a, b, c);
  else if constexpr (op == Op::MulSub)
    return S::mulAdd(a, b, -c);
  else if constexpr (op == Op::NegMulAdd)
    return S::mulAdd(-a, b, c);
  else
    return a;
}

template <Op op, int mask, int operands, class T>
void kernel(T* dst, const T* a, const T* b, const T* c) {
  using S = Simd<T>;
  using V = typename S::V;
  const V sa = (mask & 1) ? S::fill(*a) : V{}, sb = (mask & 2) ? S::fill(*b) : V{}, sc = (mask & 4) ? S::fill(*c) : V{};
  for (unsigned i = 0; i < kLanes<T>; i += S::width) {
    const V va = (mask & 1) ? sa : S::load(a + i);
    const V vb = operands < 2 ? va : (mask & 2) ? sb : S::load(b + i);
    const V vc = operands < 3 ? va : (mask & 4) ? sc : S::load(c + i);
    S::store(dst + i, apply<op, T>(va, vb, vc));
  }
}

template <Op op, int operands, class T>
constexpr void add(KernelTable<T>& table) {
  Kernel<T>* row = table.kernels[static_cast<unsigned>(op)];
  row[0] = kernel<op, 0, operands, T>;
  row[1] = kernel<op, 1, operands, T>;
  if constexpr (operands >= 2) {
    row[2] = kernel<op, 2, operands, T>;
    row[3] = kernel<op, 3, operands, T>;
  }
  if constexpr (operands >= 3) {
    row[4] = kernel<op, 4, operands, T>;
    row[5] = kernel<op, 5, operands, T>;
    row[6] = kernel<op, 6, operands, T>;
  }
}

template <class T>
constexpr KernelTable<T> makeTable() {
  KernelTable<T> t{};
  add<Op::Neg, 1>(t), add<Op::Abs, 1>(t), add<Op::Sqrt, 1>(t), add<Op::Exp, 1>(t), add<Op::Expm1, 1>(t);
  add<Op::Log, 1>(t), add<Op::Log1p, 1>(t), add<Op::Sin, 1>(t), add<Op::Cos, 1>(t), add<Op::Tan, 1>(t);
  add<Op::Asin, 1>(t), add<Op::Acos, 1>(t), add<Op::Atan, 1>(t), add<Op::Sinh, 1>(t), add<Op::Cosh, 1>(t);
  add<Op::Tanh, 1>(t), add<Op::Erf, 1>(t), add<Op::Erfc, 1>(t), add<Op::Lgamma, 1>(t), add<Op::Digamma, 1>(t);
  add<Op::Trigamma, 1>(t), add<Op::BesselJ0, 1>(t), add<Op::BesselJ1, 1>(t), add<Op::BesselI0, 1>(t);
  add<Op::BesselI1, 1>(t), add<Op::BesselK0, 1>(t), add<Op::BesselK1, 1>(t);
  add<Op::Floor, 1>(t), add<Op::Not, 1>(t), add<Op::Copy, 1>(t);
  add<Op::Add, 2>(t), add<Op::Sub, 2>(t), add<Op::Mul, 2>(t), add<Op::Div, 2>(t), add<Op::Pow, 2>(t);
  add<Op::Min, 2>(t), add<Op::Max, 2>(t), add<Op::Atan2, 2>(t), add<Op::Less, 2>(t), add<Op::LessEqual, 2>(t);
  add<Op::GammaP, 2>(t), add<Op::GammaQ, 2>(t), add<Op::GammaPDa, 2>(t);
  add<Op::Equal, 2>(t), add<Op::And, 2>(t), add<Op::Or, 2>(t);
  add<Op::Select, 3>(t), add<Op::MulAdd, 3>(t), add<Op::MulSub, 3>(t), add<Op::NegMulAdd, 3>(t);
  return t;
}

template <Op op, class T>
typename Simd<T>::V unaryFunction(typename Simd<T>::V a) {
  return apply<op, T>(a, a, a);
}
template <Op op, class T>
typename Simd<T>::V binaryFunction(typename Simd<T>::V a, typename Simd<T>::V b) {
  return apply<op, T>(a, b, a);
}

/// The table that VectorFunction (Kernels.h) describes.
template <class T>
struct FunctionTable {
  using V = typename Simd<T>::V;
  V (*unary[static_cast<unsigned>(Op::Count)])(V);
  V (*binary[static_cast<unsigned>(Op::Count)])(V, V);
};

template <Op op, class T>
constexpr void addUnary(FunctionTable<T>& t) {
  t.unary[static_cast<unsigned>(op)] = unaryFunction<op, T>;
}
template <Op op, class T>
constexpr void addBinary(FunctionTable<T>& t) {
  t.binary[static_cast<unsigned>(op)] = binaryFunction<op, T>;
}

template <class T>
constexpr FunctionTable<T> makeFunctions() {
  FunctionTable<T> t{};
  addUnary<Op::Exp>(t), addUnary<Op::Expm1>(t), addUnary<Op::Log>(t), addUnary<Op::Log1p>(t);
  addUnary<Op::Sin>(t), addUnary<Op::Cos>(t), addUnary<Op::Tan>(t), addUnary<Op::Asin>(t);
  addUnary<Op::Acos>(t), addUnary<Op::Atan>(t), addUnary<Op::Sinh>(t), addUnary<Op::Cosh>(t);
  addUnary<Op::Tanh>(t), addUnary<Op::Erf>(t), addUnary<Op::Erfc>(t), addUnary<Op::Lgamma>(t);
  addUnary<Op::Digamma>(t), addBinary<Op::Pow>(t), addBinary<Op::Atan2>(t);
  addUnary<Op::Trigamma>(t), addUnary<Op::BesselJ0>(t), addUnary<Op::BesselJ1>(t), addUnary<Op::BesselI0>(t);
  addUnary<Op::BesselI1>(t), addUnary<Op::BesselK0>(t), addUnary<Op::BesselK1>(t);
  addBinary<Op::GammaP>(t), addBinary<Op::GammaQ>(t), addBinary<Op::GammaPDa>(t);
  return t;
}

constexpr KernelTable<float> kFloats = makeTable<float>();
constexpr KernelTable<double> kDoubles = makeTable<double>();

}  // namespace
