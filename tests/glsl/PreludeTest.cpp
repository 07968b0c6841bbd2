// Every function of formula/prelude.glsl against 50-digit arithmetic over its range. BRDF_AUDIT=1 in the environment
// prints the worst of each.
#include "ProbeSupport.h"

#include <brdf/formula/Extended.h>
#include <brdf/formula/GlslPrinter.h>
#include <brdf/formula/Graph.h>

#include <cmath>
#include <random>

namespace brdf::formula {
namespace {

/// A function, a range of its first operand (logarithmic when both ends are positive) and of its second, and the
/// worst error allowed: relative, or absolute where the function passes through zero. What prelude.glsl states.
struct Function {
  Op op;
  const char* call;
  double low, high, low2, high2;
  double relative, absolute;
};

const double kTiny = 1e-37;  // smaller results may be flushed to zero

const Function kFunctions[] = {
    {Op::Exp, "brdf_exp(x)", -87, 88, 0, 0, 3e-7, 0},
    {Op::Exp, "brdf_exp(x)", -1, 1, 0, 0, 2e-7, 0},
    {Op::Expm1, "brdf_expm1(x)", -20, 80, 0, 0, 3e-7, 0},
    {Op::Expm1, "brdf_expm1(x)", 1e-30, 1, 0, 0, 3e-7, 0},
    {Op::Expm1, "brdf_expm1(x)", -1, 0, 0, 0, 3e-7, 0},
    {Op::Log, "brdf_log(x)", 1e-37, 1e38, 0, 0, 2.5e-7, 0},
    {Op::Log, "brdf_log(x)", 0.5, 2, 0, 0, 2.5e-7, 0},
    {Op::Log1p, "brdf_log1p(x)", 1e-30, 1e30, 0, 0, 2.5e-7, 0},
    {Op::Log1p, "brdf_log1p(x)", -0.999, 0, 0, 0, 2.5e-7, 0},
    {Op::Pow, "brdf_pow(x, y)", 0.01, 100, -5, 5, 4e-6, 0},
    {Op::Pow, "brdf_pow(x, y)", 0.5, 1, 0, 100, 2e-5, 0},
    {Op::Atan, "brdf_atan(x)", 1e-30, 1e30, 0, 0, 2.5e-7, 0},
    {Op::Atan, "brdf_atan(x)", -10, 10, 0, 0, 2.5e-7, 0},
    {Op::Atan2, "brdf_atan2(x, y)", -1, 1, -1, 1, 3e-7, 0},
    {Op::Acos, "brdf_acos(x)", -1, 1, 0, 0, 4e-7, 0},
    {Op::Acos, "brdf_acos(x)", 0.999, 1, 0, 0, 4e-7, 0},
    {Op::Asin, "brdf_asin(x)", -1, 1, 0, 0, 4e-7, 0},
    {Op::Asin, "brdf_asin(x)", 1e-20, 1, 0, 0, 4e-7, 0},
    {Op::Sinh, "brdf_sinh(x)", -80, 80, 0, 0, 5e-7, 0},
    {Op::Sinh, "brdf_sinh(x)", 1e-20, 80, 0, 0, 5e-7, 0},
    {Op::Cosh, "brdf_cosh(x)", -80, 80, 0, 0, 5e-7, 0},
    {Op::Tanh, "brdf_tanh(x)", 1e-20, 30, 0, 0, 5e-7, 0},
    {Op::Erf, "brdf_erf(x)", 1e-20, 6, 0, 0, 5e-7, 0},
    {Op::Erf, "brdf_erf(x)", -4, 4, 0, 0, 5e-7, 0},
    {Op::Erfc, "brdf_erfc(x)", -4, 9, 0, 0, 3e-6, 0},
    {Op::Lgamma, "brdf_lgamma(x)", 1e-3, 1e6, 0, 0, 1e-6, 5e-6},
    {Op::Digamma, "brdf_digamma(x)", 1e-3, 1e6, 0, 0, 1e-6, 5e-6},
    {Op::Trigamma, "brdf_trigamma(x)", 1e-3, 1e6, 0, 0, 1e-6, 0},
    {Op::BesselJ0, "brdf_besselj0(x)", -50, 50, 0, 0, 0, 6e-7},
    {Op::BesselJ1, "brdf_besselj1(x)", -50, 50, 0, 0, 0, 6e-7},
    {Op::BesselJ1, "brdf_besselj1(x)", 1e-20, 1, 0, 0, 6e-7, 0},
    {Op::BesselI0, "brdf_besseli0(x)", -10, 10, 0, 0, 2e-6, 0},
    {Op::BesselI0, "brdf_besseli0(x)", 10, 80, 0, 0, 1e-5, 0},
    {Op::BesselI1, "brdf_besseli1(x)", 1e-20, 10, 0, 0, 2e-6, 0},
    {Op::BesselI1, "brdf_besseli1(x)", 10, 80, 0, 0, 1e-5, 0},
    {Op::BesselK0, "brdf_besselk0(x)", 1e-20, 80, 0, 0, 2e-6, 0},
    {Op::BesselK1, "brdf_besselk1(x)", 1e-20, 80, 0, 0, 2e-6, 0},
    {Op::GammaP, "brdf_gammap(x, y)", 0.05, 20, 0, 40, 1e-5, 0},
    {Op::GammaP, "brdf_gammap(x, y)", 0.2, 5, 0, 1, 5e-6, 0},
    {Op::GammaQ, "brdf_gammaq(x, y)", 0.2, 20, 0, 20, 3e-5, 1e-6},
    {Op::GammaP, "brdf_gammap(x, y)", 20, 300, 0, 300, 6e-5, 0},
    {Op::GammaPDa, "brdf_gammapDa(x, y)", 0.2, 20, 0, 20, 0, 2e-3},
    // The driver's own, which the printer uses as they are.
    {Op::Sqrt, "sqrt(x)", 1e-37, 1e38, 0, 0, 2e-7, 0},
    {Op::Div, "x / y", 0.1, 10, 0.1, 10, 3e-7, 0},
    {Op::Sin, "sin(x)", -10, 10, 0, 0, 3e-7, 1e-7},
    {Op::Cos, "cos(x)", -10, 10, 0, 0, 3e-7, 1e-7},
    {Op::Tan, "tan(x)", -1.5, 1.5, 0, 0, 1e-6, 1e-7},
};

class Prelude : public test::GlslTest {};

TEST_F(Prelude, FunctionsAreAsAccurateAsStated) {
  constexpr std::size_t count = 4000;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const Function& function : kFunctions) {
    std::vector<float> x(count), y(count);
    for (std::size_t k = 0; k < count; ++k) {
      const double share = k == 0 ? 0 : k == 1 ? 1 : uniform(random);
      const bool logarithmic = function.low > 0;
      x[k] = static_cast<float>(logarithmic ? function.low * std::pow(function.high / function.low, share)
                                            : function.low + share * (function.high - function.low));
      y[k] = static_cast<float>(function.low2 + uniform(random) * (function.high2 - function.low2));
    }
    const std::vector<float> got = probe().Evaluate(glslPrelude(), {{"x", x}, {"y", y}}, {function.call})[0];
    Graph graph;
    const NodeId node =
        graph.make(function.op, graph.input(Input::Ux), arity(function.op) > 1 ? graph.input(Input::Uy) : 0);
    double worst = 0, worstError = 0;
    std::size_t at = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const double exact = evaluateExtended(graph, {node}, {x[k], y[k]}, {})[0];
      if (std::fabs(exact) < kTiny && std::fabs(got[k]) < kTiny) continue;
      const double error = std::fabs(got[k] - exact);
      const double allowed = std::max(function.relative * std::fabs(exact), function.absolute);
      if (!(error / allowed <= worst)) worst = error / allowed, worstError = error / std::fabs(exact), at = k;
    }
    EXPECT_LE(worst, 1) << function.call << " at " << x[at] << ", " << y[at] << ": " << got[at] << ", relative error "
                        << worstError;
    if (std::getenv("BRDF_AUDIT") != nullptr)
      std::printf("%-18s [%g, %g] worst relative %.2e (%.2f of allowed)\n", function.call, function.low, function.high,
                  worstError, worst);
  }
}

TEST_F(Prelude, DefinesTheCorners) {
  struct Corner {
    const char* expression;
    float value;
  };
  const float infinity = std::numeric_limits<float>::infinity();
  const Corner corners[] = {
      {"brdf_pow(x, x)", 1},
      {"brdf_pow(x, x + 2.0)", 0},
      {"brdf_pow(x, x - 1.0)", infinity},
      {"brdf_pow(x - 2.0, x + 3.0)", -8},
      {"brdf_pow(x - 2.0, x + 2.0)", 4},
      {"brdf_log(x + 1.0)", 0},
      {"brdf_log(x)", -infinity},
      {"brdf_log1p(x)", 0},
      {"brdf_exp(x)", 1},
      {"brdf_exp(x - 200.0)", 0},
      {"brdf_exp(x + 200.0)", infinity},
      {"brdf_expm1(x)", 0},
      {"brdf_acos(x + 1.0)", 0},
      {"brdf_acos(x + 1.5)", 0},
      {"brdf_asin(x)", 0},
      {"brdf_atan2(x, x)", 0},
      {"brdf_atan2(x, x + 1.0)", 0},
      {"brdf_erf(x)", 0},
      {"brdf_erf(x + 100.0)", 1},
      {"brdf_erfc(x)", 1},
      {"brdf_erfc(x + 100.0)", 0},
      {"brdf_erfc(x - 100.0)", 2},
      {"brdf_tanh(x + 100.0)", 1},
      {"brdf_cosh(x)", 1},
      {"brdf_sinh(x)", 0},
      {"brdf_lgamma(x + 1.0)", 0},
      {"brdf_sinh(x - 1000.0)", -infinity},
  };
  for (const Corner& corner : corners) {
    const float got = probe().Evaluate(glslPrelude(), {{"x", {0}}}, {corner.expression})[0][0];
    if (std::isinf(corner.value))
      EXPECT_EQ(got, corner.value) << corner.expression;
    else
      EXPECT_NEAR(got, corner.value, 1e-6 * std::fabs(corner.value) + 2e-7) << corner.expression;
  }
}

}  // namespace
}  // namespace brdf::formula
