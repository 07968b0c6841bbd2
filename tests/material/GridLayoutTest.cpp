// Directions of a grid's cells, and where directions fall on its axes, against closed forms.
#include <brdf/base/Error.h>

#include <gtest/gtest.h>

#include "GridSupport.h"

namespace {

using namespace gridtest;
using Q = AxisQuantity;

constexpr double kTurn = 2 * brdf::kPi;

/// The angle that a grid finds for pairs on one of its axes: a grid whose cells hold that axis' node.
std::vector<double> found(const GridLayout& layout, Q quantity, const std::vector<DirectionPair>& pairs) {
  const std::size_t axis = layout.find(quantity);
  return valuesOf(*filled(layout, [&](const auto& index) { return layout.axes[axis].nodes[index[axis]]; }), pairs)
      .value;
}

GridLayout spherical() {
  return {
      Parametrisation::Spherical,
      {GridAxis::uniformNodes(Q::ThetaO, 0, radians(90), 7), GridAxis::uniformNodes(Q::PhiO, 0, kTurn, 13).periodic(),
       GridAxis::uniformNodes(Q::PhiI, 0, kTurn, 5).periodic(), GridAxis::uniformNodes(Q::ThetaI, 0, radians(90), 4)}};
}
GridLayout halfDifference() {
  return {
      Parametrisation::HalfDifference,
      {GridAxis::uniformNodes(Q::ThetaH, 0, radians(90), 7), GridAxis::uniformNodes(Q::PhiD, 0, kTurn, 13).periodic(),
       GridAxis::uniformNodes(Q::PhiH, 0, kTurn, 9).periodic(), GridAxis::uniformNodes(Q::ThetaD, 0, radians(90), 4)}};
}
GridLayout specular() {
  return {
      Parametrisation::Specular,
      {GridAxis::uniformNodes(Q::SpecularTheta, 0, radians(180), 7),
       GridAxis::uniformNodes(Q::SpecularPhi, 0, kTurn, 13).periodic(),
       GridAxis::uniformNodes(Q::ThetaI, 0, radians(90), 4), GridAxis::uniformNodes(Q::PhiI, 0, kTurn, 9).periodic()}};
}

DirectionPair cellOf(const GridLayout& layout, std::size_t cell) {
  brdf::DirectionPairBuffer<double> pairs;
  layout.directions(cell, 1, pairs);
  return {{pairs.wi[0][0], pairs.wi[1][0], pairs.wi[2][0]}, {pairs.wo[0][0], pairs.wo[1][0], pairs.wo[2][0]}};
}

void expectNear(const Direction& a, const Direction& b, double tolerance = 1e-14) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance);
}

/// A grid of one cell at these angles.
GridLayout single(Parametrisation parametrisation, const std::vector<std::pair<Q, double>>& degrees) {
  GridLayout layout{parametrisation, {}};
  for (const auto& [quantity, angle] : degrees) layout.axes.push_back(GridAxis::listedDegrees(quantity, {angle}));
  return layout;
}

}  // namespace

TEST(GridCoordinates, SphericalAnglesAreThoseOfTheDirections) {
  const auto pairs = randomPairs(2000);
  const GridLayout layout = spherical();
  const auto thetaI = found(layout, Q::ThetaI, pairs), phiI = found(layout, Q::PhiI, pairs);
  const auto thetaO = found(layout, Q::ThetaO, pairs), phiO = found(layout, Q::PhiO, pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [wi, wo] = pairs[i];
    EXPECT_NEAR(thetaI[i], std::acos(wi[2]), 1e-12);
    EXPECT_NEAR(thetaO[i], std::acos(wo[2]), 1e-12);
    EXPECT_NEAR(phiI[i], wrapped(std::atan2(wi[1], wi[0])), 1e-12);
    EXPECT_NEAR(phiO[i], wrapped(std::atan2(wo[1], wo[0])), 1e-12);
  }
}

TEST(GridCoordinates, PhiDifferenceIsTheViewersAzimuthFromTheLights) {
  const auto pairs = randomPairs(2000);
  GridLayout isotropic{Parametrisation::Spherical,
                       {GridAxis::uniformNodes(Q::PhiDifference, 0, kTurn, 9).periodic(),
                        GridAxis::uniformNodes(Q::ThetaI, 0, radians(90), 3)}};
  GridLayout anisotropic = isotropic;
  anisotropic.axes.push_back(GridAxis::uniformNodes(Q::PhiI, 0, kTurn, 3).periodic());
  const auto a = found(isotropic, Q::PhiDifference, pairs), b = found(anisotropic, Q::PhiDifference, pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [wi, wo] = pairs[i];
    const double difference = wrapped(std::atan2(wo[1], wo[0]) - std::atan2(wi[1], wi[0]));
    EXPECT_NEAR(a[i], difference, 1e-12);
    EXPECT_NEAR(b[i], difference, 1e-12);
  }
}

TEST(GridCoordinates, HalfDifferenceAnglesAreRusinkiewiczs) {
  const auto pairs = randomPairs(2000);
  const GridLayout layout = halfDifference();
  const auto thetaH = found(layout, Q::ThetaH, pairs), phiH = found(layout, Q::PhiH, pairs);
  const auto thetaD = found(layout, Q::ThetaD, pairs), phiD = found(layout, Q::PhiD, pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    // The definition: turn the half vector to the pole about z and then y, and read the light's angles there.
    const auto& [wi, wo] = pairs[i];
    const Direction h = brdf::normalized({wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]});
    const double theta = std::acos(h[2]), phi = std::atan2(h[1], h[0]);
    const Direction d = turned(turned(wi, {0, 0, 1}, -phi), {0, 1, 0}, -theta);
    EXPECT_NEAR(thetaH[i], theta, 1e-12);
    EXPECT_NEAR(phiH[i], wrapped(phi), 1e-12);
    EXPECT_NEAR(thetaD[i], std::acos(d[2]), 1e-11);
    EXPECT_NEAR(phiD[i], wrapped(std::atan2(d[1], d[0])), 1e-11);
  }
}

TEST(GridCoordinates, SpecularAnglesAreAboutTheMirrorDirectionFromTheNormalsSide) {
  const auto pairs = randomPairs(2000);
  const GridLayout layout = specular();
  const auto theta = found(layout, Q::SpecularTheta, pairs), phi = found(layout, Q::SpecularPhi, pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [wi, wo] = pairs[i];
    const Direction mirror{-wi[0], -wi[1], wi[2]};
    EXPECT_NEAR(theta[i], angleBetween(mirror, wo), 1e-11);
    // From the mirror direction by specular_theta towards the normal, then about it by specular_phi: the viewer.
    const Direction across = brdf::normalized(brdf::cross(mirror, {0, 0, 1}));
    expectNear(turned(turned(mirror, across, theta[i]), mirror, phi[i]), wo, 1e-10);
  }
}

TEST(GridDirections, SpecularCellsLieWhereTheAnglesSay) {
  using P = Parametrisation;
  const auto at = [](double thetaI, double theta, double phi) {
    return cellOf(single(P::Specular, {{Q::ThetaI, thetaI}, {Q::SpecularTheta, theta}, {Q::SpecularPhi, phi}}), 0);
  };
  const double half = brdf::kPi;
  expectNear(at(40, 0, 0).wo, brdf::fromSpherical(radians(40), half));          // the mirror direction
  expectNear(at(40, 10, 0).wo, brdf::fromSpherical(radians(30), half));         // towards the normal
  expectNear(at(40, 10, 180).wo, brdf::fromSpherical(radians(50), half));       // away from it
  expectNear(at(40, 50, 0).wo, brdf::fromSpherical(radians(10), 0));            // beyond it
  expectNear(at(0, 20, 30).wo, brdf::fromSpherical(radians(20), radians(30)));  // at normal incidence: from phi_i
  // Counter-clockwise for one who looks back from the tip of s: at a right angle, s x (towards the normal).
  const Direction s = brdf::fromSpherical(radians(40), half), up = brdf::fromSpherical(radians(-50), half);
  const Direction side = brdf::cross(s, up);
  expectNear(at(40, 90, 90).wo, side);
  EXPECT_NEAR(side[1], 1, 1e-14);  // the light at azimuth 0, s leaning to -x, its upper side to +x: +y
}

TEST(GridDirections, SpecularOffsetsMoveTheReference) {
  GridLayout layout{
      Parametrisation::Specular,
      {GridAxis::listedDegrees(Q::ThetaI, {0, 40, 60}), GridAxis::listedDegrees(Q::SpecularTheta, {0, 30})}};
  layout.specularOffsets = {0, radians(-12), radians(-20)};
  layout.check("test");
  expectNear(cellOf(layout, 1).wo, brdf::fromSpherical(radians(28), brdf::kPi));
  // Between nodes the offset is interpolated: at 50 degrees the reference is at 34.
  const DirectionPair pair{brdf::fromSpherical(radians(50), 1), brdf::fromSpherical(radians(44), 1 + brdf::kPi)};
  EXPECT_NEAR(found(layout, Q::SpecularTheta, {pair})[0], radians(10), 1e-12);
}

TEST(GridDirections, EveryCellIsFoundAtItsOwnDirections) {
  for (GridLayout layout : {spherical(), halfDifference(), specular()}) {
    for (GridAxis& axis : layout.axes)
      axis = GridAxis::uniformCells(axis.quantity, axis.nodes.front(), axis.nodes.back(), axis.size());
    for (GridAxis& axis : layout.axes)
      if (brdf::isAzimuth(axis.quantity)) axis.period = kTurn;
    std::vector<DirectionPair> pairs;
    std::vector<double> expected;
    for (std::size_t cell = 0; cell < layout.cells(); ++cell) {
      const DirectionPair pair = cellOf(layout, cell);
      if (!(pair.wi[2] > 1e-9 && pair.wo[2] > 1e-9)) continue;
      pairs.push_back(pair);
      expected.push_back(static_cast<double>(cell));
    }
    ASSERT_GT(pairs.size(), layout.cells() / 10);
    const auto numbered = [&](GridBrdf::Lookup lookup) {
      double next = 0;
      return valuesOf(*filled(
                          layout, [&](const auto&) { return next++; }, lookup),
                      pairs)
          .value;
    };
    EXPECT_EQ(numbered(GridBrdf::Lookup::Nearest), expected) << layout.text();
    const auto interpolated = numbered(GridBrdf::Lookup::Interpolated);
    for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_NEAR(interpolated[i], expected[i], 1e-8) << layout.text();
  }
}

TEST(GridDirections, MerlsLayoutAsAGridHasTheSameDirections) {
  const brdf::TableLayout table{.phiD = 20, .thetaD = 10, .thetaH = 10};
  const GridLayout grid = GridLayout::fromTable(table);
  ASSERT_EQ(grid.cells(), table.cells());
  brdf::DirectionPairBuffer<double> a, b;
  brdf::TableDirections(table).directions(0, table.cells(), a);
  grid.directions(0, table.cells(), b);
  for (std::size_t i = 0; i < table.cells(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(a.wi[axis][i], b.wi[axis][i], 1e-14);
      EXPECT_NEAR(a.wo[axis][i], b.wo[axis][i], 1e-14);
    }
}

TEST(GridScales, StepsAreEqualInTheScale) {
  const auto cosine = GridAxis::uniformNodes(Q::ThetaI, 0, radians(90), 3, AxisScale::Cosine);
  EXPECT_NEAR(cosine.nodes[1], radians(60), 1e-15);
  const auto sine = GridAxis::uniformNodes(Q::ThetaI, 0, radians(90), 3, AxisScale::Sine);
  EXPECT_NEAR(sine.nodes[1], radians(30), 1e-15);
  const auto root = GridAxis::uniformCells(Q::ThetaH, 0, radians(90), 3, AxisScale::SquareRoot);
  EXPECT_NEAR(root.edges[1], radians(10), 1e-15);
  EXPECT_NEAR(root.nodes[0], radians(2.5), 1e-15);
}

TEST(GridLayouts, WhatDoesNotFitTogetherIsAnErrorThatSaysWhat) {
  const auto errorOf = [](const GridLayout& layout) {
    try {
      layout.check("x");
    } catch (const brdf::Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  using P = Parametrisation;
  const auto theta = [](Q q) { return GridAxis::listedDegrees(q, {0, 30, 60}); };
  EXPECT_EQ(errorOf({P::Spherical, {theta(Q::ThetaI)}}), "");
  EXPECT_NE(errorOf({P::Spherical, {}}).find("1 to 4"), std::string::npos);
  EXPECT_NE(errorOf({P::Spherical, {theta(Q::ThetaH)}}).find("theta_h"), std::string::npos);
  EXPECT_NE(errorOf({P::Spherical, {theta(Q::ThetaI), theta(Q::ThetaI)}}).find("twice"), std::string::npos);
  EXPECT_NE(errorOf({P::Spherical, {GridAxis::listedDegrees(Q::ThetaI, {0, 30, 30})}}).find("ascending"),
            std::string::npos);
  EXPECT_NE(errorOf({P::Spherical, {GridAxis::listedDegrees(Q::ThetaI, {0, 100})}}).find("out of range"),
            std::string::npos);
  EXPECT_NE(errorOf({P::Spherical, {theta(Q::PhiO)}}).find("phi_difference"), std::string::npos);
  EXPECT_NE(errorOf({P::Spherical, {theta(Q::PhiI), theta(Q::PhiO), theta(Q::PhiDifference)}}).find("the same"),
            std::string::npos);
  GridLayout mirrored{P::Spherical, {GridAxis::listedDegrees(Q::PhiDifference, {0, 180, 270})}, {.mirror = true}};
  EXPECT_NE(errorOf(mirrored).find("too far"), std::string::npos);
  GridLayout period{P::Spherical, {GridAxis::listedDegrees(Q::PhiDifference, {0, 180, 270}).periodic(3)}};
  EXPECT_NE(errorOf(period).find("period"), std::string::npos);
  GridLayout edges{P::Spherical, {theta(Q::ThetaI)}};
  edges.axes[0].edges = {0, 1};
  EXPECT_NE(errorOf(edges).find("edges"), std::string::npos);
  GridLayout huge{P::Spherical, {}};
  for (const Q q : {Q::ThetaI, Q::ThetaO, Q::PhiDifference}) huge.axes.push_back(GridAxis::uniformNodes(q, 0, 1, 2000));
  EXPECT_NE(errorOf(huge).find("2^31"), std::string::npos);
}
