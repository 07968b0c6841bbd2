// Tables on the command line: assumptions, resampling, filling, and what info says of cells and components.
#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/geometry/Directions.h>
#include <brdf/io/Container.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/LobeSum.h>

#include <gtest/gtest.h>

using nlohmann::json;

namespace {

/// A spectral-free container: a grid with one hole in the middle, one component of each kind.
void writeSheet(const std::filesystem::path& path) {
  using Q = brdf::AxisQuantity;
  const brdf::GridLayout layout{
      brdf::Parametrisation::Spherical,
      {brdf::GridAxis::listedDegrees(Q::ThetaO, {0, 30, 60}), brdf::GridAxis::listedDegrees(Q::ThetaI, {0, 30, 60})}};
  brdf::GridData data = brdf::GridBrdf::tabulate(*brdf::parseMaterialExpression("0.5*Lambertian"), layout)->data();
  data.states[4] = 0;
  brdf::Components components;
  components.scatter.push_back(
      {brdf::ComponentKind::FrontTransmission, brdf::parseMaterialExpression("0.2*Lambertian")});
  components.specular.push_back({brdf::ComponentKind::FrontTransmission, {}, {0, 1}, {0.3, 0.1}});
  components.totals.push_back({brdf::ComponentKind::FrontReflection, {0, 1}, {0.5, 0.5}});
  brdf::writeContainer(path, "sheet", brdf::GridBrdf(std::move(data), "sheet"), {}, components);
}

}  // namespace

TEST(Tables, AssumptionsChangeWhatAFileMeans) {
  const auto folder = scratchFolder();
  brdf::writeFile(folder / "a.brdf", "1 550\n0 0 1.0471975511965976 0 0.5\n");
  const auto value = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"eval", "a.brdf", "--at", "0,0,60,0"};
    words.insert(words.end(), more.begin(), more.end());
    const json report = reportOf(folder, words);
    return report["values"][0]["value"][0].get<double>();
  };
  EXPECT_NEAR(value({}), 0.5, 1e-12);
  EXPECT_NEAR(value({"--assume", "quantity=brdf_cos"}), 1.0, 1e-12);
  const json info = reportOf(folder, {"info", "a.brdf", "--assume", "quantity=brdf_cos"});
  EXPECT_NE(info["assumptions"].dump().find("quantity: brdf_cos (given"), std::string::npos);
  const Outcome refused = runBrdf(folder, {"info", "a.brdf", "--assume", "sides=swapped"});
  EXPECT_EQ(refused.exitCode, 1);
  EXPECT_NE(refused.err.find("cornell"), std::string::npos) << refused.err;
  EXPECT_EQ(runBrdf(folder, {"info", "a.brdf", "--assume", "quantity"}).exitCode, 2);
}

TEST(Tables, InfoListsCellsAxesAndComponents) {
  const auto folder = scratchFolder();
  writeSheet(folder / "sheet.vtkhdf");
  const json info = reportOf(folder, {"info", "sheet.vtkhdf"});
  EXPECT_EQ(info["cells"]["measured"], 8);
  EXPECT_EQ(info["cells"]["extrapolated"], 0);
  EXPECT_EQ(info["cells"]["invalid"], 1);
  EXPECT_EQ(info["axes"], "theta_o 3 x theta_i 3, spherical");
  ASSERT_EQ(info["components"].size(), 3u);
  EXPECT_EQ(info["components"][0]["component"], "front transmission");
  EXPECT_EQ(info["components"][1]["component"], "specular front transmission");
  EXPECT_EQ(info["components"][2]["component"], "total front reflection");
  EXPECT_NE(runBrdf(folder, {"info", "sheet.vtkhdf"}).out.find("not drawn or rendered yet"), std::string::npos);
}

TEST(Tables, ConvertFillsHolesAndKeepsComponentsInContainers) {
  const auto folder = scratchFolder();
  writeSheet(folder / "sheet.vtkhdf");
  for (const std::string method : {"nearest", "reciprocity", "model:0.5*Lambertian"}) {
    const json report = reportOf(folder, {"convert", "sheet.vtkhdf", "filled.vtkhdf", "--fill", method});
    const json info = reportOf(folder, {"info", "filled.vtkhdf"});
    // The hole is its own exchanged pair: reciprocity has nothing to take its value from.
    const int filled = method == "reciprocity" ? 0 : 1;
    EXPECT_EQ(info["cells"]["extrapolated"], filled) << method;
    EXPECT_EQ(info["cells"]["invalid"], 1 - filled) << method;
    EXPECT_EQ(info["components"].size(), 3u);
    EXPECT_NE(info["assumptions"].dump().find("filled by " + method), std::string::npos);
    EXPECT_NE(report["filled"].get<std::string>().find(std::to_string(filled) + " cells"), std::string::npos);
  }
  const json csv = reportOf(folder, {"convert", "sheet.vtkhdf", "sheet.csv"});
  for (const char* lost :
       {"\"front transmission: csv", "\"specular front transmission: csv", "total of the front reflection: csv"})
    EXPECT_NE(csv["losses"].dump().find(lost), std::string::npos) << csv["losses"].dump();
  EXPECT_EQ(runBrdf(folder, {"convert", "sheet.vtkhdf", "x.vtkhdf", "--fill", "magic"}).exitCode, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "x.vtkhdf"));
}

TEST(Tables, ConvertResamplesAndStatesTheErrorByRegion) {
  const auto folder = scratchFolder();
  const std::string lobe = "0.3*Lambertian + 0.2*GGX(alpha=0.3)";
  const auto restOf = [&](const std::string& grid) {
    const json report = reportOf(folder, {"convert", lobe, "a.vtkhdf", "--grid", grid});
    EXPECT_NE(report["losses"].dump().find("resampled at"), std::string::npos);
    EXPECT_EQ(report["regions"].size(), 4u);
    EXPECT_EQ(report["regions"][3]["region"], "rest");
    return report["regions"][3]["relative_mean"].get<double>();
  };
  const double coarse = restOf("half_difference:10"), fine = restOf("half_difference:5");
  EXPECT_GT(coarse, fine);
  EXPECT_GT(fine, 0);
  EXPECT_EQ(reportOf(folder, {"info", "a.vtkhdf"})["axes"], "phi_d 18 x theta_d 18 x theta_h 18, half_difference");
  EXPECT_EQ(runBrdf(folder, {"convert", lobe, "a.vtkhdf", "--grid", "cubic"}).exitCode, 1);
}
