#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>

#include <gtest/gtest.h>

#include <numbers>

namespace {

constexpr const char* kLobe = R"(<model name="HalfPower" title="A power of the half angle's cosine">
  <parameter name="n" default="20" min="0" max="1000">Sharpness.</parameter>
  <equation>(n + 8) / (8 * pi) * hz^n</equation>
  <sampler name="HalfCosinePower" arguments="n, n"/>
</model>)";

/// The number in the last column of the last line.
double lastValue(const std::string& text) {
  const std::string_view line = brdf::trimmed(text);
  return *brdf::parseNumber(line.substr(line.find_last_of(" \n") + 1));
}

}  // namespace

TEST(ModelPath, AFileDroppedInAFolderIsALobeLikeAnyOther) {
  const auto folder = scratchFolder();
  std::filesystem::create_directory(folder / "lobes");
  brdf::writeFile(folder / "lobes" / "mine.xml", kLobe);
  // In the mirror direction the half vector is the normal: (10 + 8)/(8 pi), whatever the angle.
  const Outcome outcome = runBrdf(folder, {"eval", "HalfPower(n=10)", "--at", "30,0,30,180", "--model-path", "lobes"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_NEAR(lastValue(outcome.out), 18 / (8 * std::numbers::pi), 1e-15);
}

TEST(ModelPath, TheUsersOwnFolderIsSearchedUnasked) {
  const auto folder = scratchFolder();
  std::filesystem::create_directories(folder / "brdflab" / "models");
  brdf::writeFile(folder / "brdflab" / "models" / "mine.xml", kLobe);
  const std::vector<std::pair<std::string, std::string>> home = {{"XDG_DATA_HOME", folder.string()}};
  EXPECT_EQ(runBrdf(folder, {"models", "HalfPower", "--quiet"}, home).exitCode, 0);
  brdf::writeFile(folder / "brdflab" / "models" / "mine.xml", "<model>");
  const Outcome outcome = runBrdf(folder, {"models", "GGX", "--quiet"}, home);
  EXPECT_EQ(outcome.exitCode, 0) << "a bad file of the user's own must not stop the program";
  EXPECT_NE(outcome.err.find("mine.xml"), std::string::npos) << outcome.err;
}

TEST(ModelPath, AMissingFolderOrABadFormulaIsOneLineOfError) {
  const auto folder = scratchFolder();
  Outcome outcome = runBrdf(folder, {"models", "--model-path", "nowhere"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.err.find("nowhere"), std::string::npos) << outcome.err;
  std::filesystem::create_directory(folder / "lobes");
  brdf::writeFile(folder / "lobes" / "bad.xml",
                  R"(<model name="Bad" title="Bad"><equation>1 +
  expp(uz)</equation></model>)");
  outcome = runBrdf(folder, {"models", "--model-path", "lobes"});
  EXPECT_EQ(outcome.exitCode, 1);
  for (const char* part : {"bad.xml", "line 2, column 3", "'expp'", "did you mean 'exp'"})
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
}
