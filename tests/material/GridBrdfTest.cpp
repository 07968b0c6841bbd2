// Look-ups in grids: interpolation error, symmetry, holes, ends of the axes, samples, quantities.
#include <brdf/base/Error.h>
#include <brdf/formula/Program.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/SampleSet.h>
#include <brdf/material/TableBrdf.h>

#include <gtest/gtest.h>

#include "GridSupport.h"

namespace {

using namespace gridtest;
using brdf::CellState;
using brdf::Outside;
using Q = AxisQuantity;

constexpr double kTurn = 2 * brdf::kPi;
constexpr double kRight = brdf::kPi / 2;

std::size_t scaled(double n, double fine) { return static_cast<std::size_t>(n * fine); }

GridLayout isotropicSpherical(double fine) {
  return {Parametrisation::Spherical,
          {GridAxis::uniformNodes(Q::PhiDifference, 0, brdf::kPi, scaled(36, fine) + 1),
           GridAxis::uniformNodes(Q::ThetaO, 0, kRight, scaled(18, fine) + 1),
           GridAxis::uniformNodes(Q::ThetaI, 0, kRight, scaled(18, fine) + 1)},
          {.mirror = true}};
}
GridLayout isotropicHalf(double fine) {
  return {Parametrisation::HalfDifference,
          {GridAxis::uniformCells(Q::PhiD, 0, brdf::kPi, scaled(18, fine)).periodic(brdf::kPi),
           GridAxis::uniformCells(Q::ThetaD, 0, kRight, scaled(18, fine)),
           GridAxis::uniformCells(Q::ThetaH, 0, kRight, scaled(18, fine), AxisScale::SquareRoot)},
          {.reciprocal = true}};
}
GridLayout isotropicSpecular(double fine) {
  return {Parametrisation::Specular,
          {GridAxis::uniformNodes(Q::SpecularTheta, 0, brdf::kPi, scaled(36, fine) + 1),
           GridAxis::uniformNodes(Q::SpecularPhi, 0, brdf::kPi, scaled(18, fine) + 1),
           GridAxis::uniformNodes(Q::ThetaI, 0, kRight, scaled(18, fine) + 1)},
          {.mirror = true}};
}
GridLayout sphericalFull(double fine) {
  return {Parametrisation::Spherical,
          {GridAxis::uniformNodes(Q::PhiO, 0, kTurn, scaled(24, fine) + 1).periodic(),
           GridAxis::uniformNodes(Q::ThetaO, 0, kRight, scaled(9, fine) + 1),
           GridAxis::uniformNodes(Q::PhiI, 0, kTurn, scaled(24, fine) + 1).periodic(),
           GridAxis::uniformNodes(Q::ThetaI, 0, kRight, scaled(9, fine) + 1)}};
}
GridLayout halfFull(double fine) {
  return {Parametrisation::HalfDifference,
          {GridAxis::uniformNodes(Q::PhiD, 0, kTurn, scaled(12, fine) + 1).periodic(),
           GridAxis::uniformNodes(Q::ThetaD, 0, kRight, scaled(9, fine) + 1),
           GridAxis::uniformNodes(Q::PhiH, 0, kTurn, scaled(24, fine) + 1).periodic(),
           GridAxis::uniformNodes(Q::ThetaH, 0, kRight, scaled(9, fine) + 1, AxisScale::SquareRoot)}};
}

struct Difference {
  double rms = 0, worst = 0;
  std::size_t valid = 0;
};
Difference difference(const brdf::Brdf& a, const brdf::Brdf& b, const std::vector<DirectionPair>& pairs) {
  const Values x = valuesOf(a, pairs), y = valuesOf(b, pairs);
  Difference result;
  double sum = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!x.valid[i]) continue;
    ++result.valid;
    const double d = x.value[i] - y.value[i];
    sum += d * d;
    result.worst = std::max(result.worst, std::abs(d));
  }
  result.rms = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(result.valid, 1)));
  return result;
}

}  // namespace

class GridError : public ::testing::TestWithParam<int> {};

TEST_P(GridError, FallsWithTheSquareOfTheStepForALobeOverADiffuseGround) {
  // Multilinear interpolation of a smooth function: second order. Polar angles to 63 degrees: near the horizon some
  // corners are below it.
  const bool anisotropic = GetParam() >= 3;
  const auto material = brdf::parseMaterialExpression(anisotropic ? "0.3*Lambertian + 0.2*Ward(ax=0.5, ay=0.7)"
                                                                  : "0.3*Lambertian + 0.2*Ward(ax=0.5, ay=0.5)");
  const auto layout = [&](double fine) {
    switch (GetParam()) {
      case 0:
        return isotropicSpherical(fine);
      case 1:
        return isotropicHalf(fine);
      case 2:
        return isotropicSpecular(fine);
      case 3:
        return sphericalFull(fine);
      default:
        return halfFull(fine);
    }
  };
  const auto pairs = randomPairs(20000, 1.1);
  const auto coarse = GridBrdf::tabulate(*material, layout(1)), fine = GridBrdf::tabulate(*material, layout(2));
  const Difference one = difference(*coarse, *material, pairs), two = difference(*fine, *material, pairs);
  EXPECT_EQ(one.valid, pairs.size());
  EXPECT_LT(one.rms, 0.01) << coarse->layout().text();
  EXPECT_LT(two.rms, one.rms / 3) << coarse->layout().text();
  EXPECT_GT(two.rms, one.rms / 6) << coarse->layout().text();
}
INSTANTIATE_TEST_SUITE_P(Layouts, GridError, ::testing::Range(0, 5));

TEST(GridBrdf, AgreesWithTheTableOfMerlsLayout) {
  const auto material = brdf::parseMaterialExpression("0.3*Lambertian + 0.2*Ward(ax=0.2, ay=0.2)");
  const brdf::TableLayout table{.phiD = 36, .thetaD = 18, .thetaH = 18};
  const auto a = brdf::TableBrdf::tabulate(*material, table);
  const auto b = GridBrdf::tabulate(*material, GridLayout::fromTable(table));
  const auto pairs = randomPairs(5000, kRight);
  EXPECT_LT(difference(*b, *a, pairs).worst, 1e-12);
  const auto nearest = b->with(GridBrdf::Lookup::Nearest);
  EXPECT_LT(difference(*nearest, *a->with(brdf::TableBrdf::Lookup::Nearest), pairs).worst, 1e-12);
  EXPECT_TRUE(b->reciprocal());
  EXPECT_EQ(b->symmetry(), brdf::Symmetry::Bilateral);
}

TEST(GridBrdf, UnequalStepsAreInterpolatedBetweenTheirNodes) {
  const GridLayout layout{Parametrisation::Spherical, {GridAxis::listedDegrees(Q::ThetaO, {0, 1, 2, 10, 45, 80})}};
  const auto grid = filled(layout, [&](const auto& index) { return brdf::degrees(layout.axes[0].nodes[index[0]]); });
  for (const double angle : {0.0, 0.5, 1.0, 1.7, 2.0, 9.99, 10.0, 30.0, 45.0, 79.0, 80.0})
    EXPECT_NEAR(grid->evaluate({0, 0, 1}, brdf::fromSpherical(radians(angle), 2))[0], angle, 1e-9);
}

TEST(GridBrdf, TheEndOfAnAxisClampsOrEnds) {
  GridLayout layout{Parametrisation::Spherical, {GridAxis::listedDegrees(Q::ThetaO, {10, 75})}};
  const auto at = [&](double angle) {
    return valuesOf(*filled(layout, [](const auto& index) { return index[0] + 1.0; }),
                    {{{0, 0, 1}, brdf::fromSpherical(radians(angle), 0)}});
  };
  EXPECT_EQ(at(80).value[0], 2);
  EXPECT_EQ(at(5).value[0], 1);
  EXPECT_EQ(at(80).valid[0], 1);
  layout.axes[0].outside = Outside::Invalid;
  for (const double angle : {80.0, 5.0}) {
    EXPECT_EQ(at(angle).value[0], 0);
    EXPECT_EQ(at(angle).valid[0], 0);
  }
  for (const double angle : {10.0, 75.0, 74.9}) EXPECT_EQ(at(angle).valid[0], 1) << angle;
}

TEST(GridBrdf, CellsEndAtTheirEdges) {
  GridLayout layout{Parametrisation::Spherical, {GridAxis::cellsDegrees(Q::ThetaO, {0, 10, 40, 50})}};
  layout.axes[0].outside = Outside::Invalid;
  const auto grid = filled(layout, [](const auto& index) { return index[0] + 1.0; });
  const auto at = [&](const GridBrdf& brdf, double angle) {
    return valuesOf(brdf, {{{0, 0, 1}, brdf::fromSpherical(radians(angle), 0)}});
  };
  EXPECT_NEAR(at(*grid, 2).value[0], 1, 1e-12);     // between the edge and the first middle, 5 degrees
  EXPECT_NEAR(at(*grid, 15).value[0], 1.5, 1e-12);  // half way from 5 to 25
  EXPECT_NEAR(at(*grid, 49).value[0], 3, 1e-12);
  EXPECT_EQ(at(*grid, 51).valid[0], 0);
  const auto nearest = grid->with(GridBrdf::Lookup::Nearest);
  EXPECT_EQ(at(*nearest, 9.9).value[0], 1);
  EXPECT_EQ(at(*nearest, 10.1).value[0], 2);
  EXPECT_EQ(at(*nearest, 39.9).value[0], 2);
  EXPECT_EQ(at(*nearest, 51).valid[0], 0);
}

TEST(GridBrdf, AFullTurnHasNoSeamWhereverItStarts) {
  for (const double start : {0.0, -180.0, 30.0}) {
    std::vector<double> angles;
    for (int i = 0; i < 36; ++i) angles.push_back(start + 10 * i);
    GridLayout layout{Parametrisation::Spherical, {GridAxis::listedDegrees(Q::PhiDifference, angles).periodic()}};
    const auto grid = filled(layout, [&](const auto& index) { return 2 + std::cos(layout.axes[0].nodes[index[0]]); });
    for (int angle = -190; angle <= 400; ++angle) {
      const auto wo = brdf::fromSpherical(0.5, radians(angle));
      EXPECT_NEAR(grid->evaluate({0.6, 0, 0.8}, wo)[0], 2 + std::cos(radians(angle)), 0.004) << angle;
    }
    const auto nearest = grid->with(GridBrdf::Lookup::Nearest);
    const auto near = [&](double angle) {
      return nearest->evaluate({0.6, 0, 0.8}, brdf::fromSpherical(0.5, radians(angle)))[0];
    };
    EXPECT_NEAR(near(-4.9), 3, 1e-12);
    EXPECT_NEAR(near(4.9), 3, 1e-12);
    EXPECT_NEAR(near(184.9), 1, 1e-12);
  }
}

TEST(GridBrdf, AnAzimuthThatIsNoFullTurnClampsToTheNearerEnd) {
  GridLayout layout{Parametrisation::Spherical, {GridAxis::listedDegrees(Q::PhiDifference, {90, 270})}};
  const auto grid = filled(layout, [](const auto& index) { return index[0] + 1.0; });
  const auto at = [&](double angle) {
    return grid->evaluate({0.6, 0, 0.8}, brdf::fromSpherical(0.5, radians(angle)))[0];
  };
  EXPECT_EQ(at(60), 1);
  EXPECT_EQ(at(-60), 2);
  EXPECT_NEAR(at(180), 1.5, 1e-12);
}

TEST(GridBrdf, MirrorSymmetryCompletesHalfTheAzimuths) {
  const auto isotropic = GridBrdf::tabulate(*brdf::parseMaterialExpression("GGX(alpha=0.4)"), isotropicSpherical(1));
  const auto mirrored = [](Direction w) { return Direction{w[0], -w[1], w[2]}; };
  for (const auto& [wi, wo] : randomPairs(500))
    EXPECT_NEAR(isotropic->evaluate(wi, wo)[0], isotropic->evaluate(mirrored(wi), mirrored(wo))[0], 1e-12);
  EXPECT_EQ(isotropic->symmetry(), brdf::Symmetry::Isotropic);
  // Anisotropic: phi_i in half a turn stands for the other half, phi_o goes all round.
  GridLayout layout = sphericalFull(1);
  layout.axes[2] = GridAxis::uniformNodes(Q::PhiI, 0, brdf::kPi, 13);
  layout.symmetry.mirror = true;
  const auto ward = brdf::parseMaterialExpression("Ward(ax=0.5, ay=0.7)");
  const auto half = GridBrdf::tabulate(*ward, layout), full = GridBrdf::tabulate(*ward, sphericalFull(1));
  EXPECT_LT(difference(*half, *full, randomPairs(2000)).worst, 1e-12);
  EXPECT_EQ(half->symmetry(), brdf::Symmetry::Anisotropic);
}

TEST(GridBrdf, ReciprocityCompletesOneOfEachTwoPairs) {
  GridLayout layout = isotropicSpherical(1);
  layout.symmetry.reciprocal = true;
  GridData data = GridBrdf::tabulate(*brdf::parseMaterialExpression("GGX(alpha=0.4)"), layout)->data();
  const std::size_t phis = layout.axes[0].size(), thetas = layout.axes[1].size();
  for (std::size_t cell = 0; cell < layout.cells(); ++cell)
    if (cell / phis % thetas < cell / (phis * thetas)) data.values[cell] = 1e9;  // theta_o < theta_i: never looked at
  const GridBrdf grid(std::move(data), "half");
  EXPECT_TRUE(grid.reciprocal());
  for (const auto& [wi, wo] : randomPairs(2000, 1.4)) {
    // Cells on the diagonal mix both sides of it: stay a step away.
    if (std::abs(std::acos(wi[2]) - std::acos(wo[2])) < radians(5.1)) continue;
    EXPECT_EQ(grid.evaluate(wi, wo)[0], grid.evaluate(wo, wi)[0]);
    EXPECT_LT(grid.evaluate(wi, wo)[0], 1e3);
  }
}

TEST(GridBrdf, InvalidCellsAreLeftOutAndExtrapolatedOnesAreNoSamples) {
  const GridLayout layout{Parametrisation::Spherical, {GridAxis::listedDegrees(Q::ThetaO, {0, 20, 40, 60, 80})}};
  GridData data{layout, brdf::Channels::monochrome(), {1, 2, std::nan(""), 4, 5}, {1, 2, 1, 0, 1}};
  const GridBrdf grid(data, "holes");
  const auto at = [&](double angle) { return valuesOf(grid, {{{0, 0, 1}, brdf::fromSpherical(radians(angle), 0)}}); };
  EXPECT_NEAR(at(10).value[0], 1.5, 1e-12);
  EXPECT_NEAR(at(39).value[0], 2, 1e-12);  // the NaN beside it has no say
  EXPECT_EQ(at(50).valid[0], 0);
  EXPECT_NEAR(at(61).value[0], 5, 1e-12);
  std::vector<double> values(5);
  std::vector<std::uint8_t> valid(5);
  grid.samples()->read(0, 5, nullptr, values.data(), valid.data());
  EXPECT_EQ(valid, (std::vector<std::uint8_t>{1, 0, 0, 0, 1}));
  EXPECT_EQ(values, (std::vector<double>{1, 0, 0, 0, 5}));
}

TEST(GridBrdf, CellsBelowTheHorizonAreNoSamplesAndCanBeMadeInvalid) {
  GridData data = filled(isotropicSpecular(1), [](const auto&) { return 1.0; })->data();
  const std::size_t below = brdf::invalidateBelowHorizon(data);
  std::size_t expected = 0;
  for (std::size_t cell = 0; cell < data.layout.cells(); ++cell) {
    brdf::DirectionPairBuffer<double> pair;
    data.layout.directions(cell, 1, pair);
    const bool above = pair.wi[2][0] > 1e-15 && pair.wo[2][0] > 1e-15;
    expected += !above;
    EXPECT_EQ(data.states[cell], above ? 1 : 0);
  }
  EXPECT_EQ(below, expected);
  EXPECT_GT(below, 0u);
  const GridBrdf grid(std::move(data), "ones");
  for (const auto& [wi, wo] : randomPairs(500, 1.4)) EXPECT_NEAR(grid.evaluate(wi, wo)[0], 1, 1e-12);
  EXPECT_EQ(grid.evaluate({0, 0, 1}, {0.6, 0, -0.8})[0], 0);
}

TEST(GridBrdf, QuantitiesBecomeBrdfsTogetherWithTheirErrors) {
  const GridLayout layout{Parametrisation::Spherical, {GridAxis::listedDegrees(Q::ThetaO, {0, 60, 90})}};
  GridData data{layout, brdf::Channels::monochrome(), {1, 1, 1}, {}, {0.1, 0.1, 0.1}};
  GridData factor = data;
  brdf::convertQuantity(data, brdf::Quantity::BrdfCosine);
  EXPECT_NEAR(data.values[0], 1, 1e-15);
  EXPECT_NEAR(data.values[1], 2, 1e-14);
  EXPECT_NEAR(data.standardError[1], 0.2, 1e-15);
  EXPECT_EQ(data.states, (std::vector<std::uint8_t>{1, 1, 0}));
  EXPECT_EQ(data.original, brdf::Quantity::BrdfCosine);
  brdf::convertQuantity(factor, brdf::Quantity::ReflectanceFactor);
  EXPECT_NEAR(factor.values[2], 1 / brdf::kPi, 1e-15);
}

TEST(GridBrdf, ManyChannelsAndBigBatchesKeepTheirPlaces) {
  GridData data{isotropicHalf(0.5), brdf::Channels::spectral({400, 500, 600, 700}), {}, {}};
  const std::size_t cells = data.layout.cells();
  for (std::size_t channel = 0; channel < 4; ++channel)
    for (std::size_t i = 0; i < cells; ++i) data.values.push_back(static_cast<double>(channel));
  const GridBrdf grid(std::move(data), "channels");
  const auto pairs = randomPairs(1500);
  std::vector<double> values(4 * pairs.size());
  grid.evaluate(bufferOf(pairs).view(), values.data(), nullptr);
  for (std::size_t channel = 0; channel < 4; ++channel)
    for (std::size_t i = 0; i < pairs.size(); ++i)
      EXPECT_NEAR(values[channel * pairs.size() + i], static_cast<double>(channel), 1e-12);
}

TEST(GridBrdf, FloatLookUpsAndEveryInstructionSetAgree) {
  const auto material = brdf::parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + 0.2*Ward(ax=0.5, ay=0.7)");
  const auto pairs = randomPairs(3001, kRight);
  const auto wide = bufferOf(pairs);
  brdf::DirectionPairBuffer<float> narrow(pairs.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    narrow.wi[axis].assign(wide.wi[axis].begin(), wide.wi[axis].end());
    narrow.wo[axis].assign(wide.wo[axis].begin(), wide.wo[axis].end());
  }
  const std::string best(brdf::formula::instructionSet());
  for (const GridLayout& layout : {halfFull(1), isotropicHalf(1)})
    for (const bool rgb : {true, false}) {
      const auto seen = rgb ? brdf::BrdfPointer(material) : brdf::asLuminance(material);
      const auto grid = GridBrdf::tabulate(*seen, layout);
      const std::size_t count = grid->channels().count() * pairs.size();
      std::vector<double> first(count), other(count);
      std::vector<float> floats(count);
      std::vector<std::uint8_t> valid(pairs.size()), otherValid(pairs.size());
      brdf::formula::setInstructionSet("generic");
      grid->evaluate(wide.view(), first.data(), valid.data());
      for (const auto set : brdf::formula::instructionSets()) {
        brdf::formula::setInstructionSet(set);
        grid->evaluate(wide.view(), other.data(), otherValid.data());
        EXPECT_EQ(valid, otherValid) << set;
        for (std::size_t i = 0; i < count; ++i)
          EXPECT_NEAR(other[i], first[i], 1e-12 * (1 + std::abs(first[i]))) << set;
        grid->evaluate(narrow.view(), floats.data(), otherValid.data());
        for (std::size_t i = 0; i < count; ++i)
          EXPECT_NEAR(floats[i], first[i], 2e-5 * (1 + std::abs(first[i]))) << set;
      }
    }
  brdf::formula::setInstructionSet(best);
}

TEST(GridBrdf, WrongArraysAreErrors) {
  const GridLayout layout{Parametrisation::Spherical, {GridAxis::listedDegrees(Q::ThetaO, {0, 60, 90})}};
  const auto make = [&](std::vector<double> values, std::vector<std::uint8_t> states, std::vector<double> errors) {
    GridBrdf({layout, brdf::Channels::monochrome(), std::move(values), std::move(states), std::move(errors)}, "wrong");
  };
  EXPECT_NO_THROW(make({1, 2, 3}, {}, {}));
  EXPECT_THROW(make({1, 2}, {}, {}), brdf::Error);
  EXPECT_THROW(make({1, 2, 3}, {1, 1}, {}), brdf::Error);
  EXPECT_THROW(make({1, 2, 3}, {1, 1, 3}, {}), brdf::Error);
  EXPECT_THROW(make({1, 2, 3}, {}, {1}), brdf::Error);
}
