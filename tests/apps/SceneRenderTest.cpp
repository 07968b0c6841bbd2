// Scenes, cameras, backgrounds and turntables on the command line.
#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/io/ImageFile.h>

#include <gtest/gtest.h>

#include <algorithm>

using nlohmann::json;

#ifdef BRDF_HAS_PICTURES
TEST(SceneRender, ASceneIsDrawnByTheDeviceUnlessTheReferenceIsAskedFor) {
  const auto folder = scratchFolder();
  brdf::writeFile(folder / "scene.json", R"json({"film": {"width": 40, "height": 30},
    "lights": [{"kind": "directional", "theta": 30, "phi": 40, "irradiance": [3, 3, 3]}],
    "materials": {"red": "(0.5,0.1,0.1)*Lambertian", "metal": "GGX(alpha=0.3)"},
    "objects": [{"shape": "torus", "material": "red", "position": [-1, 0, 0]},
                {"shape": "preview", "material": "metal", "position": [1, 0, 0]}],
    "camera": {"preset": "three-quarter"}, "ground": {}})json");
  const json device = reportOf(folder, {"render", "--scene", "scene.json", "--out", "a.exr"});
  const json reference =
      reportOf(folder, {"render", "--scene", "scene.json", "--reference", "--samples", "64", "--out", "b.exr"});
  EXPECT_NE(device["device"], "CPU");
  EXPECT_EQ(reference["device"], "CPU");
  EXPECT_NEAR(device["mean_radiance"].get<double>(), reference["mean_radiance"].get<double>(),
              0.005 * reference["mean_radiance"].get<double>());
  // Without shadows more of the ground is lit.
  const json open = reportOf(folder, {"render", "--scene", "scene.json", "--shadows", "none", "--out", "c.exr"});
  EXPECT_GT(open["mean_radiance"].get<double>(), 1.01 * device["mean_radiance"].get<double>());
}

TEST(SceneRender, WithoutABackgroundThePictureHasAlphaInBothRenderers) {
  const auto folder = scratchFolder();
  for (const bool reference : {false, true}) {
    std::vector<std::string> words{"render",       "0.5*Lambertian", "--light", "directional:60,0",
                                   "--background", "none",           "--size",  "33x33",
                                   "--out",        "a.exr",          "--out",   "a.png"};
    if (reference) words.insert(words.end(), {"--reference", "--samples", "16"});
    reportOf(folder, words);
    const brdf::Image picture = brdf::readImage(folder / "a.exr");
    ASSERT_EQ(picture.channels, 4u);
    EXPECT_EQ(picture.pixel(0, 0)[3], 0);
    EXPECT_EQ(picture.pixel(16, 16)[3], 1);
    EXPECT_GT(picture.pixel(16, 16)[0], 0.1);
  }
}

TEST(SceneRender, APictureBehindTheObjectIsReadAsSrgb) {
  const auto folder = scratchFolder();
  // White where the light is, from the program itself: a plane that fills the picture.
  reportOf(folder, {"render", "0.5*Lambertian", "--object", "plane", "--light", "directional:90,0", "--view-angle", "2",
                    "--size", "16x16", "--out", "half.png"});
  reportOf(folder, {"render", "0.5*Lambertian", "--light", "directional:90,0", "--background", "half.png", "--size",
                    "32x32", "--out", "a.exr"});
  const brdf::Image picture = brdf::readImage(folder / "a.exr");
  EXPECT_NEAR(picture.pixel(16, 16)[0], 0.5, 0.01);
  EXPECT_EQ(picture.pixel(0, 16)[0], picture.pixel(0, 17)[0]);
}

TEST(SceneRender, ATurntableWritesItsFramesAndTurns) {
  const auto folder = scratchFolder();
  const json report =
      reportOf(folder, {"render", "0.5*Lambertian", "--object", "cube", "--ground", "--camera", "grazing", "--light",
                        "directional:60,30", "--size", "32x32", "--turntable", "4", "--out", "f_%02d.exr"});
  EXPECT_EQ(report["frames"], 4);
  const auto frame = [&](const char* name) { return brdf::readImage(folder / name).values; };
  // A cube is the same after a quarter turn, up to the rounding of its turn.
  const auto first = frame("f_00.exr"), second = frame("f_01.exr");
  double difference = 0;
  for (std::size_t k = 0; k < first.size(); ++k) difference += std::abs(double(first[k]) - double(second[k]));
  EXPECT_LT(difference / double(first.size()), 5e-3);
  EXPECT_TRUE(std::filesystem::exists(folder / "f_03.exr"));
  EXPECT_FALSE(std::filesystem::exists(folder / "f_04.exr"));
  reportOf(folder, {"render", "0.5*Lambertian", "--object", "cube", "--light", "directional:60,30", "--size", "32x32",
                    "--turntable", "3", "--out", "g_%d.exr"});
  EXPECT_NE(frame("g_0.exr"), frame("g_1.exr"));
}

TEST(SceneRender, WhatCannotBeDrawnIsSaidInOneLine) {
  const auto folder = scratchFolder();
  brdf::writeFile(folder / "bad.obj", "v 0 0 0\nf 1 2 3\n");
  const auto refused = [&](std::vector<std::string> words, int code) {
    words.insert(words.begin(), {"render", "Lambertian", "--light", "directional:0,0", "--out", "a.png"});
    const Outcome run = runBrdf(folder, words);
    EXPECT_EQ(run.exitCode, code) << run.err;
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
    return run.err;
  };
  EXPECT_NE(refused({"--object", "teapot"}, 1).find("superellipsoid"), std::string::npos);
  EXPECT_NE(refused({"--object", "bad.obj"}, 1).find("bad.obj, line 2"), std::string::npos);
  EXPECT_NE(refused({"--object", "none.glb"}, 1).find("none.glb"), std::string::npos);
  EXPECT_NE(refused({"--camera", "below"}, 1).find("three-quarter"), std::string::npos);
  EXPECT_NE(refused({"--look-at", "1,2"}, 2).find("--look-at"), std::string::npos);
  EXPECT_NE(refused({"--background", "color:1"}, 2).find("--background"), std::string::npos);
  EXPECT_NE(refused({"--background", "none.png"}, 1).find("none.png"), std::string::npos);
  EXPECT_NE(refused({"--look-at", "0,0,0", "--shadows", "some"}, 2).find("lights"), std::string::npos);
}
#endif
