#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using nlohmann::json;

namespace {

const std::string kHeader = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z";
const std::string kGgx = "0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)";

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (const auto line : brdf::split(text, '\n')) lines.emplace_back(line);
  if (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

double lastNumber(const std::string& line) { return *brdf::parseNumber(brdf::split(line, ',').back()); }

/// Rows of random directions above the horizon with 17 digits, after an identifying first column.
std::string randomTable(std::size_t rows) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform;
  std::string text = "row," + kHeader + "\n";
  for (std::size_t i = 0; i < rows; ++i) {
    text += "r" + std::to_string(i);
    for (int k = 0; k < 2; ++k) {
      const double z = 0.02 + 0.98 * uniform(random), phi = 2 * std::numbers::pi * uniform(random);
      const double r = std::sqrt(1 - z * z);
      for (const double w : {r * std::cos(phi), r * std::sin(phi), z}) text += "," + brdf::formatNumber(w, 17);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

TEST(Eval, ALambertianIsItsAlbedoOverPiInEveryPrecision) {
  const auto folder = scratchFolder();
  for (const auto& [precision, tolerance] : {std::pair{"float", 1e-7}, {"double", 1e-16}, {"extended", 1e-16}}) {
    const json report =
        reportOf(folder, {"eval", "0.5*Lambertian", "--at", "30,0,60,90", "--precision", precision, "--pdf"});
    ASSERT_EQ(report["values"].size(), 1u);
    const json& value = report["values"][0];
    EXPECT_NEAR(value["value"][0].get<double>(), 0.5 / std::numbers::pi, tolerance) << precision;
    EXPECT_NEAR(value["pdf"].get<double>(), std::cos(std::numbers::pi / 6) / std::numbers::pi, 1e-7) << precision;
  }
}

TEST(Eval, BelowTheHorizonTheValueIsZero) {
  const json report = reportOf(scratchFolder(), {"eval", "0.5*Lambertian", "--at", "95,0,10,0", "--at", "10,0,95,0"});
  for (const json& value : report["values"]) EXPECT_EQ(value["value"][0], 0.0);
}

TEST(Eval, ATableKeepsItsRowsAndGainsOneColumnAChannel) {
  const auto folder = scratchFolder();
  brdf::writeFile(folder / "in.csv", "name," + kHeader + "\r\n\"up\",0,0,1,0,0,1\r\n\r\nx,0.6,0,0.8,-0.6,0,0.8\r\n");
  const Outcome run =
      runBrdf(folder, {"eval", "(0.3,0.2,0.1)*Lambertian", "--directions", "in.csv", "--out", "out.csv", "--pdf"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const auto lines = linesOf(brdf::readFile(folder / "out.csv"));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "name," + kHeader + ",value_0,value_1,value_2,pdf");
  EXPECT_TRUE(lines[1].starts_with("\"up\",0,0,1,0,0,1,0.0954929658551372")) << lines[1];
  EXPECT_TRUE(lines[2].starts_with("x,0.6,0,0.8,-0.6,0,0.8,0.0954929658551372")) << lines[2];
}

TEST(Eval, ALongTableHasTheValuesOfSingleEvaluationsInRowOrder) {
  const auto folder = scratchFolder();
  constexpr std::size_t rows = 10'000;  // several blocks
  brdf::writeFile(folder / "in.csv", randomTable(rows));
  ASSERT_EQ(runBrdf(folder, {"eval", kGgx, "--directions", "in.csv", "--out", "out.csv"}).exitCode, 0);
  ASSERT_EQ(
      runBrdf(folder, {"eval", kGgx, "--directions", "in.csv", "--out", "x.csv", "--precision", "extended"}).exitCode,
      0);
  const auto in = linesOf(brdf::readFile(folder / "in.csv")), out = linesOf(brdf::readFile(folder / "out.csv")),
             exact = linesOf(brdf::readFile(folder / "x.csv"));
  ASSERT_EQ(out.size(), rows + 1);
  for (std::size_t i = 1; i <= rows; ++i) {
    ASSERT_TRUE(out[i].starts_with(in[i] + ","));
    ASSERT_NEAR(lastNumber(out[i]), lastNumber(exact[i]), 1e-13 * lastNumber(exact[i])) << out[i];
  }
}

TEST(Eval, DirectionsOfFewDigitsAreNormalised) {
  const auto folder = scratchFolder();
  brdf::writeFile(folder / "in.csv", kHeader + "\n0.7071,0,0.7071,-0.7071,0,0.7071\n");
  ASSERT_EQ(runBrdf(folder, {"eval", kGgx, "--directions", "in.csv", "--out", "out.csv"}).exitCode, 0);
  const json report = reportOf(folder, {"eval", kGgx, "--at", "45,0,45,180"});
  EXPECT_NEAR(lastNumber(linesOf(brdf::readFile(folder / "out.csv"))[1]), report["values"][0]["value"][0].get<double>(),
              1e-12);
}
