#include "SimpleBrdfs.h"

#include <brdf/base/Error.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/view/Slice.h>

#include <gtest/gtest.h>

#include <cmath>

namespace brdf {
namespace {

using test::FunctionBrdf;

TEST(Slice, TheColumnsAreTheHalfAngleAndTheRowsTheDifferenceAngle) {
  const FunctionBrdf both([](const Direction& wi, const Direction& wo) {
    const double half = std::atan2(std::hypot(wi[0] + wo[0], wi[1] + wo[1]), wi[2] + wo[2]);
    return 1000 * half + test::angleBetween(wi, wo) / 2;
  });
  SliceOptions options;
  options.columns = 30;
  options.rows = 20;
  for (const double phiD : {90.0, 30.0}) {
    options.phiD = radians(phiD);
    options.phiH = 0.4;
    const Slice slice = makeSlice(both, options);
    for (std::size_t row = 0; row < 20; ++row)
      for (std::size_t column = 0; column < 30; ++column) {
        const double x = radians((static_cast<double>(column) + 0.5) * 3),
                     y = radians((static_cast<double>(row) + 0.5) * 4.5);
        const std::size_t i = row * 30 + column;
        const DirectionPair pair = fromHalfDifference({x, 0.4, y, options.phiD});
        EXPECT_EQ(slice.states[i], pair.wi[2] > 0 && pair.wo[2] > 0 ? 1 : kBelowHorizon);
        if (slice.states[i] == 1) {
          EXPECT_NEAR(slice.values[i], 1000 * x + y, 1e-9);
        }
      }
    EXPECT_EQ(slice.countOf(kBelowHorizon) == 0, phiD == 90);  // cos theta_i = cos theta_h cos theta_d there
  }
}

TEST(Slice, BelowTheHorizonStartsWhereTheSumOfBothAnglesIsARightAngle) {
  SliceOptions options;
  options.columns = options.rows = 45;
  options.phiD = 0;
  const Slice slice = makeSlice(test::constantBrdf(3), options);
  for (std::size_t row = 0; row < 45; ++row)
    for (std::size_t column = 0; column < 45; ++column) {
      if (row + column == 44) continue;  // exactly 90 degrees: rounding decides
      EXPECT_EQ(slice.states[row * 45 + column], row + column < 44 ? 1 : kBelowHorizon);
      EXPECT_EQ(slice.values[row * 45 + column], row + column < 44 ? 3 : 0);
    }
}

TEST(Slice, TheWarpIsAPowerOfTheAngle) {
  SliceOptions options;
  options.columns = 8;
  options.rows = 2;
  options.warp = 2;
  const Slice slice = makeSlice(test::constantBrdf(1), options);
  for (std::size_t k = 0; k < 8; ++k) {
    const double u = (static_cast<double>(k) + 0.5) / 8;
    EXPECT_NEAR(degrees(slice.x[k]), 90 * u * u, 1e-12);
  }
  EXPECT_NEAR(degrees(slice.y[1]), 67.5, 1e-12);
}

TEST(Slice, OfIncidentAndOutgoingAnglesInAPlane) {
  const FunctionBrdf angles([](const Direction& wi, const Direction& wo) {
    return std::acos(wi[2]) + 10 * std::acos(wo[2]) + 100 * (1 - dot(wi, wo));
  });
  SliceOptions options;
  options.axes = SliceAxes::IncidentOutgoing;
  options.columns = 9;
  options.rows = 9;
  options.phi = radians(120);
  options.phiI = 2;
  const Slice slice = makeSlice(angles, options);
  const double x = radians(25), y = radians(65);  // column 2, row 6
  const double c = std::cos(x) * std::cos(y) + std::sin(x) * std::sin(y) * std::cos(radians(120));
  EXPECT_NEAR(slice.values[6 * 9 + 2], x + 10 * y + 100 * (1 - c), 1e-11);
}

TEST(Slice, ATableSaysWhatIsMeasuredFilledAndMissing) {
  TableData data;
  data.layout = {4, 3, 3, true};
  data.values.assign(36, 5);
  data.valid.assign(36, 1);
  for (std::size_t p = 0; p < 4; ++p) {
    data.valid[p + 4 * (0 + 3 * 2)] = 0;
    data.valid[p + 4 * (1 + 3 * 2)] = 2;
  }
  const TableBrdf table(data, "table", TableBrdf::Lookup::Nearest);
  SliceOptions options;
  options.columns = options.rows = 3;
  options.warp = 2;
  options.phiD = radians(100);
  const Slice slice = makeSlice(table, options);
  EXPECT_EQ(slice.states[0 * 3 + 2], 0);
  EXPECT_EQ(slice.states[1 * 3 + 2], 2);
  EXPECT_EQ(slice.states[1 * 3 + 1], 1);
}

TEST(Slice, OptionsOutOfRangeAreRefused) {
  SliceOptions options;
  options.columns = 0;
  EXPECT_THROW(makeSlice(test::constantBrdf(1), options), Error);
  options = {};
  options.warp = 0;
  EXPECT_THROW(makeSlice(test::constantBrdf(1), options), Error);
  EXPECT_THROW(parseSliceAxes("theta_h"), Error);
}

}  // namespace
}  // namespace brdf
