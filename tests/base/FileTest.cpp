#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <gtest/gtest.h>

#include <fstream>

#include "../TestFolder.h"

namespace fs = std::filesystem;

namespace {

fs::path freshFolder(const char* name) { return testFolder(name); }

}  // namespace

TEST(File, WhatIsWrittenReadsBackByteForByte) {
  const fs::path path = freshFolder("roundtrip") / "a.bin";
  const std::string bytes("\0\r\n\xff x", 6);
  brdf::writeFile(path, bytes);
  EXPECT_EQ(brdf::readFile(path), bytes);
  EXPECT_EQ(brdf::readFileHead(path, 3), bytes.substr(0, 3));
}

TEST(File, ATargetStaysAsItWasUntilCommit) {
  const fs::path folder = freshFolder("atomic");
  brdf::writeFile(folder / "a.txt", "old");
  {
    brdf::AtomicFile file(folder / "a.txt");
    std::ofstream(file.temporaryPath()) << "half";
  }
  EXPECT_EQ(brdf::readFile(folder / "a.txt"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "the temporary file was left behind";
}

TEST(File, AProcessThatEndsEarlyCanRemoveItsTemporaryFiles) {
  const fs::path folder = freshFolder("early");
  const brdf::AtomicFile file(folder / "a.txt");
  EXPECT_TRUE(fs::exists(file.temporaryPath()));
  brdf::removeTemporaryFiles();
  EXPECT_FALSE(fs::exists(file.temporaryPath()));
}

TEST(File, ErrorsNameTheFile) {
  EXPECT_THROW(brdf::readFile("/no/such/file"), brdf::Error);
  EXPECT_THROW(brdf::readFile("/"), brdf::Error);
  EXPECT_THROW(brdf::writeFile("/no/such/folder/x", "a"), brdf::Error);
  const fs::path path = freshFolder("large") / "big";
  brdf::writeFile(path, std::string(100, 'x'));
  EXPECT_THROW(brdf::readFile(path, 99), brdf::Error);
}

TEST(File, DevicesAreNeverReplaced) { EXPECT_THROW(brdf::AtomicFile("/dev/null"), brdf::Error); }
