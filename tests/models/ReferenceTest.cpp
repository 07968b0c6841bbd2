// Values that an independent program (BBM 0.5.1) computed, against ours: reference/analytic_models.csv, translated by
// tests/reference/analytic_mapping.json.
#include "../CsvFields.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/LobeSum.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

namespace brdf {
namespace {

/// "Name(a = 1, b = [2, [3, 4]])" as {"a": 1, "b": [2, [3, 4]]}.
nlohmann::json parametersOf(const std::string& text) {
  std::string json = "{";
  for (std::size_t k = text.find('(') + 1; k + 1 < text.size(); ++k) {
    if (std::isalpha(static_cast<unsigned char>(text[k])) && (text[k - 1] == '(' || text[k - 1] == ' ')) {
      const std::size_t end = text.find_first_of(" =", k);
      json += "\"" + text.substr(k, end - k) + "\"";
      k = end - 1;
    } else {
      json += text[k] == '=' ? ':' : text[k];
    }
  }
  return nlohmann::json::parse(json + "}");
}

/// `expression` with each "{name[i][j]}" replaced by its number.
std::string filledIn(std::string expression, const nlohmann::json& parameters) {
  for (std::size_t open = expression.find('{'); open != std::string::npos; open = expression.find('{', open)) {
    const std::size_t close = expression.find('}', open);
    const std::string path = expression.substr(open + 1, close - open - 1);
    const nlohmann::json* value = &parameters.at(path.substr(0, path.find('[')));
    for (std::size_t at = path.find('['); at != std::string::npos; at = path.find('[', at + 1))
      value = &value->at(static_cast<std::size_t>(*parseNumber(path.substr(at + 1, path.find(']', at) - at - 1))));
    expression.replace(open, close - open + 1, formatNumber(value->get<double>()));
  }
  return expression;
}

/// Our expression for a row's model; the sum of those of its parts for an "Aggregate(A(...), B(...))".
std::string translated(const std::string& text, const nlohmann::json& mapping) {
  const std::string name = text.substr(0, text.find('('));
  if (name != "Aggregate") return filledIn(mapping.at(name), parametersOf(text));
  std::string result;
  int depth = 0;
  std::size_t start = text.find('(') + 1;
  for (std::size_t k = start; k < text.size(); ++k) {
    if (text[k] == '(' || text[k] == '[') ++depth;
    if (depth == 0 && (text[k] == ',' || text[k] == ')')) {
      result +=
          (result.empty() ? "" : " + ") + translated(std::string(trimmed(text.substr(start, k - start))), mapping);
      start = k + 1;
    }
    if (text[k] == ')' || text[k] == ']') --depth;
  }
  return result;
}

/// What may be asked beside that program: EPD's shadowing is read there from a table of 3 to 4 digits.
double toleranceOf(const std::string& name) { return name == "EPD" ? 5e-4 : 1e-9; }

/// Rows where the two programs differ by design: SGD's shadowing and Fresnel terms are clamped at 0 here, as the
/// model's page says, and left negative there. True when a clamp acts in this row.
bool clampActs(const nlohmann::json& p, std::size_t channel, const Direction& wi, const Direction& wo) {
  const auto shadow = [&](double theta) {
    const double theta0 = p["theta0"][channel], c = p["c"][channel], k = p["k"][channel],
                 amplitude = p["Lambda"][channel];
    return theta > theta0 ? 1 + amplitude * (1 - std::exp(c * std::pow(theta - theta0, k))) : 1.0;
  };
  const double cosD = std::sqrt(std::max(0.0, (1 + dot(wi, wo)) / 2));
  const double f0 = p["eta"][0][channel], f1 = p["eta"][1][channel];
  const double fresnel = f0 - f1 * cosD + (1 - f0) * std::pow(1 - cosD, 5);
  return shadow(std::acos(wi[2])) < 0 || shadow(std::acos(wo[2])) < 0 || fresnel < 0;
}

/// Models whose series that program cuts short: HeTorranceTest.cpp restates it, cut included, and compares.
const std::set<std::string> kTruncated{"HeWestin", "NganHe"};

TEST(Reference, ModelsAgreeWithAnIndependentProgram) {
  const std::filesystem::path table = std::filesystem::path(BRDF_SHARED_DIR) / "reference" / "analytic_models.csv";
  if (!std::filesystem::exists(table)) GTEST_SKIP() << "no reference values at " << table;
  const nlohmann::json mapping =
      nlohmann::json::parse(readFile(std::filesystem::path(BRDF_SOURCE_DIR) / "tests/reference/analytic_mapping.json"));

  std::map<std::string, std::size_t> checked;
  std::set<std::string> unmapped, used;
  std::size_t rows = 0, clamped = 0;
  double worst = 0;
  std::string text = readFile(table), previous;
  std::shared_ptr<const LobeSum> material;
  const std::vector<std::string_view> lines = split(text, '\n');
  ASSERT_EQ(csvFields(lines[0])[3], "wi_x");
  for (std::size_t line = 1; line < lines.size(); ++line) {
    if (lines[line].empty()) continue;
    const std::vector<std::string> row = csvFields(lines[line]);
    ASSERT_EQ(row.size(), 13u) << "line " << line + 1;
    const std::string name = row[1].substr(0, row[1].find('('));
    if (!mapping.contains(name) && name != "Aggregate") {
      unmapped.insert(name);
      continue;
    }
    used.insert(name);
    if (kTruncated.contains(name)) continue;
    if (row[1] != previous) material = parseMaterialExpression(translated(row[1], mapping));
    previous = row[1];
    Direction wi, wo;
    for (std::size_t axis = 0; axis < 3; ++axis)
      wi[axis] = *parseNumber(row[3 + axis]), wo[axis] = *parseNumber(row[6 + axis]);
    const std::vector<double> values = material->evaluate(wi, wo);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double expected = *parseNumber(row[9 + channel]), got = values[values.size() == 1 ? 0 : channel];
      if (name == "Bagher" && clampActs(parametersOf(row[1]), channel, wi, wo)) {
        EXPECT_EQ(got, 0) << "line " << line + 1 << ", where a clamp acts";
        ++clamped;
        continue;
      }
      const double size = std::max({std::fabs(expected), std::fabs(got), 1e-290});
      const double tolerance = toleranceOf(name);
      if (tolerance < 1e-8) worst = std::max(worst, std::fabs(got - expected) / size);
      EXPECT_LE(std::fabs(got - expected), tolerance * size)
          << row[1] << ", line " << line + 1 << ", channel " << channel << " (" << row[2]
          << "): " << formatNumber(got, 17) << " instead of " << row[9 + channel];
    }
    ++rows;
    ++checked[name];
    used.insert(name);
  }
  for (const auto& [name, expression] : mapping.items()) EXPECT_TRUE(used.contains(name)) << name << " has no rows";
  std::printf(
      "%zu rows of %zu models agree, worst relative difference %.1e; %zu values where SGD's clamp acts are 0; not "
      "mapped yet: %s\n",
      rows, checked.size(), worst, clamped, joined(unmapped).c_str());
}

}  // namespace
}  // namespace brdf
