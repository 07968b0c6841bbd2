#include <brdf/material/ScatteredBrdf.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/measured/Format.h>

#include <cstring>
#include <limits>

#include "MeasuredSupport.h"

namespace {

using measuredtest::errorOf;
using measuredtest::folder;

std::string merlBytes(std::int32_t thetaH, std::int32_t thetaD, std::int32_t phiD, const std::vector<double>& raw) {
  const std::int32_t counts[3] = {thetaH, thetaD, phiD};
  std::string bytes(12 + 8 * raw.size(), '\0');
  std::memcpy(bytes.data(), counts, 12);
  std::memcpy(bytes.data() + 12, raw.data(), 8 * raw.size());
  return bytes;
}

/// 2 x 3 x 4 cells: red 1500 + cell, green 3000, blue 1500.
std::vector<double> smallRaw() {
  std::vector<double> raw(72);
  for (std::size_t cell = 0; cell < 24; ++cell) {
    raw[cell] = 1500 + static_cast<double>(cell);
    raw[24 + cell] = 3000;
    raw[48 + cell] = 1500;
  }
  return raw;
}

brdf::ReadResult readBytes(const std::filesystem::path& dir, const std::string& name, const std::string& bytes) {
  brdf::writeFile(dir / name, bytes);
  return brdf::readMeasured(dir / name);
}

const brdf::TableData& dataOf(const brdf::ReadResult& result) {
  return dynamic_cast<const brdf::TableBrdf&>(*result.brdf).data();
}

}  // namespace

TEST(Merl, ScalesEachColourAndKeepsTheOrder) {
  const auto result = readBytes(folder("merl_small"), "a.anything", merlBytes(2, 3, 4, smallRaw()));
  EXPECT_EQ(result.report.format, "merl");
  EXPECT_EQ(result.report.samples, 24u);
  const auto& data = dataOf(result);
  EXPECT_EQ(data.layout, (brdf::TableLayout{.phiD = 4, .thetaD = 3, .thetaH = 2}));
  for (std::size_t cell = 0; cell < 24; ++cell) {
    EXPECT_DOUBLE_EQ(data.values[cell], 1 + static_cast<double>(cell) / 1500);
    EXPECT_DOUBLE_EQ(data.values[24 + cell], 2 * 1.15);
    EXPECT_DOUBLE_EQ(data.values[48 + cell], 1.66);
  }
}

TEST(Merl, NegativeAndNonFiniteCellsAreInvalidAndCounted) {
  auto raw = smallRaw();
  raw[1] = -1;
  raw[24 + 1] = -1;  // the same cell counts once
  raw[24 + 4] = -0.5;
  raw[48 + 7] = std::nan("");
  raw[9] = std::numeric_limits<double>::infinity();
  const auto result = readBytes(folder("merl_defects"), "a.binary", merlBytes(2, 3, 4, raw));
  EXPECT_EQ(result.report.negative, 2u);
  EXPECT_EQ(result.report.notFinite, 2u);
  for (const std::size_t cell : {1u, 4u, 7u, 9u}) EXPECT_EQ(dataOf(result).valid[cell], 0) << cell;
  EXPECT_EQ(dataOf(result).valid[0], 1);
  EXPECT_EQ(dataOf(result).values[48 + 7], 0);
  EXPECT_GE(result.report.invalid, 4u);
  EXPECT_FALSE(result.report.warnings.empty());
}

TEST(Merl, ZeroIsAValue) {
  auto raw = smallRaw();
  raw[0] = raw[24] = raw[48] = 0;
  EXPECT_EQ(dataOf(readBytes(folder("merl_zero"), "a.binary", merlBytes(2, 3, 4, raw))).valid[0], 1);
}

TEST(Merl, BrokenFilesAreErrors) {
  const auto dir = folder("merl_broken");
  const auto good = merlBytes(2, 3, 4, smallRaw());
  const std::int32_t most = std::numeric_limits<std::int32_t>::max();
  const struct {
    std::string bytes;
    const char* expected;
  } cases[] = {
      {good.substr(0, good.size() - 8), "588 bytes"},  // truncated: 12 + 24 * 24 expected
      {good + "x", "588 bytes"},
      {good.substr(0, 7), "header is cut short"},
      {good.substr(0, 12), "588 bytes"},
      {merlBytes(most, most, most, smallRaw()), "a smaller table"},
      {merlBytes(0, 90, 180, smallRaw()), "positive"},
      {merlBytes(-90, 90, 180, smallRaw()), "positive"},
      {merlBytes(90, 90, 180, smallRaw()), "34992012 bytes"},
      {"", "empty"},
  };
  for (const auto& [bytes, expected] : cases) {
    const std::string error = errorOf([&] { readBytes(dir, "a.binary", bytes); });
    EXPECT_NE(error.find(expected), std::string::npos) << error;
    EXPECT_NE(error.find("a.binary"), std::string::npos) << error;
  }
  // A cut MERL file is known for what it is whatever its name.
  EXPECT_NE(errorOf([&] { readBytes(dir, "a.dat", good.substr(0, 500)); }).find("588 bytes"), std::string::npos);
}

TEST(Merl, RoundTripKeepsEveryCellToTheLastDigit) {
  const auto dir = folder("merl_round_trip");
  for (const std::size_t phiD : {180u, 360u}) {
    const auto table = brdf::TableBrdf::tabulate(measuredtest::FunctionBrdf(measuredtest::glossy),
                                                 {.phiD = phiD, .reciprocal = phiD == 180});
    EXPECT_TRUE(brdf::writeMeasured(*table, dir / "a.binary").losses.empty());
    EXPECT_EQ(std::filesystem::file_size(dir / "a.binary"), 12 + 24 * 8100 * phiD);
    const auto back = brdf::readMeasured(dir / "a.binary");
    const auto& data = dataOf(back);
    EXPECT_EQ(data.layout, table->data().layout);
    EXPECT_EQ(data.valid, table->data().valid);
    double worst = 0;
    for (std::size_t i = 0; i < data.values.size(); ++i)
      if (data.values[i] != 0) worst = std::max(worst, std::abs(data.values[i] / table->data().values[i] - 1));
    EXPECT_LE(worst, 2 * std::numeric_limits<double>::epsilon());
    std::filesystem::remove(dir / "a.binary");
  }
}

TEST(Merl, WritingOtherKindsResamplesAndSaysSo) {
  const auto dir = folder("merl_resampled");
  const measuredtest::FunctionBrdf spectral(
      [](const brdf::Direction&, const brdf::Direction&, std::size_t) { return 0.25; },
      brdf::Channels::spectral({450, 500, 550, 600, 650}));
  const auto report = brdf::writeMeasured(spectral, dir / "a.binary");
  EXPECT_EQ(report.losses.size(), 2u);  // the spectrum and the sampling
  const auto back = brdf::readMeasured(dir / "a.binary");
  const auto value = back.brdf->evaluate(brdf::fromSpherical(0.3, 0), brdf::fromSpherical(0.5, 2));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(value[c], 0.25, 1e-12);
}

TEST(Merl, TablesTravelThroughCsvAsScatteredSamples) {
  const auto dir = folder("merl_csv");
  const auto first = readBytes(dir, "a.binary", merlBytes(2, 3, 4, smallRaw()));
  brdf::writeMeasured(*first.brdf, dir / "a.csv");
  const auto second = brdf::readMeasured(dir / "a.csv");
  EXPECT_EQ(second.report.samples, first.report.samples - first.report.invalid);
}
