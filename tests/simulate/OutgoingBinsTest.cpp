#include <brdf/base/Error.h>
#include <brdf/sampling/PathRandom.h>
#include <brdf/sampling/SamplerChecks.h>
#include <brdf/sampling/Sequence.h>
#include <brdf/simulate/OutgoingBins.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace brdf {
namespace {

using Q = AxisQuantity;

const GridAxis kThetaI = GridAxis::listedDegrees(Q::ThetaI, {0, 20, 50, 80});
const GridAxis kPhiI = GridAxis::listedDegrees(Q::PhiI, {0, 45, 200});

std::vector<GridLayout> layouts() {
  const GridAxis thetaO = GridAxis::uniformCells(Q::ThetaO, 0, kPi / 2, 9);
  const GridAxis fine = GridAxis::cellsDegrees(Q::SpecularTheta, {0, 0.5, 2, 5, 10, 20, 40, 60, 90, 120, 150, 180});
  return {
      {Parametrisation::Spherical,
       {thetaO, GridAxis::uniformCells(Q::PhiDifference, 0, kPi, 6), kThetaI},
       {true, false}},
      {Parametrisation::Spherical,
       {GridAxis::uniformCells(Q::PhiDifference, -kPi, kPi, 12).periodic(), thetaO, kThetaI}},
      {Parametrisation::Spherical,
       {thetaO, GridAxis::uniformCells(Q::PhiO, radians(-5.0), radians(355.0), 36).periodic(), kThetaI, kPhiI}},
      {Parametrisation::Spherical, {kThetaI, thetaO}},
      {Parametrisation::Spherical,
       {GridAxis::uniformCells(Q::ThetaO, 0, kPi / 2, 8, AxisScale::Cosine),
        GridAxis::uniformCells(Q::PhiO, 0, kPi / 2, 4).periodic(kPi / 2), kThetaI, kPhiI}},
      {Parametrisation::Specular, {fine, GridAxis::uniformCells(Q::SpecularPhi, 0, kPi, 6), kThetaI}, {true, false}},
      {Parametrisation::Specular,
       {kThetaI, kPhiI, fine, GridAxis::uniformCells(Q::SpecularPhi, 0, 2 * kPi, 12).periodic()}},
      {Parametrisation::Specular, {fine, kThetaI}, {}, {0, 0.02, 0.05, 0.1}},
      // About the direction back to the light.
      {Parametrisation::Specular,
       {fine, GridAxis::uniformCells(Q::SpecularPhi, radians(-10.0), radians(350.0), 18).periodic(), kThetaI, kPhiI},
       {},
       {0, radians(-40.0), radians(-100.0), radians(-160.0)}},
      {Parametrisation::Specular,
       {fine, GridAxis::uniformCells(Q::SpecularPhi, 0, kPi, 6), kThetaI},
       {true, false},
       {0, radians(-40.0), radians(-100.0), radians(-160.0)}}};
}

TEST(OutgoingBins, ProjectedSolidAnglesSumToPi) {
  for (const GridLayout& layout : layouts())
    for (const double theta : {0.0, 20.0, 35.0, 50.0, 80.0}) {
      const OutgoingBins bins(layout, radians(theta), radians(45.0));
      const auto& measures = bins.projectedSolidAngles();
      ASSERT_EQ(measures.size(), bins.count());
      // The horizon cuts bins of a specular layout: midpoints of 1/256 bin.
      EXPECT_NEAR(std::accumulate(measures.begin(), measures.end(), 0.0), kPi,
                  layout.parametrisation == Parametrisation::Specular ? 2e-4 : 1e-12)
          << layout.text() << " " << theta;
    }
}

TEST(OutgoingBins, TheNodeOfACellIsInItsBin) {
  for (const GridLayout& layout : layouts()) {
    const std::size_t cells = layout.cells();
    DirectionPairBuffer<double> pairs;
    layout.directions(0, cells, pairs);
    std::vector<std::uint8_t> above(cells);
    layout.aboveHorizon(0, cells, above.data());
    for (std::size_t cell = 0; cell < cells; ++cell) {
      if (!above[cell]) continue;
      // The bin of a cell: its place among the outgoing axes.
      std::size_t rest = cell, bin = 0, stride = 1;
      double theta = 0, phi = 0;
      for (const GridAxis& axis : layout.axes) {
        const std::size_t index = rest % axis.size();
        rest /= axis.size();
        if (axis.quantity == Q::ThetaI) {
          theta = axis.nodes[index];
        } else if (axis.quantity == Q::PhiI) {
          phi = axis.nodes[index];
        } else {
          bin += index * stride;
          stride *= axis.size();
        }
      }
      const OutgoingBins bins(layout, theta, phi);
      EXPECT_EQ(bins.count(), stride);
      EXPECT_EQ(bins.find({pairs.wo[0][cell], pairs.wo[1][cell], pairs.wo[2][cell]}), bin)
          << layout.text() << " cell " << cell;
    }
  }
}

TEST(OutgoingBins, CosineDistributedDirectionsFillBinsByTheirMeasure) {
  const std::vector<GridLayout> all = layouts();
  const std::vector<double> angles{0.0, 35.0, 80.0};
  const double level = sidakSignificance(1e-4, all.size() * angles.size());
  for (const GridLayout& layout : all)
    for (const double theta : angles) {
      const OutgoingBins bins(layout, radians(theta), radians(45.0));
      constexpr std::size_t draws = 200'000;
      std::vector<double> observed(bins.count() + 1), expected;
      PathRandom random(7);
      for (std::size_t k = 0; k < draws; ++k) {
        const double u = random.next(), v = random.next();
        ++observed[bins.find(cosineDirection(u, v))];
      }
      EXPECT_EQ(observed.back(), 0) << "outside all bins, " << layout.text();
      observed.pop_back();
      for (const double measure : bins.projectedSolidAngles()) expected.push_back(draws * measure / kPi);
      EXPECT_GT(chiSquare(observed, expected).probability, level) << layout.text() << " " << theta;
    }
}

TEST(OutgoingBins, CoordinatesAreThoseOfTheBin) {
  for (const GridLayout& layout : layouts()) {
    const OutgoingBins bins(layout, radians(50.0), radians(45.0));
    const auto polar = std::ranges::find_if(layout.axes, [](const GridAxis& axis) {
      return axis.quantity == Q::ThetaO || axis.quantity == Q::SpecularTheta;
    });
    PathRandom random(3);
    for (int k = 0; k < 1000; ++k) {
      const double u = random.next(), v = random.next();
      const Direction wo = cosineDirection(u, v);
      const std::size_t ring = bins.ring(bins.find(wo));
      const double angle = bins.coordinates(wo)[0];
      EXPECT_GE(angle, polar->edges[ring] - 1e-9) << layout.text();
      EXPECT_LE(angle, polar->edges[ring + 1] + 1e-9) << layout.text();
    }
  }
}

TEST(OutgoingBins, OffsetsOfMinusTwiceThetaMakeRingsAboutTheLight) {
  const GridLayout layout{Parametrisation::Specular,
                          {GridAxis::cellsDegrees(Q::SpecularTheta, {0, 1, 180}), kThetaI, kPhiI},
                          {},
                          {0, radians(-40.0), radians(-100.0), radians(-160.0)}};
  // Between the nodes of theta_i as well.
  for (const double theta : {0.0, 33.0, 50.0, 71.0}) {
    const OutgoingBins bins(layout, radians(theta), radians(45.0));
    EXPECT_EQ(bins.find(bins.wi()), 0u) << theta;
    EXPECT_EQ(bins.find(fromSpherical(radians(theta + 0.9), radians(45.0))), 0u) << theta;
    EXPECT_EQ(bins.find(fromSpherical(radians(theta + 1.1), radians(45.0))), 1u) << theta;
  }
}

TEST(OutgoingBins, DirectionsThatNoAxisReachesAreInNone) {
  const GridLayout part{
      Parametrisation::Spherical,
      {GridAxis::cellsDegrees(Q::ThetaO, {10, 20, 40}), GridAxis::cellsDegrees(Q::PhiO, {-30, 0, 30}), kThetaI, kPhiI}};
  const OutgoingBins bins(part, radians(20.0), 0);
  const auto at = [&](double theta, double phi) { return bins.find(fromSpherical(radians(theta), radians(phi))); };
  EXPECT_EQ(bins.count(), 4);
  EXPECT_EQ(at(15, -15), 0);
  EXPECT_EQ(at(30, 359), 1);
  EXPECT_EQ(at(15, 15), 2);
  EXPECT_EQ(at(5, 0), 4);
  EXPECT_EQ(at(50, 0), 4);
  EXPECT_EQ(at(15, 90), 4);
  EXPECT_EQ(at(15, 180), 4);
}

TEST(OutgoingBins, RefusesWhatCannotCount) {
  EXPECT_THROW(OutgoingBins({Parametrisation::Spherical, {GridAxis::uniformNodes(Q::ThetaO, 0, 1, 3), kThetaI}}, 0, 0),
               Error);
  EXPECT_THROW(OutgoingBins({Parametrisation::HalfDifference, {GridAxis::uniformCells(Q::ThetaH, 0, 1, 3)}}, 0, 0),
               Error);
  EXPECT_THROW(
      OutgoingBins(
          {Parametrisation::Spherical, {GridAxis::uniformCells(Q::ThetaO, 0, kPi / 2, 3), kThetaI}, {false, true}}, 0,
          0),
      Error);
}

}  // namespace
}  // namespace brdf
