// Symbolic derivatives against central differences in 50-digit arithmetic, and where a naive chain rule gives NaN.
#include <brdf/formula/Derivative.h>

#include "FormulaSupport.h"

namespace brdf::formula {
namespace {

struct Slope {
  std::string text;
  std::vector<double> parameters;  // p, q
};

class Slopes : public testing::TestWithParam<Slope> {};

TEST_P(Slopes, AgreesWithExtendedPrecisionDifferences) {
  Graph graph;
  const std::vector<std::string> names{"p", "q"};
  ParseOptions options;
  options.parameters = names;
  const NodeId root = parse(graph, GetParam().text, options).value;
  const std::vector<NodeId> slopes = derivatives(graph, root, {0, 1});
  const Program program(graph, slopes);
  const InputLane lane = someLane();
  const double* inputs[8];
  for (std::size_t k = 0; k < 8; ++k) inputs[k] = &lane[k];
  double got[2] = {};
  double* outputs[2] = {&got[0], &got[1]};
  program.run(inputs, GetParam().parameters, outputs, 1);
  for (std::size_t k = 0; k < 2; ++k) {
    const double exact = differenceExtended(graph, root, lane, GetParam().parameters, k);
    EXPECT_NEAR(got[k], exact, 1e-13 * std::max(1.0, std::fabs(exact))) << GetParam().text << ", parameter " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(
    EveryOperation, Slopes,
    testing::Values(
        Slope{"-p * q", {1.3, 0.4}}, Slope{"abs(p - 2) + abs(q)", {1.3, 0.4}}, Slope{"sqrt(p * ux + q)", {1.3, 0.4}},
        Slope{"exp(-p * q)", {1.3, 0.4}}, Slope{"expm1(p / q)", {1e-3, 0.4}}, Slope{"log(p * q)", {1.3, 0.4}},
        Slope{"log1p(p * q)", {1e-6, 0.4}}, Slope{"sin(p) * cos(q)", {1.3, 0.4}}, Slope{"tan(p + q)", {0.3, 0.4}},
        Slope{"asin(p) + acos(q)", {0.3, 0.4}}, Slope{"atan(p / q)", {1.3, 0.4}},
        Slope{"sinh(p) + cosh(q) * tanh(p * q)", {1.3, 0.4}}, Slope{"erf(p) + erfc(q)", {1.3, 0.4}},
        Slope{"lgamma(p) * lgamma(q)", {1.3, 0.4}}, Slope{"digamma(p) * digamma(q)", {1.3, 0.4}},
        Slope{"besselj0(p) + besselj1(20 * q)", {1.3, 0.4}}, Slope{"besseli0(p) * besseli1(q)", {1.3, 0.4}},
        Slope{"besselk0(p) * besselk1(q)", {1.3, 0.4}}, Slope{"gammap(p, q)", {1.3, 0.4}},
        Slope{"gammaq(p, q)", {1.3, 0.4}}, Slope{"gammap(p, q)", {1.3, 9.4}}, Slope{"gammaq(p, q)", {30, 24}},
        Slope{"gammap(p, q) + gammaq(q, p)", {0.02, 1e-3}}, Slope{"floor(p) * q", {1.3, 0.4}},
        Slope{"!p + q", {1.3, 0.4}}, Slope{"p + q - p * q / (p - q)", {1.3, 0.4}}, Slope{"p ^ q", {1.3, 0.4}},
        Slope{"p ^ 3 + q ^ 2.5", {1.3, 0.4}}, Slope{"2 ^ p * p ^ -2", {1.3, 0.4}}));

INSTANTIATE_TEST_SUITE_P(Compositions, Slopes,
                         testing::Values(Slope{"min(p, q) + max(p, q) * p", {1.3, 0.4}},
                                         Slope{"min(p, q) * max(p, 2 * q)", {0.4, 1.3}},
                                         Slope{"atan2(p, q)", {1.3, 0.4}}, Slope{"atan2(p, q)", {1.3, -0.4}},
                                         Slope{"hypot(p, q)", {1.3, 0.4}},
                                         Slope{"select(p > q, p * q, exp(p))", {1.3, 0.4}},
                                         Slope{"select(p > q, p * q, exp(p))", {0.3, 0.4}},
                                         Slope{"p < q ? p : q * q", {1.3, 0.4}}, Slope{"(p > q) * p", {1.3, 0.4}},
                                         Slope{"(p && q) + p", {1.3, 0.4}}, Slope{"f(x) = x * p; f(f(q))", {1.3, 0.4}},
                                         Slope{"exp(-tan2_h / p^2) / (pi * p^2 * cos2_h^2)", {0.6, 0.4}},
                                         Slope{"(-p) ^ 3 * q", {1.3, 0.4}}));

/// Derivative with respect to p of `text` by the batch evaluator.
double slopeAt(const std::string& text, double p) {
  Graph graph;
  const std::vector<std::string> names{"p"};
  ParseOptions options;
  options.parameters = names;
  const NodeId root = parse(graph, text, options).value;
  const Program program(graph, derivatives(graph, root, {0}));
  const InputLane lane = someLane();
  const double* inputs[8];
  for (std::size_t k = 0; k < 8; ++k) inputs[k] = &lane[k];
  double got = 0;
  double* output = &got;
  program.run(inputs, std::vector{p}, &output, 1);
  return got;
}

TEST(Derivative, OfABranchNotTakenMayBeInfinite) {
  EXPECT_EQ(slopeAt("select(p > 0, log(p), 3)", 0), 0);
  EXPECT_EQ(slopeAt("select(p > 0, sqrt(p), 2 * p)", 0), 2);
  EXPECT_EQ(slopeAt("select(p > 1, 1 / p, p)", 0), 1);
}

TEST(Derivative, AtTiesFollowsTheFirstOperand) {
  EXPECT_EQ(slopeAt("min(p, 1)", 1), 1);
  EXPECT_EQ(slopeAt("min(1, p)", 1), 0);
  EXPECT_EQ(slopeAt("max(p, 1)", 1), 1);
  EXPECT_EQ(slopeAt("max(1, p)", 1), 0);
}

TEST(Derivative, IsFiniteAtTheEdgeOfADomain) {
  EXPECT_EQ(slopeAt("acos(p)", 1), 0);
  EXPECT_EQ(slopeAt("asin(p)", -1), 0);
  EXPECT_EQ(slopeAt("sqrt(p)", 0), 0);
  EXPECT_EQ(slopeAt("sqrt(p * p)", 0), 0);
  EXPECT_EQ(slopeAt("p ^ 2", 0), 0);
  EXPECT_EQ(slopeAt("pow(p, 3.5)", 0), 0);
  EXPECT_EQ(slopeAt("pow(0, p)", 2), 0);
  EXPECT_EQ(slopeAt("abs(p)", 0), 1);
}

TEST(Derivative, OfSpecialFunctionsIsFiniteAtTheirEdges) {
  EXPECT_EQ(slopeAt("besselj1(p)", 0), 0.5);
  EXPECT_EQ(slopeAt("besseli1(p)", 0), 0.5);
  EXPECT_EQ(slopeAt("gammap(2.5, p)", 0), 0);
  EXPECT_EQ(slopeAt("gammap(p, 0)", 2.5), 0);
}

TEST(Derivative, OfARootOfTheIncompleteGammaFunctionFollowsTheImplicitFunction) {
  // x with P(a, x) = 1/2: dx/da = -(dP/da)/(dP/dx).
  Graph graph;
  const std::vector<std::string> names{"p"};
  ParseOptions options;
  options.parameters = names;
  const NodeId root = parse(graph, "solve(x, 1e-6, 20, gammap(p, x) - 0.5)", options).value;
  const std::vector<double> parameters{3.2};
  const double exact = differenceExtended(graph, root, someLane(), parameters, 0);
  EXPECT_NEAR(slopeAt("solve(x, 1e-6, 20, gammap(p, x) - 0.5)", 3.2), exact, 1e-12);
  EXPECT_NEAR(exact, 1.0, 0.02);  // the median of a gamma variate is close to a - 1/3
}

TEST(Derivative, ThatIsNotOfferedIsRefusedByName) {
  Graph graph;
  const NodeId p = graph.parameter(0);
  const NodeId first = derivative(graph, graph.make(Op::GammaP, p, graph.constant(2)), p);
  for (const auto& [node, what] : {std::pair{graph.make(Op::Trigamma, p), "derivative of trigamma"},
                                   std::pair{first, "second derivative of gammap"}}) {
    try {
      derivative(graph, node, p);
      ADD_FAILURE() << what;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Formula);
      EXPECT_NE(error.details().what.find(what), std::string::npos) << error.what();
    }
  }
}

TEST(Derivative, OfARootDoesNotNeedThatOfItsSlope) {
  // Newton's slope holds dP/da, whose derivative by a is not offered and not needed either.
  EXPECT_NEAR(slopeAt("solve(x, 0.1, 5, gammap(x + p, 2) - 0.5)", 0.3), -1, 1e-12);
}

TEST(Derivative, SharesTheValuesNodes) {
  Graph graph;
  const std::vector<std::string> names{"p"};
  ParseOptions options;
  options.parameters = names;
  const NodeId root = parse(graph, "exp(p * ux)", options).value;
  const NodeId slope = derivatives(graph, root, {0})[0];
  EXPECT_EQ(slope, graph.mul(root, graph.input(Input::Ux)));
  EXPECT_EQ(derivatives(graph, graph.input(Input::Uy), {0})[0], graph.constant(0));
}

}  // namespace
}  // namespace brdf::formula
