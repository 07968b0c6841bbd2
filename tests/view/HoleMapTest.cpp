#include "SimpleBrdfs.h"

#include <brdf/base/Error.h>
#include <brdf/material/CellCounts.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/view/HoleMap.h>

#include <gtest/gtest.h>

namespace brdf {
namespace {

GridData plane() {
  GridData data;
  data.layout.axes = {GridAxis::listedDegrees(AxisQuantity::PhiDifference, {0, 90, 180}),
                      GridAxis::listedDegrees(AxisQuantity::ThetaO, {0, 30, 60, 90}),
                      GridAxis::listedDegrees(AxisQuantity::ThetaI, {10, 50})};
  data.values.assign(24, 1);
  data.states.assign(24, 1);
  return data;
}

TEST(HoleMap, EveryCellIsCountedOnceInItsPlace) {
  GridData data = plane();
  data.states[0 + 3 * (1 + 4 * 0)] = 0;
  data.states[2 + 3 * (1 + 4 * 0)] = 2;
  const GridBrdf grid(data, "grid");
  const HoleMap map = makeHoleMap(grid);
  EXPECT_EQ(map.x.name, "theta_o");
  EXPECT_EQ(map.y.name, "theta_i");
  ASSERT_EQ(map.counts.size(), 8u);
  EXPECT_EQ(map.counts[0], (HoleMap::Counts{3, 0, 0, 0}));
  EXPECT_EQ(map.counts[1], (HoleMap::Counts{1, 1, 1, 0}));
  EXPECT_EQ(map.counts[3], (HoleMap::Counts{0, 0, 0, 3}));  // theta_o = 90 degrees
  EXPECT_EQ(map.total, (HoleMap::Counts{16, 1, 1, 6}));
  ASSERT_EQ(map.x.edges.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(map.x.edges[k], std::vector<double>({0, 15, 45, 75, 90})[k], 1e-12);

  const HoleMap other = makeHoleMap(grid, "theta_i", "phi_difference");
  EXPECT_EQ(other.counts[0 * 2 + 0], (HoleMap::Counts{2, 0, 1, 1}));
  EXPECT_EQ(other.counts[1 * 2 + 1], (HoleMap::Counts{3, 0, 0, 1}));
  EXPECT_EQ(other.total, map.total);
}

TEST(HoleMap, ATableOfHolesOnlyAndOneOfMerlsLayoutAgreeWithCountCells) {
  TableData data;
  data.layout = {6, 5, 7, true};
  data.values.assign(210, 0);
  data.valid.assign(210, 0);
  const auto empty = std::make_shared<TableBrdf>(data, "empty");
  const HoleMap map = makeHoleMap(*asRgb(empty));  // seen through other channels
  EXPECT_EQ(map.x.name, "theta_h");
  EXPECT_EQ(map.x.nodes.size(), 7u);
  EXPECT_EQ(map.total[HoleMap::Measured], 0u);
  const CellCounts counts = *countCells(*empty);
  EXPECT_EQ(map.total[HoleMap::BelowHorizon], counts.belowHorizon);
  EXPECT_EQ(map.total[HoleMap::Invalid] + map.total[HoleMap::BelowHorizon], 210u);
  EXPECT_NEAR(map.x.edges[1], 90.0 / 49, 1e-12);  // cells in the square root
}

TEST(HoleMap, WhatHasNoGridIsRefusedWithAReason) {
  EXPECT_THROW(makeHoleMap(test::constantBrdf(1)), Error);
  const GridBrdf grid(plane(), "grid");
  EXPECT_THROW(makeHoleMap(grid, "theta_h"), Error);
  EXPECT_THROW(makeHoleMap(grid, "theta_i", "theta_i"), Error);
  EXPECT_EQ(makeHoleMap(grid, "theta_i").y.name, "phi_difference");  // the usual y is taken already
}

}  // namespace
}  // namespace brdf
