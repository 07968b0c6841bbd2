#include <brdf/base/File.h>
#include <brdf/io/Container.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/io/Presets.h>
#include <brdf/material/LobeSum.h>
#include <gtest/gtest.h>

#include "Samples.h"

namespace fs = std::filesystem;
using brdf::loadMaterial;
using samples::errorOf;
using samples::freshFolder;

namespace {

/// A container of two materials.
fs::path twoMaterials(const std::string& folder) {
  const fs::path path = freshFolder(folder) / "two.vtkhdf";
  brdf::ContainerWriter writer(path);
  writer.add("dull", *brdf::parseMaterialExpression("0.25*Lambertian"), {});
  writer.add("bright", *brdf::parseMaterialExpression("0.75*Lambertian"), {});
  writer.commit();
  return path;
}

double albedo(const brdf::LoadedMaterial& loaded) { return loaded.brdf->evaluate({0, 0, 1}, {0, 0, 1})[0] * brdf::kPi; }

}  // namespace

TEST(LoadMaterial, AnExpressionIsAnExpression) {
  const brdf::LoadedMaterial loaded = loadMaterial(" 0.5*Lambertian ");
  EXPECT_EQ(loaded.kind, "expression");
  EXPECT_NEAR(albedo(loaded), 0.5, 1e-15);
}

TEST(LoadMaterial, APresetCarriesItsCitation) {
  const brdf::LoadedMaterial loaded = loadMaterial("preset:ngan-ward-nickel");
  EXPECT_EQ(loaded.kind, "preset");
  EXPECT_EQ(loaded.brdf->channels(), brdf::Channels::rgb());
  EXPECT_NE(loaded.report.metadata.at("citation").find("Ngan"), std::string::npos);
}

TEST(LoadMaterial, AnUnknownPresetIsAnErrorThatListsTheKnown) {
  const std::string error = errorOf([] { loadMaterial("preset:gold"); });
  EXPECT_NE(error.find("preset:gold"), std::string::npos) << error;
  EXPECT_NE(error.find("bagher-sgd-gold-metallic-paint"), std::string::npos) << error;
}

TEST(LoadMaterial, OneOfSeveralIsPickedByNumberOrName) {
  const std::string path = twoMaterials("pick").string();
  EXPECT_NEAR(albedo(loadMaterial(path)), 0.25, 1e-15);
  EXPECT_NEAR(albedo(loadMaterial(path + "#0")), 0.25, 1e-15);
  EXPECT_NEAR(albedo(loadMaterial(path + "#1")), 0.75, 1e-15);
  EXPECT_NEAR(albedo(loadMaterial(path + "#bright")), 0.75, 1e-15);
  EXPECT_EQ(loadMaterial(path).kind, "container");
  EXPECT_EQ(loadMaterial(path).report.warnings.size(), 1U) << "says that there are others";
  EXPECT_EQ(loadMaterial(path + "#0").report.warnings.size(), 0U);
  EXPECT_NE(errorOf([&] { loadMaterial(path + "#2"); }).find("0 (dull), 1 (bright)"), std::string::npos);
}

TEST(LoadMaterial, AContainerIsRecognisedByContentNotName) {
  const fs::path path = twoMaterials("renamed");
  fs::rename(path, path.parent_path() / "two.binary");
  EXPECT_EQ(loadMaterial((path.parent_path() / "two.binary").string()).kind, "container");
}

TEST(LoadMaterial, AnExistingFileWinsOverAnExpression) {
  const fs::path folder = freshFolder("wins");
  fs::rename(twoMaterials("wins2"), folder / "Lambertian");
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  const brdf::LoadedMaterial loaded = loadMaterial("Lambertian");
  fs::create_directory("GGX");  // a folder does not
  const brdf::LoadedMaterial expression = loadMaterial("GGX");
  fs::current_path(before);
  EXPECT_EQ(loaded.kind, "container");
  EXPECT_EQ(expression.kind, "expression");
}

TEST(LoadMaterial, AMissingFileIsNoFormulaError) {
  for (const char* spec : {"missing.brdf", "folder/missing", "a.vtkhdf#2", "my gold (2).binary", "/no/such/file.exr"})
    EXPECT_NE(errorOf([&] { loadMaterial(spec); }).find("no such file"), std::string::npos) << spec;
  EXPECT_NE(errorOf([&] { loadMaterial(freshFolder("afolder").string()); }).find("a folder"), std::string::npos);
}

TEST(LoadMaterial, AWrongExpressionIsNoFileError) {
  for (const char* spec : {"0.5*Lamberian", "0.5*GGX(alpha=0.2", "1.e5", "GGX(alpha=0.)"})
    EXPECT_EQ(errorOf([&] { loadMaterial(spec); }).find("no such file"), std::string::npos) << spec;
  EXPECT_NE(errorOf([] { loadMaterial("0.5*Lamberian"); }).find("Lambertian"), std::string::npos);
}

TEST(LoadMaterial, NothingIsAUsageError) {
  try {
    loadMaterial("  ");
    FAIL();
  } catch (const brdf::Error& error) {
    EXPECT_EQ(error.kind(), brdf::Error::Kind::Usage);
  }
}

TEST(LoadMaterial, AMeasuredFileHoldsOneBrdf) {
  const fs::path path = freshFolder("measured") / "a.csv";
  brdf::writeFile(path, "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z,value_0\n0,0,1,0,0,1,0.25\n");
  EXPECT_EQ(loadMaterial(path.string()).kind, "measured");
  EXPECT_EQ(loadMaterial(path.string() + "#0").kind, "measured");
  EXPECT_NE(errorOf([&] { loadMaterial(path.string() + "#1"); }).find("holds one BRDF"), std::string::npos);
}

TEST(LoadMaterial, AnEmptyContainerIsAnError) {
  const fs::path path = freshFolder("none") / "a.vtkhdf";
  brdf::ContainerWriter(path).commit();
  EXPECT_NE(errorOf([&] { loadMaterial(path.string()); }).find("empty"), std::string::npos);
}
