#include "SimulationSupport.h"

#include <brdf/base/Error.h>
#include <brdf/sampling/PathRandom.h>
#include <brdf/sampling/Sequence.h>
#include <brdf/simulate/LayoutChoice.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

using Bins = LayoutRequest::Bins;
using Q = AxisQuantity;
using testing::facetedSurface;

/// Light that leaves by a known distribution: half of it Lambertian, half in a Gaussian peak.
class KnownLight : public Transport {
 public:
  enum class About { Nothing, Mirror, Light, Tilted };
  KnownLight(About about, double width) : about_(about), width_(width) {}

  void trace(const RayBatch& batch, const OutgoingBins& bins, Tally& tally) override {
    PathRandom random(batch.seed);
    const Direction wi = bins.wi();
    for (std::uint64_t ray = 0; ray < batch.count; ++ray) {
      const double which = random.next(), u = random.next(), v = random.next();
      Direction wo = cosineDirection(u, v);
      if (about_ != About::Nothing && which < 0.5) {
        const Direction pole = about_ == About::Mirror  ? Direction{-wi[0], -wi[1], wi[2]}
                               : about_ == About::Light ? wi
                                                        : fromSpherical(radians(37.3), radians(123.4));
        Direction t, b;
        orthonormalBasis(pole, t, b);
        const double r = width_ * std::sqrt(-2 * std::log1p(-u)), x = r * std::cos(2 * kPi * v),
                     y = r * std::sin(2 * kPi * v);
        for (std::size_t k = 0; k < 3; ++k) wo[k] = pole[k] + x * t[k] + y * b[k];
        wo = normalized(wo);
      }
      if (!(wo[2] > 0)) continue;
      tally.reflected.add(bins.find(wo), 1);
      if (tally.listsDepartures) tally.departures.push_back({wo, 1, false});
    }
    tally.rays += batch.count;
  }

 private:
  About about_;
  double width_;
};

LayoutRequest request(const std::vector<double>& thetaI, const std::vector<double>& phiI, Bins bins = Bins::Automatic) {
  LayoutRequest asked;
  for (const double angle : thetaI) asked.thetaI.push_back(radians(angle));
  for (const double angle : phiI) asked.phiI.push_back(radians(angle));
  asked.bins = bins;
  return asked;
}

/// The widest cell that reaches within `reach` of `at`.
double widest(const GridAxis& axis, double at, double reach) {
  double most = 0;
  for (std::size_t k = 0; k < axis.size(); ++k)
    if (axis.edges[k + 1] > at - reach && axis.edges[k] < at + reach)
      most = std::max(most, axis.edges[k + 1] - axis.edges[k]);
  return most;
}

TEST(LayoutChoice, WhatHasNoPeakKeepsUniformCells) {
  for (const std::vector<double>& phiI : {std::vector<double>{}, std::vector<double>{0, 90}}) {
    KnownLight light(KnownLight::About::Nothing, 0);
    const LayoutRequest asked = request({0, 30, 60, 80}, phiI);
    const LayoutChoice choice = chooseLayout(light, 1, asked);
    LayoutRequest uniform = asked;
    uniform.bins = Bins::Spherical;
    EXPECT_EQ(choice.layout, chooseLayout(light, 1, uniform).layout) << choice.reason;
  }
  // Neither does a peak that the cells show as it is: a standard deviation of two cells.
  KnownLight broad(KnownLight::About::Mirror, radians(10.0));
  EXPECT_EQ(chooseLayout(broad, 1, request({0, 30}, {})).layout.axes[0].size(), 18u);
}

TEST(LayoutChoice, APeakIsSpannedByNarrowCellsWhereverItIs) {
  for (const double width : {1.0, 0.1}) {
    const double sigma = radians(width);
    for (const auto about : {KnownLight::About::Mirror, KnownLight::About::Light}) {
      KnownLight light(about, sigma);
      const LayoutChoice choice = chooseLayout(light, 1, request({20, 45, 70}, {0, 60}));
      EXPECT_EQ(choice.layout.parametrisation, Parametrisation::Specular) << choice.reason;
      EXPECT_EQ(choice.layout.specularOffsets.empty(), about == KnownLight::About::Mirror) << choice.reason;
      // A cell within two standard deviations is narrower than one.
      EXPECT_LT(widest(choice.layout.axes[0], 0, 2 * sigma), sigma) << choice.reason;
      EXPECT_NEAR(widest(choice.layout.axes[0], radians(120.0), radians(20.0)), radians(5.0), 1e-9);
    }
    KnownLight tilted(KnownLight::About::Tilted, sigma);
    const LayoutChoice choice = chooseLayout(tilted, 1, request({20, 45, 70}, {0, 60}));
    ASSERT_EQ(choice.layout.parametrisation, Parametrisation::Spherical) << choice.reason;
    EXPECT_LT(widest(choice.layout.axes[0], radians(37.3), 2 * sigma), sigma);
    EXPECT_LT(widest(choice.layout.axes[1], radians(123.4), 2 * sigma), sigma / std::sin(radians(37.3)));
    EXPECT_NEAR(widest(choice.layout.axes[0], radians(70.0), radians(10.0)), radians(5.0), 1e-9);
    EXPECT_NEAR(widest(choice.layout.axes[1], radians(270.0), radians(60.0)), radians(5.0), 1e-9);
  }
}

TEST(LayoutChoice, TheNumberOfCellsIsBounded) {
  // Peaks of no width at another place for each of 40 directions of light.
  KnownLight light(KnownLight::About::Light, 0);
  std::vector<double> angles;
  for (int k = 1; k <= 40; ++k) angles.push_back(2.1 * k);
  EXPECT_LE(chooseLayout(light, 1, request(angles, {0, 30, 60, 90})).layout.cells(), std::size_t{1} << 22);
}

TEST(LayoutChoice, RefusesWhatIsNoRequest) {
  KnownLight light(KnownLight::About::Nothing, 0);
  EXPECT_THROW(chooseLayout(light, 1, request({}, {})), Error);
  EXPECT_THROW(chooseLayout(light, 1, request({30, 20}, {})), Error);
  LayoutRequest fine = request({30}, {});
  fine.step = radians(0.01);
  EXPECT_THROW(chooseLayout(light, 1, fine), Error);
}

/// The table that a choice of bins makes of a surface.
std::shared_ptr<const GridBrdf> measured(const Microsurface& surface, const GridLayout& layout, std::uint64_t rays) {
  GonioreflectometerOptions options;
  options.layout = layout;
  options.minimumRays = options.maximumRays = rays;
  return simulateBrdf(surface, options).brdf;
}

TEST(LayoutChoice, MirrorGroovesSendLightBackWhereCellsAreAsWideAsEver) {
  // TransportTest: 1 - tan(theta_i) of the light comes back, in the light's direction exactly: no width, no cut.
  const Microsurface surface = facetedSurface(testing::vGrooves(), {"mirror"});
  LayoutRequest asked = request({20, 30}, {0});
  const LayoutChoice automatic = chooseLayout(*makeTransport("cpu", surface), 1, asked);
  asked.bins = LayoutRequest::Bins::Spherical;
  EXPECT_EQ(automatic.layout.axes, chooseLayout(*makeTransport("cpu", surface), 1, asked).layout.axes);
  asked.bins = LayoutRequest::Bins::Retro;
  const LayoutChoice choice = chooseLayout(*makeTransport("cpu", surface), 1, asked);
  ASSERT_EQ(choice.layout.specularOffsets.size(), 2u) << choice.reason;
  EXPECT_NEAR(choice.layout.axes[0].edges[1], asked.step, 1e-12);
  constexpr std::uint64_t rays = 100'000;
  const auto table = measured(surface, choice.layout, rays);
  for (const double theta : asked.thetaI) {
    const double t = std::tan(theta), sigma = std::sqrt(t * (1 - t) / rays);
    const OutgoingBins bins(choice.layout, theta, 0);
    double measure = 0, most = 0, light = 0;
    for (std::size_t b = 0; b < bins.count(); ++b)
      if (bins.ring(b) == 0) measure += bins.projectedSolidAngles()[b];
    const double width = choice.layout.axes[0].edges[1];
    EXPECT_NEAR(measure / (kPi * std::sin(width) * std::sin(width) * std::cos(theta)), 1, 1e-9);  // of a whole cap
    // The look-up about the light: rounding decides the azimuth, and so the sector: what is in all of them.
    const std::size_t sectors = choice.layout.axes[1].size();
    for (std::size_t k = 0; k < sectors; ++k) {
      const auto& axis = choice.layout.axes[1];
      const double phi = axis.nodes[k];
      const double pole = -theta, c = std::cos(pole), s = std::sin(pole), r = width / 2;
      const Direction local = fromSpherical(r, phi);
      const double u = c * local[0] - s * local[2];
      const Direction wo{u, local[1], s * local[0] + c * local[2]};
      const double value = table->evaluate(fromSpherical(theta, 0), wo)[0];
      light += value * bins.projectedSolidAngles()[bins.find(wo)];
      most = std::max(most, value);
    }
    EXPECT_GT(most, 0);
    EXPECT_NEAR(light, 1 - t, 5 * sigma + 1e-4) << degrees(theta);
  }
}

TEST(LayoutChoice, TiltedGlossyFacetsAreMeasuredBetterThanByAsManyUniformCells) {
  // Grooves along y, walls tilted by 10 degrees either way: facets that neither shadow each other nor, narrow as their
  // lobes are, light each other. Each wall has half of the tile's area, and so
  // f_r = sum over walls of (1/2) f_facet (n . wi) (n . wo) / (n_z cos theta_i cos theta_o).
  const double tilt = radians(10.0), theta = radians(20.0);
  const auto high = static_cast<float>(0.5 * std::tan(tilt));
  const Microsurface surface =
      facetedSurface(HeightField{2, 2, 0.5, 0.5, {high, 0, high, 0}}, {"scattering(GGX(alpha=0.01, ior=1.5))"});
  const Direction wi = fromSpherical(theta, 0);
  const auto exact = [&](const Direction& wo) {
    double sum = 0;
    for (const double side : {-1.0, 1.0}) {
      const double c = std::cos(tilt), s = side * std::sin(tilt);
      const auto turned = [&](const Direction& w) { return Direction{c * w[0] - s * w[2], w[1], s * w[0] + c * w[2]}; };
      const Direction a = turned(wi), b = turned(wo);
      sum += 0.5 * surface.facets[0].brdf->evaluate(a, b)[0] * a[2] * b[2] / (c * wi[2] * wo[2]);
    }
    return sum;
  };
  LayoutRequest asked = request({20}, {0});
  const auto transport = makeTransport("cpu", surface);
  const LayoutChoice choice = chooseLayout(*transport, 1, asked);
  LayoutRequest uniform = asked;
  uniform.bins = Bins::Spherical;
  const double cells = static_cast<double>(choice.layout.cells());
  uniform.step = std::sqrt(kPi / 2 * 2 * kPi / cells);
  const GridLayout plain = chooseLayout(*transport, 1, uniform).layout;
  EXPECT_NEAR(static_cast<double>(plain.cells()) / cells, 1, 0.05);
  constexpr std::uint64_t rays = 1'000'000;
  const auto fine = measured(surface, choice.layout, rays), coarse = measured(surface, plain, rays);
  // The peaks are turned by twice the tilt from the mirror direction: at the normal, and at 40 degrees.
  double square = 0, ofFine = 0, ofCoarse = 0;
  for (const double peak : {0.0, -40.0})
    for (int i = -30; i <= 30; ++i)
      for (int k = -30; k <= 30; ++k) {
        const Direction wo =
            normalized({std::sin(radians(peak)) + radians(0.1) * i * std::cos(radians(peak)), radians(0.1) * k,
                        std::cos(radians(peak)) - radians(0.1) * i * std::sin(radians(peak))});
        const double value = exact(wo);
        square += value * value;
        ofFine += std::pow(fine->evaluate(wi, wo)[0] - value, 2);
        ofCoarse += std::pow(coarse->evaluate(wi, wo)[0] - value, 2);
      }
  RecordProperty("error", std::to_string(std::sqrt(ofFine / square)));
  RecordProperty("uniform", std::to_string(std::sqrt(ofCoarse / square)));
  EXPECT_LT(std::sqrt(ofFine / square), 0.15) << choice.layout.text() << ", " << choice.reason;
  EXPECT_GT(std::sqrt(ofCoarse / square), 3 * std::sqrt(ofFine / square)) << plain.text();
}

}  // namespace
}  // namespace brdf
