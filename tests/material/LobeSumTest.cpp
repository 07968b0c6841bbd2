// Sums of lobes: values add, channels are independent, and the mixture of samplers draws what its density says.
#include <brdf/base/Error.h>
#include <brdf/check/Cases.h>
#include <brdf/material/LobeSum.h>
#include <brdf/sampling/SamplerChecks.h>
#include <gtest/gtest.h>

namespace brdf {
namespace {

std::vector<double> valuesOf(const Brdf& brdf, const CheckPairs& set) {
  std::vector<double> values(brdf.channels().count() * set.size());
  brdf.evaluate(set.pairs.view(), values.data(), nullptr);
  return values;
}

TEST(LobeSum, IsTheSumOfItsScaledLobes) {
  const CheckPairs set = adversarialPairs(150, 1, true);  // more than one block of 1024 pairs
  ASSERT_GT(set.size(), 1024u);
  const std::vector<double> sum = valuesOf(
                                *parseMaterialExpression("0.3*Lambertian + 2*GGX(alpha=0.3) + Ward(ax=0.1, ay=0.4)"),
                                set),
                            a = valuesOf(*parseMaterialExpression("Lambertian"), set),
                            b = valuesOf(*parseMaterialExpression("GGX(alpha=0.3)"), set),
                            c = valuesOf(*parseMaterialExpression("Ward(ax=0.1, ay=0.4)"), set);
  for (std::size_t k = 0; k < set.size(); ++k) EXPECT_DOUBLE_EQ(sum[k], 0.3 * a[k] + 2 * b[k] + c[k]);
}

TEST(LobeSum, AChannelDependentLobeHasEachChannelsOwnShape) {
  const CheckPairs set = adversarialPairs(20, 2, true);
  const std::vector<double> all =
      valuesOf(*parseMaterialExpression("(0.1,0.2,0.3)*GGX(alpha=(0.1,0.2,0.3), ior=1.4)"), set);
  const char* const single[] = {"0.1*GGX(alpha=0.1,ior=1.4)", "0.2*GGX(alpha=0.2,ior=1.4)",
                                "0.3*GGX(alpha=0.3,ior=1.4)"};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::vector<double> one = valuesOf(*parseMaterialExpression(single[channel]), set);
    for (std::size_t k = 0; k < set.size(); ++k)
      EXPECT_EQ(all[channel * set.size() + k], one[k]) << "channel " << channel;
  }
}

TEST(LobeSum, FloatAgreesWithDoubleAtTheSameRoundedDirections) {
  const CheckPairs set = adversarialPairs(50, 3, true).rounded();
  const auto material = parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + GGX(alpha=(0.1,0.2,0.4))");
  const std::vector<double> wide = valuesOf(*material, set);
  std::vector<float> narrow(wide.size());
  const DirectionPairBuffer<float> pairs = set.narrow();
  material->evaluate(pairs.view(), narrow.data(), nullptr);
  for (std::size_t k = 0; k < wide.size(); ++k)
    EXPECT_NEAR(narrow[k], wide[k], 1e-5 * wide[k]) << directionText(set.wi(k % set.size()), set.wo(k % set.size()));
}

TEST(LobeSum, ParallelEvaluationGivesTheSameValues) {
  const CheckPairs set = adversarialPairs(2000, 4, false);
  const auto material = parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + GGX");
  const std::vector<double> alone = valuesOf(*material, set);
  std::vector<double> together(alone.size());
  std::vector<std::uint8_t> valid(set.size());
  material->evaluateParallel(set.pairs.view(), together.data(), valid.data());
  EXPECT_EQ(together, alone);
  EXPECT_EQ(valid, std::vector<std::uint8_t>(set.size(), 1));
}

TEST(LobeSum, SamplingWeightsAreSharesOfReflectedLight) {
  // At equal albedo equal shares; a Lambertian of albedo 0.5 reflects half of what one of albedo 1 does.
  const std::vector<double> weights = parseMaterialExpression("0.5*Lambertian + Lambertian")->samplingWeights();
  EXPECT_NEAR(weights[0], 1.0 / 3, 1e-12);
  EXPECT_NEAR(weights[1], 2.0 / 3, 1e-12);
  // A dark material still draws: equal shares.
  EXPECT_EQ(parseMaterialExpression("0*Lambertian + 0*GGX")->samplingWeights(), (std::vector<double>{0.5, 0.5}));
}

void expectDrawsAsStated(const std::string& expression, double angle) {
  const auto material = parseMaterialExpression(expression);
  const SamplerTest found = testSampler(samplerOf(*material), fromSpherical(radians(angle), 0.7));
  EXPECT_GT(found.chiSquare.probability, 1e-5)
      << expression << " at " << angle << " degrees: chi-square " << found.chiSquare.statistic << " over "
      << found.chiSquare.cells << " cells";
  EXPECT_LT(std::fabs(found.deviation), 5) << expression << " at " << angle << " degrees: " << found.integral;
  EXPECT_EQ(found.bad + found.uncovered, 0u);
}

TEST(LobeSum, AMixtureDrawsWhatItsDensitySays) {
  for (const double angle : {0.0, 45.0, 80.0, 89.0}) {
    expectDrawsAsStated("0.5*Lambertian + GGX(alpha=0.1, ior=3)", angle);
    expectDrawsAsStated("(0.1,0.2,0.3)*Lambertian + GGXConductor(alpha=(0.05,0.2,0.5))", angle);
    expectDrawsAsStated("Ward(ax=0.1, ay=0.4) + BlinnPhong(n=100) + AshikhminShirley(nu=20, nv=500)", angle);
  }
}

TEST(LobeSum, RefusesWhatDoesNotFit) {
  const ModelPointer lambertian = findModel("Lambertian"), ggx = findModel("GGX");
  const auto make = [](std::vector<Lobe> lobes) { LobeSum(std::move(lobes), Channels::rgb()); };
  EXPECT_THROW(make({}), Error);
  EXPECT_THROW(make({Lobe{lambertian, {}, {1, 2}}}), Error);
  EXPECT_THROW(make({Lobe{lambertian, {{0.5}}, {1}}}), Error);
  EXPECT_THROW(make({Lobe{ggx, {{0.5}, {0.5}, {1.5, 1.5}}, {1}}}), Error);
  EXPECT_THROW(make({Lobe{ggx, {{0.5}, {0.5}, {0.5}}, {1}}}), Error);
  EXPECT_THROW(make({Lobe{lambertian, {}, {-1}}}), Error);
  EXPECT_NO_THROW(make({Lobe{ggx, {{0.5}, {0.5}, {1.5}}, {1, 2, 3}}}));
}

}  // namespace
}  // namespace brdf
