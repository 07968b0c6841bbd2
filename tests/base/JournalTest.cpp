#include "../TestFolder.h"

#include <brdf/base/Base64.h>
#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Journal.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

using brdf::Journal;

namespace {

std::vector<std::string> recordsOf(const std::filesystem::path& path, std::size_t damagedExpected = 0) {
  std::vector<std::string> records;
  const std::size_t damaged = Journal::read(path, [&](std::string_view record) { records.emplace_back(record); });
  EXPECT_EQ(damaged, damagedExpected);
  return records;
}

}  // namespace

// The check value of CRC-32/ISO-HDLC in Cook's catalogue of parametrised CRC algorithms.
TEST(Journal, ChecksumIsTheStandardOne) { EXPECT_EQ(brdf::crc32("123456789"), 0xCBF43926u); }

TEST(Journal, RecordsComeBackInOrderAndAreAppendedAfterReopening) {
  const auto path = testFolder("j") / "journal";
  {
    auto journal = Journal::tryOpen(path);
    ASSERT_TRUE(journal);
    journal->append("one");
    journal->append("");
  }
  Journal::tryOpen(path)->append("three");
  EXPECT_EQ(recordsOf(path), (std::vector<std::string>{"one", "", "three"}));
}

TEST(Journal, CutAnywhereItKeepsAllWholeLinesAndGoesOn) {
  const auto folder = testFolder("j");
  Journal::tryOpen(folder / "full")->append("first record");
  const std::size_t first = brdf::readFile(folder / "full").size();
  Journal::tryOpen(folder / "full")->append("second record");
  const std::string full = brdf::readFile(folder / "full");
  for (std::size_t length = 0; length <= full.size(); ++length) {
    const auto path = folder / ("cut" + std::to_string(length));
    brdf::writeFile(path, full.substr(0, length));
    std::vector<std::string> expected;
    if (length >= first) expected.push_back("first record");
    if (length == full.size()) expected.push_back("second record");
    EXPECT_EQ(recordsOf(path, length != 0 && length != first && length != full.size()), expected);
    Journal::tryOpen(path)->append("next");
    expected.push_back("next");
    EXPECT_EQ(recordsOf(path), expected) << length;
  }
}

TEST(Journal, AChangedByteCostsOneRecordAndIsCounted) {
  const auto path = testFolder("j") / "journal";
  for (const char* record : {"one", "two", "three"}) Journal::tryOpen(path)->append(record);
  std::string bytes = brdf::readFile(path);
  bytes[bytes.find("two")] = 'T';
  brdf::writeFile(path, bytes);
  EXPECT_EQ(recordsOf(path, 1), (std::vector<std::string>{"one", "three"}));
  Journal::tryOpen(path)->append("four");  // damage before whole lines is left as it is
  EXPECT_EQ(recordsOf(path, 1), (std::vector<std::string>{"one", "three", "four"}));
}

TEST(Journal, HasOneWriterAtATime) {
  const auto path = testFolder("j") / "journal";
  {
    const auto writer = Journal::tryOpen(path);
    ASSERT_TRUE(writer);
    EXPECT_FALSE(Journal::tryOpen(path));
  }
  EXPECT_TRUE(Journal::tryOpen(path));
}

TEST(Journal, ARecordThatDoesNotFitTheDiskIsAnErrorAndLeavesTheJournalWhole) {
  const auto path = testFolder("j") / "journal";
  auto journal = Journal::tryOpen(path);
  journal->append("fits");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tight{1000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
  EXPECT_THROW(journal->append(std::string(5000, 'x')), brdf::Error);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, oldHandler);
  EXPECT_EQ(recordsOf(path), std::vector<std::string>{"fits"});
  journal->append("fits again");
  EXPECT_EQ(recordsOf(path), (std::vector<std::string>{"fits", "fits again"}));
}

TEST(Base64, GivesTheTestVectorsOfRfc4648) {
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) {
    EXPECT_EQ(brdf::toBase64(bytes), text);
    EXPECT_EQ(brdf::fromBase64(text), bytes);
  }
}

TEST(Base64, KeepsEveryByteAndRefusesWhatIsNone) {
  std::string all;
  for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
  EXPECT_EQ(brdf::fromBase64(brdf::toBase64(all)), all);
  for (const char* text : {"Z", "Zg", "Zg=", "Z===", "====", "Zm9v!A==", "Zh==", "Zg==Zg=="})
    EXPECT_FALSE(brdf::fromBase64(text)) << text;
}
