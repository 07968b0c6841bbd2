// Every operation on every instruction set, in float and double, against 50-digit arithmetic on the same operands.
#include "FormulaSupport.h"

#include <algorithm>
#include <random>

namespace brdf::formula {
namespace {

/// An operation and how far (units of the last place) its kernels may be from the exact value.
struct Accuracy {
  Op op;
  double ulps;      ///< of a double or float result; 0.5 is correct rounding
  double absolute;  ///< or this far in units of the machine epsilon, whichever is larger
  double reach;     ///< operands beyond this magnitude are not judged (but must not crash)
};

constexpr double kAll = INFINITY;

/// Quotients and roots end with a Newton step on their residual. SLEEF promises 1.0 ulp (erfc 1.5). Its lgamma is
/// judged absolutely near its zeros at 1 and 2; its log1p ends at 1e307 (1e38 in float). Sine, cosine and tangent
/// beyond 1e6 would need more digits of pi than 50-digit arithmetic leaves after reduction of a double's huge argument;
/// so would powers of negative bases to huge exponents. The reciprocals inside atan2 underflow beyond 1e37 in float.
constexpr Accuracy kAccuracies[] = {
    {Op::Neg, 0.5, 0, kAll},     {Op::Abs, 0.5, 0, kAll},   {Op::Sqrt, 0.56, 0, kAll}, {Op::Exp, 1, 0, kAll},
    {Op::Expm1, 1, 0, kAll},     {Op::Log, 1, 0, kAll},     {Op::Log1p, 1, 0, 1e37},   {Op::Sin, 1, 0, 1e6},
    {Op::Cos, 1, 0, 1e6},        {Op::Tan, 1, 0, 1e6},      {Op::Asin, 1, 0, kAll},    {Op::Acos, 1, 0, kAll},
    {Op::Atan, 1, 0, kAll},      {Op::Sinh, 1, 0, 80},      {Op::Cosh, 1, 0, 80},      {Op::Tanh, 1, 0, kAll},
    {Op::Erf, 1, 0, kAll},       {Op::Erfc, 1.5, 0, kAll},  {Op::Lgamma, 1, 1, 1e10},  {Op::Digamma, 4, 4, 1e10},
    {Op::Floor, 0.5, 0, kAll},   {Op::Not, 0.5, 0, kAll},   {Op::Add, 0.5, 0, kAll},   {Op::Sub, 0.5, 0, kAll},
    {Op::Mul, 0.5, 0, kAll},     {Op::Div, 0.501, 0, kAll}, {Op::Pow, 1, 0, kAll},     {Op::Min, 0.5, 0, kAll},
    {Op::Max, 0.5, 0, kAll},     {Op::Atan2, 1, 0, 1e30},   {Op::Less, 0.5, 0, kAll},  {Op::LessEqual, 0.5, 0, kAll},
    {Op::Equal, 0.5, 0, kAll},   {Op::And, 0.5, 0, kAll},   {Op::Or, 0.5, 0, kAll},    {Op::Trigamma, 2, 0, 1e10},
    {Op::BesselJ0, 2, 2, 1e4},   {Op::BesselJ1, 2, 2, 1e4}, {Op::BesselI0, 2, 0, 80},  {Op::BesselI1, 2, 0, 80},
    {Op::BesselK0, 2, 0, 80},    {Op::BesselK1, 2, 0, 80},  {Op::GammaP, 20, 0, 1e3},  {Op::GammaQ, 20, 0, 1e3},
    {Op::GammaPDa, 100, 1, 1e3},
};

bool isIncompleteGamma(Op op) { return op == Op::GammaP || op == Op::GammaQ || op == Op::GammaPDa; }
bool isPositiveOnly(Op op) {
  return op == Op::Lgamma || op == Op::Digamma || op == Op::Trigamma || op == Op::BesselK0 || op == Op::BesselK1 ||
         isIncompleteGamma(op);
}

/// Numbers where functions break, of both signs, as T holds them (subnormal ones in double only: float programs flush
/// them); then ordinary ones, logarithmically spread.
template <class T>
std::vector<T> operands() {
  using Limits = std::numeric_limits<T>;
  std::vector<T> values{T(0),
                        sizeof(T) == sizeof(float) ? Limits::min() : Limits::denorm_min() * 5,
                        Limits::min(),
                        T(1e-30),
                        T(1e-8),
                        T(0.25),
                        T(0.5),
                        1 - Limits::epsilon() / 2,
                        T(1),
                        1 + Limits::epsilon(),
                        T(1.5707963267948966),
                        T(2),
                        T(3.141592653589793),
                        T(8),
                        T(20),
                        T(30.5),
                        T(87),
                        T(88.5),
                        T(1e4),
                        T(1e10),
                        T(1e30),
                        Limits::max()};
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-6, 2.5);
  for (int k = 0; k < 60; ++k) values.push_back(static_cast<T>(std::pow(10.0, exponent(random))));
  const std::size_t half = values.size();
  for (std::size_t k = 0; k < half; ++k) values.push_back(-values[k]);
  return values;
}

template <class T>
struct Case {
  T a, b;
  double exact;
};

template <class T>
std::vector<Case<T>> casesOf(const Accuracy& accuracy) {
  Graph graph;
  const NodeId x = graph.input(Input::Ux), y = graph.input(Input::Uy);
  const NodeId node = graph.make(accuracy.op, x, arity(accuracy.op) > 1 ? y : 0);
  const std::vector<T> values = operands<T>();
  std::vector<Case<T>> cases;
  const auto add = [&](T a, T b) {
    if (std::fabs(a) > accuracy.reach || std::fabs(b) > accuracy.reach) return;
    if (accuracy.op == Op::Pow && a < 0 && std::fabs(b) > 1e9) return;
    if (isPositiveOnly(accuracy.op) && !(a > 0)) return;  // the language asks for a > 0
    if (isIncompleteGamma(accuracy.op) && !(b >= 0)) return;
    cases.push_back({a, b, evaluateExtended(graph, {node}, {static_cast<double>(a), static_cast<double>(b)}, {})[0]});
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (arity(accuracy.op) == 1)
      add(values[i], T(0));
    else
      for (std::size_t j = i % 3; j < values.size(); j += 3) add(values[i], values[j]);
  }
  return cases;
}

/// Worst departure over the cases, as a multiple of what is allowed; `what` names the case.
template <class T>
void expectAccurate(const Accuracy& accuracy, const std::vector<Case<T>>& cases, const std::vector<T>& got,
                    double allowedUlps, const std::string& what) {
  constexpr double epsilon = std::numeric_limits<T>::epsilon();
  double worst = 0;
  std::size_t at = 0;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    double error = ulpError(got[k], cases[k].exact) / allowedUlps;
    if (accuracy.absolute > 0)
      error = std::min(error, std::fabs(static_cast<double>(got[k]) - cases[k].exact) / (accuracy.absolute * epsilon));
    if (error > worst) worst = error, at = k;
  }
  // The exact value is itself rounded to double: half a unit for double, nothing for float.
  EXPECT_LE(worst, 1.0 + (sizeof(T) == sizeof(double) ? 0.5 / allowedUlps : 1e-6))
      << what << ": " << opName(accuracy.op) << "(" << cases[at].a << ", " << cases[at].b << ") = " << got[at]
      << " instead of " << cases[at].exact << ", " << worst * allowedUlps << " ulps";
}

template <class T>
void expectAllAccurate(const std::string& set) {
  setInstructionSet(set);
  for (const Accuracy& accuracy : kAccuracies) {
    const std::vector<Case<T>> cases = casesOf<T>(accuracy);
    std::vector<T> a, b, got(cases.size());
    for (const Case<T>& one : cases) a.push_back(one.a), b.push_back(one.b);
    const T* inputs[8] = {a.data(), b.data()};
    T* output = got.data();
    Graph graph;
    const NodeId x = graph.input(Input::Ux), y = graph.input(Input::Uy), p = graph.parameter(0);
    const bool two = arity(accuracy.op) > 1;
    const std::string what = set + (sizeof(T) == sizeof(float) ? ", float" : ", double");

    Program(graph, {graph.make(accuracy.op, x, two ? y : 0)}).run(inputs, {}, &output, cases.size());
    expectAccurate(accuracy, cases, got, accuracy.ulps, what);
    if (!two) continue;

    // One operand the same for all lanes: kernels of their own; a division is then a product with the reciprocal.
    const Program left(graph, {graph.make(accuracy.op, p, y)}), right(graph, {graph.make(accuracy.op, x, p)});
    for (const bool uniformLeft : {true, false}) {
      for (std::size_t k = 0; k < cases.size(); ++k) {
        const T* lane[8] = {&a[k], &b[k]};
        T* one = &got[k];
        const double parameter = static_cast<double>(uniformLeft ? a[k] : b[k]);
        (uniformLeft ? left : right).run(lane, std::vector{parameter}, &one, 1);
      }
      if (accuracy.op == Op::Div && !uniformLeft) {
        // Three roundings at most, where the reciprocal is a normal number.
        std::vector<Case<T>> normal;
        std::vector<T> values;
        for (std::size_t k = 0; k < cases.size(); ++k) {
          const double divisor = std::fabs(static_cast<double>(cases[k].b));
          if (divisor < 4 * std::numeric_limits<T>::min() || divisor > 0.25 / std::numeric_limits<T>::min()) continue;
          normal.push_back(cases[k]), values.push_back(got[k]);
        }
        expectAccurate(accuracy, normal, values, 1.5, what + ", uniform divisor");
      } else {
        expectAccurate(accuracy, cases, got, accuracy.ulps,
                       what + (uniformLeft ? ", first uniform" : ", second uniform"));
      }
    }
  }
  setInstructionSet(instructionSets().front());
}

class Kernels : public testing::TestWithParam<std::string> {};

TEST_P(Kernels, AreAsAccurateInDoubleAsStated) { expectAllAccurate<double>(GetParam()); }
TEST_P(Kernels, AreAsAccurateInFloatAsStated) { expectAllAccurate<float>(GetParam()); }

template <class T>
void expectSelectsAndSums(const std::string& set) {
  setInstructionSet(set);
  const std::vector<T> values = operands<T>();
  std::mt19937_64 random(5);
  std::uniform_int_distribution<std::size_t> pick(0, values.size() - 1);
  Graph graph;
  for (unsigned mask = 0; mask < 8; ++mask) {
    NodeId node[3];
    for (unsigned k = 0; k < 3; ++k)
      node[k] = (mask >> k & 1) ? graph.parameter(k) : graph.input(static_cast<Input>(k));
    const Program program(
        graph, {graph.select(node[0], node[1], node[2]), graph.add(graph.mul(node[0], node[1]), node[2]),
                graph.sub(graph.mul(node[0], node[1]), node[2]), graph.sub(node[2], graph.mul(node[0], node[1]))});
    for (int trial = 0; trial < 300; ++trial) {
      const T x[3] = {trial % 3 == 0 ? T(0) : values[pick(random)], values[pick(random)], values[pick(random)]};
      const T* inputs[8] = {&x[0], &x[1], &x[2]};
      const std::vector<double> parameters{x[0], x[1], x[2]};
      T got[4];
      T* outputs[4] = {&got[0], &got[1], &got[2], &got[3]};
      program.run(inputs, parameters, outputs, 1);
      EXPECT_EQ(got[0], x[0] != 0 ? x[1] : x[2]) << set;
      const long double product = static_cast<long double>(x[0]) * x[1], c = x[2];
      const double scale = static_cast<double>(std::fabs(product) + std::fabs(c));
      if (!(scale < 0.1 * std::numeric_limits<T>::max())) continue;
      // Fused: one rounding. Otherwise two, each at most half a unit of the largest part.
      const double allowed = scale * std::numeric_limits<T>::epsilon() + std::numeric_limits<T>::min();
      EXPECT_NEAR(got[1], static_cast<double>(product + c), allowed) << set << " mask " << mask;
      EXPECT_NEAR(got[2], static_cast<double>(product - c), allowed) << set << " mask " << mask;
      EXPECT_NEAR(got[3], static_cast<double>(c - product), allowed) << set << " mask " << mask;
    }
  }
  setInstructionSet(instructionSets().front());
}

TEST_P(Kernels, SelectAndFusedSumsWorkWithAnyOperandUniform) {
  expectSelectsAndSums<double>(GetParam());
  expectSelectsAndSums<float>(GetParam());
}

/// Infinities and NaN take the path that C's functions take, on every set.
template <class T>
void expectSpecialValues(const std::string& set) {
  setInstructionSet(set);
  const T infinity = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
  const std::vector<T> specials{infinity, -infinity, nan, T(0), T(-0.0), T(1), T(-1), T(2.5)};
  for (const Accuracy& accuracy : kAccuracies) {
    if (accuracy.op == Op::Digamma || accuracy.op == Op::Lgamma) continue;  // defined for positive finite arguments
    Graph graph;
    const Program program(graph, {graph.make(accuracy.op, graph.input(Input::Ux), graph.input(Input::Uy))});
    for (const T a : specials)
      for (const T b : specials) {
        const T* inputs[8] = {&a, &b};
        T got = 0;
        T* output = &got;
        program.run(inputs, {}, &output, 1);
        const double expected = applyOp(accuracy.op, a, b, 0);
        const bool same = std::isnan(expected) ? std::isnan(got)
                                               : std::fabs(got - static_cast<T>(expected)) <=
                                                         2 * std::numeric_limits<T>::epsilon() * std::fabs(got) ||
                                                     got == static_cast<T>(expected);
        EXPECT_TRUE(same) << set << ": " << opName(accuracy.op) << "(" << a << ", " << b << ") = " << got
                          << " instead of " << expected;
      }
  }
  setInstructionSet(instructionSets().front());
}

TEST_P(Kernels, TreatInfinitiesAndNansLikeC) {
  expectSpecialValues<double>(GetParam());
  expectSpecialValues<float>(GetParam());
}

std::vector<std::string> setNames() {
  std::vector<std::string> names;
  for (const std::string_view name : instructionSets()) names.emplace_back(name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, Kernels, testing::ValuesIn(setNames()),
                         [](const auto& set) { return set.param; });

TEST(InstructionSet, UnknownInstructionSetsAreRefusedByName) {
  try {
    setInstructionSet("mmx");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Value);
    EXPECT_NE(error.details().allowed.find("generic"), std::string::npos);
  }
  EXPECT_EQ(instructionSet(), instructionSets().front());
}

}  // namespace
}  // namespace brdf::formula
