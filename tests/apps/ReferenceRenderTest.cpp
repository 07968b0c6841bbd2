// The reference renderer on the command line.
#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/io/ImageFile.h>

#include <gtest/gtest.h>

#include <cmath>

using nlohmann::json;

TEST(ReferenceRender, WritesRadianceAndItsStandardError) {
  const auto folder = scratchFolder();
  const json report =
      reportOf(folder, {"render", "0.5*Lambertian", "--light", "directional:0,0", "--reference", "--size", "33x33",
                        "--samples", "16", "--out", "a.exr", "--standard-error", "e.exr"});
  EXPECT_EQ(report["device"], "CPU");
  EXPECT_EQ(report["samples"], 16);
  const brdf::Image picture = brdf::readImage(folder / "a.exr"), error = brdf::readImage(folder / "e.exr");
  ASSERT_EQ(picture.width, 33u);
  // Light from above. The camera stands at z = 1.08 / sin 15 degrees = 4.173; the ray through the middle of this pixel,
  // (1 - 7 / 33) tan 15 degrees upwards, meets the sphere at y = 0.739.
  EXPECT_NEAR(picture.pixel(16, 3)[0], 0.5 * 0.739, 0.002 + 4 * error.pixel(16, 3)[0]);
  EXPECT_EQ(picture.pixel(16, 29)[0], 0);
  EXPECT_GT(error.pixel(16, 3)[0], 0);
  EXPECT_LT(error.pixel(16, 3)[0], 0.05f);
}

TEST(ReferenceRender, AToleranceIsReachedOrSaidNotToBe) {
  const auto folder = scratchFolder();
  brdf::writeFile(folder / "scene.json", R"json({"film": {"width": 24, "height": 24},
    "environment": {"constant": [1, 1, 1]}, "background": {"kind": "color", "color": [0, 0, 0]},
    "materials": {"m": "0.5*Lambertian + 0.3*GGX"}, "objects": [{"shape": "sphere", "material": "m"}]})json");
  const auto render = [&](const char* tolerance, const char* samples) {
    return reportOf(folder, {"render", "--scene", "scene.json", "--reference", "--tolerance", tolerance, "--samples",
                             samples, "--out", "a.exr"});
  };
  const json reached = render("0.02", "100000");
  EXPECT_TRUE(reached["converged"]);
  EXPECT_LE(reached["relative_error"].get<double>(), 0.02);
  EXPECT_EQ(reached["size"], json({24, 24}));
  EXPECT_FALSE(render("0.0001", "32")["converged"]);
}

TEST(ReferenceRender, TablesAreDrawnByIt) {
  const auto folder = scratchFolder();
  ASSERT_EQ(runBrdf(folder, {"convert", "(0.4,0.2,0.1)*Lambertian", "a.binary"}).exitCode, 0);
  const json report = reportOf(folder, {"render", "a.binary", "--light", "directional:0,0", "--reference", "--size",
                                        "17x17", "--samples", "4", "--out", "a.exr"});
  EXPECT_EQ(report["device"], "CPU");
  EXPECT_EQ(report["samples"], 4);
  const brdf::Image picture = brdf::readImage(folder / "a.exr");
  EXPECT_NEAR(picture.pixel(8, 3)[0] / picture.pixel(8, 3)[2], 4, 0.01);
}

TEST(ReferenceRender, WhatDoesNotGoTogetherIsRefused) {
  const auto folder = scratchFolder();
  const auto refused = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "render");
    words.insert(words.end(), {"--out", "a.exr"});
    const Outcome run = runBrdf(folder, words);
    EXPECT_EQ(run.exitCode, 2) << run.err;
    EXPECT_TRUE(filesIn(folder).empty());
    return run.err;
  };
  EXPECT_NE(refused({}).find("MATERIAL or --scene"), std::string::npos);
  EXPECT_NE(refused({"Lambertian", "--scene", "x.json"}).find("a material and a scene"), std::string::npos);
  EXPECT_NE(refused({"--scene", "x.json", "--light", "point:1,1,1"}).find("its own lights"), std::string::npos);
  EXPECT_NE(refused({"Lambertian"}).find("--light"), std::string::npos);
  EXPECT_NE(refused({"Lambertian", "--light", "directional:0,0", "--turntable", "3"}).find("frame_%03d.png"),
            std::string::npos);
  EXPECT_NE(refused({"Lambertian", "--light", "directional:0,0", "--turn", "environment"}).find("no environment"),
            std::string::npos);
  EXPECT_NE(refused({"Lambertian", "--light", "directional:0,0", "--bounces", "3"}).find("--reference"),
            std::string::npos);
}

#ifdef BRDF_HAS_PICTURES
TEST(ReferenceRender, MeshesComeFromFiles) {
  const auto folder = scratchFolder();
  // A square facing +z, without normals.
  brdf::writeFile(folder / "square.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3\nf 1 3 4\n");
  reportOf(folder, {"render", "0.5*Lambertian", "--object", "square.obj", "--light", "directional:90,0", "--reference",
                    "--size", "16x16", "--samples", "2", "--out", "a.exr"});
  EXPECT_NEAR(brdf::readImage(folder / "a.exr").pixel(8, 8)[1], 0.5, 1e-5);
}

TEST(ReferenceRender, TheExampleSceneOfTheDocumentationIsDrawn) {
  const auto folder = scratchFolder();
  const json report = reportOf(folder, {"render", "--scene", BRDF_SOURCE_DIR "/docs/examples/three-spheres.json",
                                        "--reference", "--samples", "2", "--bounces", "2", "--out", "a.png"});
  EXPECT_EQ(report["size"], json({480, 320}));
  EXPECT_GT(report["mean_radiance"].get<double>(), 0.05);
}
#endif
