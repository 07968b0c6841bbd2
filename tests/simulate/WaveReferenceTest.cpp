#include "../CsvFields.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/wave/WaveModels.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

namespace brdf {
namespace {

struct Row {
  std::map<std::string, std::string> text;
  double number(const std::string& name) const { return std::strtod(text.at(name).c_str(), nullptr); }
};

std::vector<Row> readRows(const std::filesystem::path& path) {
  std::vector<Row> rows;
  std::vector<std::string> titles;
  const std::string text = readFile(path);
  for (const std::string_view line : split(text, '\n')) {
    if (line.empty()) continue;
    const std::vector<std::string> values = csvFields(line);
    if (titles.empty()) {
      titles = values;
      continue;
    }
    Row row;
    for (std::size_t k = 0; k < titles.size(); ++k) row.text[titles[k]] = values.at(k);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// As the mapping says: polar angles of 0 keep their azimuth.
std::array<double, 3> direction(double thetaDegrees, double phiDegrees) {
  const double theta = std::max(thetaDegrees, 1e-9) * std::numbers::pi / 180, phi = phiDegrees * std::numbers::pi / 180;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

TEST(WaveReference, EveryMappedRowAgreesToAMillionth) {
  const std::filesystem::path path = std::filesystem::path(BRDF_SHARED_DIR) / "reference" / "wave_models.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const auto mapping =
      nlohmann::json::parse(readFile(std::filesystem::path(BRDF_SOURCE_DIR) / "tests/reference/wave_mapping.json"));
  std::map<std::string, std::shared_ptr<const WaveBrdf>> models;
  std::map<std::string, double> worst;
  for (const Row& row : readRows(path)) {
    const std::string& config = row.text.at("config");
    ASSERT_TRUE(mapping["configs"].contains(config)) << config << " is neither mapped nor refused";
    if (!mapping["configs"][config].contains("expression")) continue;
    auto& model = models[config];
    if (!model) model = makeWaveBrdf(std::string(mapping["configs"][config]["expression"]));
    const double turn = row.number("rotation_deg");
    const auto wi = direction(row.number("theta_i_deg"), 180 - turn);
    const auto wo = direction(row.number("theta_s_deg"), row.number("phi_s_deg") - turn);
    DirectionPairs<double> pair{{&wi[0], &wi[1], &wi[2]}, {&wo[0], &wo[1], &wo[2]}, 1};
    const double expected = row.number("brdf_unpolarized_per_sr"), value = model->evaluate(wi, wo)[0];
    const std::string where = config + " at " + row.text.at("theta_i_deg") + " " + row.text.at("theta_s_deg") + " " +
                              row.text.at("phi_s_deg");
    EXPECT_NEAR(value, expected, 1e-6 * expected + 1e-300) << where;
    wave::Mueller matrix;
    model->mueller(pair, 0, &matrix);
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t c = 0; c < 4; ++c) {
        const double element = row.number("m" + std::to_string(r) + std::to_string(c));
        worst[config] = std::max(worst[config], expected > 0 ? std::abs(matrix(r, c) - element) / expected : 0);
        // An element that cancels keeps the digits of the largest.
        EXPECT_NEAR(matrix(r, c), element, 1e-6 * std::abs(element) + 1e-9 * expected + 1e-300)
            << where << " m" << r << c;
      }
  }
  for (const auto& [config, value] : worst) RecordProperty("worst " + config, formatNumber(value, 3));
  EXPECT_EQ(models.size(), 8u);
}

}  // namespace
}  // namespace brdf
