// HeTorrance against a direct restatement of the paper's equations, and that against the table of an independent
// program (BBM 0.5.1, HeWestin), whose departures the restatement reproduces: it stops the series of (78) when the
// smallest term of the three channels falls below 2.2e-16 after shrinking, at 64 terms at most, takes four Newton steps
// for the apparent roughness, and takes the factor G of (76) as 1 where light and viewer coincide (its limit is
// (|H|^2/Hz)^2).
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/check/Cases.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

namespace brdf {
namespace {

using Channels3 = std::array<double, 3>;
constexpr Channels3 kWavelengths{0.645, 0.526, 0.444};  // um
constexpr double kSmallest = std::numeric_limits<double>::epsilon();

struct Surface {
  double sigma0, tau, eta;  // um, um, real index
};

double sine(double cosine) { return std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine))); }

/// (24), (25) with the exponential of the errata.
double shadowing(const Surface& s, double cosine) {
  if (sine(cosine) < 1e-12) return 1;
  const double x = s.tau * cosine / (2 * s.sigma0 * sine(cosine)), tail = 0.5 * std::erfc(x);
  return (1 - tail) / (1 + std::exp(-x * x) / (2 * std::sqrt(kPi) * x) - tail);
}

/// (80)-(83): sigma0 over the apparent roughness, squared, less 1.
double apparent(const Surface& s, double ci, double co, bool asProgram) {
  const auto k = [&](double cosine) {
    const double tangent = sine(cosine) / cosine;
    return tangent > 1e-12 ? tangent * std::erfc(s.tau / (2 * s.sigma0 * tangent)) : 0;
  };
  const double target = (k(ci) + k(co)) / std::sqrt(8 * kPi);
  double x = target <= 1 ? target : std::sqrt(2 * std::log(target));
  for (int step = 0; step < (asProgram ? 4 : 60); ++step) {
    const double e = std::exp(0.5 * x * x);
    x -= (x * e - target) / ((1 + x * x) * e);
  }
  return x * x;
}

double fresnel(double eta, double c) {
  const double g = std::sqrt(eta * eta - 1 + c * c);
  return 0.5 * std::pow((g - c) / (g + c), 2) * (1 + std::pow((c * (g + c) - 1) / (c * (g - c) + 1), 2));
}

Channels3 restated(const Surface& s, const Direction& wi, const Direction& wo, bool asProgram) {
  const Direction h{wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]};
  const double h2 = dot(h, h), tangential = h[0] * h[0] + h[1] * h[1], facing = dot(wi, wo);
  const double more = apparent(s, wi[2], wo[2], asProgram);
  const bool coincide = std::pow(1 - facing * facing, 2) <= kSmallest;
  const double geometry = asProgram && coincide ? 1 : std::pow(h2 / h[2], 2);
  Channels3 g, b, power{1, 1, 1}, sum{}, result;
  for (int c = 0; c < 3; ++c) {
    g[c] = std::pow(2 * kPi * s.sigma0 * h[2] / kWavelengths[c], 2) / (1 + more);
    b[c] = tangential * std::pow(kPi * s.tau / kWavelengths[c], 2);
  }
  double last = 0;
  for (int m = 1; m <= (asProgram ? 64 : 150); ++m) {
    double smallest = INFINITY;
    for (int c = 0; c < 3; ++c) {
      power[c] *= g[c] / m;
      const double term = std::exp(-g[c] - b[c] / m) * power[c] / m;
      sum[c] += term;
      smallest = std::min(smallest, term);
    }
    if (asProgram && smallest < kSmallest && smallest < last) break;
    last = smallest;
  }
  for (int c = 0; c < 3; ++c)
    result[c] = fresnel(s.eta, std::sqrt(h2) / 2) * geometry * shadowing(s, wi[2]) * shadowing(s, wo[2]) /
                (kPi * wi[2] * wo[2]) * std::pow(kPi * s.tau / (2 * kWavelengths[c]), 2) * sum[c];
  return result;
}

TEST(HeTorrance, AgreesWithADirectSumOfThePapersSeries) {
  const ModelPointer model = findModel("HeTorrance");
  const CheckPairs set = adversarialPairs(60, 31, false);
  for (const Surface& surface : {Surface{0.18, 3, 1.5}, Surface{0.03, 1, 1.8}, Surface{0.2, 0.7, 1.3}}) {
    std::array<std::vector<double>, 3> values;
    for (int c = 0; c < 3; ++c) {
      values[c].resize(set.size());
      model->evaluate(set.pairs.view(), std::array{surface.sigma0, surface.tau, kWavelengths[c], surface.eta, 0.0},
                      values[c].data());
    }
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Channels3 expected = restated(surface, set.wi(k), set.wo(k), false);
      for (int c = 0; c < 3; ++c)  // the restatement cancels near the normal and at grazing
        ASSERT_NEAR(values[c][k], expected[c], 1e-8 * expected[c] + 1e-30) << directionText(set.wi(k), set.wo(k));
    }
  }
}

TEST(HeTorrance, SumsTheSeriesOfVeryRoughSurfacesToo) {
  // Far above g = 144 the model steps over the series; the sum over every term is the truth.
  const ModelPointer model = findModel("HeTorrance");
  for (const double sigma0 : {1.2, 3.0, 8.0})
    for (const double angle : {0.0, 10.0, 40.0}) {
      const Surface s{sigma0, 12, 1.5};
      const Direction wi = fromSpherical(radians(30), 0.2), wo = fromSpherical(radians(30 + angle), 0.2 + kPi + 0.1);
      const Direction h{wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]};
      const double g = std::pow(2 * kPi * sigma0 * h[2] / kWavelengths[0], 2) / (1 + apparent(s, wi[2], wo[2], false));
      const double b = (h[0] * h[0] + h[1] * h[1]) * std::pow(kPi * s.tau / kWavelengths[0], 2);
      ASSERT_GT(g, 144);
      long double sum = 0;
      for (int m = 1; m < 8 * g + 1000; ++m)
        sum += std::exp(m * std::log(static_cast<long double>(g)) - std::lgamma(m + 1.0L) - g - b / m) / m;
      const double scale = fresnel(s.eta, std::sqrt(dot(h, h)) / 2) * std::pow(dot(h, h) / h[2], 2) *
                           shadowing(s, wi[2]) * shadowing(s, wo[2]) / (kPi * wi[2] * wo[2]) *
                           std::pow(kPi * s.tau / (2 * kWavelengths[0]), 2);
      const double expected = scale * static_cast<double>(sum);
      DirectionPairBuffer<double> pair;
      pair.push(wi, wo);
      double value = 0;
      model->evaluate(pair.view(), std::array{sigma0, s.tau, kWavelengths[0], s.eta, 0.0}, &value);
      EXPECT_NEAR(value, expected, 1e-10 * expected) << "sigma0 " << sigma0 << " um, " << angle << " degrees, g " << g;
    }
}

TEST(HeTorrance, ItsRestatementReproducesTheIndependentProgramWithItsTruncation) {
  const std::filesystem::path table = std::filesystem::path(BRDF_SHARED_DIR) / "reference/analytic_models.csv";
  if (!std::filesystem::exists(table)) GTEST_SKIP() << table << " is missing";
  const Surface surface{0.18, 3, 1.5};
  std::size_t rows = 0;
  double worst = 0;
  const std::string text = readFile(table);
  for (const std::string_view line : split(text, '\n')) {
    if (line.rfind("hewestin_a,", 0) != 0) continue;
    ASSERT_NE(line.find("\"HeWestin(roughness = 0.18, autocorrelation = 3, eta = [[1.5, 1.5, 1.5], [0, 0, 0]])\""),
              std::string_view::npos);
    const std::vector<std::string_view> fields = split(line.substr(line.rfind('"') + 2), ',');
    double n[9];
    for (int k = 0; k < 9; ++k) n[k] = *parseNumber(fields[1 + static_cast<std::size_t>(k)]);
    const Channels3 values = restated(surface, {n[0], n[1], n[2]}, {n[3], n[4], n[5]}, true);
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::fabs(values[c] - n[6 + c]) / n[6 + c]);
    ++rows;
  }
  EXPECT_EQ(rows, 40u);
  EXPECT_LE(worst, 1e-9);
}

}  // namespace
}  // namespace brdf
