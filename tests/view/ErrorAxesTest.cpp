#include "SimpleBrdfs.h"

#include <brdf/base/Error.h>
#include <brdf/view/ErrorAxes.h>

#include <gtest/gtest.h>

#include <map>

namespace brdf {
namespace {

using test::angleBetween;

/// Sums of weights, and of weights times a function, over what a grid visits.
template <class Function>
double weightedMean(const ErrorGrid& grid, Symmetry symmetry, const Function& function) {
  double sum = 0, weight = 0;
  grid.visit(400, symmetry, [&](const DirectionPair& pair, double w) {
    sum += w * function(pair);
    weight += w;
  });
  return sum / weight;
}

TEST(ErrorAxes, WeightsAreTheSolidAnglesOfBothDirections) {
  // Over two hemispheres of equal solid angles: mean cos = 1/2, mean cos^2 = 1/3, and light and viewer independent.
  for (ErrorAxes axes : {ErrorAxes::IncidentOutgoing, ErrorAxes::HalfDifference, ErrorAxes::DifferenceAzimuth})
    for (Symmetry symmetry : {Symmetry::Isotropic, Symmetry::Bilateral, Symmetry::Anisotropic}) {
      const ErrorGrid grid{.axes = axes, .intervals = 60};
      SCOPED_TRACE(static_cast<int>(axes) * 10 + static_cast<int>(symmetry));
      EXPECT_NEAR(weightedMean(grid, symmetry, [](const DirectionPair& p) { return p.wi[2]; }), 0.5, 0.01);
      EXPECT_NEAR(weightedMean(grid, symmetry, [](const DirectionPair& p) { return p.wo[2] * p.wo[2]; }), 1 / 3.0,
                  0.01);
      EXPECT_NEAR(weightedMean(grid, symmetry, [](const DirectionPair& p) { return p.wi[2] * p.wo[2]; }), 0.25, 0.01);
    }
}

TEST(ErrorAxes, DisksWeighViewDirectionsBySolidAngle) {
  for (DiskProjection projection : {DiskProjection::EqualArea, DiskProjection::Orthographic}) {
    const ErrorGrid grid{.axes = ErrorAxes::Hemisphere, .intervals = 400, .projection = projection};
    EXPECT_NEAR(weightedMean(grid, Symmetry::Isotropic, [](const DirectionPair& p) { return p.wo[2]; }), 0.5, 0.02);
    for (double theta : {0.0, 0.3, 1.0, 1.5})
      EXPECT_NEAR(diskTheta(projection, diskRadius(projection, theta)), theta, 1e-14);
    EXPECT_NEAR(diskRadius(projection, kPi / 2), 1, 1e-15);
  }
  EXPECT_NEAR(diskRadius(DiskProjection::EqualArea, radians(60)), std::sqrt(0.5), 1e-15);  // half of the solid angle
  EXPECT_NEAR(diskRadius(DiskProjection::Orthographic, radians(30)), 0.5, 1e-15);
}

TEST(ErrorAxes, EveryPairVisitedCountsAtItsOwnNode) {
  for (ErrorAxes axes :
       {ErrorAxes::IncidentOutgoing, ErrorAxes::HalfDifference, ErrorAxes::DifferenceAzimuth, ErrorAxes::Hemisphere}) {
    const ErrorGrid grid{.axes = axes, .intervals = 12, .phiI = 0.4};
    std::map<std::size_t, std::size_t> visits;
    grid.visit(16, Symmetry::Isotropic, [&](const DirectionPair& pair, double weight) {
      EXPECT_GT(weight, 0);
      EXPECT_NEAR(dot(pair.wi, pair.wi), 1, 1e-14);
      ++visits[grid.nodeOf(pair.wi, pair.wo, Symmetry::Isotropic)];
    });
    EXPECT_EQ(visits.count(ErrorGrid::kNowhere), 0u);
    for (const auto& [node, count] : visits) EXPECT_LE(count, 16u) << node;
    if (axes == ErrorAxes::IncidentOutgoing) {
      EXPECT_EQ(visits.size(), 13u * 13);
      for (const auto& [node, count] : visits) EXPECT_EQ(count, 16u) << node;
    }
    if (axes == ErrorAxes::Hemisphere) {
      for (const auto& [node, count] : visits) EXPECT_EQ(count, 1u) << node;
    }
  }
}

TEST(ErrorAxes, ExchangingLightAndViewerKeepsTheNodeOfDifferenceAzimuth) {
  const ErrorGrid grid{.axes = ErrorAxes::DifferenceAzimuth, .intervals = 36};
  for (int k = 0; k < 100; ++k) {
    const Direction wi = fromSpherical(0.1 + 0.013 * k, 0.37 * k), wo = fromSpherical(1.2 - 0.011 * k, 1.7 * k + 0.3);
    EXPECT_EQ(grid.nodeOf(wi, wo, Symmetry::Isotropic), grid.nodeOf(wo, wi, Symmetry::Isotropic)) << k;
  }
}

TEST(ErrorAxes, AHemisphereTakesOnlyItsIncidentDirection) {
  const ErrorGrid grid{.axes = ErrorAxes::Hemisphere,
                       .intervals = 10,
                       .thetaI = radians(30),
                       .phiI = 0,
                       .projection = DiskProjection::Orthographic,
                       .within = radians(1)};
  const auto node = [&](double theta, double phi, Symmetry symmetry) {
    return grid.nodeOf(fromSpherical(radians(theta), radians(phi)), fromSpherical(radians(35), radians(phi + 90)),
                       symmetry);
  };
  // The view direction is 90 degrees on from the light: x = 0, y = sin(35 degrees).
  const std::size_t expected = 8 * 11 + 5;
  EXPECT_EQ(node(30, 0, Symmetry::Anisotropic), expected);
  EXPECT_EQ(node(30.9, 77, Symmetry::Isotropic), expected);
  EXPECT_EQ(node(30.9, 77, Symmetry::Anisotropic), ErrorGrid::kNowhere);
  EXPECT_EQ(node(31.5, 0, Symmetry::Isotropic), ErrorGrid::kNowhere);
}

TEST(ErrorAxes, NamesReadBack) {
  EXPECT_EQ(errorAxesNames().size(), 4u);
  for (const std::string& name : errorAxesNames()) EXPECT_NO_THROW(parseErrorAxes(name));
  for (const std::string& name : diskProjectionNames()) EXPECT_NO_THROW(parseDiskProjection(name));
  EXPECT_THROW(parseErrorAxes("theta_i"), Error);
  EXPECT_THROW(parseDiskProjection("mercator"), Error);
}

}  // namespace
}  // namespace brdf
