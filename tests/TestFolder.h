#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

/// A fresh folder for the files of the running test. Tests run side by side: each has its own.
inline std::filesystem::path testFolder(const std::string& name) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string own = std::string(test->test_suite_name()) + "." + test->name();
  std::replace(own.begin(), own.end(), '/', '-');
  const auto path = std::filesystem::path(BRDF_TEST_DIR) / own / name;
  std::filesystem::remove_all(path);
  std::filesystem::create_directories(path);
  return path;
}
