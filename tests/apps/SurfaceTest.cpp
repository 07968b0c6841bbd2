#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace {

using nlohmann::json;

double fact(const json& report, const std::string& name) {
  for (const json& one : report["facts"])
    if (one["name"] == name) return one["value"];
  ADD_FAILURE() << name;
  return NAN;
}

}  // namespace

TEST(Surface, ListShowsEveryKindWithItsParameters) {
  const auto folder = scratchFolder();
  std::set<std::string> listed;
  for (const json& kind : reportOf(folder, {"surface", "--list"})) listed.insert(kind["name"].get<std::string>());
  for (const char* name : {"flat", "grooves", "lamellar", "sinusoidal", "blazed", "gaussian", "exponential", "rough",
                           "brushed", "scratched", "triangles", "heightfield", "mesh", "spheres"})
    EXPECT_TRUE(listed.contains(name)) << name;
  const json one = reportOf(folder, {"surface", "grooves", "--list"});
  ASSERT_EQ(one.size(), 1u);
  for (const json& parameter : one[0]["parameters"])
    for (const char* key : {"name", "default", "min", "max", "unit", "description"})
      EXPECT_TRUE(parameter.contains(key)) << parameter;
  EXPECT_EQ(runBrdf(folder, {"surface", "groves", "--list"}).exitCode, 1);
}

TEST(Surface, HeightsWrittenReadBackAsTheSameSurface) {
  const auto folder = scratchFolder();
  const json made =
      reportOf(folder, {"surface", "gaussian(rms=0.3, correlation=4, period=64, resolution=4)", "--out", "h.exr"});
  EXPECT_NEAR(fact(made, "rms height"), 0.3, 1e-6);
  const json read = reportOf(folder, {"surface", "heightfield(file=h.exr)"});
  for (const char* name : {"rms height", "rms slope along x", "rms slope along y", "lowest point", "nodes along x"})
    EXPECT_DOUBLE_EQ(fact(read, name), fact(made, name)) << name;
}

TEST(Surface, SpectrumIsWrittenAndItsIntegralIsTheVariance) {
  const auto folder = scratchFolder();
  const json report = reportOf(folder, {"surface", "sinusoidal(pitch=10, depth=2)", "--spectrum", "psd.csv"});
  EXPECT_NEAR(report["spectrum"]["variance"].get<double>(), 0.5, 1e-6);
  EXPECT_NEAR(report["spectrum"]["slope_variance_x"].get<double>(), std::pow(2 * M_PI / 10, 2) / 2, 1e-6);
  const std::string text = brdf::readFile(folder / "psd.csv");
  EXPECT_TRUE(text.starts_with("direction,frequency (1/um),psd (um^4)\n"));
  // Period 10 x 10 um: 100 |c|^2 with c = 1/2, at 0.1/um.
  const std::size_t at = text.find("along x,0.1,");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(text.substr(at + 12)), 25, 1e-5);
}

TEST(Surface, ErrorsAreOneLine) {
  const auto folder = scratchFolder();
  for (const auto& [arguments, code, text] : std::vector<std::tuple<std::vector<std::string>, int, std::string>>{
           {{"surface"}, 2, "no surface"},
           {{"surface", "grooves(width=40)"}, 1, "surface grooves, width: out of bounds"},
           {{"surface", "grooves(", "--out", "x.png"}, 1, "column"},
           {{"surface", "lamellar", "--spectrum", "x.csv"}, 1, "a height field"},
           {{"surface", "lamellar", "--out", "x.exr"}, 1, "a height field"},
           {{"surface", "flat", "--out", "x.gif"}, 2, ".png, .vtp"},
           {{"surface", "flat", "--spectrum", "x.gif"}, 2, ".csv"},
           {{"surface", "heightfield(file=missing.png)"}, 1, "missing.png"},
           {{"surface", "mesh(file=missing.stl)"}, 1, "missing.stl"}}) {
    const Outcome run = runBrdf(folder, arguments);
    EXPECT_EQ(run.exitCode, code) << run.err;
    EXPECT_NE(run.err.find(text), std::string::npos) << run.err;
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
  }
  EXPECT_TRUE(filesIn(folder).empty());
}

#ifdef BRDF_HAS_PICTURES
TEST(Surface, MeshWrittenIsASurfaceAgain) {
  const auto folder = scratchFolder();
  const json made = reportOf(folder, {"surface", "lamellar(pitch=10, depth=2)", "--out", "l.stl", "--out", "l.ply",
                                      "--out", "l.vtp", "--out", "l.obj"});
  for (const char* file : {"l.stl", "l.ply", "l.vtp", "l.obj"}) {
    const json read = reportOf(folder, {"surface", std::string("mesh(file=") + file + ")"});
    for (const char* name : {"triangles", "lowest point", "highest point", "period along x", "period along y"})
      EXPECT_NEAR(fact(read, name), fact(made, name), 1e-6) << file << " " << name;
  }
}
#endif
