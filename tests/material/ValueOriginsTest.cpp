// What a tabulated cell is said to rest on: its source's cells or samples, and their standard errors.
#include <brdf/material/CellState.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/Resample.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/material/ValueOrigins.h>
#include <gtest/gtest.h>

#include <limits>

#include "GridSupport.h"

namespace {

using namespace gridtest;
using brdf::CellState;
using States = std::vector<std::uint8_t>;

constexpr std::uint8_t kInvalid = 0, kMeasured = 1, kExtrapolated = 2;

GridLayout alongThetaO(const std::vector<double>& degrees, brdf::Outside outside = brdf::Outside::Clamp) {
  GridLayout layout{Parametrisation::Spherical, {GridAxis::listedDegrees(AxisQuantity::ThetaO, degrees)}};
  layout.axes[0].outside = outside;
  return layout;
}

GridBrdf fourCells(brdf::Outside outside = brdf::Outside::Clamp) {
  return {{alongThetaO({0, 20, 40, 60}, outside),
           brdf::Channels::monochrome(),
           {1, 2, 3, 4},
           {kMeasured, kMeasured, kExtrapolated, kInvalid},
           {0.1, 0.3, 0.5, 0.7}},
          "four cells"};
}

/// The fraction of the cells of a grid above the horizon that are Measured.
double measuredFraction(const GridBrdf& grid) {
  const std::size_t cells = grid.layout().cells();
  States above(cells);
  grid.layout().aboveHorizon(0, cells, above.data());
  double count = 0, all = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    all += above[i];
    count += above[i] && grid.data().states[i] == kMeasured;
  }
  return count / all;
}

/// A Lambertian at all pairs of these polar angles (degrees) and differences of azimuth.
std::shared_ptr<const brdf::ScatteredBrdf> scattered(const std::vector<double>& theta, const std::vector<double>& phi) {
  brdf::ScatteredSamples samples;
  samples.channels = brdf::Channels::monochrome();
  std::vector<DirectionPair> pairs;
  for (const double i : theta)
    for (const double o : theta)
      for (const double p : phi)
        pairs.push_back({brdf::fromSpherical(radians(i), 0), brdf::fromSpherical(radians(o), radians(p))});
  samples.pairs = bufferOf(pairs);
  samples.values.assign(pairs.size(), 0.1);
  return std::make_shared<const brdf::ScatteredBrdf>(std::move(samples), "lattice");
}

std::uint8_t originAt(const brdf::Brdf& brdf, double thetaI, double thetaO, double phi) {
  std::uint8_t state = 1;
  const auto pairs =
      bufferOf({{brdf::fromSpherical(radians(thetaI), 0.3), brdf::fromSpherical(radians(thetaO), 0.3 + radians(phi))}});
  brdf::ValueOrigins(brdf).classify(pairs.view(), &state);
  return state;
}

}  // namespace

TEST(ValueOrigins, AGridAtItsOwnNodesIsItself) {
  const GridBrdf source = fourCells();
  const auto copy = GridBrdf::tabulate(source, source.layout());
  EXPECT_EQ(copy->data().states, source.data().states);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(copy->data().standardError[i], source.data().standardError[i], 1e-15) << i;
}

TEST(ValueOrigins, InterpolatedCellsAreMeasuredBetweenMeasuredOnesOnly) {
  const auto fine = GridBrdf::tabulate(fourCells(), alongThetaO({0, 5, 20, 25, 40, 45, 60, 65}));
  // 25: partly extrapolated. 45: what is left beside an invalid cell. 60, 65: the invalid cell alone.
  EXPECT_EQ(fine->data().states,
            (States{kMeasured, kMeasured, kMeasured, kExtrapolated, kExtrapolated, kExtrapolated, kInvalid, kInvalid}));
}

TEST(ValueOrigins, BeyondTheEndsIsExtrapolatedOrInvalidAsTheAxisSays) {
  const GridData ends{alongThetaO({10, 50}), brdf::Channels::monochrome(), {1, 2}, {}};
  EXPECT_EQ(GridBrdf::tabulate(GridBrdf(ends, ""), alongThetaO({5, 10, 30, 50, 55}))->data().states,
            (States{kExtrapolated, kMeasured, kMeasured, kMeasured, kExtrapolated}));
  GridData open = ends;
  open.layout.axes[0].outside = brdf::Outside::Invalid;
  EXPECT_EQ(GridBrdf::tabulate(GridBrdf(open, ""), alongThetaO({5, 10, 30, 50, 55}))->data().states,
            (States{kInvalid, kMeasured, kMeasured, kMeasured, kInvalid}));
}

TEST(ValueOrigins, StandardErrorsAreInterpolatedAsBoundsForAnyCorrelation) {
  const auto fine = GridBrdf::tabulate(fourCells(), alongThetaO({5, 10, 15, 45}));
  const std::vector<double>& errors = fine->data().standardError;
  ASSERT_EQ(errors.size(), 4u);
  // Errors 0.1 and 0.3 at both ends: of the values' sum with weights w and 1 - w, with correlation r, the variance is
  // w^2 0.01 + (1 - w)^2 0.09 + 2 r w (1 - w) 0.03, largest at r = 1.
  for (int k = 0; k < 3; ++k) {
    const double w = 0.75 - 0.25 * k, bound = w * 0.1 + (1 - w) * 0.3;
    EXPECT_NEAR(errors[k], bound, 1e-14);
    for (const double r : {-1.0, 0.0, 0.5, 1.0})
      EXPECT_LE(std::sqrt(w * w * 0.01 + (1 - w) * (1 - w) * 0.09 + 2 * r * w * (1 - w) * 0.03), errors[k] + 1e-14);
  }
  EXPECT_NEAR(errors[3], 0.5, 1e-14);  // the invalid neighbour's does not count

  GridData unknown = fourCells().data();
  unknown.standardError[1] = std::numeric_limits<double>::quiet_NaN();
  const auto partly = GridBrdf::tabulate(GridBrdf(unknown, ""), alongThetaO({0, 5, 20, 40}));
  EXPECT_NEAR(partly->data().standardError[0], 0.1, 1e-15);
  EXPECT_TRUE(std::isnan(partly->data().standardError[1]));
  EXPECT_TRUE(std::isnan(partly->data().standardError[2]));
  EXPECT_NEAR(partly->data().standardError[3], 0.5, 1e-15);
}

TEST(ValueOrigins, TablesAndOtherChannelsOfThemKeepTheirStates) {
  const brdf::TableLayout layout{.phiD = 12, .thetaD = 9, .thetaH = 9};
  brdf::TableData data =
      brdf::TableBrdf::tabulate(*brdf::parseMaterialExpression("(0.3,0.2,0.1)*Lambertian"), layout)->data();
  std::size_t extrapolated = 0;
  for (std::size_t i = 0; i < data.valid.size(); i += 5)
    if (data.valid[i]) data.valid[i] = kExtrapolated, ++extrapolated;
  const auto table = std::make_shared<const brdf::TableBrdf>(data, "table");
  ASSERT_GT(extrapolated, 50u);
  EXPECT_EQ(brdf::TableBrdf::tabulate(*table, layout)->data().valid, data.valid);
  EXPECT_EQ(brdf::TableBrdf::tabulate(*brdf::asLuminance(table), layout)->data().valid, data.valid);
  EXPECT_EQ(GridBrdf::tabulate(*table, GridLayout::fromTable(layout))->data().states, data.valid);
}

TEST(ValueOrigins, AHoleIsAHoleAtItsOwnNode) {
  const brdf::TableLayout layout{.phiD = 12, .thetaD = 9, .thetaH = 9};
  brdf::TableData data = brdf::TableBrdf::tabulate(*brdf::parseMaterialExpression("0.3*Lambertian"), layout)->data();
  for (std::size_t i = 0; i < data.valid.size(); i += 5) data.valid[i] = kInvalid;
  const brdf::TableBrdf table(data, "table");
  EXPECT_EQ(GridBrdf::tabulate(table, GridLayout::fromTable(layout))->data().states, data.valid);
}

TEST(ValueOrigins, FormulasHaveValuesOfTheirOwn) {
  const auto material = brdf::parseMaterialExpression("0.5*Lambertian");
  const auto grid = brdf::resample(*material, brdf::parseGridLayout("spherical:10", *material));
  EXPECT_EQ(measuredFraction(*grid.brdf), 1);
  EXPECT_EQ(grid.losses.size(), 1u);
}

TEST(ValueOrigins, ScatteredSamplesReachAsFarAsTheirHull) {
  const auto all = scattered({5, 15, 25, 35, 45, 55}, {0, 30, 60, 90, 120, 150, 180});
  EXPECT_EQ(originAt(*all, 25, 35, 60), kMeasured);  // a sample
  EXPECT_EQ(originAt(*all, 30, 40, 75), kMeasured);
  EXPECT_EQ(originAt(*all, 50, 20, 170), kMeasured);
  EXPECT_EQ(originAt(*all, 80, 80, 180), kExtrapolated);
  EXPECT_EQ(originAt(*all, 75, 10, 0), kExtrapolated);
  // Measured in one half of the plane of incidence only.
  const auto plane = scattered({5, 15, 25, 35, 45, 55}, {180});
  EXPECT_EQ(originAt(*plane, 30, 40, 180), kMeasured);
  EXPECT_EQ(originAt(*plane, 30, 40, 90), kExtrapolated);
  const auto grid = brdf::resample(*all, brdf::parseGridLayout("spherical:10", *all));
  EXPECT_LT(measuredFraction(*grid.brdf), 0.6);  // 6 x 6 of 9 x 9 polar angles: 0.44
  EXPECT_GT(measuredFraction(*grid.brdf), 0.3);
  EXPECT_NE(grid.losses.back().find("extrapolated"), std::string::npos);
}
