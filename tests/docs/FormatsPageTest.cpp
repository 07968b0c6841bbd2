// docs/formats.md against the registry: a row for every format, none for others.
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/measured/Format.h>
#include <brdf/measured/ReadOptions.h>

#include <gtest/gtest.h>

#include "Page.h"

namespace {

std::string rowOf(const brdf::Format& format) {
  std::vector<std::string> options;
  for (const std::string& key : format.takes) options.push_back("`" + key + "`");
  return "| `" + format.name + "` | " + format.title + " | " +
         (format.extension.empty() ? "-" : "`" + format.extension + "`") + " | " +
         (!format.read                           ? "write"
          : format.write || format.writeMaterial ? "read, write"
                                                 : "read") +
         " | " + (options.empty() ? "-" : brdf::joined(options)) + " |";
}

TEST(FormatsPage, HasARowForEveryFormatAndNoOther) {
  const std::string page = brdf::readFile(brdf::docs() / "formats.md");
  std::size_t rows = 0;
  for (std::size_t at = page.find("\n| `"); at != page.npos; at = page.find("\n| `", at + 1)) ++rows;
  for (const brdf::Format& format : brdf::allFormats())
    EXPECT_NE(page.find(rowOf(format)), page.npos) << "missing in docs/formats.md:\n" << rowOf(format);
  EXPECT_EQ(rows, brdf::allFormats().size() + brdf::readOptionKeys().size());
}

TEST(FormatsPage, ListsEverySettingOfAWriter) {
  const std::string page = brdf::readFile(brdf::docs() / "formats.md");
  for (const brdf::Format& format : brdf::allFormats())
    for (const brdf::WriteSetting& setting : format.settings) {
      const std::string row = "- `" + format.name + ":" + setting.key + "=`" + setting.values + ": " + setting.meaning;
      EXPECT_NE(page.find(row), page.npos) << "missing in docs/formats.md:\n" << row;
    }
}

TEST(FormatsPage, ListsEveryReadOptionWithItsValues) {
  const std::string page = brdf::readFile(brdf::docs() / "formats.md");
  for (const brdf::ReadOptionKey& key : brdf::readOptionKeys()) {
    std::vector<std::string> values;
    for (const std::string& value : key.values) values.push_back("`" + value + "`");
    const std::string row = "| `" + key.key + "` | " + brdf::joined(values) + " | " + key.meaning + " |";
    EXPECT_NE(page.find(row), page.npos) << "missing in docs/formats.md:\n" << row;
  }
}

}  // namespace
