// `brdf models`: its pages, and the command lines that the documentation shows.
#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>

#include <gtest/gtest.h>

#include <cmath>

namespace fs = std::filesystem;

namespace {

const fs::path kDocs = fs::path(BRDF_SOURCE_DIR) / "docs";

/// The lines of a page that call the program.
std::vector<std::string> commandLines(const fs::path& page) {
  const std::string text = brdf::readFile(page);
  std::vector<std::string> lines;
  for (const auto line : brdf::split(text, '\n'))
    if (line.starts_with("brdf ")) lines.emplace_back(line.substr(0, line.find('#')));
  return lines;
}

}  // namespace

TEST(Models, PrintsAPageAsTextAndAsMarkdown) {
  const Outcome text = runBrdf(scratchFolder(), {"models", "Ward"});
  ASSERT_EQ(text.exitCode, 0) << text.err;
  for (const char* part : {"α_x", "10.1145/133994.134078", "light at 60 degrees"})
    EXPECT_NE(text.out.find(part), std::string::npos) << text.out;
  const Outcome markdown = runBrdf(scratchFolder(), {"models", "Ward", "--markdown"});
  ASSERT_EQ(markdown.exitCode, 0) << markdown.err;
  EXPECT_TRUE(markdown.out.starts_with("# Ward\n")) << markdown.out;
}

TEST(Models, PageAsJsonGivesTheAlbedo) {
  const auto page = reportOf(scratchFolder(), {"models", "Lambertian"});
  ASSERT_EQ(page[0]["albedo"].size(), 2u);
  for (const auto& albedo : page[0]["albedo"])
    EXPECT_LE(std::fabs(albedo["value"].get<double>() - 1), albedo["bound"].get<double>());
}

TEST(Models, WritesTheReferenceIntoAFolderThatIsThere) {
  const auto folder = scratchFolder();
  EXPECT_EQ(runBrdf(folder, {"models", "--markdown", "."}).exitCode, 0);
  EXPECT_TRUE(fs::exists(folder / "models.md"));
  EXPECT_TRUE(fs::exists(folder / "models" / "GGX.md"));
}

TEST(Models, AsksForOneLobeOrOneFolder) {
  const auto folder = scratchFolder();
  EXPECT_EQ(runBrdf(folder, {"models", "--markdown"}).exitCode, 2);
  EXPECT_EQ(runBrdf(folder, {"models", "GGX", "--markdown", "."}).exitCode, 2);
  const Outcome outcome = runBrdf(folder, {"models", "--markdown", "GGX"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.err.find("NAME --markdown"), std::string::npos) << outcome.err;
  EXPECT_TRUE(filesIn(folder).empty());
}

TEST(Documentation, ItsCommandLinesRun) {
  const auto folder = scratchFolder();
  fs::create_directory_symlink(kDocs, folder / "docs");
  fs::copy_file(kDocs / "examples/lobes/SatinPaint.xml", folder / "mine.xml");
  for (const char* page : {"own-lobes.md", "checks.md", "models/terms.md"}) {
    const auto lines = commandLines(kDocs / page);
    EXPECT_GE(lines.size(), 1u) << page;
    for (const std::string& line : lines) {
      if (line.find("--all") != std::string::npos) continue;  // the whole library takes minutes
      const Outcome outcome = runLine(folder, line);
      EXPECT_EQ(outcome.exitCode, 0) << line << "\n" << outcome.out << outcome.err;
    }
  }
}
