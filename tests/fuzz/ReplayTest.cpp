// The corpus of the fuzzers and the hand-written files, given to every reader: each answers or refuses, none crashes.
#include <brdf/base/File.h>
#include <brdf/io/Container.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "ContainerEdits.h"
#include "Targets.h"

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> filesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::exists(folder))
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) files.push_back(entry.path());
  return files;
}

}  // namespace

TEST(Replay, EveryTargetStandsItsCorpusAndEveryHandWrittenFile) {
  const fs::path tests = fs::path(BRDF_SOURCE_DIR) / "tests";
  const auto seeds = filesBelow(tests / "data");
  EXPECT_GE(seeds.size(), 10u);
  for (const FuzzTarget& target : fuzzTargets()) {
    auto files = filesBelow(tests / "fuzz/corpus" / target.name);
    files.insert(files.end(), seeds.begin(), seeds.end());
    for (const fs::path& file : files)
      EXPECT_NO_THROW(target.run(brdf::readFile(file))) << target.name << " on " << file;
  }
}

TEST(Replay, ContainersWithoutChecksumsAreReadAndStandDamage) {
  const auto targets = fuzzTargets();
  const auto target = std::find_if(targets.begin(), targets.end(), [](const auto& t) { return t.name == "container"; });
  ASSERT_NE(target, targets.end());
  for (std::size_t i = 0; i < containerCount(); ++i) {
    const std::string bytes = withoutChecksums(containerBytes(i));
    EXPECT_NO_THROW(brdf::Container::fromBytes(bytes, "old").load(0)) << i;
    for (std::size_t at = 0; at < bytes.size(); at += 61) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
      EXPECT_NO_THROW(target->run(damaged)) << i << ", byte " << at;
    }
  }
}

TEST(Replay, EveryFolderOfTheCorpusHasATarget) {
  std::set<std::string> names;
  for (const FuzzTarget& target : fuzzTargets()) names.insert(target.name);
  const fs::path corpus = fs::path(BRDF_SOURCE_DIR) / "tests/fuzz/corpus";
  ASSERT_TRUE(fs::is_directory(corpus));
  for (const auto& entry : fs::directory_iterator(corpus))
    EXPECT_TRUE(names.contains(entry.path().filename().string())) << entry.path();
}
