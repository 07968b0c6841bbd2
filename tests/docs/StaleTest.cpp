// The committed reference is what the models' records give today, on every instruction set.
#include <brdf/base/File.h>
#include <brdf/formula/Program.h>
#include <brdf/reference/ModelPage.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "Page.h"

namespace brdf {
namespace {

constexpr char kUpdate[] = ": the model reference is stale; update it with scripts/update-docs.sh";

TEST(ModelReference, IsWhatTheRecordsGiveAndHasNoOtherPage) {
  const auto reference = modelReference();
  for (const auto& [path, text] : reference) {
    ASSERT_TRUE(std::filesystem::exists(docs() / path)) << "docs/" << path << kUpdate;
    ASSERT_TRUE(readFile(docs() / path) == text) << "docs/" << path << kUpdate;
  }
  for (const auto& entry : std::filesystem::directory_iterator(docs() / "models")) {
    const std::string path = "models/" + entry.path().filename().string();
    EXPECT_TRUE(reference.contains(path)) << "docs/" << path << kUpdate;
  }
}

TEST(ModelReference, IsTheSameOnEveryInstructionSet) {
  const auto best = formula::instructionSet();
  for (const std::string_view set : formula::instructionSets()) {
    formula::setInstructionSet(set);
    for (const char* name : {"GGX", "SGD", "Disney", "Ward", "StudentT", "LowSmooth"}) {
      const std::string page = readFile(docs() / "models" / (std::string(name) + ".md"));
      EXPECT_NE(page.find(modelPageMarkdown(findModel(name))), std::string::npos) << set << " " << name << kUpdate;
    }
  }
  formula::setInstructionSet(best);
}

TEST(ModelReference, LinksLeadSomewhere) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(docs())) {
    if (entry.path().extension() != ".md") continue;
    const std::string page = readFile(entry.path());
    for (std::size_t at = page.find("]("); at != std::string::npos; at = page.find("](", at + 1)) {
      const std::string target = page.substr(at + 2, page.find_first_of(")#", at + 2) - at - 2);
      if (target.empty() || target.starts_with("http")) continue;
      EXPECT_TRUE(std::filesystem::exists(entry.path().parent_path() / target)) << entry.path() << " -> " << target;
    }
  }
}

}  // namespace
}  // namespace brdf
