#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>

#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace {

const fs::path kSource = BRDF_SOURCE_DIR;

std::string readme() { return brdf::readFile(kSource / "README.md"); }

/// The README's lines that call the program, in order.
std::vector<std::string> commandLines() {
  const std::string text = readme();
  std::vector<std::string> lines;
  for (const auto line : brdf::split(text, '\n'))
    if (line.starts_with("brdf ")) lines.emplace_back(line);
  return lines;
}

[[maybe_unused]] bool draws(const std::string& line) {
  return line.starts_with("brdf lobe ") || line.starts_with("brdf error ") || line.starts_with("brdf render ");
}

}  // namespace

TEST(Readme, EveryCommandLineRuns) {
  const auto folder = scratchFolder();
  fs::create_directory_symlink(kSource / "datasets", folder / "datasets");
  const auto lines = commandLines();
  ASSERT_GE(lines.size(), 9u);
  for (const std::string& line : lines) {
#ifndef BRDF_HAS_PICTURES
    if (draws(line)) continue;
#endif
    const Outcome outcome = runLine(folder, line.substr(0, line.find('#')));
    EXPECT_EQ(outcome.exitCode, 0) << line << "\n" << outcome.err;
  }
}

TEST(Readme, ItsCodeIsTheExamplesThatAreBuiltAndRun) {
  for (const char* example : {"fit.cpp", "lobe.py"})
    EXPECT_NE(readme().find(brdf::readFile(kSource / "docs/examples" / example)), std::string::npos) << example;
}

TEST(Readme, TheCppExampleFits) {
  const auto folder = scratchFolder();
  ASSERT_EQ(runBrdf(folder, {"convert", "0.3*Lambertian + 0.05*GGX(alpha=0.25, ior=1.5)", "gold.binary"}).exitCode, 0);
  const Outcome outcome = runLine(folder, BRDF_EXAMPLE_FIT);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("*GGX(alpha=0.2"), std::string::npos) << outcome.out;
}

#ifdef BRDF_PYTHON_PATH
TEST(Readme, ThePythonExampleDraws) {
  const auto folder = scratchFolder();
  const Outcome outcome = runLine(folder, "env -u DISPLAY PYTHONPATH='" BRDF_PYTHON_PATH "' '" BRDF_PYTHON "' '" +
                                              (kSource / "docs/examples/lobe.py").string() + "'");
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(folder / "lobe.png"));
}
#endif
