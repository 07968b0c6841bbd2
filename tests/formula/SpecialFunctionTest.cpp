// Special functions against values that an independent program computed in 40-digit arithmetic (mpmath 1.3), and
// against identities.
#include <brdf/formula/Derivative.h>

#include "FormulaSupport.h"

namespace brdf::formula {
namespace {

/// The same by the batch evaluator, in double.
double batchValueOf(const std::string& text) {
  Graph graph;
  const NodeId node = parse(graph, text, {}).value;
  const Program program(graph, {node});
  const InputLane lane = someLane();
  const double* inputs[8];
  for (std::size_t k = 0; k < 8; ++k) inputs[k] = &lane[k];
  double got = 0;
  double* output = &got;
  program.run(inputs, {}, &output, 1);
  return got;
}

struct Known {
  const char* text;
  double value;
};
constexpr Known kKnown[] = {
    {"besselj0(0.25)", 0.984435929295852705},
    {"besselj0(2)", 0.223890779141235668},
    {"besselj0(12.5)", 0.146884054700421102},
    {"besselj0(40)", 0.00736689058423728955},
    {"besselj1(0.25)", 0.124025977322726923},
    {"besselj1(2)", 0.576724807756873387},
    {"besselj1(12.5)", -0.165483804614759718},
    {"besselj1(40)", 0.126038318037584999},
    {"besseli0(0.25)", 1.01568614122360792},
    {"besseli0(2)", 2.27958530233606727},
    {"besseli0(12.5)", 30596.3351557851536},
    {"besseli0(40)", 14894774793419899.9},
    {"besseli1(0.25)", 0.125979108945467926},
    {"besseli1(2)", 1.59063685463732906},
    {"besseli1(12.5)", 29345.7496420711273},
    {"besseli1(40)", 14707396163259352.7},
    {"besselk0(0.25)", 1.54150675124830282},
    {"besselk0(2)", 0.113893872749533436},
    {"besselk0(12.5)", 1.30840369677697743e-6},
    {"besselk0(40)", 8.39286110009956703e-19},
    {"besselk1(0.25)", 3.74702597444071164},
    {"besselk1(2)", 0.139865881816522427},
    {"besselk1(12.5)", 1.35976784382151759e-6},
    {"besselk1(40)", 8.49713195486103865e-19},
    {"trigamma(0.25)", 17.1973291545071107},
    {"trigamma(2)", 0.644934066848226436},
    {"trigamma(12.5)", 0.0832852246015783704},
    {"trigamma(40)", 0.0253151038412910282},
    {"gammap(0.5, 0.25)", 0.520499877813046538},
    {"gammaq(0.5, 0.25)", 0.479500122186953462},
    {"gammap(3, 2)", 0.323323583816936541},
    {"gammaq(3, 2)", 0.676676416183063459},
    {"gammap(2.5, 8)", 0.993155926077579569},
    {"gammaq(2.5, 8)", 0.006844073922420431},
    {"gammap(10, 9.5)", 0.478173977762792589},
    {"gammaq(10, 9.5)", 0.521826022237207411},
    {"gammap(100, 110)", 0.841721329939912906},
    {"gammaq(100, 110)", 0.158278670060087094},
    {"gammap(0.125, 0.0009765625)", 0.446409192165004082},
    {"gammaq(0.125, 0.0009765625)", 0.553590807834995918},
};

TEST(SpecialFunctions, AgreeWithAnotherProgram) {
  for (const Known& known : kKnown) {
    EXPECT_NEAR(valueOf(known.text), known.value, 2e-15 * std::fabs(known.value)) << known.text;
    EXPECT_NEAR(batchValueOf(known.text), known.value, 4e-15 * std::fabs(known.value)) << known.text;
  }
}

struct KnownSlope {
  const char* text;
  double parameter, slope;
};
/// dP/da by the other program's own differences.
constexpr KnownSlope kSlopes[] = {
    {"gammap(p, 0.25)", 0.5, -0.797947316783222941}, {"gammap(p, 2)", 3, -0.231848672043989592},
    {"gammap(p, 8)", 2.5, -0.0103088641775120168},   {"gammap(p, 9.5)", 10, -0.128827641679308206},
    {"gammap(p, 110)", 100, -0.0238086568548903865}, {"gammap(p, 0.0009765625)", 0.125, -2.92119042790713714},
};

TEST(SpecialFunctions, SlopesOfTheIncompleteGammaFunctionInItsFirstArgumentAgreeWithAnotherProgram) {
  const std::vector<std::string> names{"p"};
  for (const KnownSlope& known : kSlopes) {
    Graph graph;
    ParseOptions options;
    options.parameters = names;
    const NodeId root = parse(graph, known.text, options).value;
    const Program program(graph, derivatives(graph, root, {0}));
    const double* inputs[8] = {};
    double got = 0;
    double* output = &got;
    program.run(inputs, std::vector{known.parameter}, &output, 1);
    EXPECT_NEAR(got, known.slope, 1e-13 * std::fabs(known.slope)) << known.text;
  }
}

TEST(SpecialFunctions, SatisfyTheirIdentities) {
  for (const double x : {0.1, 0.7, 3.0, 11.0, 45.0}) {
    const std::string t = std::to_string(x);
    // DLMF 8.4.1, 8.4.5: P(1/2, x^2) = erf x, Q(1, x) = exp(-x); Wronskian 10.28.2: I0 K1 + I1 K0 = 1/x.
    EXPECT_NEAR(valueOf("gammap(0.5, " + t + "^2) - erf(" + t + ")"), 0, 1e-15);
    EXPECT_NEAR(valueOf("gammaq(1, " + t + ") * exp(" + t + ")"), 1, 1e-15);
    EXPECT_NEAR(
        valueOf("(besseli0(" + t + ") * besselk1(" + t + ") + besseli1(" + t + ") * besselk0(" + t + ")) * " + t), 1,
        1e-15);
  }
}

TEST(SpecialFunctions, OutsideTheirDomainAreNotNumbers) {
  for (const char* text : {"gammap(-1, 1)", "gammap(0, 1)", "gammaq(1, -1)", "besselk0(-1)", "besselk1(-1)",
                           "trigamma(-1)", "trigamma(0)"}) {
    EXPECT_TRUE(std::isnan(valueOf(text))) << text;
    EXPECT_TRUE(std::isnan(batchValueOf(text))) << text;
  }
  EXPECT_EQ(batchValueOf("gammap(2, 0)"), 0);
  EXPECT_EQ(batchValueOf("gammaq(2, 0)"), 1);
}

}  // namespace
}  // namespace brdf::formula
