// Filling invalid cells: by what, from what, and that it is told apart from measurement.
#include <brdf/base/Error.h>
#include <brdf/material/FillHoles.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/TableBrdf.h>

#include <gtest/gtest.h>

#include "GridSupport.h"

namespace {

using namespace gridtest;
using brdf::CellState;
using brdf::FillMethod;
using Q = AxisQuantity;
using States = std::vector<std::uint8_t>;

GridLayout isotropic() {
  return {Parametrisation::Spherical,
          {GridAxis::uniformNodes(Q::PhiDifference, 0, radians(350), 36).periodic(),
           GridAxis::uniformNodes(Q::ThetaO, 0, radians(80), 9), GridAxis::uniformNodes(Q::ThetaI, 0, radians(80), 9)}};
}

/// The material on the grid, the cells that `hole(phi, theta_o, theta_i indices)` names made invalid.
template <class Hole>
std::shared_ptr<const GridBrdf> withHoles(const Hole& hole) {
  GridData data =
      GridBrdf::tabulate(*brdf::parseMaterialExpression("0.2*Lambertian + 0.1*GGX(alpha=0.4)"), isotropic())->data();
  for (std::size_t i = 0; i < data.states.size(); ++i)
    if (hole(i % 36, i / 36 % 9, i / 324)) data.states[i] = 0;
  return std::make_shared<const GridBrdf>(std::move(data), "holes");
}

void expectTruth(const brdf::FilledBrdf& filled, double tolerance) {
  const auto whole = withHoles([](auto, auto, auto) { return false; });
  const GridData& data = dynamic_cast<const GridBrdf&>(*filled.brdf).data();
  for (std::size_t i = 0; i < data.values.size(); ++i)
    if (data.states[i]) {
      EXPECT_NEAR(data.values[i], whole->data().values[i], tolerance) << i;
    }
}

}  // namespace

TEST(FillHoles, ReciprocityTakesTheExchangedPair) {
  const auto filled = fillHoles(withHoles([](auto, auto o, auto i) { return o > i; }), FillMethod::Reciprocity);
  EXPECT_EQ(filled.filled, 36u * 36u);
  EXPECT_EQ(filled.remaining, 0u);
  expectTruth(filled, 1e-12);
}

TEST(FillHoles, SymmetryTakesTheMirroredPair) {
  const auto filled = fillHoles(withHoles([](auto p, auto, auto) { return p > 18; }), FillMethod::Symmetry);
  EXPECT_EQ(filled.filled, 17u * 81u);
  EXPECT_EQ(filled.remaining, 0u);
  expectTruth(filled, 1e-12);
}

TEST(FillHoles, AModelGivesItsOwnValues) {
  const auto model = brdf::parseMaterialExpression("0.2*Lambertian + 0.1*GGX(alpha=0.4)");
  const auto filled =
      fillHoles(withHoles([](auto p, auto o, auto) { return p < 4 && o > 5; }), FillMethod::Model, model.get());
  EXPECT_EQ(filled.filled, 4u * 3u * 9u);
  expectTruth(filled, 1e-12);
  EXPECT_THROW(fillHoles(filled.brdf, FillMethod::Model), brdf::Error);
  const auto rgb = brdf::parseMaterialExpression("(0.2,0.1,0.1)*Lambertian");
  EXPECT_THROW(fillHoles(filled.brdf, FillMethod::Model, rgb.get()), brdf::Error);
}

TEST(FillHoles, NearestTakesTheFewestStepsAlongTheAxes) {
  const GridLayout layout{Parametrisation::Spherical,
                          {GridAxis::uniformNodes(Q::PhiDifference, 0, radians(300), 6).periodic(),
                           GridAxis::uniformNodes(Q::ThetaO, 0, radians(60), 3)}};
  // Measured: 10 at (phi 1, theta 0) and 20 at (phi 4, theta 2).
  GridData data{layout, brdf::Channels::monochrome(), std::vector<double>(18, 0), States(18, 0)};
  data.values[1] = 10, data.states[1] = 1;
  data.values[16] = 20, data.states[16] = 1;
  const auto filled = fillHoles(std::make_shared<const GridBrdf>(std::move(data), "two"), FillMethod::Nearest);
  EXPECT_EQ(filled.filled, 16u);
  const auto& values = dynamic_cast<const GridBrdf&>(*filled.brdf).data().values;
  for (int t = 0; t < 3; ++t)
    for (int p = 0; p < 6; ++p) {
      const auto around = [](int a, int b) { return std::min(std::abs(a - b), 6 - std::abs(a - b)); };
      const int first = around(p, 1) + t, second = around(p, 4) + 2 - t;
      if (first != second) {
        EXPECT_EQ(values[static_cast<std::size_t>(p + 6 * t)], first < second ? 10 : 20) << p << t;
      }
    }
}

TEST(FillHoles, FilledCellsAreExtrapolatedAndNeverASource) {
  const auto holed = withHoles([](auto, auto o, auto i) { return o > 4 || i > 4; });
  const auto once = fillHoles(holed, FillMethod::Nearest);
  const auto& states = dynamic_cast<const GridBrdf&>(*once.brdf).data().states;
  for (std::size_t i = 0; i < states.size(); ++i) EXPECT_EQ(states[i], holed->data().states[i] ? 1 : 2) << i;
  // What reciprocity could take from there is all filled: nothing.
  GridData data = dynamic_cast<const GridBrdf&>(*once.brdf).data();
  const std::size_t hole = 36 * (6 + 9 * 2);
  data.states[hole] = 0;
  const auto twice = fillHoles(std::make_shared<const GridBrdf>(std::move(data), "again"), FillMethod::Reciprocity);
  EXPECT_EQ(twice.filled, 0u);
  EXPECT_EQ(twice.remaining, 1u);
}

TEST(FillHoles, TablesAreFilledAboveTheHorizonOnly) {
  const brdf::TableLayout layout{.phiD = 36, .thetaD = 18, .thetaH = 18};
  const auto whole = brdf::TableBrdf::tabulate(*brdf::parseMaterialExpression("0.5*Lambertian"), layout);
  brdf::TableData data = whole->data();
  for (std::size_t i = 0; i < data.valid.size(); i += 3) data.valid[i] = 0;
  const auto filled =
      fillHoles(std::make_shared<const brdf::TableBrdf>(std::move(data), "thirds"), FillMethod::Nearest);
  const auto& after = dynamic_cast<const brdf::TableBrdf&>(*filled.brdf).data();
  std::size_t extrapolated = 0;
  for (std::size_t i = 0; i < after.valid.size(); ++i) {
    EXPECT_EQ(after.valid[i] != 0, whole->data().valid[i] != 0) << i;
    if (after.valid[i]) {
      EXPECT_NEAR(after.values[i], 0.5 / brdf::kPi, 1e-15);
    }
    extrapolated += after.valid[i] == 2;
  }
  EXPECT_EQ(filled.filled, extrapolated);
  EXPECT_EQ(filled.remaining, 0u);
}

TEST(FillHoles, WhatFallsOnTheHoleItselfFillsNothing) {
  // Exchanged pairs of a reciprocal table lie in the same cell.
  const brdf::TableLayout layout{.phiD = 36, .thetaD = 18, .thetaH = 18};
  const auto whole = brdf::TableBrdf::tabulate(*brdf::parseMaterialExpression("GGX(alpha=0.3)"), layout);
  brdf::TableData data = whole->data();
  std::uint64_t holes = 0;
  for (std::size_t i = 0; i < data.valid.size(); i += 7)
    if (data.valid[i]) data.valid[i] = 0, ++holes;
  const auto table = std::make_shared<const brdf::TableBrdf>(std::move(data), "sevenths");
  const auto exchanged = fillHoles(table, FillMethod::Reciprocity);
  EXPECT_EQ(exchanged.filled, 0u);
  EXPECT_EQ(exchanged.remaining, holes);
}

TEST(FillHoles, WithoutCellsOrAKnownMethodThereIsAnError) {
  EXPECT_THROW(fillHoles(brdf::parseMaterialExpression("Lambertian"), FillMethod::Nearest), brdf::Error);
  EXPECT_EQ(brdf::fillMethod("nearest"), FillMethod::Nearest);
  EXPECT_THROW(brdf::fillMethod("magic"), brdf::Error);
  const auto holed = withHoles([](auto, auto o, auto) { return o > 4; });
  EXPECT_EQ(fillHoles(holed, FillMethod::None).filled, 0u);
}
