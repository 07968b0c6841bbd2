// The expression graph: one node an expression, constants folded, no identity that changes a value.
#include "FormulaSupport.h"

#include <random>

namespace brdf::formula {
namespace {

TEST(Graph, EqualExpressionsAreOneNode) {
  Graph graph;
  const NodeId first = parse(graph, "sqrt(ux * uy) + ux * uy", {}).value;
  const std::size_t size = graph.size();
  EXPECT_EQ(parse(graph, "p = uy * ux; p + sqrt(p)", {}).value, first);
  EXPECT_EQ(graph.size(), size);
}

TEST(Graph, FoldsConstantsToTheirValue) {
  Graph graph;
  const NodeId node = parse(graph, "2 * erf(0.5) + min(3, 4) ^ 2 - select(1 < 2, 5, 6)", {}).value;
  ASSERT_TRUE(graph.isConstant(node));
  EXPECT_DOUBLE_EQ(graph[node].value, 2 * std::erf(0.5) + 4);
}

TEST(Graph, KeepsZeroAndMinusZeroApart) {
  Graph graph;
  EXPECT_NE(graph.constant(0.0), graph.constant(-0.0));
  EXPECT_TRUE(std::signbit(graph[graph.constant(-0.0)].value));
}

TEST(Graph, OperandsPrecedeTheirUsers) {
  Graph graph;
  parse(graph, "a = ux * uy + 1; b = exp(a) / a; select(b > a, a ^ b, b - a)", {});
  for (NodeId id = 0; id < graph.size(); ++id)
    for (int k = 0; k < arity(graph[id].op); ++k) EXPECT_LT(graph[id].operands[k], id);
}

TEST(Graph, ReachableNamesWhatTheRootsNeedAndNothingElse) {
  Graph graph;
  const NodeId used = parse(graph, "exp(ux)", {}).value;
  const NodeId unused = parse(graph, "exp(uy)", {}).value;
  const NodeId root = graph.sqrt(used);
  const std::vector<bool> needed = graph.reachable({root});
  EXPECT_TRUE(needed[root] && needed[used] && needed[graph.input(Input::Ux)]);
  EXPECT_FALSE(needed[unused]);
}

/// Each identity beside the operation it stands for, on operands where a careless one breaks.
TEST(Graph, SimplificationsKeepTheValue) {
  struct Identity {
    const char* simplified;
    double (*meaning)(double, double);
  };
  const Identity identities[] = {
      {"ux + 0", [](double a, double) { return a; }},
      {"0 + ux", [](double a, double) { return a; }},
      {"ux - 0", [](double a, double) { return a; }},
      {"0 - ux", [](double a, double) { return -a; }},
      {"ux - ux", [](double, double) { return 0.0; }},
      {"--ux", [](double a, double) { return a; }},
      {"ux + -uy", [](double a, double b) { return a - b; }},
      {"-ux + uy", [](double a, double b) { return b - a; }},
      {"ux - -uy", [](double a, double b) { return a + b; }},
      {"ux * 1", [](double a, double) { return a; }},
      {"-1 * ux", [](double a, double) { return -a; }},
      {"0 * ux", [](double, double) { return 0.0; }},
      {"ux / 1", [](double a, double) { return a; }},
      {"ux / 4", [](double a, double) { return a / 4; }},
      {"ux / 0.125", [](double a, double) { return a / 0.125; }},
      {"ux / -2", [](double a, double) { return a / -2; }},
      {"ux / 3", [](double a, double) { return a / 3; }},
      {"0 / ux", [](double, double) { return 0.0; }},
      {"ux ^ 0", [](double, double) { return 1.0; }},
      {"ux ^ 1", [](double a, double) { return a; }},
      {"ux ^ 2", [](double a, double) { return a * a; }},
      {"abs(ux) ^ 0.5", [](double a, double) { return std::sqrt(std::fabs(a)); }},
      {"min(ux, ux)", [](double a, double) { return a; }},
      {"max(ux, ux)", [](double a, double) { return a; }},
      {"select(1, ux, uy)", [](double a, double) { return a; }},
      {"select(0, ux, uy)", [](double, double b) { return b; }},
      {"select(uy, ux, ux)", [](double a, double) { return a; }},
      {"max(ux * ux, 0)", [](double a, double) { return a * a; }},
      {"max(ux * uy, 0)", [](double a, double b) { return std::max(a * b, 0.0); }},
      {"select(0 < 1 + ux * ux, ux, uy)", [](double a, double) { return a; }},
      {"select(0 < ux * ux, ux, uy)", [](double a, double b) { return a * a > 0 ? a : b; }},
      {"select(0 < ux * ux * (uy * uy + 1), ux, uy)", [](double a, double b) { return a * a > 0 ? a : b; }},
      {"select(0 < 1 + sqrt(ux), ux, uy)", [](double a, double b) { return a >= 0 ? a : b; }},
      {"select(0 < sqrt(1 + abs(ux)), ux, uy)", [](double a, double) { return a; }},
      {"0 && ux", [](double, double) { return 0.0; }},
      {"ux && 0", [](double, double) { return 0.0; }},
      {"0 || ux", [](double a, double) { return a != 0 ? 1.0 : 0.0; }},
      {"1 || ux", [](double, double) { return 1.0; }},
      {"!!ux", [](double a, double) { return a != 0 ? 1.0 : 0.0; }},
  };
  for (const Identity& identity : identities) {
    Graph graph;
    const NodeId node = parse(graph, identity.simplified, {}).value;
    const Program program(graph, {node});
    for (const double a : {-3.0, -1e-300, 0.0, 0.7, 1e300})
      for (const double b : {-2.0, 0.0, 5.0}) {
        const double* inputs[8] = {&a, &b};
        double got = 0;
        double* output = &got;
        program.run(inputs, {}, &output, 1);
        EXPECT_EQ(got, identity.meaning(a, b)) << identity.simplified << " at " << a << ", " << b;
      }
  }
}

TEST(Graph, ComparisonsThatSumsOfSquaresDecideAreGone) {
  Graph graph;
  const NodeId x = graph.input(Input::Ux);
  EXPECT_EQ(parse(graph, "select(sqrt(0.5 + uy * uy) > 0, ux, uy)", {}).value, x);
  EXPECT_EQ(parse(graph, "max(abs(uy) + ux * ux, 0)", {}).value, parse(graph, "abs(uy) + ux * ux", {}).value);
  EXPECT_NE(parse(graph, "select(sqrt(uy * uy) > 0, ux, uy)", {}).value, x);
}

TEST(Graph, WholePowersAreWithinOneUlpAFactorOfTheExactPower) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-3, 3);
  for (int power = 2; power <= 10; ++power) {
    Graph graph;
    const NodeId node = parse(graph, "ux ^ " + std::to_string(power), {}).value;
    const Program program(graph, {node});
    for (int trial = 0; trial < 200; ++trial) {
      InputLane lane{};
      lane[0] = uniform(random);
      const double* inputs[8] = {lane.data()};
      double got = 0;
      double* output = &got;
      program.run(inputs, {}, &output, 1);
      // pow of a negative base is what C's pow gives for whole exponents
      EXPECT_LE(ulpError(got, std::pow(lane[0], power)), power) << lane[0] << " ^ " << power;
    }
  }
}

TEST(Graph, ArityMatchesWhatTheOperationReads) {
  EXPECT_EQ(arity(Op::Constant), 0);
  EXPECT_EQ(arity(Op::Neg), 1);
  EXPECT_EQ(arity(Op::Not), 1);
  EXPECT_EQ(arity(Op::Add), 2);
  EXPECT_EQ(arity(Op::Or), 2);
  EXPECT_EQ(arity(Op::Select), 3);
  EXPECT_EQ(opName(Op::Atan2), "atan2");
  EXPECT_EQ(opName(Op::Add), "+");
}

}  // namespace
}  // namespace brdf::formula
