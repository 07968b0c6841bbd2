// The linter on samples of a known surface, right and read by each wrong convention.
#include <brdf/measured/Lint.h>

#include <algorithm>
#include <random>

#include "MeasuredSupport.h"

namespace {

using brdf::Direction;
using brdf::LintFinding;
using Change = std::function<double(const Direction& wi, const Direction& wo, double value)>;

/// Diffuse with albedo 0.3 and a highlight, 8000 samples on a grid of angles.
brdf::ScatteredSamples surface(const Change& change, double angleScale = 1, double turn = 0) {
  brdf::ScatteredSamples samples;
  for (int thetaI = 0; thetaI <= 80; thetaI += 8)
    for (int thetaO = 0; thetaO <= 80; thetaO += 8)
      for (int phi = 0; phi <= 180; phi += 6) {
        const auto at = [](double theta, double azimuth) {
          return brdf::fromSpherical(brdf::radians(theta), brdf::radians(azimuth));
        };
        const Direction wi = at(thetaI, 0), wo = at(thetaO, phi);
        const Direction h = brdf::normalized({wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]});
        const double tangent2 = (h[0] * h[0] + h[1] * h[1]) / (h[2] * h[2]);
        const double value = 0.3 / brdf::kPi + 2 * std::exp(-tangent2 / 0.01);
        samples.pairs.push(at(angleScale * thetaI, 0), at(angleScale * thetaO, phi + turn));
        samples.values.push_back(change(wi, wo, value));
      }
  return samples;
}

const LintFinding* find(const std::vector<LintFinding>& findings, const std::string& check) {
  const auto found = std::find_if(findings.begin(), findings.end(), [&](const auto& f) { return f.check == check; });
  return found == findings.end() ? nullptr : &*found;
}

std::vector<LintFinding> lintOf(brdf::ScatteredSamples samples) {
  return brdf::lint(brdf::ScatteredBrdf(std::move(samples), "test"));
}

double same(const Direction&, const Direction&, double value) { return value; }

}  // namespace

TEST(Lint, ARightSurfaceGivesNoFinding) {
  const auto findings = lintOf(surface(same));
  for (const LintFinding& finding : findings) ADD_FAILURE() << finding.sentence();
}

TEST(Lint, ACosineTooManyShowsInTheExponentAndInReciprocity) {
  const auto findings = lintOf(surface([](const Direction&, const Direction& wo, double f) { return f * wo[2]; }));
  for (const char* check : {"grazing", "reciprocity"}) {
    const LintFinding* finding = find(findings, check);
    ASSERT_TRUE(finding) << check;
    EXPECT_EQ(finding->option, "quantity=brdf_cos") << finding->sentence();
  }
  EXPECT_NE(find(findings, "grazing")->evidence.find("cos(theta_o)^1 "), std::string::npos)
      << find(findings, "grazing")->evidence;
}

TEST(Lint, ADivisionTooManyShowsLikewise) {
  const auto findings = lintOf(surface([](const Direction&, const Direction& wo, double f) { return f / wo[2]; }));
  for (const char* check : {"grazing", "reciprocity"}) {
    const LintFinding* finding = find(findings, check);
    ASSERT_TRUE(finding) << check;
    EXPECT_EQ(finding->option, "quantity=brdf") << finding->sentence();
  }
}

TEST(Lint, AReflectanceFactorReflectsTooMuch) {
  const auto findings = lintOf(surface([](const Direction&, const Direction&, double) { return 0.9; }));
  const LintFinding* finding = find(findings, "energy");
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->option, "quantity=reflectance_factor");
  EXPECT_NE(finding->evidence.find("2.83"), std::string::npos) << "0.9 pi: " << finding->evidence;
  EXPECT_FALSE(
      find(lintOf(surface([](const Direction&, const Direction&, double) { return 0.9 / brdf::kPi; })), "energy"));
}

TEST(Lint, RadiansReadAsDegreesLeaveNoSlant) {
  const auto findings = lintOf(surface(same, brdf::radians(1)));
  ASSERT_TRUE(find(findings, "angles"));
  EXPECT_EQ(find(findings, "angles")->option, "angles=radians");
}

TEST(Lint, MarksForWhatWasNotMeasured) {
  int counter = 0;
  const auto every = [&](double mark) {
    counter = 0;
    return surface(
        [&counter, mark](const Direction&, const Direction&, double f) { return ++counter % 20 == 0 ? mark : f; });
  };
  ASSERT_TRUE(find(lintOf(every(-1)), "negative"));
  EXPECT_EQ(find(lintOf(every(-1)), "negative")->option, "invalid=negative");
  ASSERT_TRUE(find(lintOf(every(0)), "zero"));
  EXPECT_EQ(find(lintOf(every(0)), "zero")->option, "invalid=not_positive");
  // Noise about zero is no mark.
  std::mt19937 engine(1);
  std::normal_distribution<double> noise(0, 0.01);
  EXPECT_FALSE(
      find(lintOf(surface([&](const Direction&, const Direction&, double) { return noise(engine); })), "negative"));
}

TEST(Lint, AHighlightOffTheMirrorDirectionIsSeen) {
  const auto turned = lintOf(surface(same, 1, 180));
  ASSERT_TRUE(find(turned, "highlight"));
  EXPECT_NE(find(turned, "highlight")->evidence.find("from the other side"), std::string::npos);
  ASSERT_TRUE(find(lintOf(surface(same, 1, 90)), "highlight"));
}

TEST(Lint, ReadingAFileWarns) {
  const auto dir = measuredtest::folder("lint");
  brdf::writeMeasured(
      brdf::ScatteredBrdf(surface([](const Direction&, const Direction& wo, double f) { return f * wo[2]; }), "a"),
      dir / "a.csv");
  const auto mentions = [&](const std::vector<std::string>& options) {
    const auto result = brdf::readMeasured(dir / "a.csv", brdf::parseReadOptions(options));
    return std::any_of(result.report.warnings.begin(), result.report.warnings.end(),
                       [](const std::string& warning) { return warning.find("grazing:") == 0; });
  };
  EXPECT_TRUE(mentions({}));
  EXPECT_FALSE(mentions({"quantity=brdf_cos"})) << "the option that the finding names removes it";
}
