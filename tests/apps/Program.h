#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// What a run of a program left behind.
struct Outcome {
  int exitCode = -1;  ///< 128 + signal when a signal ended it
  std::string out;
  std::string err;
};

/// Runs the program `brdf` in `folder`, with variables added to the environment.
Outcome runBrdf(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                const std::vector<std::pair<std::string, std::string>>& environment = {});

/// Runs a line as a shell would, `brdf` being the program under test.
Outcome runLine(const std::filesystem::path& folder, const std::string& line);

/// Runs brdf with `--json -` added and reads the report; records a test failure when it does not succeed.
nlohmann::json reportOf(const std::filesystem::path& folder, std::vector<std::string> arguments);

/// An empty folder of its own for the running test.
std::filesystem::path scratchFolder();

/// Names of all files below `folder`, sorted.
std::vector<std::string> filesIn(const std::filesystem::path& folder);

/// Writes into `folder` spectral data at 31 wavelengths, 400 to 700 nm: a diffuse red surface of reflectance
/// redReflectance(), as a sum of lobes (spectral.xml) and as samples (spectral.csv).
void writeSpectralFiles(const std::filesystem::path& folder);
/// Of the wavelength in nm.
double redReflectance(double wavelength);
