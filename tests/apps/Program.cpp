#include "Program.h"

#include "../TestFolder.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

fs::path scratchFolder() { return testFolder("scratch"); }

std::vector<std::string> filesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    names.push_back(fs::relative(entry.path(), folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

double redReflectance(double wavelength) { return 0.1 + 0.7 / (1 + std::exp((590 - wavelength) / 12)); }

void writeSpectralFiles(const fs::path& folder) {
  std::string wavelengths, scales, names, values;
  for (int channel = 0; channel < 31; ++channel) {
    const int wavelength = 400 + 10 * channel;
    wavelengths += (channel > 0 ? " " : "") + std::to_string(wavelength);
    scales += (channel > 0 ? " " : "") + brdf::formatNumber(redReflectance(wavelength));
    names += ",value_" + std::to_string(channel);
    values += "," + brdf::formatNumber(redReflectance(wavelength) / std::numbers::pi);
  }
  brdf::writeFile(folder / "spectral.xml", "<material version='1' channels='spectral' wavelengths='" + wavelengths +
                                               "'><lobe model='Lambertian'><scale>" + scales +
                                               "</scale></lobe></material>\n");
  std::string text = "# wavelengths_nm: " + wavelengths + "\n# isotropic\ntheta_i,theta_o,phi_o" + names + "\n";
  for (const char* angles : {"0,0,0", "0,40,0", "30,30,180", "30,10,90", "30,60,0", "60,60,180", "60,0,0", "60,20,45"})
    text += angles + values + "\n";
  brdf::writeFile(folder / "spectral.csv", text);
}
