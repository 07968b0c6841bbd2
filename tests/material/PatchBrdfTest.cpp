// Patches of directions: Klems bases, look-up, sampling and averaging.
#include <brdf/base/Error.h>
#include <brdf/material/Averages.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/PatchBrdf.h>
#include <brdf/material/SampleSet.h>
#include <brdf/sampling/SamplerChecks.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace brdf {
namespace {

/// 3 incident patches (one at the pole, two around), 5 outgoing ones; every value its own.
PatchData smallData(Channels channels = Channels::monochrome()) {
  PatchData data{PatchBasis("in", {{radians(40), 1}, {radians(90), 2}}),
                 PatchBasis("out", {{radians(30), 1}, {radians(60), 3}, {radians(90), 1}}),
                 std::move(channels),
                 {}};
  for (std::size_t i = 0; i < 15 * data.channels.count(); ++i)
    data.values.push_back(0.02 * static_cast<double>(i % 11));
  return data;
}

Direction degreesDirection(double theta, double phi) { return fromSpherical(radians(theta), radians(phi)); }

}  // namespace

TEST(PatchBasis, KlemsBasesHaveTheirPatchesAndFillTheHemisphere) {
  const struct {
    const PatchBasis& basis;
    std::size_t count;
  } cases[] = {{PatchBasis::klemsFull(), 145}, {PatchBasis::klemsHalf(), 77}, {PatchBasis::klemsQuarter(), 41}};
  for (const auto& [basis, count] : cases) {
    EXPECT_EQ(basis.count(), count);
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) sum += basis.projectedSolidAngle(k);
    EXPECT_NEAR(sum, kPi, 1e-14);
    // Of the pole's cap: pi sin^2 of its half angle.
    const double s = std::sin(basis.rings()[0].upperTheta);
    EXPECT_NEAR(basis.projectedSolidAngle(0), kPi * s * s, 1e-15);
  }
}

TEST(PatchBasis, NumbersRingsFromThePoleAndAzimuthsFromZeroAcross) {
  const PatchBasis& full = PatchBasis::klemsFull();
  const auto find = [&](double theta, double phi) {
    const Direction w = degreesDirection(theta, phi);
    return full.find(w[0], w[1], w[2]);
  };
  EXPECT_EQ(find(0, 0), 0u);
  EXPECT_EQ(find(4.9, 123), 0u);
  EXPECT_EQ(find(5.1, 0), 1u);
  EXPECT_EQ(find(10, 22), 1u);  // patch 0 of 8 straddles the azimuth 0: -22.5 to 22.5 degrees
  EXPECT_EQ(find(10, -22), 1u);
  EXPECT_EQ(find(10, 23), 2u);
  EXPECT_EQ(find(10, -23), 8u);
  EXPECT_EQ(find(16, 0), 9u);
  EXPECT_EQ(find(89, 180), 145u - 6);  // 6 of 12
  EXPECT_EQ(find(91, 0), PatchBasis::npos);
  EXPECT_EQ(full.find(0, 0, 1.0000001), 0u);
}

TEST(PatchBasis, CentresPointsAndMirrorImagesLieWhereTheyBelong) {
  for (const PatchBasis* basis : {&PatchBasis::klemsFull(), &PatchBasis::klemsHalf(), &PatchBasis::klemsQuarter()})
    for (std::size_t k = 0; k < basis->count(); ++k) {
      const Direction c = basis->centre(k);
      EXPECT_EQ(basis->find(c[0], c[1], c[2]), k);
      EXPECT_EQ(basis->find(c[0], -c[1], c[2]), basis->mirrored(k));
      for (const double u : {0.01, 0.5, 0.99})
        for (const double v : {0.01, 0.99}) {
          const Direction p = basis->at(k, u, v);
          EXPECT_NEAR(dot(p, p), 1, 1e-15);
          EXPECT_EQ(basis->find(p[0], p[1], p[2]), k);
        }
    }
}

TEST(PatchBasis, RefusesRingsOutOfOrder) {
  EXPECT_THROW(PatchBasis("a", {}), Error);
  EXPECT_THROW(PatchBasis("a", {{radians(50), 1}, {radians(40), 4}}), Error);
  EXPECT_THROW(PatchBasis("a", {{radians(91), 1}}), Error);
  EXPECT_THROW(PatchBasis("a", {{radians(45), 0}}), Error);
  EXPECT_THROW(PatchBasis("a", {{std::nan(""), 1}}), Error);
}

TEST(PatchBrdf, LooksUpTheTravelOfLightAndTheViewer) {
  const PatchBrdf brdf(smallData(), "small");
  // Incident patch 1 is centred at azimuth 0 of the travel: a light at azimuth 180 degrees.
  const auto value = [&](double thetaI, double phiI, double thetaO, double phiO) {
    return brdf.evaluate(degreesDirection(thetaI, phiI), degreesDirection(thetaO, phiO))[0];
  };
  const auto expected = [](std::size_t o, std::size_t i) { return 0.02 * static_cast<double>((o * 3 + i) % 11); };
  EXPECT_EQ(value(20, 0, 10, 0), expected(0, 0));
  EXPECT_EQ(value(60, 180, 45, 0), expected(1, 1));
  EXPECT_EQ(value(60, 0, 45, 120), expected(2, 2));
  EXPECT_EQ(value(60, 10, 45, 250), expected(3, 2));
  EXPECT_EQ(value(60, -100, 80, 33), expected(4, 1));
  EXPECT_EQ(value(60, 0, 95, 0), 0);
}

TEST(PatchBrdf, BasesThatEndEarlyAreInvalidBeyond) {
  PatchData data = smallData();
  data.outgoing = PatchBasis("out", {{radians(30), 1}, {radians(60), 4}});
  const PatchBrdf brdf(std::move(data), "clipped");
  DirectionPairBuffer<double> pairs;
  pairs.push({0, 0, 1}, degreesDirection(59, 0));
  pairs.push({0, 0, 1}, degreesDirection(61, 0));
  pairs.push({0, 0, 1}, degreesDirection(95, 0));
  double values[3];
  std::uint8_t valid[3];
  brdf.evaluate(pairs.view(), values, valid);
  EXPECT_EQ(valid[0], 1);
  EXPECT_EQ(valid[1], 0);
  EXPECT_EQ(values[1], 0);
  EXPECT_EQ(valid[2], 1) << "below the horizon there is no reflection, which is known";
}

TEST(PatchBrdf, SamplesAreThePairsOfPatchesAndLookUpTheirOwnValues) {
  const PatchBrdf brdf(smallData(Channels::rgb()), "small");
  const SampleSet& samples = *brdf.samples();
  ASSERT_EQ(samples.count(), 15u);
  DirectionPairBuffer<double> pairs;
  std::vector<double> values(45), found(45);
  std::vector<std::uint8_t> valid(15);
  samples.read(0, 15, &pairs, values.data(), valid.data());
  brdf.evaluate(pairs.view(), found.data(), nullptr);
  EXPECT_EQ(values, found);
  EXPECT_EQ(valid, std::vector<std::uint8_t>(15, 1));
}

TEST(PatchBrdf, DrawsEachPatchByItsShareAndEvenlyWithin) {
  const PatchBrdf brdf(smallData(), "small");
  const PatchBasis& incident = brdf.data().incident;
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> uniform;
  for (const auto& [theta, phi] : {std::pair{10.0, 0.0}, {45.0, 0.0}, {45.0, 130.0}, {80.0, 5.0}}) {
    const Direction wo = degreesDirection(theta, phi);
    const std::size_t o = brdf.data().outgoing.find(wo[0], wo[1], wo[2]);
    double total = 0;
    std::vector<double> expected, observed(3, 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
      expected.push_back(brdf.data().values[o * 3 + i] * incident.projectedSolidAngle(i));
      total += expected.back();
    }
    constexpr int draws = 20000;
    for (double& e : expected) e *= draws / total;
    for (int k = 0; k < draws; ++k) {
      const double u = uniform(engine), v = uniform(engine);
      Direction wi;
      brdf.sample({&wo[0], &wo[1], &wo[2]}, {&u, &v}, {&wi[0], &wi[1], &wi[2]}, 1);
      const std::size_t i = incident.find(-wi[0], -wi[1], wi[2]);
      ASSERT_LT(i, 3u);
      ++observed[i];
    }
    EXPECT_GT(chiSquare(observed, expected).probability, sidakSignificance(0.001, 4)) << theta;
    SamplerTestOptions options;
    options.draws = 40000;
    options.cells = 200;
    const SamplerTest test = testSampler(samplerOf(brdf), wo, options);
    EXPECT_GT(test.chiSquare.probability, sidakSignificance(0.001, 4)) << theta;
    EXPECT_NEAR(test.integral, 1, 5e-3) << theta;
    EXPECT_EQ(test.failed + static_cast<double>(test.bad + test.uncovered), 0) << theta;
  }
}

TEST(PatchBrdf, RefusesAWrongNumberOfValues) {
  PatchData data = smallData();
  data.values.pop_back();
  EXPECT_THROW(PatchBrdf(std::move(data), "short"), Error);
}

TEST(PatchAverage, LambertianIsReproducedWithItsEnergy) {
  AverageReport report;
  const auto mean = averageOverPatches(*parseMaterialExpression("(0.5,0.7,0.2)*Lambertian"), PatchBasis::klemsFull(),
                                       PatchBasis::klemsQuarter(), {}, report);
  const std::array<double, 3> albedo{0.5, 0.7, 0.2};
  EXPECT_LT(report.error, 1e-14);
  EXPECT_EQ(report.invalid, 0u);
  for (std::size_t k = 0; k < mean->data().values.size(); ++k)
    ASSERT_NEAR(mean->data().values[k], albedo[k / (145 * 41)] / kPi, 1e-15);
  const auto albedos = mean->directionalAlbedos();
  for (std::size_t k = 0; k < albedos.size(); ++k) ASSERT_NEAR(albedos[k], albedo[k / 145], 1e-13);
}

TEST(PatchAverage, MeansAreTheIntegralsWithinTheErrorStated) {
  // f = 0.1 (1 + wo.z^2 wi.z): over patches the integral of the cosines' powers has a closed form.
  class Powers : public Brdf {
   public:
    const Channels& channels() const override { return channels_; }
    Symmetry symmetry() const override { return Symmetry::Isotropic; }
    bool reciprocal() const override { return false; }
    std::string description() const override { return "powers"; }
    using Brdf::evaluate;
    void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override {
      for (std::size_t k = 0; k < pairs.count; ++k) {
        values[k] = 0.1 * (1 + pairs.wo[2][k] * pairs.wo[2][k] * pairs.wi[2][k]);
        if (valid) valid[k] = 1;
      }
    }

   private:
    Channels channels_;
  };
  AverageReport report;
  const auto mean = averageOverPatches(Powers(), PatchBasis::klemsFull(), PatchBasis::klemsFull(), {}, report);
  // Mean of z^n weighted by z between cosines a > b: 2 (a^(n+2) - b^(n+2)) / ((n+2) (a^2 - b^2)).
  const auto meanPower = [](int n, double a, double b) {
    return 2 * (std::pow(a, n + 2) - std::pow(b, n + 2)) / ((n + 2) * (a * a - b * b));
  };
  const PatchBasis& full = PatchBasis::klemsFull();
  const std::vector<double> bounds{0, 5, 15, 25, 35, 45, 55, 65, 75, 90};
  const auto ringMean = [&](int n, std::size_t patch) {
    const double theta = degrees(toSpherical(full.centre(patch)).theta);
    const auto upper = std::upper_bound(bounds.begin(), bounds.end(), theta);
    return meanPower(n, std::cos(radians(*(upper - 1))), std::cos(radians(*upper)));
  };
  for (const std::size_t i : {0u, 4u, 60u, 140u}) {
    double error = 0, energy = 0;
    for (std::size_t o = 0; o < 145; ++o) {
      const double exact = 0.1 * (1 + ringMean(2, o) * ringMean(1, i));
      error += std::abs(mean->data().values[o * 145 + i] - exact) * full.projectedSolidAngle(o);
      energy += exact * full.projectedSolidAngle(o);
    }
    EXPECT_LT(error / energy, report.error) << i;
  }
  EXPECT_LT(report.error, 2e-3);
  EXPECT_GT(report.error, 1e-7);
}

}  // namespace brdf
