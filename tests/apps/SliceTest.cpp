#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/io/ImageFile.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

using nlohmann::json;

namespace {

constexpr double kPi = std::numbers::pi;
const std::string kPaint = "(0.4,0.2,0.1)*Lambertian";

/// A file of comma-separated values, none of them quoted: its rows by column.
std::vector<std::map<std::string, std::string>> readCsv(const std::filesystem::path& path) {
  std::vector<std::map<std::string, std::string>> rows;
  std::vector<std::string_view> names;
  const std::string text = brdf::readFile(path);
  for (const auto line : brdf::split(text, '\n')) {
    const auto cells = brdf::split(line, ',');
    if (names.empty()) {
      names = cells;
      continue;
    }
    if (line.empty()) continue;
    auto& row = rows.emplace_back();
    for (std::size_t k = 0; k < std::min(cells.size(), names.size()); ++k)
      row[std::string(names[k])] = std::string(cells[k]);
  }
  return rows;
}

double number(const std::string& text) { return *brdf::parseNumber(text); }

}  // namespace

#ifdef BRDF_HAS_PICTURES

TEST(Slice, EveryFileOfAnImageHoldsTheSameValues) {
  const auto folder = scratchFolder();
  const json report =
      reportOf(folder, {"slice",        kPaint,  "--kind", "image", "--channel", "rgb",   "--phi-d", "0",
                        "--resolution", "10",    "--out",  "x.exr", "--out",     "x.csv", "--out",   "x.vti",
                        "--out",        "x.png", "--out",  "x.svg", "--out",     "x.pdf"});
  EXPECT_EQ(filesIn(folder).size(), 6u);
  const brdf::Image image = brdf::readImage(folder / "x.exr");
  ASSERT_EQ(image.width, 10u);
  ASSERT_EQ(image.channels, 3u);
  std::size_t below = 0;
  for (const auto& row : readCsv(folder / "x.csv")) {
    const double half = number(row.at("theta_h")), difference = number(row.at("theta_d"));
    const auto x = static_cast<std::size_t>(half / 9), y = static_cast<std::size_t>(difference / 9);
    const float* pixel = image.pixel(x, 9 - y);
    EXPECT_NEAR(half, 9 * (static_cast<double>(x) + 0.5), 1e-12);
    if (half + difference > 90 + 1e-9) {
      ++below;
      EXPECT_EQ(row.at("state"), "below the horizon");
      EXPECT_EQ(row.at("red"), "nan");
      EXPECT_TRUE(std::isnan(pixel[0]));
    } else if (half + difference < 90 - 1e-9) {
      EXPECT_EQ(row.at("state"), "measured or computed");
      EXPECT_NEAR(number(row.at("red")), 0.4 / kPi, 1e-15);
      EXPECT_NEAR(pixel[2], 0.1 / kPi, 1e-8);
    }
  }
  EXPECT_EQ(below, 45u);
  const json& counts = report["series"][0]["counts"];
  EXPECT_GE(counts["below_the_horizon"], 45);
  EXPECT_LE(counts["below_the_horizon"], 55);  // ten cells lie on it: rounding decides
  EXPECT_EQ(report["axes"][0]["name"], "theta_h");
  EXPECT_EQ(report["axes"][1]["unit"], "deg");
  EXPECT_NEAR(report["series"][0]["largest"], 0.4 / kPi, 1e-15);
}

TEST(Slice, ACurveIsWhatEvalGives) {
  const auto folder = scratchFolder();
  const std::string gloss = "0.2*Lambertian + 0.5*GGX(alpha=0.2)";
  reportOf(folder, {"slice", gloss, "Lambertian", "--kind", "polar", "--theta-i", "30", "--phi", "120", "--out",
                    "x.csv", "--out", "x.svg"});
  const auto rows = readCsv(folder / "x.csv");
  std::size_t compared = 0;
  for (const auto& row : rows) {
    const double angle = number(row.at("angle"));
    if (row.at("material") != gloss || (angle != 60 && angle != -75 && angle != 0)) continue;
    const json eval = reportOf(
        folder, {"eval", gloss, "--at", "30,0," + brdf::formatNumber(std::abs(angle)) + (angle < 0 ? ",300" : ",120")});
    EXPECT_NEAR(number(row.at("value")), eval["values"][0]["value"][0].get<double>(), 1e-13);
    ++compared;
  }
  EXPECT_EQ(compared, 3u);
}

TEST(Slice, TheAlbedoOfALambertianIsReportedWithItsError) {
  const json report = reportOf(scratchFolder(), {"slice", kPaint, "--kind", "albedo", "--channel", "all", "--points",
                                                 "256", "--resolution", "6", "--out", "x.png"});
  const json& series = report["series"][0];
  EXPECT_EQ(series["channels"], json({"red", "green", "blue"}));
  EXPECT_NEAR(series["bihemispherical"]["value"][0], 0.4, 1e-12);
  EXPECT_LT(series["bihemispherical"]["std_error"][0], 1e-12);
  EXPECT_NEAR(series["smallest"], 0.1, 1e-12);
}

TEST(Slice, HolesOfATableAreCountedAsInfoCountsThem) {
  const auto folder = scratchFolder();
  ASSERT_EQ(runBrdf(folder, {"convert", kPaint, "table.binary", "--quiet"}).exitCode, 0);
  const json report = reportOf(folder, {"slice", "table.binary", "--kind", "holes", "--axes", "phi_d,theta_d", "--out",
                                        "x.png", "--out", "x.csv"});
  const json& counts = report["series"][0]["counts"];
  std::map<std::string, double> sums;
  for (const auto& row : readCsv(folder / "x.csv"))
    for (const char* name : {"measured", "filled", "invalid", "below the horizon"}) sums[name] += number(row.at(name));
  EXPECT_EQ(counts["measured"], sums["measured"]);
  EXPECT_EQ(counts["below_the_horizon"], sums["below the horizon"]);
  EXPECT_EQ(sums["measured"] + sums["filled"] + sums["invalid"] + sums["below the horizon"], 90 * 90 * 180);
  EXPECT_EQ(report["axes"][0]["name"], "phi_d");
}

TEST(Slice, WhatCannotBeDrawnIsSaidAndNothingWritten) {
  const auto folder = scratchFolder();
  const std::vector<std::pair<std::vector<std::string>, int>> cases{
      {{"slice", kPaint, "--kind", "wavelength", "--out", "x.png"}, 1},
      {{"slice", kPaint, "--kind", "holes", "--out", "x.png"}, 1},
      {{"slice", kPaint, "--kind", "image", "--axes", "theta_h", "--out", "x.png"}, 1},
      {{"slice", kPaint, "--kind", "image", "--channel", "9", "--out", "x.png"}, 1},
      {{"slice", kPaint, "--kind", "pie", "--out", "x.png"}, 2},
      {{"slice", kPaint, "--kind", "volume", "--out", "x.svg"}, 2},
      {{"slice", kPaint, kPaint, "--kind", "image", "--out", "x.exr"}, 2},
      {{"slice", kPaint, "--kind", "image", "--scale", "log1p", "--out", "x.png"}, 2},
      {{"slice", kPaint, "--kind", "image", "--range", "0,1", "--out", "x.png"}, 2},
      {{"slice", kPaint, "--kind", "polar", "--theta-i", "90", "--out", "x.png"}, 2}};
  for (const auto& [words, exitCode] : cases) {
    const Outcome run = runBrdf(folder, words);
    EXPECT_EQ(run.exitCode, exitCode) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_TRUE(filesIn(folder).empty());
  }
}

#endif
