// What the formula language means, and what it says about text that means nothing.
#include "FormulaSupport.h"

#include <chrono>
#include <numbers>

namespace brdf::formula {
namespace {

using std::numbers::pi;

struct Valued {
  const char* text;
  double value;
};

class Language : public testing::TestWithParam<Valued> {};

TEST_P(Language, EvaluatesAsMathematicsReadsIt) {
  EXPECT_DOUBLE_EQ(valueOf(GetParam().text), GetParam().value) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(Precedence, Language,
                         testing::Values(Valued{"-3^2", -9}, Valued{"(-3)^2", 9}, Valued{"2^-1", 0.5},
                                         Valued{"2^3^2", 512}, Valued{"-2^-2", -0.25}, Valued{"2*3^2", 18},
                                         Valued{"1+2*3", 7}, Valued{"(1+2)*3", 9}, Valued{"10-4-3", 3},
                                         Valued{"16/4/2", 2}, Valued{"2*-3", -6}, Valued{"1--1", 2}, Valued{"+-+2", -2},
                                         Valued{"1 < 2 == 1", 1}, Valued{"1 + 1 < 3 && 2 < 1 || 1", 1},
                                         Valued{"0 && 0 || 1", 1}, Valued{"0 && (0 || 1)", 0}, Valued{"!1 == 0", 1},
                                         Valued{"!(1 == 0)", 1}, Valued{"!0 + 1", 2}));

INSTANTIATE_TEST_SUITE_P(Conditions, Language,
                         testing::Values(Valued{"1 ? 2 : 3", 2}, Valued{"0 ? 2 : 3", 3}, Valued{"0 ? 2 : 0 ? 3 : 4", 4},
                                         Valued{"1 ? 0 ? 1 : 2 : 3", 2}, Valued{"2 > 1 ? 5 : 6", 5},
                                         Valued{"-0.5 ? 1 : 2", 1}, Valued{"2 >= 2", 1}, Valued{"2 <= 1", 0},
                                         Valued{"2 != 3", 1}, Valued{"2 == 3", 0}, Valued{"2 && -3", 1},
                                         Valued{"0 || 0", 0}, Valued{"1 U+003C 2", 1}, Valued{"2U+003C1", 0},
                                         Valued{"1 U+003C= 1", 1}));

INSTANTIATE_TEST_SUITE_P(Numbers, Language,
                         testing::Values(Valued{"1.", 1}, Valued{".5", 0.5}, Valued{"1.e-3", 1e-3}, Valued{"1E+2", 100},
                                         Valued{"0.1", 0.1}, Valued{"1e300*1e-300", 1}, Valued{"007", 7},
                                         Valued{"2e0", 2}, Valued{"pi", pi}, Valued{"_pi", pi}, Valued{"1e-400", 0},
                                         Valued{"1.7976931348623157e308", 1.7976931348623157e308}));

INSTANTIATE_TEST_SUITE_P(Statements, Language,
                         testing::Values(Valued{"a = 2; a * 3", 6}, Valued{"a = 2", 2}, Valued{";; 4 ;;", 4},
                                         Valued{"a = 2; a = a + 1; a", 3}, Valued{"1; 2; 3", 3},
                                         Valued{"a = 2 # two\n; a // twice\n + a", 4}, Valued{"# only words\n7", 7},
                                         Valued{"pi = 3; pi", 3}, Valued{"f(x) = x^2; f(3)", 9},
                                         Valued{"f(x, y) = x - y; f(f(5, 2), 1)", 2},
                                         Valued{"k = 4; f(x) = k * x; k = 5; f(2)", 10},
                                         Valued{"f(x) = x; g(x) = f(x) + 1; g(1)", 2},
                                         Valued{"sqr(x) = x + 1; sqr(3)", 4}, Valued{"x = 9; f(x) = x; f(1) + x", 10},
                                         Valued{"f(ux) = ux; f(3)", 3}));

INSTANTIATE_TEST_SUITE_P(Functions, Language,
                         testing::Values(Valued{"select(1, 2, 3)", 2}, Valued{"select(0, 2, 3)", 3},
                                         Valued{"min(3, 1, 2)", 1}, Valued{"min(3)", 3}, Valued{"if(1, 2, 3)", 2},
                                         Valued{"max(3, 1, 2, 7)", 7}, Valued{"pow(2, 10)", 1024},
                                         Valued{"atan2(1, -1)", 3 * pi / 4}, Valued{"hypot(3, 4)", 5},
                                         Valued{"sqr(3)", 9}, Valued{"ln(1)", 0}, Valued{"abs(-2)", 2},
                                         Valued{"floor(-1.5)", -2}, Valued{"sqrt(2)^2", 2}, Valued{"log1p(0)", 0},
                                         Valued{"erf(0)", 0}, Valued{"erfc(0)", 1}, Valued{"lgamma(5)", std::log(24)},
                                         Valued{"digamma(1)", -std::numbers::egamma}, Valued{"pow(0, 0)", 1},
                                         Valued{"pow(0, 3)", 0}, Valued{"pow(0, 0.5)", 0}, Valued{"acos(1 + 1e-12)", 0},
                                         Valued{"asin(-2)", -pi / 2}, Valued{"neg(2)", -2}));

TEST(Parser, DirectionVariablesAreTheDocumentedQuantities) {
  const InputLane at = someLane();
  const double wi[3] = {at[0], at[1], at[2]}, wo[3] = {at[3], at[4], at[5]};
  const double cosIo = wi[0] * wo[0] + wi[1] * wo[1] + wi[2] * wo[2];
  const double thetaD = std::acos(cosIo) / 2;
  const double length = std::hypot(wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]);
  const double thetaH = std::acos((wi[2] + wo[2]) / length);
  EXPECT_NEAR(valueOf("cos_io"), cosIo, 1e-15);
  EXPECT_NEAR(valueOf("theta_d"), thetaD, 1e-15);
  EXPECT_NEAR(valueOf("cos_d"), std::cos(thetaD), 1e-15);
  EXPECT_NEAR(valueOf("sin2_d"), std::pow(std::sin(thetaD), 2), 1e-15);
  EXPECT_NEAR(valueOf("theta_h"), thetaH, 1e-15);
  EXPECT_NEAR(valueOf("tan2_h"), std::pow(std::tan(thetaH), 2), 1e-15);
  EXPECT_NEAR(valueOf("cos2_h"), std::pow(std::cos(thetaH), 2), 1e-15);
  EXPECT_NEAR(valueOf("hx^2 + hy^2 + hz^2"), 1, 1e-15);
  EXPECT_NEAR(valueOf("phi_h"), std::atan2(wi[1] + wo[1], wi[0] + wo[0]), 1e-15);
  EXPECT_NEAR(valueOf("theta_i"), std::acos(wi[2]), 1e-15);
  EXPECT_NEAR(valueOf("theta_o"), std::acos(wo[2]), 1e-15);
  EXPECT_NEAR(valueOf("phi_i"), std::atan2(wi[1], wi[0]), 1e-15);
  EXPECT_NEAR(valueOf("phi_o"), std::atan2(wo[1], wo[0]), 1e-15);
  EXPECT_NEAR(valueOf("tan2_i"), 1 / (wi[2] * wi[2]) - 1, 1e-15);
  EXPECT_NEAR(valueOf("tan2_o"), 1 / (wo[2] * wo[2]) - 1, 1e-15);
  EXPECT_NEAR(valueOf("sin2_i"), 1 - wi[2] * wi[2], 1e-15);
  EXPECT_NEAR(valueOf("dot_xy"), wi[0] * wo[0] + wi[1] * wo[1], 1e-15);
  const double cosR = -wi[0] * wo[0] - wi[1] * wo[1] + wi[2] * wo[2];
  EXPECT_NEAR(valueOf("cos_r"), cosR, 1e-15);
  EXPECT_NEAR(valueOf("sin2_r2"), (1 - cosR) / 2, 1e-15);
  EXPECT_EQ(valueOf("random1"), at[6]);
  EXPECT_EQ(valueOf("random2"), at[7]);
}

TEST(Parser, ParametersHideVariablesAndAssignmentsHideParameters) {
  Graph graph;
  const std::vector<std::string> names{"m", "pi"};
  ParseOptions options;
  options.parameters = names;
  const NodeId first = parse(graph, "pi + m", options).value;
  const NodeId second = parse(graph, "m = 10; pi + m", options).value;
  const std::vector<double> values{1, 2};
  EXPECT_EQ(evaluateExtended(graph, {first, second}, someLane(), values), (std::vector<double>{3, 12}));
}

TEST(Parser, LibraryFunctionsSeeTheirArgumentsOnlyAndAreListedOnceInOrderOfUse) {
  const FunctionTable table{{"twice", {"twice", {"x"}, "y = x; y + x", "function twice"}},
                            {"wing", {"wing", {}, "uz * twice(1)", "function wing"}},
                            {"nosy", {"nosy", {}, "m", "function nosy"}}};
  Graph graph;
  const std::vector<std::string> names{"m"};
  ParseOptions options;
  options.parameters = names;
  options.functions = &table;
  const ParseResult result = parse(graph, "y = 100; twice(wing() + twice(y))", options);
  EXPECT_EQ(result.functionsUsed, (std::vector<std::string>{"wing", "twice"}));
  const std::vector<double> values{7};
  EXPECT_DOUBLE_EQ(evaluateExtended(graph, {result.value}, someLane(), values)[0], 2 * (0.8 * 2 + 200));

  const Error::Details error = errorOf("nosy()", names, &table);
  EXPECT_EQ(error.where, "function nosy, line 1, column 1");
  EXPECT_EQ(error.found, "'m'");
}

struct Refused {
  const char* text;
  const char* where;
  const char* what;
  const char* found;
};

class BadFormula : public testing::TestWithParam<Refused> {};

TEST_P(BadFormula, IsRefusedWithItsPlace) {
  const Error::Details error = errorOf(GetParam().text, {"alpha"});
  EXPECT_EQ(error.where, "test, " + std::string(GetParam().where)) << GetParam().text;
  EXPECT_EQ(error.what, GetParam().what) << GetParam().text;
  EXPECT_EQ(error.found, GetParam().found) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Table, BadFormula,
    testing::Values(Refused{"", "line 1, column 1", "empty formula", ""},
                    Refused{" ;; # x", "line 1, column 1", "empty formula", ""},
                    Refused{"1 +", "line 1, column 4", "expected a number, a name or '('", "the end of the formula"},
                    Refused{"1 +\n  * 2", "line 2, column 3", "expected a number, a name or '('", "'*'"},
                    Refused{"(1", "line 1, column 3", "expected ')'", "the end of the formula"},
                    Refused{"1)", "line 1, column 2", "expected ';' or an operator", "')'"},
                    Refused{"1 2", "line 1, column 3", "expected ';' or an operator", "'2'"},
                    Refused{"a = 1;\n\nb = $", "line 3, column 5", "unexpected character", "'$'"},
                    Refused{"1 ? 2", "line 1, column 6", "expected ':'", "the end of the formula"},
                    Refused{"a = 1;\n  beta", "line 2, column 3", "unknown name", "'beta'"},
                    Refused{"1 + alhpa", "line 1, column 5", "unknown name", "'alhpa'"},
                    Refused{"2 * sqtr(2)", "line 1, column 5", "unknown function", "'sqtr'"},
                    Refused{"sqrt(1, 2)", "line 1, column 1", "wrong number of arguments to sqrt", "2"},
                    Refused{"atan2(1)", "line 1, column 1", "wrong number of arguments to atan2", "1"},
                    Refused{"min()", "line 1, column 1", "wrong number of arguments to min", "0"},
                    Refused{"select(1, 2)", "line 1, column 1", "wrong number of arguments to select", "2"},
                    Refused{"sqrt()", "line 1, column 1", "wrong number of arguments to sqrt", "0"},
                    Refused{"f(x) = x; f(1, 2)", "line 1, column 11", "wrong number of arguments to f", "2"},
                    Refused{"f(x) = x", "line 1, column 1", "the last statement must be an expression",
                            "a function definition"},
                    Refused{"1 & 2", "line 1, column 3", "unexpected character", "'&'"},
                    Refused{"alpha = = 2", "line 1, column 9", "expected a number, a name or '('", "'='"},
                    Refused{"sqrt(2", "line 1, column 7", "expected ',' or ')'", "the end of the formula"},
                    Refused{"3 = 4", "line 1, column 3", "expected ';' or an operator", "'='"},
                    Refused{"sqrt", "line 1, column 1", "unknown name", "'sqrt'"}));

TEST(Parser, NamesTheNearestKnownName) {
  EXPECT_EQ(errorOf("1 + alhpa", {"alpha"}).allowed, "did you mean 'alpha'?");
  EXPECT_EQ(errorOf("sqqrt(2)").allowed, "did you mean 'sqrt'?");
  EXPECT_EQ(errorOf("rough = 2; ruogh + 1").allowed, "did you mean 'rough'?");
  EXPECT_EQ(errorOf("cos_j").allowed.substr(0, 15), "did you mean 'c");
  EXPECT_EQ(errorOf("qwertyuiop").allowed, "");
}

TEST(Parser, RefusesNestingBeyondItsBoundWithoutExhaustingTheStack) {
  for (const char* piece : {"(", "-", "!", "sqrt(", "2^", "1?1:", "1+("}) {
    std::string text;
    for (int k = 0; k < 100'000; ++k) text += piece;
    EXPECT_EQ(errorOf(text + "1").what, "nested too deeply") << piece;
  }
  EXPECT_EQ(valueOf(std::string(40, '(') + "1" + std::string(40, ')')), 1);
}

TEST(Parser, ReadsLongSumsAsTheyAreFlat) {
  std::string text = "1";
  for (int k = 0; k < 2000; ++k) text += " + 1";
  EXPECT_EQ(valueOf(text), 2001);
}

TEST(Parser, RefusesRecursion) {
  EXPECT_EQ(errorOf("f(x) = f(x - 1); f(3)").what, "functions call each other too deeply");
  EXPECT_EQ(errorOf("f(x) = g(x); g(x) = f(x); f(1)").what, "functions call each other too deeply");
  const FunctionTable table{{"f", {"f", {}, "g()", "f"}}, {"g", {"g", {}, "f()", "g"}}};
  EXPECT_EQ(errorOf("f()", {}, &table).what, "functions call each other too deeply");
}

/// f0 = x + ux; f1 = f0(f0(..)): each level calls the one below `calls` times.
std::string tower(int levels, int calls, bool asArguments) {
  std::string text = "f0(x) = x + ux;\n";
  for (int level = 1; level <= levels; ++level) {
    const std::string below = "f" + std::to_string(level - 1) + "(";
    text += "f" + std::to_string(level) + "(x) = ";
    if (asArguments) {
      for (int k = 0; k < calls; ++k) text += below;
      text += "x" + std::string(static_cast<std::size_t>(calls), ')');
    } else {
      for (int k = 0; k < calls; ++k) text += (k == 0 ? "" : " + ") + below + "x)";
    }
    text += ";\n";
  }
  return text + "f" + std::to_string(levels) + "(uy)";
}

TEST(Parser, BoundsExponentialExpansionInTimeAndMemory) {
  const auto start = std::chrono::steady_clock::now();
  for (const bool asArguments : {false, true}) EXPECT_NE(errorOf(tower(40, 4, asArguments)).what, "");
  // The same in library functions, whose bodies are parsed at each call.
  FunctionTable table{{"f0", {"f0", {"x"}, "x + ux", "f0"}}};
  for (int level = 1; level <= 40; ++level) {
    const std::string name = "f" + std::to_string(level), below = "f" + std::to_string(level - 1);
    table[name] = {name, {"x"}, below + "(x) + " + below + "(x)", name};
  }
  EXPECT_NE(errorOf("f40(1)", {}, &table).what, "");
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 10);
}

TEST(Parser, SurvivesEveryByte) {
  Graph graph;
  for (int byte = 0; byte < 256; ++byte) {
    const std::string text = "1 " + std::string(1, static_cast<char>(byte)) + " 2";
    try {
      parse(graph, text, {});
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Formula);
    }
  }
}

}  // namespace
}  // namespace brdf::formula
