#include "SurfaceSupport.h"

#include <brdf/geometry/Directions.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace brdf {
namespace {

HeightField made(const std::string& expression) { return heightField(expression); }

double fact(const std::string& expression, const std::string& name) { return factOf(makeSurface(expression), name); }

/// The cross section as the parameters say: distance `d` from the centre of a groove of the given width, bottom (um)
/// and angle between walls (degrees).
double section(double d, double width, double bottom, double angle) {
  const double depth = (width - bottom) / 2 / std::tan(radians(angle / 2));
  if (d >= width / 2) return 0;
  if (d <= bottom / 2) return -depth;
  return -depth * (width / 2 - d) / ((width - bottom) / 2);
}

TEST(Grooves, CrossSectionIsWhatTheParametersSay) {
  struct Case {
    const char* expression;
    double width, spacing, angle, bottom;
  };
  for (const Case& c : {Case{"grooves", 4, 20, 60, 0},
                        Case{"grooves(width=7.3, spacing=11.9, angle=95, bottom=2.2)", 7.3, 11.9, 95, 2.2},
                        Case{"grooves(width=10, spacing=10, angle=90)", 10, 10, 90, 0}}) {
    SCOPED_TRACE(c.expression);
    const HeightField field = made(c.expression);
    EXPECT_NEAR(field.periodX(), c.spacing, 1e-12 * c.spacing);
    // The centre of the groove is the middle of its lowest points.
    double centre = 0;
    const float lowest = *std::ranges::min_element(field.heights);
    double first = -1, last = 0;
    for (std::size_t i = 0; i < field.columns; ++i)
      if (field.height(i, 0) == lowest) {
        last = static_cast<double>(i) * field.spacingX;
        if (first < 0) first = last;
      }
    centre = (first + last) / 2;
    for (int k = 0; k < 1000; ++k) {
      const double x = c.spacing * (k + 0.37) / 1000;
      const double d = std::abs(std::remainder(x - centre, c.spacing));
      EXPECT_NEAR(heightAt(field, x, 0.3 * k), section(d, c.width, c.bottom, c.angle), 1e-6 * c.width) << x;
    }
  }
}

TEST(Grooves, WidthWithoutACommonLatticeIsRoundedAndTheAngleKept) {
  const std::string expression = "grooves(width=3.14159265, spacing=20, angle=80)";
  const double width = fact(expression, "groove width");
  EXPECT_NEAR(width, 3.14159265, 20.0 / 4096);
  EXPECT_NEAR(fact(expression, "groove depth"), width / 2 / std::tan(radians(40)), 1e-6);
}

TEST(Grooves, ObliqueSetsRepeatExactly) {
  // Exact in any direction; along the cells' diagonals even between nodes.
  for (const double orientation : {-30.0, -71.5, 135.0, 150.0}) {
    const HeightField field =
        made("grooves(width=5, spacing=20, angle=100, orientation=" + std::to_string(orientation + 90) + ")");
    const double fx = std::cos(radians(orientation)), fy = std::sin(radians(orientation));
    EXPECT_NEAR(field.periodX() * std::abs(fx), 20, 1e-9);
    EXPECT_NEAR(field.periodY() * std::abs(fy), 20, 1e-9);
    const double base = heightAt(field, 0, 0);
    EXPECT_EQ(base, 0);
    for (int k = 0; k < 2000; ++k) {
      const double x = 0.137 * k, y = 1.93 * k;
      const double d = std::abs(std::remainder(x * fx + y * fy - 10, 20.0));
      EXPECT_NEAR(heightAt(field, x, y), section(d, 5, 0, 100), 1e-4) << orientation << " " << k;
    }
  }
}

TEST(Grooves, ObliqueEdgesAcrossDiagonalsAreOneCellWide) {
  const HeightField field = made("grooves(width=5, spacing=20, angle=100, orientation=120)");
  const double fx = std::cos(radians(30)), fy = std::sin(radians(30));
  const double cell = 20.0 / static_cast<double>(field.columns), slope = 1 / std::tan(radians(50));
  for (int k = 0; k < 2000; ++k) {
    const double x = 0.137 * k, y = 1.93 * k;
    const double d = std::abs(std::remainder(x * fx + y * fy - 10, 20.0));
    EXPECT_NEAR(heightAt(field, x, y), section(d, 5, 0, 100), slope * cell) << k;
  }
}

TEST(Grooves, CrossedSetsKeepTheDeeperCut) {
  const HeightField field = made("grooves(width=6, spacing=12, angle=90, sets=2)");
  EXPECT_NEAR(field.periodX(), 12, 1e-12);
  EXPECT_NEAR(field.periodY(), 12, 1e-12);
  for (std::size_t j = 0; j < field.rows; ++j)
    for (std::size_t i = 0; i < field.columns; ++i) {
      const double dx = std::abs(std::remainder(static_cast<double>(i) * field.spacingX - 6, 12.0));
      const double dy = std::abs(std::remainder(static_cast<double>(j) * field.spacingY - 6, 12.0));
      EXPECT_NEAR(field.height(i, j), std::min(section(dx, 6, 0, 90), section(dy, 6, 0, 90)), 1e-5);
    }
}

TEST(Grooves, ThreeSetsAtSixtyDegreesHaveAnExactTile) {
  const std::string expression = "grooves(sets=3, set_angle=60, spacing=20, width=4)";
  for (int k = 1; k <= 3; ++k) {
    const std::string of = " of set " + std::to_string(k);
    EXPECT_NEAR(fact(expression, "spacing" + of), 20, 1e-9);
    EXPECT_NEAR(fact(expression, "azimuth along the grooves" + of), 90 + 60 * (k - 1), 1e-9);
  }
}

TEST(Grooves, SetsWithoutACommonTileGiveWayLittleAndSaySo) {
  const std::string expression = "grooves(sets=2, orientation=10, set_angle=37, spacing=20, width=4, resolution=16)";
  for (int k = 1; k <= 2; ++k) {
    const std::string of = " of set " + std::to_string(k);
    EXPECT_NEAR(fact(expression, "spacing" + of), 20, 0.3);
    EXPECT_NEAR(fact(expression, "azimuth along the grooves" + of), 10 + 37 * (k - 1), 1.0);
  }
}

TEST(Grooves, JitterShiftsGroovesAndKeepsTheSection) {
  const HeightField still = made("grooves(width=4, spacing=20, angle=60, grooves=32)");
  const HeightField field = made("grooves(width=4, spacing=20, angle=60, jitter=0.5)");
  EXPECT_NEAR(field.periodX(), 32 * 20, 1e-9);
  EXPECT_NEAR(still.periodX(), 32 * 20, 1e-9);
  std::vector<double> centres;
  const float lowest = *std::ranges::min_element(field.heights);
  EXPECT_NEAR(lowest, section(0, 4, 0, 60), 1e-6);
  for (std::size_t i = 0; i < field.columns; ++i)
    if (field.height(i, 0) == lowest) centres.push_back(static_cast<double>(i) * field.spacingX);
  ASSERT_EQ(centres.size(), 32u);
  double most = 0;
  for (std::size_t k = 0; k < 32; ++k) {
    const double shift = centres[k] - 20 * (static_cast<double>(k) + 0.5);
    EXPECT_LE(std::abs(shift), 5.0 + 0.2);
    most = std::max(most, std::abs(shift));
  }
  EXPECT_GT(most, 3.0);  // all 32 within 3 of 5: probability (3/5)^32 = 8e-8
  EXPECT_NE(made("grooves(jitter=0.5, seed=2)").heights, made("grooves(jitter=0.5)").heights);
  EXPECT_EQ(made("grooves(jitter=0.5)").heights, made("grooves(jitter=0.5, seed=1)").heights);
}

}  // namespace
}  // namespace brdf
