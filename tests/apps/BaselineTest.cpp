#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/io/ImageFile.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

namespace fs = std::filesystem;

#ifdef BRDF_HAS_PICTURES

/// The only picture's state in the report of a run, and the run's exit code.
struct State {
  std::string state;
  int exitCode;
};
State stateOf(const fs::path& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "baseline");
  arguments.insert(arguments.end(), {"--json", "-"});
  const Outcome run = runBrdf(folder, arguments);
  const auto report = nlohmann::json::parse(run.out, nullptr, false);
  if (report.is_discarded()) return {run.err, run.exitCode};
  return {report["pictures"].at(0)["state"].get<std::string>(), run.exitCode};
}

/// Writes a suite of one picture.
void writeSuite(const fs::path& folder, const std::string& file, const std::string& command,
                const std::string& tolerance = "") {
  brdf::writeFile(folder / "suite.json",
                  "{\"pictures\": [{\"file\": \"" + file + "\", \"command\": " + command + tolerance + "}]}");
}

std::string lobe(const std::string& thetaI, const std::string& more = "") {
  return "[\"lobe\", \"0.3*Lambertian + 0.05*GGX(alpha=0.3)\", \"--theta-i\", \"" + thetaI +
         "\", \"--size\", \"450x350\"" + more + "]";
}
std::string sphere(const std::string& scale) {
  return R"(["render", ")" + scale + R"(*Lambertian", "--light", "directional:45,0", "--size", "48x48"])";
}

TEST(Baseline, MadeOnceThePictureIsTheSame) {
  const fs::path folder = scratchFolder();
  writeSuite(folder, "lobe.png", lobe("45"));
  EXPECT_EQ(stateOf(folder, {"suite.json"}).state, "no baseline");
  EXPECT_EQ(stateOf(folder, {"suite.json"}).exitCode, 1);
  EXPECT_EQ(filesIn(folder), std::vector<std::string>{"suite.json"});
  const State made = stateOf(folder, {"suite.json", "--update"});
  EXPECT_EQ(made.state, "updated");
  EXPECT_EQ(made.exitCode, 0);
  const State same = stateOf(folder, {"suite.json"});
  EXPECT_EQ(same.state, "same");
  EXPECT_EQ(same.exitCode, 0);
  const auto before = fs::last_write_time(folder / "lobe.png");
  EXPECT_EQ(stateOf(folder, {"suite.json", "--update"}).state, "same");
  EXPECT_EQ(fs::last_write_time(folder / "lobe.png"), before) << "a baseline that holds is left alone";
}

TEST(Baseline, SeesAChangedDigitInATitle) {
  const fs::path folder = scratchFolder();
  writeSuite(folder, "lobe.png", lobe("45"));
  EXPECT_EQ(stateOf(folder, {"suite.json", "--update"}).state, "updated");
  writeSuite(folder, "lobe.png", lobe("46"));
  EXPECT_EQ(stateOf(folder, {"suite.json", "--results", "found"}).state, "differs");
  EXPECT_EQ(filesIn(folder / "found"), (std::vector<std::string>{"lobe.difference.png", "lobe.png"}));
}

TEST(Baseline, SeesAChannelThatChangesColourAlone) {
  const fs::path folder = scratchFolder();
  writeSuite(folder, "lobe.png", lobe("45"));
  EXPECT_EQ(stateOf(folder, {"suite.json", "--update"}).state, "updated");
  writeSuite(folder, "lobe.png", lobe("45", R"(, "--channel", "rgb")"));
  EXPECT_EQ(stateOf(folder, {"suite.json"}).state, "differs");
}

TEST(Baseline, RadianceMayDifferByItsToleranceAndNoMore) {
  const fs::path folder = scratchFolder();
  const std::string tolerance = R"(, "relative": 0.02, "absolute": 1e-6)";
  writeSuite(folder, "sphere.exr", sphere("0.5"), tolerance);
  EXPECT_EQ(stateOf(folder, {"suite.json", "--update"}).state, "updated");
  writeSuite(folder, "sphere.exr", sphere("0.5095"), tolerance);
  EXPECT_EQ(stateOf(folder, {"suite.json"}).state, "same") << "1.9 % off";
  writeSuite(folder, "sphere.exr", sphere("0.5105"), tolerance);
  EXPECT_EQ(stateOf(folder, {"suite.json"}).state, "differs") << "2.1 % off";
  writeSuite(folder, "sphere.exr", sphere("0.5105"), tolerance + R"(, "outliers": 1)");
  EXPECT_EQ(stateOf(folder, {"suite.json"}).state, "same") << "every pixel may be an outlier";
}

TEST(Baseline, PicturesOfAnotherSizeDiffer) {
  const fs::path folder = scratchFolder();
  writeSuite(folder, "sphere.exr", sphere("0.5"));
  brdf::writeExr(brdf::Image(48, 47, 3), folder / "sphere.exr");
  EXPECT_EQ(stateOf(folder, {"suite.json"}).state, "differs");
}

TEST(Baseline, SaysWhyACommandFailed) {
  const fs::path folder = scratchFolder();
  writeSuite(folder, "lobe.png", R"(["lobe", "Nonsense"])");
  const Outcome run = runBrdf(folder, {"baseline", "suite.json"});
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_NE(run.out.find("lobe.png: failed"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("Nonsense"), std::string::npos) << run.out;
}

TEST(Baseline, FilesOfACommandAreBesideTheSuite) {
  const fs::path folder = scratchFolder(), other = folder / "other";
  fs::create_directories(other);
  writeSpectralFiles(other);
  writeSuite(other, "lobe.png", R"(["lobe", "spectral.xml", "--size", "200x200"])");
  EXPECT_EQ(stateOf(folder, {"other/suite.json", "--update"}).state, "updated");
  EXPECT_TRUE(fs::exists(other / "lobe.png"));
}

TEST(Baseline, OnlyDrawsThePicturesAskedFor) {
  const fs::path folder = scratchFolder();
  brdf::writeFile(folder / "suite.json", R"({"pictures": [{"file": "a.exr", "command": )" + sphere("0.1") +
                                             R"(}, {"file": "b.exr", "command": )" + sphere("0.2") + "}]}");
  EXPECT_EQ(runBrdf(folder, {"baseline", "suite.json", "--update", "--only", "b.exr"}).exitCode, 0);
  EXPECT_EQ(filesIn(folder), (std::vector<std::string>{"b.exr", "suite.json"}));
  const Outcome run = runBrdf(folder, {"baseline", "suite.json", "--only", "c.exr"});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_NE(run.err.find("a.exr, b.exr"), std::string::npos) << run.err;
}

#endif

struct WrongSuite {
  std::string name, text, named;
};

class BaselineSuite : public ::testing::TestWithParam<WrongSuite> {};

TEST_P(BaselineSuite, IsRefusedInOneLine) {
  const fs::path folder = scratchFolder();
  brdf::writeFile(folder / "suite.json", GetParam().text);
  const Outcome run = runBrdf(folder, {"baseline", "suite.json"});
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_NE(run.err.find("suite.json"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find(GetParam().named), std::string::npos) << run.err;
}

INSTANTIATE_TEST_SUITE_P(
    Wrong, BaselineSuite,
    ::testing::Values(
        WrongSuite{"NoJson", "{", "suite.json"}, WrongSuite{"NoPictures", "{}", "pictures"},
        WrongSuite{"AnUnknownKey", R"({"pictures": [{"file": "a.png", "command": ["lobe"], "tolerence": 1}]})",
                   "tolerence"},
        WrongSuite{"AFolder", R"({"pictures": [{"file": "../a.png", "command": ["lobe"]}]})", "../a.png"},
        WrongSuite{"AnotherKind", R"({"pictures": [{"file": "a.svg", "command": ["lobe"]}]})", "a.svg"},
        WrongSuite{"AnOutput", R"({"pictures": [{"file": "a.png", "command": ["lobe", "--out", "b.png"]}]})", "--out"},
        WrongSuite{"ATolerance", R"({"pictures": [{"file": "a.exr", "command": ["lobe"], "relative": -1}]})",
                   "relative"},
        WrongSuite{"OneNameTwice",
                   R"({"pictures": [{"file": "a.png", "command": ["lobe"]}, {"file": "a.png", "command": ["lobe"]}]})",
                   "two pictures"}),
    [](const auto& suite) { return suite.param.name; });

}  // namespace
