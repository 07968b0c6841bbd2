// Converging pictures on the command line.
#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/io/ImageFile.h>

#include <gtest/gtest.h>

#include <cmath>

using nlohmann::json;

#ifdef BRDF_HAS_PICTURES

namespace {

void writeFurnace(const std::filesystem::path& folder) {
  brdf::writeFile(folder / "furnace.json", R"json({"film": {"width": 24, "height": 24},
    "environment": {"constant": [1, 1, 1]}, "background": {"kind": "color", "color": [0, 0, 0]},
    "materials": {"m": "0.5*Lambertian + GGX(alpha=0.3, ior=1.5)"},
    "objects": [{"shape": "sphere", "material": "m"}]})json");
}

}  // namespace

TEST(Converge, ReachesAToleranceOrSaysThatItDidNot) {
  const auto folder = scratchFolder();
  writeFurnace(folder);
  const auto render = [&](const char* tolerance, const char* samples) {
    return reportOf(folder, {"render", "--scene", "furnace.json", "--converge", "--tolerance", tolerance, "--samples",
                             samples, "--out", "a.exr", "--standard-error", "e.exr"});
  };
  const json reached = render("0.02", "100000");
  EXPECT_TRUE(reached["converged"]);
  EXPECT_LE(reached["relative_error"].get<double>(), 0.02);
  EXPECT_NE(reached["device"], "CPU");
  const brdf::Image picture = brdf::readImage(folder / "a.exr"), error = brdf::readImage(folder / "e.exr");
  ASSERT_EQ(error.width, 24u);
  ASSERT_EQ(error.channels, 3u);
  // Facing the viewer: 0.5 and 4.09 % of Fresnel's reflectance, which the lobe's shadowing lowers a little.
  EXPECT_NEAR(picture.pixel(12, 12)[1], 0.54, 0.01);
  EXPECT_LT(error.pixel(12, 12)[1], 0.05f);
  EXPECT_GT(error.pixel(12, 12)[1], 0);
  const json cut = render("0.0001", "32");
  EXPECT_FALSE(cut["converged"]);
  EXPECT_EQ(cut["samples"], 32);
}

TEST(Converge, CtrlCKeepsThePictureSoFar) {
  const auto folder = scratchFolder();
  writeFurnace(folder);
  const Outcome outcome = runLine(folder, "{ '" BRDF_PROGRAM
                                          "' render --scene furnace.json --converge --tolerance 0 --samples 10000000"
                                          " --out a.exr --standard-error e.exr --json report.json > out & p=$!;"
                                          " until grep -q relative out; do sleep 0.1; done; kill -INT $p; wait $p; }");
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
  const json report = json::parse(brdf::readFile(folder / "report.json"));
  EXPECT_FALSE(report["converged"]);
  EXPECT_LT(report["samples"].get<int>(), 10000000);
  // However few samples there were.
  EXPECT_NEAR(brdf::readImage(folder / "a.exr").pixel(12, 12)[1], 0.54,
              0.01 + 5 * brdf::readImage(folder / "e.exr").pixel(12, 12)[1]);
}

#endif

TEST(Converge, WhatDoesNotGoTogetherIsRefused) {
  const auto folder = scratchFolder();
  const auto refused = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"render", "Lambertian", "--light", "directional:0,0", "--out", "a.exr"});
    const Outcome run = runBrdf(folder, words);
    EXPECT_EQ(run.exitCode, 2) << run.err;
    EXPECT_TRUE(filesIn(folder).empty());
    return run.err;
  };
  EXPECT_NE(refused({"--converge", "--reference"}).find("one of two ways"), std::string::npos);
  EXPECT_NE(refused({"--tolerance", "0.1"}).find("--reference or --converge"), std::string::npos);
  EXPECT_NE(refused({"--standard-error", "e.exr"}).find("--reference or --converge"), std::string::npos);
  EXPECT_NE(refused({"--converge", "--bounces", "2"}).find("--reference"), std::string::npos);
}
