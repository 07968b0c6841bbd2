// examples/external/v_groove.py through the program, as docs/external-programs.md shows it.
#include "Program.h"

#include <brdf/base/File.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <numbers>
#include <thread>

namespace {

#ifdef BRDF_PYTHON
constexpr double kPi = std::numbers::pi;

std::string grooves(const std::string& settings, const std::string& options = "") {
  return "program:" + options + " '" BRDF_PYTHON "' '" BRDF_SOURCE_DIR "/examples/external/v_groove.py' " + settings;
}

double valueAt(const std::filesystem::path& folder, const std::string& material, const std::string& angles) {
  return reportOf(folder, {"eval", material, "--at", angles}).at("values").at(0).at("value").at(0).get<double>();
}
#endif

}  // namespace

#ifdef BRDF_PYTHON

TEST(ExternalProgram, GroovesWithoutDepthAreLambertian) {
  EXPECT_NEAR(valueAt(scratchFolder(), grooves("--walls 0 --albedo 0.7"), "60,20,35,230"), 0.7 / kPi, 1e-12);
}

TEST(ExternalProgram, TheSecondBounceHasHottelsFormFactor) {
  // Seen and lit along the normal, every point of the walls is lit and seen under the wall's angle w. The share of the
  // light that leaves one wall of a long V and meets the other is 1 - sin(half the opening) (H. C. Hottel's crossed
  // strings), whatever comes after the second bounce is between 0 and a^3 F / (1 - a F_max), F_max < 0.5 here.
  const double angle = 40 * kPi / 180, albedo = 0.1, F = 1 - std::cos(angle);
  const double two = albedo + albedo * albedo * F, rest = albedo * albedo * albedo * F / (1 - 0.5 * albedo);
  const double value =
      valueAt(scratchFolder(), grooves("--walls 40 --albedo 0.1 --rays 100000"), "0,0,0,0") * kPi / std::cos(angle);
  const double noise = 4 * albedo * albedo * std::sqrt(F * (1 - F) / 100000);
  EXPECT_GT(value, two - noise);
  EXPECT_LT(value, two + rest + noise);
}

TEST(ExternalProgram, ItIsDrawnTabulatedAndFittedLikeAnyMaterial) {
  const auto folder = scratchFolder();
  const std::string material = grooves("--rays 20", "--stay --channels mono");
#ifdef BRDF_HAS_PICTURES
  const Outcome lobe = runBrdf(folder, {"lobe", material, "--out", "lobe.png", "--size", "200x150", "--quiet"});
  EXPECT_EQ(lobe.exitCode, 0) << lobe.err;
#endif
  const Outcome converted = runBrdf(folder, {"convert", material, "table.vtkhdf", "--grid", "spherical:30", "--quiet"});
  ASSERT_EQ(converted.exitCode, 0) << converted.err;
  // A cell of the table, from its centre.
  const double exact = valueAt(folder, grooves("--rays 20"), "45,15,15,210");
  EXPECT_NEAR(valueAt(folder, "table.vtkhdf", "45,15,15,210"), exact, 1e-9 * exact);
  const auto fit = reportOf(folder, {"fit", "table.vtkhdf", "--lobes", "Lambertian"});
  EXPECT_GT(fit.at("parameters").at(0).at("value").get<double>(), 0.5);
  EXPECT_LT(fit.at("parameters").at(0).at("value").get<double>(), 0.8);
}

TEST(ExternalProgram, ItsErrorsAreOneLineAndNothingIsWritten) {
  const auto folder = scratchFolder();
  const Outcome run = runBrdf(folder, {"lobe", grooves("--albedo 7"), "--out", "lobe.vtp"});
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_NE(run.err.find("--albedo 0 to 1"), std::string::npos) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_TRUE(filesIn(folder).empty());
}

#endif

TEST(ExternalProgram, AnInterruptEndsTheProgramToo) {
  for (const std::string signal : {"INT", "KILL"}) {
    const auto folder = scratchFolder();
    brdf::writeFile(folder / "slow.sh", "echo $$ > child.tmp; mv child.tmp child; exec sleep 100\n");
    runLine(folder, "{ '" BRDF_PROGRAM
                    "' eval 'program:sh slow.sh' --at 0,0,0,0 & p=$!; until [ -e child ]; do sleep 0.05; done;"
                    " kill -" +
                        signal + " $p; wait $p; true; }");
    const int child = std::stoi(brdf::readFile(folder / "child"));
    bool gone = false;
    for (int i = 0; i < 100 && !gone; ++i) {
      gone = kill(child, 0) != 0;
      if (!gone) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    EXPECT_TRUE(gone) << signal;
  }
}
