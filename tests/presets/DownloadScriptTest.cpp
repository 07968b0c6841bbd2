#include <brdf/base/File.h>
#include <gtest/gtest.h>

#include <sys/wait.h>

#include "../TestFolder.h"

#include <cstdlib>

namespace {

struct Outcome {
  int status;
  std::string text;
};

/// Runs datasets/download.sh; nothing that these tests ask for reaches the network.
Outcome runScript(const std::string& arguments) {
  const auto out = testFolder("download") / "output.txt";
  const int status = std::system(
      ("bash " BRDF_SOURCE_DIR "/datasets/download.sh " + arguments + " > " + out.string() + " 2>&1").c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, brdf::readFile(out)};
}

}  // namespace

TEST(DownloadScript, IsValidBash) { EXPECT_EQ(std::system("bash -n " BRDF_SOURCE_DIR "/datasets/download.sh"), 0); }

TEST(DownloadScript, HelpAndListSaySomethingAndSucceed) {
  EXPECT_EQ(runScript("--help").status, 0);
  EXPECT_NE(runScript("--help").text.find("example:"), std::string::npos);
  const Outcome list = runScript("--list");
  EXPECT_EQ(list.status, 0);
  for (const char* name : {"merl", "rgl", "utia", "mpi-carpaint"}) EXPECT_NE(list.text.find(name), std::string::npos);
}

TEST(DownloadScript, WrongUsageIsStatusTwo) {
  for (const char* arguments : {"", "merl", "--nonsense", "nonsense nickel", "merl ../../etc/passwd", "--to"}) {
    EXPECT_EQ(runScript(arguments).status, 2) << arguments;
    EXPECT_NE(runScript(arguments).text, "") << arguments;
  }
}

TEST(DownloadScript, ADatabaseThatIsNotOfferedSaysSo) {
  const Outcome outcome = runScript("utia carpet01");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.text.find("--list"), std::string::npos);
}
