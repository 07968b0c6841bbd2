#include "Program.h"

#include <brdf/base/Text.h>

#include <gtest/gtest.h>

namespace {

const std::vector<std::string> kCommands = {"models", "info",    "eval",     "convert", "export",   "fit",
                                            "batch",  "compare", "check",    "lobe",    "slice",    "error",
                                            "render", "surface", "simulate", "waves",   "baseline", "plugins"};

[[maybe_unused]] bool draws(const std::string& command) {
  return command == "lobe" || command == "slice" || command == "error" || command == "render" || command == "surface" ||
         command == "baseline";
}

class Command : public ::testing::TestWithParam<std::string> {};
class QuietCommand : public ::testing::TestWithParam<std::string> {};

std::string commandName(const ::testing::TestParamInfo<std::string>& info) { return info.param; }

}  // namespace

TEST(Help, TheOverviewNamesEveryCommandAndSoDoesTheErrorForNone) {
  const auto folder = scratchFolder();
  const Outcome help = runBrdf(folder, {"--help"}), none = runBrdf(folder, {});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_EQ(none.exitCode, 2);
  for (const std::string& command : kCommands) {
    EXPECT_NE(help.out.find("  " + command + " "), std::string::npos) << command;
    EXPECT_NE(none.err.find(command), std::string::npos) << command;
  }
}

TEST(Help, AMisspeltCommandIsAnsweredWithTheNearest) {
  const Outcome run = runBrdf(scratchFolder(), {"rendre"});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_NE(run.err.find("nearest: render"), std::string::npos) << run.err;
}

TEST_P(Command, HelpDocumentsTheCommonOptions) {
  const Outcome run = runBrdf(scratchFolder(), {GetParam(), "--help"});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_EQ(run.err, "");
  for (const char* text : {"--help", "--json", "--quiet", "--assume", "Example:"})
    EXPECT_NE(run.out.find(text), std::string::npos) << text;
}

TEST_P(Command, TheExampleThatHelpEndsWithRuns) {
#ifndef BRDF_HAS_PICTURES
  if (draws(GetParam())) GTEST_SKIP() << "this build has no VTK, so nothing draws";
#endif
  const auto folder = scratchFolder();
  writeSpectralFiles(folder);  // spectral.csv and spectral.xml, a user's data
  const std::string help = runBrdf(folder, {GetParam(), "--help"}).out;
  const std::size_t start = help.find("Example:\n");
  ASSERT_NE(start, std::string::npos);
  std::size_t count = 0;
  for (const auto line : brdf::split(std::string_view(help).substr(start + 9), '\n')) {
    if (line.empty()) continue;
    ASSERT_TRUE(line.starts_with("brdf ")) << "help goes on after the example: " << line;
    const Outcome run = runLine(folder, std::string(line));
    EXPECT_EQ(run.exitCode, 0) << line << "\n" << run.err;
    EXPECT_EQ(run.err, "") << line;
    EXPECT_NE(run.out, "") << line;
    ++count;
  }
  EXPECT_GE(count, 1u);
}

TEST_P(QuietCommand, PrintsNothing) {
  const auto folder = scratchFolder();
  writeSpectralFiles(folder);
  const std::string help = runBrdf(folder, {GetParam(), "--help"}).out;
  for (const auto line : brdf::split(std::string_view(help).substr(help.find("Example:\n") + 9), '\n')) {
    if (line.empty()) continue;
    const Outcome run = runLine(folder, std::string(line) + " --quiet");
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err, "");
  }
}

INSTANTIATE_TEST_SUITE_P(Help, Command, ::testing::ValuesIn(kCommands), commandName);
INSTANTIATE_TEST_SUITE_P(Help, QuietCommand,
                         ::testing::Values("models", "info", "eval", "convert", "fit", "batch", "compare", "check",
                                           "simulate"),
                         commandName);
