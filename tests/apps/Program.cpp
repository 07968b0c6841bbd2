#include "Program.h"

#include <brdf/base/File.h>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {

/// Outside the folder under test, so that listing it shows what the program wrote and nothing else.
fs::path captureFile(const char* name) {
  const fs::path folder = fs::path(BRDF_TEST_DIR) / "apps-capture" / std::to_string(::getpid());
  fs::create_directories(folder);
  return folder / name;
}

}  // namespace

Outcome runBrdf(const fs::path& folder, const std::vector<std::string>& arguments,
                const std::vector<std::pair<std::string, std::string>>& environment) {
  const fs::path out = captureFile("out"), err = captureFile("err");
  std::vector<char*> argv = {const_cast<char*>(BRDF_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    const bool ready = ::chdir(folder.c_str()) == 0 && ::dup2(::open("/dev/null", O_RDONLY), 0) >= 0 &&
                       ::dup2(::open(out.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), 1) >= 0 &&
                       ::dup2(::open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), 2) >= 0;
    for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
    if (ready) ::execv(BRDF_PROGRAM, argv.data());
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), brdf::readFile(out), brdf::readFile(err)};
}

Outcome runLine(const fs::path& folder, const std::string& line) {
  const fs::path out = captureFile("out"), err = captureFile("err");
  const std::string command = "cd '" + folder.string() + "' && brdf() { '" BRDF_PROGRAM "' \"$@\"; } && " + line +
                              " >'" + out.string() + "' 2>'" + err.string() + "' </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), brdf::readFile(out), brdf::readFile(err)};
}

nlohmann::json reportOf(const fs::path& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--json", "-"});
  const Outcome run = runBrdf(folder, arguments);
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const auto report = nlohmann::json::parse(run.out, nullptr, false);
  EXPECT_FALSE(report.is_discarded()) << "standard output is not one JSON document:\n" << run.out;
  return report;
}

fs::path scratchFolder() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  std::replace(name.begin(), name.end(), '/', '-');
  const fs::path folder = fs::path(BRDF_TEST_DIR) / "apps" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

std::vector<std::string> filesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    names.push_back(fs::relative(entry.path(), folder).string());
  std::sort(names.begin(), names.end());
  return names;
}
