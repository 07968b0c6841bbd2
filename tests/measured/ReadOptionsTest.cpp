// What the user says of a measured file overrides what its format says, and is recorded with its evidence.
#include <brdf/geometry/Directions.h>
#include <brdf/measured/Format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "MeasuredSupport.h"

namespace {

using brdf::ReadOptions;
using measuredtest::errorOf;
using measuredtest::folder;

brdf::ReadResult readCornell(const char* test, const std::vector<std::string>& assumed) {
  const auto path = folder(std::string("options_") + test) / "a.brdf";
  // One wavelength; theta_i, phi_i, theta_o, phi_o, value.
  brdf::writeFile(path, "1 550\n0.5 0 1.0 0.3 0.2\n0.2 0 0.7 0.1 -0.1\n0.1 0 0.2 0 0\n");
  return brdf::readMeasured(path, brdf::parseReadOptions(assumed));
}

struct Sample {
  brdf::DirectionPairBuffer<double> pairs;
  std::array<double, 3> values;
  std::array<std::uint8_t, 3> valid;
};
Sample samplesOf(const brdf::ReadResult& result) {
  Sample sample;
  result.brdf->samples()->read(0, 3, &sample.pairs, sample.values.data(), sample.valid.data());
  return sample;
}

bool assumed(const brdf::ReadResult& result, const std::string& sentence) {
  const auto& all = result.report.assumptions;
  return std::find(all.begin(), all.end(), sentence) != all.end();
}

}  // namespace

TEST(ReadOptions, QuantitiesBecomeBrdfs) {
  EXPECT_DOUBLE_EQ(samplesOf(readCornell("plain", {})).values[0], 0.2);
  EXPECT_NEAR(samplesOf(readCornell("cos", {"quantity=brdf_cos"})).values[0], 0.2 / std::cos(1.0), 1e-15);
  EXPECT_NEAR(samplesOf(readCornell("factor", {"quantity=reflectance_factor"})).values[0], 0.2 / brdf::kPi, 1e-15);
}

TEST(ReadOptions, SwappedDirectionsTradePlacesBeforeTheCosineIsTaken) {
  const auto sample = samplesOf(readCornell("swap", {"incident=swapped", "quantity=brdf_cos"}));
  EXPECT_NEAR(sample.pairs.wi[2][0], std::cos(1.0), 1e-15);
  EXPECT_NEAR(sample.pairs.wo[2][0], std::cos(0.5), 1e-15);
  EXPECT_NEAR(sample.values[0], 0.2 / std::cos(0.5), 1e-15);
}

TEST(ReadOptions, AnglesMayBeDegrees) {
  EXPECT_NEAR(samplesOf(readCornell("degrees", {"angles=degrees"})).pairs.wo[2][0], std::cos(brdf::radians(1.0)),
              1e-15);
}

TEST(ReadOptions, TheRuleForInvalidValuesDecidesWhichSamplesCount) {
  using Flags = std::array<std::uint8_t, 3>;
  EXPECT_EQ(samplesOf(readCornell("noise", {})).valid, (Flags{1, 1, 1}));
  EXPECT_EQ(samplesOf(readCornell("negative", {"invalid=negative"})).valid, (Flags{1, 0, 1}));
  const auto strict = readCornell("positive", {"invalid=not_positive"});
  EXPECT_EQ(samplesOf(strict).valid, (Flags{1, 0, 0}));
  EXPECT_EQ(strict.report.invalid, 2u);
}

TEST(ReadOptions, SymmetryMayBeSaid) {
  EXPECT_EQ(readCornell("isotropic", {}).brdf->symmetry(), brdf::Symmetry::Isotropic);
  EXPECT_EQ(readCornell("anisotropic", {"symmetry=anisotropic"}).brdf->symmetry(), brdf::Symmetry::Anisotropic);
}

TEST(ReadOptions, WhatIsAssumedIsRecordedWithItsEvidence) {
  EXPECT_TRUE(assumed(readCornell("recorded", {}), "quantity: brdf (the format's definition)"));
  EXPECT_TRUE(assumed(readCornell("given", {"quantity=brdf_cos"}),
                      "quantity: brdf_cos (given; the format's definition: brdf)"));
  EXPECT_TRUE(assumed(readCornell("same", {"quantity=brdf"}), "quantity: brdf (given; the format's definition)"));
}

TEST(ReadOptions, NegativeCellsOfMerlMayCount) {
  const auto path = folder("options_merl") / "a.binary";
  std::string bytes(12 + 24, '\0');
  const std::int32_t ones[3] = {1, 1, 1};
  const double values[3] = {1500, -1500, 1500};
  std::memcpy(bytes.data(), ones, 12);
  std::memcpy(bytes.data() + 12, values, 24);
  brdf::writeFile(path, bytes);
  const auto valueAtNormal = [&](const std::vector<std::string>& items) {
    return brdf::readMeasured(path, brdf::parseReadOptions(items)).brdf->evaluate({0, 0, 1}, {0, 0, 1})[1];
  };
  EXPECT_EQ(valueAtNormal({}), 0);
  EXPECT_NEAR(valueAtNormal({"invalid=not_finite"}), -1.15, 1e-12);
}

TEST(ReadOptions, AnOptionThatTheFormatHasNoUseForIsAnErrorThatNamesThose) {
  const std::string error = errorOf([] { readCornell("refused", {"sides=swapped"}); });
  EXPECT_NE(error.find("cornell"), std::string::npos) << error;
  EXPECT_NE(error.find("quantity, incident, symmetry, invalid, angles"), std::string::npos) << error;
}

TEST(ReadOptions, UnknownKeysAndValuesAreErrorsThatNameTheKnownOnes) {
  const auto of = [](const std::string& item) {
    return errorOf([&] { brdf::parseReadOptions(std::vector<std::string>{item}); });
  };
  EXPECT_NE(of("quantum=brdf").find("quantity, angles"), std::string::npos);
  EXPECT_NE(of("quantity=radiance").find("brdf, brdf_cos, reflectance_factor"), std::string::npos);
  EXPECT_NE(of("quantity").find("brdf, brdf_cos"), std::string::npos);
}

TEST(ReadOptions, EveryKeyAndValueThatHelpListsIsAccepted) {
  for (const brdf::ReadOptionKey& key : brdf::readOptionKeys())
    for (const std::string& value : key.values) {
      const ReadOptions options = brdf::parseReadOptions(std::vector<std::string>{" " + key.key + " = " + value});
      EXPECT_EQ(options.keys(), std::vector<std::string>{key.key}) << value;
    }
}
