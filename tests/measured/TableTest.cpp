#include <brdf/material/TableBrdf.h>

#include <random>

#include "MeasuredSupport.h"

namespace {

using brdf::Direction;
using brdf::TableBrdf;
using brdf::TableLayout;

/// A one-channel table whose cell values are given by a function of the cell's number.
template <class Function>
std::shared_ptr<const TableBrdf> numbered(const TableLayout& layout, const Function& value,
                                          TableBrdf::Lookup lookup = TableBrdf::Lookup::Interpolated) {
  brdf::TableData data{layout, brdf::Channels::monochrome(), {}, {}};
  for (std::size_t cell = 0; cell < layout.cells(); ++cell) data.values.push_back(value(cell));
  data.valid.assign(layout.cells(), 1);
  return std::make_shared<TableBrdf>(std::move(data), "numbered", lookup);
}

struct Samples {
  brdf::DirectionPairBuffer<double> pairs;
  std::vector<double> values;
  std::vector<std::uint8_t> valid;
  explicit Samples(const brdf::Brdf& brdf) {
    const brdf::SampleSet& set = *brdf.samples();
    values.resize(set.count() * set.channels().count());
    valid.resize(set.count());
    set.read(0, set.count(), &pairs, values.data(), valid.data());
  }
};

Direction random(std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(0, 1);
  return brdf::fromSpherical(std::acos(0.01 + 0.99 * uniform(engine)), 2 * brdf::kPi * uniform(engine));
}

const TableLayout kHalfTurn{};
const TableLayout kFullTurn{.phiD = 360, .reciprocal = false};

}  // namespace

TEST(TableLayout, CellCentresAreTheHalfDifferenceAnglesOfTheContract) {
  for (const TableLayout& layout : {kHalfTurn, kFullTurn}) {
    const brdf::TableDirections directions(layout);
    brdf::DirectionPairBuffer<double> pairs;
    directions.directions(0, layout.cells(), pairs);
    for (std::size_t cell = 0; cell < layout.cells(); cell += 997) {
      const double p = static_cast<double>(cell % layout.phiD) + 0.5;
      const double d = static_cast<double>(cell / layout.phiD % 90) + 0.5;
      const double h = static_cast<double>(cell / layout.phiD / 90) + 0.5;
      const auto expected =
          brdf::fromHalfDifference({brdf::radians(h * h / 90), 0, brdf::radians(d), brdf::radians(p)});
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(pairs.wi[axis][cell], expected.wi[axis], 1e-15) << cell;
        EXPECT_NEAR(pairs.wo[axis][cell], expected.wo[axis], 1e-15) << cell;
      }
    }
  }
}

TEST(TableBrdf, NearestLookupAtEachCentreReturnsThatCell) {
  for (const TableLayout& layout : {kHalfTurn, kFullTurn, TableLayout{.phiD = 7, .thetaD = 5, .thetaH = 3}}) {
    const auto table = numbered(
        layout, [](std::size_t cell) { return static_cast<double>(cell); }, TableBrdf::Lookup::Nearest);
    const Samples samples(*table);
    std::vector<double> found(layout.cells());
    table->evaluateParallel(samples.pairs.view(), found.data(), nullptr);
    std::size_t wrong = 0, above = 0;
    for (std::size_t cell = 0; cell < layout.cells(); ++cell) {
      if (!samples.valid[cell]) continue;
      ++above;
      wrong += found[cell] != static_cast<double>(cell) || samples.values[cell] != static_cast<double>(cell);
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(above, layout.cells() / 2);
  }
}

TEST(TableBrdf, NearestLookupIsTheOfficialTruncation) {
  const auto table = numbered(
      kHalfTurn, [](std::size_t cell) { return static_cast<double>(cell); }, TableBrdf::Lookup::Nearest);
  std::mt19937 engine(5);
  std::size_t disagreements = 0;
  for (int i = 0; i < 20000; ++i) {
    const Direction wi = random(engine), wo = random(engine);
    const auto angles = brdf::toHalfDifference(wi, wo);
    const auto h = static_cast<int>(90 * std::sqrt(angles.thetaH / (brdf::kPi / 2)));
    const auto d = static_cast<int>(brdf::degrees(angles.thetaD));
    const auto p = static_cast<int>(brdf::degrees(angles.phiD < 0 ? angles.phiD + brdf::kPi : angles.phiD));
    disagreements += table->evaluate(wi, wo)[0] != p + 180.0 * (d + 90.0 * h);
  }
  EXPECT_LE(disagreements, 1u);  // a pair on the edge of a cell may round either way
}

TEST(TableBrdf, InterpolationAtEachCentreReturnsThatCell) {
  for (const TableLayout& layout : {kHalfTurn, kFullTurn}) {
    const auto table = numbered(layout, [](std::size_t cell) { return 1 + static_cast<double>(cell % 1009); });
    const Samples samples(*table);
    std::vector<double> found(layout.cells());
    table->evaluateParallel(samples.pairs.view(), found.data(), nullptr);
    double worst = 0;
    for (std::size_t cell = 0; cell < layout.cells(); ++cell)
      if (samples.valid[cell]) worst = std::max(worst, std::abs(found[cell] / samples.values[cell] - 1));
    EXPECT_LT(worst, 1e-6);  // phi_d is ill-conditioned by 1 / sin theta_d, and values jump by a thousand
  }
}

TEST(TableBrdf, InterpolationIsCloserThanNearestAndShrinksWithResolution) {
  const measuredtest::FunctionBrdf function(measuredtest::glossy, brdf::Channels::monochrome());
  const auto rms = [&](const TableBrdf& table) {
    std::mt19937 engine(11);
    double sum = 0;
    for (int i = 0; i < 5000; ++i) {
      const Direction wi = random(engine), wo = random(engine);
      sum += std::pow(table.evaluate(wi, wo)[0] - function.evaluate(wi, wo)[0], 2);
    }
    return std::sqrt(sum / 5000);
  };
  const auto coarse = TableBrdf::tabulate(function, {.phiD = 45, .thetaD = 23, .thetaH = 23});
  const auto fine = TableBrdf::tabulate(function);
  EXPECT_LT(rms(*fine), rms(*fine->with(TableBrdf::Lookup::Nearest)) / 5);
  EXPECT_LT(rms(*fine), rms(*coarse) / 8);
  EXPECT_LT(rms(*fine), 1e-3);  // of a peak of 3
}

TEST(TableBrdf, NodePositionMovesTheHighlightByHalfACell) {
  // A ramp in sqrt(theta_h): cell h holds h. At nodes the value at position t is t, at centres t - 1/2.
  const auto table = numbered(kHalfTurn, [](std::size_t cell) { return static_cast<double>(cell / (180 * 90)); });
  const auto pair = brdf::fromHalfDifference({brdf::radians(40.3 * 40.3 / 90), 0, 0.3, 1.0});
  EXPECT_NEAR(table->evaluate(pair.wi, pair.wo)[0], 39.8, 1e-9);
  const auto node = table->with(TableBrdf::Lookup::Interpolated, TableBrdf::Position::Node);
  EXPECT_NEAR(node->evaluate(pair.wi, pair.wo)[0], 40.3, 1e-9);
}

TEST(TableBrdf, PhiDifferenceIsPeriodic) {
  // A function of cos(2 phi_d) has no seam at phi_d = 0, which is also pi.
  const auto table = numbered(kHalfTurn, [](std::size_t cell) {
    return 2 + std::cos(2 * brdf::radians(static_cast<double>(cell % 180) + 0.5));
  });
  const auto at = [&](double phi) {
    const auto pair = brdf::fromHalfDifference({0.2, 0.4, 0.5, phi});
    return table->evaluate(pair.wi, pair.wo)[0];
  };
  for (const double phi : {-1e-9, 1e-9, brdf::kPi - 1e-9, brdf::kPi, -brdf::kPi + 1e-9}) EXPECT_NEAR(at(phi), 3, 1e-3);
  EXPECT_NEAR(at(brdf::kPi / 2), 1, 1e-3);
}

TEST(TableBrdf, HalfTurnTablesAreReciprocalAndFullTurnOnesNeedNotBe) {
  const auto half = numbered(kHalfTurn, [](std::size_t cell) { return static_cast<double>(cell % 180); });
  const auto full = numbered(kFullTurn, [](std::size_t cell) { return static_cast<double>(cell % 360); });
  EXPECT_TRUE(half->reciprocal());
  EXPECT_FALSE(full->reciprocal());
  const auto pair = brdf::fromHalfDifference({0.2, 0, 0.5, 1.0});
  EXPECT_NEAR(half->evaluate(pair.wi, pair.wo)[0], half->evaluate(pair.wo, pair.wi)[0], 1e-9);
  EXPECT_NEAR(full->evaluate(pair.wi, pair.wo)[0] + 180, full->evaluate(pair.wo, pair.wi)[0], 1e-9);
}

TEST(TableBrdf, HolesAreFilledFromValidNeighboursOnlyAndInvalidInside) {
  brdf::TableData data{kHalfTurn, brdf::Channels::monochrome(), std::vector<double>(kHalfTurn.cells(), 2.0), {}};
  data.valid.assign(kHalfTurn.cells(), 1);
  // theta_h cells 20 to 29 are a hole with nonsense in it, one of them not marked but not finite.
  for (std::size_t cell = 20 * 16200; cell < 30 * 16200; ++cell) {
    data.values[cell] = cell % 2 ? -1e9 : std::nan("");
    data.valid[cell] = cell % 2 ? 0 : 1;
  }
  const TableBrdf table(std::move(data), "hole");
  const auto at = [&](double position, std::uint8_t& valid) {
    const auto pair = brdf::fromHalfDifference({brdf::radians(position * position / 90), 0, 0.5, 1.0});
    brdf::DirectionPairBuffer<double> pairs(1);
    pairs.set(0, pair.wi, pair.wo);
    double value = -1;
    table.evaluate(pairs.view(), &value, &valid);
    return value;
  };
  std::uint8_t valid = 0;
  EXPECT_NEAR(at(20.3, valid), 2, 1e-12);  // between cells 19 and 20
  EXPECT_EQ(valid, 1);
  EXPECT_EQ(at(25, valid), 0);
  EXPECT_EQ(valid, 0);
}

TEST(TableBrdf, SamplesReadInAnyBlocksAreTheSame) {
  const auto table =
      TableBrdf::tabulate(measuredtest::FunctionBrdf(measuredtest::glossy), {.phiD = 12, .thetaD = 6, .thetaH = 5});
  const Samples all(*table);
  const std::size_t cells = table->data().layout.cells(), length = 37;
  brdf::DirectionPairBuffer<double> pairs;
  std::vector<double> values(3 * length);
  std::vector<std::uint8_t> valid(length);
  for (std::size_t first = 0; first + length <= cells; first += 29) {
    table->samples()->read(first, length, &pairs, values.data(), valid.data());
    for (std::size_t i = 0; i < length; ++i) {
      EXPECT_EQ(valid[i], all.valid[first + i]);
      EXPECT_EQ(pairs.wo[2][i], all.pairs.wo[2][first + i]);
      for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(values[c * length + i], all.values[c * cells + first + i]);
    }
  }
}

TEST(TableBrdf, CellsBelowTheHorizonAreInvalidSamples) {
  const auto table =
      TableBrdf::tabulate(measuredtest::FunctionBrdf(measuredtest::glossy), {.phiD = 36, .thetaD = 18, .thetaH = 18});
  const Samples samples(*table);
  std::size_t below = 0;
  for (std::size_t i = 0; i < samples.valid.size(); ++i) {
    const bool above = samples.pairs.wi[2][i] > 0 && samples.pairs.wo[2][i] > 0;
    EXPECT_EQ(samples.valid[i], above) << i;
    below += !above;
  }
  EXPECT_GT(below, 0u);
  EXPECT_EQ(table->evaluate({0, 0, 1}, {0.6, 0, -0.8})[0], 0);
}

TEST(TableBrdf, WrongSizesAreErrors) {
  EXPECT_THROW(TableBrdf({{.phiD = 0}, brdf::Channels::rgb(), {}, {}}, "empty"), brdf::Error);
  EXPECT_THROW(
      TableBrdf({{.phiD = 2, .thetaD = 2, .thetaH = 2}, brdf::Channels::rgb(), std::vector<double>(8), {}}, "short"),
      brdf::Error);
}
