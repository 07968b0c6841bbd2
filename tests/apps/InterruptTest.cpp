#include "Program.h"

#include <gtest/gtest.h>

namespace {

/// Runs a fit without an end; after its first word of progress, runs `signals` on process $p.
Outcome interruptedFit(const std::filesystem::path& folder, const std::string& signals) {
  return runLine(folder, "{ '" BRDF_PROGRAM
                         "' fit a.binary --starts 100000 --out fit.vtkhdf --json fit.json > out & p=$!;"
                         " until grep -q iteration out; do sleep 0.1; done; " +
                             signals + "; wait $p; }");
}

}  // namespace

TEST(Interrupt, AFitStopsAndKeepsTheBestSoFar) {
  const auto folder = scratchFolder();
  ASSERT_EQ(runBrdf(folder, {"convert", "0.3*Lambertian + 0.05*GGX(alpha=0.25, ior=1.5)", "a.binary"}).exitCode, 0);
  // Twice, as `timeout -s INT` does: the program, then its group
  const Outcome outcome = interruptedFit(folder, "kill -INT $p; sleep 0.02; kill -INT $p || true");
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
  EXPECT_EQ(filesIn(folder), (std::vector<std::string>{"a.binary", "fit.json", "fit.vtkhdf", "out"}));
  EXPECT_EQ(runBrdf(folder, {"info", "fit.vtkhdf"}).exitCode, 0);
}

TEST(Interrupt, ACommandThatCannotStopHalfwayEndsAndLeavesNothing) {
  const auto folder = scratchFolder();
  // 130: the signal came before the program had begun; then later.
  const Outcome outcome = runLine(
      folder,
      "{ for s in 0.05 0.1 0.2 0.4 0.8 1.6 3.2; do timeout --preserve-status -s INT $s '" BRDF_PROGRAM
      "' convert 'SGD + GGX + GGX(alpha=0.1)' a.binary && c=0 || c=$?; [ $c = 130 ] || break; done; (exit $c); }");
  if (outcome.exitCode == 0) GTEST_SKIP() << "the machine finishes as soon as it has begun";
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(outcome.err, "brdf: interrupted\n");
  EXPECT_TRUE(filesIn(folder).empty());
}

TEST(Interrupt, ATurntableKeepsItsFinishedFrames) {
  const auto folder = scratchFolder();
  const Outcome outcome =
      runLine(folder, "{ '" BRDF_PROGRAM
                      "' render Lambertian --light directional:0,0 --reference --samples 16 --size 32x32 --turntable "
                      "10000 --out f_%04d.exr > out & p=$!; until [ -e f_0001.exr ]; do sleep 0.1; done; kill -INT $p; "
                      "wait $p; }");
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.err.find("finished frames were kept"), std::string::npos) << outcome.err;
  const auto files = filesIn(folder);
  EXPECT_GE(files.size(), 3u);
  EXPECT_LT(files.size(), 10000u);
  for (const std::string& file : files) EXPECT_TRUE(file == "out" || file.ends_with(".exr")) << file;
}
