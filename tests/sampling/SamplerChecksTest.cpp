// The checks of samplers themselves: they pass what is right, and they can fail.
#include <brdf/material/LobeSum.h>
#include <brdf/sampling/SamplerChecks.h>
#include <gtest/gtest.h>

#include <random>

#include "FunctionBrdf.h"

namespace brdf {
namespace {

const Direction kViewer = fromSpherical(radians(50), 0.7);

/// The cosine sampler with a density that is `wrong`(wi) times the right one.
DirectionSampler wrongCosine(std::function<double(const Direction&)> wrong) {
  DirectionSampler sampler = cosineSampler();
  sampler.pdf = [right = sampler.pdf, wrong](const DirectionPairs<double>& pairs, double* density) {
    right(pairs, density);
    for (std::size_t i = 0; i < pairs.count; ++i) density[i] *= wrong({pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]});
  };
  return sampler;
}

TEST(ChiSquare, MatchesPublishedCriticalValues) {
  // Two cells with statistic 3.841 and eleven with 18.307: the 5 % points for 1 and 10 degrees of freedom
  // (NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.4).
  const double one = std::sqrt(3.841 * 100 / 2);
  const ChiSquare two = chiSquare(std::array{100 + one, 100 - one}, std::array{100.0, 100.0});
  EXPECT_EQ(two.cells, 2u);
  EXPECT_NEAR(two.statistic, 3.841, 1e-9);
  EXPECT_NEAR(two.probability, 0.05, 2e-5);  // the published points have three decimals
  std::vector<double> observed(11, 100), expected(11, 100);
  observed[4] += std::sqrt(18.307 * 100);
  const ChiSquare eleven = chiSquare(observed, expected);
  EXPECT_NEAR(eleven.probability, 0.05, 2e-5);
  EXPECT_EQ(eleven.worst, 4u);
}

TEST(ChiSquare, PoolsCellsThatExpectTooLittle) {
  const ChiSquare pooled = chiSquare(std::array{3.0, 4.0, 5.0, 100.0}, std::array{4.0, 4.0, 4.0, 100.0}, 10);
  EXPECT_EQ(pooled.cells, 2u);
  EXPECT_DOUBLE_EQ(pooled.statistic, 0);
}

TEST(ChiSquare, SeesDrawsWhereNoneBelong) {
  EXPECT_LT(chiSquare(std::array{20.0, 1000.0}, std::array{0.0, 1020.0}).probability, 1e-10);
}

TEST(Sidak, MakesTheChanceOfAnyFalseAlarmTheLevel) {
  EXPECT_DOUBLE_EQ(sidakSignificance(0.05, 1), 0.05);
  for (const std::size_t tests : {2u, 100u, 100'000u})
    EXPECT_NEAR(1 - std::pow(1 - sidakSignificance(0.01, tests), static_cast<double>(tests)), 0.01, 1e-10);
}

TEST(SamplerChecks, PassTheCosineSampler) {
  for (const double angle : {0.0, 30.0, 60.0, 85.0, 89.9}) {
    const SamplerTest test = testSampler(cosineSampler(), fromSpherical(radians(angle), 2.0));
    EXPECT_GT(test.chiSquare.probability, sidakSignificance(0.001, 5)) << angle;
    EXPECT_NEAR(test.integral, 1, 1e-3) << angle;
    EXPECT_EQ(test.failed, 0);
    EXPECT_EQ(test.bad, 0u);
    EXPECT_EQ(test.uncovered, 0u);
  }
}

TEST(SamplerChecks, RejectADensityOfTheWrongTotal) {
  const SamplerTest test = testSampler(wrongCosine([](const Direction&) { return 1.01; }), kViewer);
  EXPECT_GT(test.deviation, 5);
  EXPECT_NEAR(test.integral, 1.01, 1e-3);
}

TEST(SamplerChecks, RejectADensityTenPercentOffInAQuarterOfTheHemisphere) {
  const SamplerTest test =
      testSampler(wrongCosine([](const Direction& wi) { return wi[0] > 0 ? (wi[1] > 0 ? 1.1 : 0.9) : 1.0; }), kViewer);
  EXPECT_LT(test.chiSquare.probability, 1e-10);
  EXPECT_LT(std::fabs(test.deviation), 3);
}

TEST(SamplerChecks, CountDirectionsThatAreNone) {
  DirectionSampler sampler = cosineSampler();
  sampler.sample = [draw = sampler.sample](const auto& wo, const auto& u, const auto& wi, std::size_t count) {
    draw(wo, u, wi, count);
    for (std::size_t i = 0; i < count; ++i) {
      const double scale = u[0][i] < 0.1 ? 0 : u[0][i] < 0.2 ? 2 : 1;
      for (std::size_t axis = 0; axis < 3; ++axis) wi[axis][i] *= scale;
    }
  };
  const SamplerTest test = testSampler(sampler, kViewer);
  EXPECT_NEAR(test.failed, 0.1, 0.005);
  EXPECT_NEAR(static_cast<double>(test.bad), 10'000, 500);
}

TEST(SamplerChecks, IntegrateAPeakOfAnyWidthAndPlace) {
  // The visible-normal sampler of GGX integrates to 1 less its failed draws; here next to none fail.
  for (const char* alpha : {"1e-4", "1e-3", "0.02"}) {
    const auto ggx = parseMaterialExpression("GGX(alpha=" + std::string(alpha) + ")");
    for (const double angle : {0.0, 20.0, 70.0})
      EXPECT_NEAR(pdfIntegral(samplerOf(*ggx), fromSpherical(radians(angle), 1.0)), 1, 2e-3) << alpha << " " << angle;
  }
}

TEST(PdfIntegral, OfWhatHasNoneComesOutLargeAndEnds) {
  // 1 / theta^3 about the mirror direction and about the viewer, infinite in all.
  DirectionSampler sampler = cosineSampler();
  std::size_t evaluations = 0;
  sampler.pdf = [&](const DirectionPairs<double>& pairs, double* density) {
    evaluations += pairs.count;
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const double x = std::hypot(pairs.wi[0][i] + kViewer[0], pairs.wi[1][i] + kViewer[1]);
      const double y = std::hypot(pairs.wi[0][i] - kViewer[0], pairs.wi[1][i] - kViewer[1]);
      density[i] = std::pow(std::min(x, y) + 1e-300, -3);
    }
  };
  EXPECT_GT(pdfIntegral(sampler, kViewer), 1e3);
  EXPECT_LT(evaluations, std::size_t{70'000'000});  // 4 parts of 64 midpoints for each of 2^18 divisions
}

TEST(RelativeVariance, OfCosineSamplingAPowerOfTheCosineIsTheClosedForm) {
  // f = cos^n about the normal: A = 2 pi/(n + 2), the second moment 2 pi^2/(2 n + 2), so that the variance over A^2 is
  // (n + 2)^2/(4 n + 4) - 1.
  for (const double n : {0.0, 1.0, 10.0, 1000.0}) {
    const test::FunctionBrdf power([n](const Direction& wi, const Direction&) { return std::pow(wi[2], n); });
    const double theta[] = {radians(50)};
    const Efficiency found = efficiency(power, theta)[0];
    const double exact = (n + 2) * (n + 2) / (4 * n + 4) - 1;
    EXPECT_NEAR(found.albedo, 2 * kPi / (n + 2), 0.01 * found.albedo) << n;
    EXPECT_NEAR(found.cosineRelativeVariance, exact, 0.02 * exact + 1e-6) << n;
  }
}

TEST(Efficiency, ChargesCosineSamplingForASharpLobeThatItNeverFinds) {
  const test::FunctionBrdf sharp([](const Direction& wi, const Direction& wo) {
    const double z = wi[2] + wo[2], x = wi[0] + wo[0], y = wi[1] + wo[1];
    return 1e5 * std::exp(-(x * x + y * y) / (z * z) * 1e6);
  });
  const double thetas[] = {radians(10), radians(60)};
  for (const Efficiency& found : efficiency(sharp, thetas)) {
    EXPECT_GT(found.relativeVariance, 1e4);
    EXPECT_NEAR(found.relativeVariance, found.cosineRelativeVariance, 1e-9 * found.relativeVariance);
  }
}

}  // namespace
}  // namespace brdf
