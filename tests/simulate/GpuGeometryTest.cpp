#include "SimulationSupport.h"

#include <brdf/base/Error.h>
#include <brdf/simulate/gpu/FieldTexels.h>
#include <brdf/simulate/gpu/TileTree.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace brdf {
namespace {

TEST(GpuGeometry, SquaresOfAFieldHaveItsLeastAndMostHeight) {
  HeightField field{13, 6, 0.5, 0.25, {}};
  for (std::size_t k = 0; k < 78; ++k) field.heights.push_back(static_cast<float>(5 + std::sin(double(k * k))));
  const FieldTexels texels(field, 100, "test");
  const auto [low, high] = std::ranges::minmax(field.heights);
  const double middle = (double(low) + double(high)) / 2;
  ASSERT_EQ(texels.levelRows.size(), 5U);  // 13 cells: squares of 2, 4, 8, 16
  EXPECT_EQ(texels.cellsPerUnit[1], 2);
  for (std::size_t level = 1; level < 5; ++level)
    for (std::size_t J = 0; J << level < field.rows; ++J)
      for (std::size_t I = 0; I << level < field.columns; ++I) {
        double least = 1e9, most = -1e9;
        // Nodes of the square's cells, the last ones included.
        for (std::size_t j = J << level; j <= std::min((J + 1) << level, field.rows); ++j)
          for (std::size_t i = I << level; i <= std::min((I + 1) << level, field.columns); ++i) {
            const double h = (double(field.height(i % field.columns, j % field.rows)) - middle) / field.spacingX;
            least = std::min(least, h);
            most = std::max(most, h);
          }
        const auto& bounds = texels.texels[(texels.levelRows[level] + J) * texels.columns + I];
        EXPECT_NEAR(double(bounds[0]), least, 1e-6);
        EXPECT_NEAR(double(bounds[1]), most, 1e-6);
        EXPECT_GE(double(bounds[0]), texels.lowest);
        EXPECT_LE(double(bounds[1]), texels.highest);
      }
  EXPECT_THROW(FieldTexels(field, 12, "test"), Error);
}

TEST(GpuGeometry, FieldsThatDoNotChangeAlongAnAxisHaveOneCellThere) {
  const FieldTexels grooves(testing::vGrooves(), 100, "test");
  EXPECT_EQ(grooves.columns, 2U);
  EXPECT_EQ(grooves.rows, 1U);
  EXPECT_EQ(grooves.cellsPerUnit[1], 0);
  const FieldTexels flat(testing::flatField(7), 100, "test");
  EXPECT_EQ(flat.columns * flat.rows, 1U);
  EXPECT_LT(flat.lowest, 0);
  EXPECT_GT(flat.highest, 0);
}

/// Visits a tree: every primitive is in one leaf, within its box and those above it.
struct Visit {
  const TileTree& tree;
  std::vector<int> seen;
  std::size_t deepest = 0;
  void node(std::size_t k, std::array<float, 3> least, std::array<float, 3> most, std::size_t depth) {
    deepest = std::max(deepest, depth);
    for (std::size_t side = 0; side < 2; ++side) {
      const auto &low = tree.nodes[4 * k + 2 * side], &high = tree.nodes[4 * k + 2 * side + 1];
      if (low[0] > 1e29F) continue;
      const auto link = static_cast<std::size_t>(low[3]), count = static_cast<std::size_t>(high[3]);
      for (std::size_t a = 0; a < 3; ++a) {
        EXPECT_GE(low[a], least[a]);
        EXPECT_LE(high[a], most[a]);
      }
      if (count == 0) node(link, {low[0], low[1], low[2]}, {high[0], high[1], high[2]}, depth + 1);
      for (std::size_t p = link; p < link + count; ++p) {
        ++seen[p];
        for (std::size_t a = 0; a < 3; ++a) {
          EXPECT_GE(tree.primitives[p][a] - tree.primitives[p][3], low[a]);
          EXPECT_LE(tree.primitives[p][a] + tree.primitives[p][3], high[a]);
        }
      }
    }
  }
};

TEST(GpuGeometry, TreesHoldEverySphereOnce) {
  for (const bool same : {false, true}) {
    SpherePacking packing{{}, 10, 5, true};
    for (int k = 0; k < 500; ++k) {
      const auto x = static_cast<float>(10 * std::fmod(k * 0.618034, 1)),
                 y = static_cast<float>(5 * std::fmod(k * 0.7548777, 1));
      packing.spheres.push_back({same ? std::array<float, 3>{5, 2, 1} : std::array<float, 3>{x, y, 1}, 0.1F});
    }
    const TileTree tree(packing, {-1, -1}, "test");
    EXPECT_GE(tree.primitives.size(), 500U);
    EXPECT_EQ(tree.unit, 10);
    EXPECT_EQ(tree.half[1], 0.25);
    Visit visit{tree, std::vector<int>(tree.primitives.size())};
    visit.node(0, {-1e9F, -1e9F, -1e9F}, {1e9F, 1e9F, 1e9F}, 1);
    EXPECT_EQ(std::ranges::count(visit.seen, 1), std::ssize(visit.seen));
    EXPECT_LE(visit.deepest, 44U);
  }
}

TEST(GpuGeometry, WhatReachesAcrossTheBorderIsThereTwice) {
  const SpherePacking packing{{{{0, 2, 1}, 1}}, 4, 4, true};
  EXPECT_EQ(TileTree(packing, {-1, -1}, "test").primitives.size(), 2U);
  // Nothing of it is above an opaque plane; of a dielectric one all is met.
  const SpherePacking buried{{{{2, 2, -2}, 1}}, 4, 4, true};
  EXPECT_EQ(TileTree(buried, {-1, -1}, "test").primitives.size(), 1U)
      << "buffers of a device are never empty; no node names it";
  EXPECT_GT(TileTree(buried, {-1, -1}, "test").nodes[0][0], 1e29F);
  EXPECT_LT(TileTree(buried, {-1, 0}, "test").nodes[0][0], 1);
}

}  // namespace
}  // namespace brdf
