#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>

#include <gtest/gtest.h>

#include <cstring>

#ifdef BRDF_HAS_PICTURES
using nlohmann::json;

namespace {

std::vector<std::string> linesOf(const std::filesystem::path& path) {
  const std::string text = brdf::readFile(path);
  std::vector<std::string> lines;
  for (const auto line : brdf::split(text, '\n'))
    if (!line.empty()) lines.emplace_back(line);
  return lines;
}

}  // namespace

TEST(ErrorCommand, OverallIsWhatCompareReportsForEveryMetric) {
  const auto folder = scratchFolder();
  writeSpectralFiles(folder);
  const std::string model = "0.3*Lambertian";
  const json compared = reportOf(folder, {"compare", model, "spectral.csv", "--channels", "luminance"});
  for (const auto& [name, value] : compared["metrics"].items()) {
    const json map = reportOf(folder, {"error", model, "spectral.csv", "--measure", name});
    EXPECT_NEAR(map["mean"].get<double>(), value.get<double>(), 1e-12 * value.get<double>()) << name;
    EXPECT_EQ(map["pairs"], compared["samples"]);
  }
}

TEST(ErrorCommand, WritesTheMapTheHistogramAndTheWorstAsTables) {
  const auto folder = scratchFolder();
  const json report = reportOf(folder, {"error",
                                        "(0.2,0.3,0.4)*Lambertian + 0.1*GGX(alpha=0.3)",
                                        "0.3*Lambertian",
                                        "--channel",
                                        "rgb",
                                        "--axes",
                                        "theta_d,phi_d",
                                        "--resolution",
                                        "18",
                                        "--worst",
                                        "4",
                                        "--out",
                                        "map.csv",
                                        "--out",
                                        "map.png",
                                        "--histogram",
                                        "bars.csv",
                                        "--histogram",
                                        "bars.png",
                                        "--worst-out",
                                        "worst.csv"});
  ASSERT_EQ(report["worst"].size(), 4u);
  EXPECT_EQ(report["channels"].size(), 3u);
  EXPECT_EQ(report["quantiles"].back()["share"], 1);
  EXPECT_EQ(report["quantiles"].back()["error"], report["worst"][0]["error"]);
  EXPECT_EQ(filesIn(folder), (std::vector<std::string>{"bars.csv", "bars.png", "map.csv", "map.png", "worst.csv"}));

  const auto map = linesOf(folder / "map.csv"), bars = linesOf(folder / "bars.csv"),
             worst = linesOf(folder / "worst.csv");
  EXPECT_EQ(map[0], "theta_d,phi_d,error,error_0,error_1,error_2,count");
  EXPECT_LE(map.size(), 1u + 19 * 19);
  EXPECT_EQ(bars[0], "low,high,count,share");
  double pairs = 0;
  for (std::size_t k = 1; k < bars.size(); ++k) pairs += *brdf::parseNumber(brdf::split(bars[k], ',')[2]);
  EXPECT_EQ(pairs, report["pairs"].get<double>());
  EXPECT_EQ(worst.size(), 5u);
  EXPECT_EQ(worst[0], "error,theta_i,phi_i,theta_o,phi_o,a_0,a_1,a_2,b_0,b_1,b_2,x,y");
  // The listed values are the materials' own at the listed directions.
  const json& first = report["worst"][0];
  const auto at = [&](const char* name) { return brdf::formatNumber(first[name].get<double>()); };
  const json value = reportOf(folder, {"eval", "(0.2,0.3,0.4)*Lambertian + 0.1*GGX(alpha=0.3)", "--at",
                                       at("theta_i") + "," + at("phi_i") + "," + at("theta_o") + "," + at("phi_o")});
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(value["values"][0]["value"][c].get<double>(), first["a"][c].get<double>(), 1e-9);
}

TEST(ErrorCommand, VectorFilesHoldTheWords) {
  const auto folder = scratchFolder();
  const Outcome run =
      runLine(folder,
              "brdf error GGX Lambertian --axes hemisphere --resolution 20 --out disk.svg --out disk.pdf "
              "--histogram bars.svg");
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const std::string disk = brdf::readFile(folder / "disk.svg"), bars = brdf::readFile(folder / "bars.svg");
  for (const char* words : {"A against B", "A: GGX", "B: Lambertian", "phi = 0"})
    EXPECT_NE(disk.find(words), std::string::npos) << words;
  EXPECT_NE(bars.find("median"), std::string::npos);
  EXPECT_EQ(brdf::readFile(folder / "disk.pdf").substr(0, 5), "%PDF-");
}

TEST(LobeCommand, MeshFilesHoldTheTrianglesReported) {
  const auto folder = scratchFolder();
  const json report =
      reportOf(folder, {"lobe", "(0.9,0.5,0.1)*Lambertian", "--colour", "true", "--tolerance", "0", "--subdivision",
                        "3", "--out", "a.ply", "--out", "a.obj", "--out", "a.stl", "--out", "a.vtp"});
  EXPECT_EQ(report["lobes"][0]["triangles"], 256);
  const std::string ply = brdf::readFile(folder / "a.ply"), stl = brdf::readFile(folder / "a.stl");
  EXPECT_EQ(ply.substr(0, 3), "ply");
  EXPECT_NE(ply.find("element face 256"), std::string::npos);
  EXPECT_NE(ply.find("property uchar red"), std::string::npos);
  std::uint32_t triangles = 0;
  ASSERT_GE(stl.size(), 84u);
  std::memcpy(&triangles, stl.data() + 80, 4);
  EXPECT_EQ(triangles, 256u);
  std::size_t faces = 0;
  for (const std::string& line : linesOf(folder / "a.obj")) faces += line.starts_with("f ");
  EXPECT_EQ(faces, 256u);
}

TEST(LobeCommand, AMirrorLikeLobeReachesItsPeak) {
  // D = 1 / (pi alpha^2) at the mirror direction, G = 1, F = 1, over 4 cos^2: what the eval command gives there.
  const auto folder = scratchFolder();
  const json value = reportOf(folder, {"eval", "GGX(alpha=0.001)", "--at", "40,0,40,180"});
  const json report = reportOf(folder, {"lobe", "GGX(alpha=0.001)", "--theta-i", "40", "--out", "a.vtp"});
  const double peak = value["values"][0]["value"][0].get<double>();
  EXPECT_GT(peak, 1000);
  EXPECT_NEAR(report["lobes"][0]["largest"].get<double>() / peak, 1, 1e-6);
  EXPECT_LE(report["lobes"][0]["chord_error"].get<double>(), 1e-3);
}

TEST(LobeCommand, SeveralMaterialsSideBySideWithSamplesAndDifferences) {
  const auto folder = scratchFolder();
  writeSpectralFiles(folder);
  for (const char* options :
       {"--layout side --colour value", "--layout side --samples --within 20", "--samples --within 20",
        "--difference lobe --transform cuberoot", "--difference displaced --transform logfloor --floor 0.01"}) {
    const Outcome run =
        runLine(folder, std::string("brdf lobe spectral.csv spectral.xml ") + options + " --size 200x160 --out a.png");
    EXPECT_EQ(run.exitCode, 0) << options << run.err;
  }
}
#endif
