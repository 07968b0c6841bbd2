// Readers of scattered samples against small files written by hand (tests/data), with values computed by hand.
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/measured/Format.h>

#include <algorithm>

#include "MeasuredSupport.h"

namespace {

using brdf::Direction;
using measuredtest::dataOf;
using measuredtest::expectPair;

brdf::ReadResult readData(const char* name, std::vector<std::string> options = {}) {
  return brdf::readMeasured(std::filesystem::path(BRDF_SOURCE_DIR) / "tests/data" / name,
                            brdf::parseReadOptions(options));
}

bool mentions(const std::vector<std::string>& sentences, const std::string& text) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& sentence) { return sentence.find(text) != std::string::npos; });
}

const double kHalf = std::sqrt(0.5), kThree = std::sqrt(3.0) / 2;

}  // namespace

TEST(Alta, CosineWeightedValuesAndIntervalsAreDividedByTheViewersCosine) {
  const auto result = readData("alta_isotropic.alta");
  const auto& data = dataOf(result);
  EXPECT_EQ(result.report.format, "alta");
  ASSERT_EQ(data.pairs.size(), 3u);
  EXPECT_TRUE(data.isotropic);
  expectPair(data, 0, {0.5, 0, kThree}, {-kThree, 0, 0.5});
  expectPair(data, 1, {0.5, 0, kThree}, {0, 0, 1});
  expectPair(data, 2, {0.5, 0, kThree}, {0, kHalf, kHalf});
  EXPECT_NEAR(data.values[0], 0.5, 1e-15);
  EXPECT_NEAR(data.values[1], 0.125, 1e-15);
  EXPECT_NEAR(data.values[2], std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(data.uncertainty[0], 0.02, 1e-16);
  EXPECT_NEAR(data.uncertainty[1], 0.02, 1e-16);
  EXPECT_TRUE(mentions(result.report.assumptions, "quantity: brdf_cos"));
  EXPECT_EQ(dataOf(readData("alta_isotropic.alta", {"quantity=brdf"})).values[0], 0.25);
}

TEST(Alta, XyzBecomesLinearSrgb) {
  const auto result = readData("alta_xyz.dat");
  const auto& data = dataOf(result);
  EXPECT_EQ(data.channels, brdf::Channels::rgb());
  for (const double value : data.values) EXPECT_NEAR(value, 1, 1e-12) << "the white of D65";
  expectPair(data, 0, brdf::fromSpherical(0.5, 0.25), brdf::fromSpherical(0.75, -1.5));
  EXPECT_FALSE(data.isotropic);
  EXPECT_EQ(dataOf(readData("alta_xyz.dat", {"colour=linear_srgb"})).values[1], 1);
}

TEST(Alta, BinaryOfBothByteOrders) {
  for (const char* name : {"alta_little.altabin", "alta_big.altabin"}) {
    const auto result = readData(name);
    const auto& data = dataOf(result);
    EXPECT_EQ(result.report.format, "alta-binary");
    ASSERT_EQ(data.pairs.size(), 2u);
    EXPECT_EQ(data.values, (std::vector<double>{0.125, 2}));
    // theta_h = 0.5 and theta_d = 0.25 at right angles: both cosines are cos(0.5) cos(0.25).
    EXPECT_NEAR(data.pairs.wi[2][0], std::cos(0.5) * std::cos(0.25), 1e-15);
    EXPECT_NEAR(data.pairs.wo[2][0], std::cos(0.5) * std::cos(0.25), 1e-15);
    EXPECT_TRUE(mentions(result.report.assumptions, "phi_d = 90 degrees"));
  }
}

TEST(Astm, ReadsColoursAndTellsDegreesFromRadians) {
  const auto result = readData("astm_rgb.astm");
  const auto& data = dataOf(result);
  EXPECT_EQ(data.channels, brdf::Channels::rgb());
  EXPECT_EQ(data.values, (std::vector<double>{0.1, 0.4, 0.4, 0.2, 0.5, 0.5, 0.3, 0.6, 0.6}));
  EXPECT_TRUE(data.isotropic);
  EXPECT_FALSE(mentions(result.report.warnings, "NUM_POINTS"));
  EXPECT_EQ(result.report.metadata.at("DEVICE"), "by hand");
  expectPair(data, 0, brdf::fromSpherical(0.5, 0), brdf::fromSpherical(0.25, -1.5));

  const auto spectral = readData("astm_degrees.astm");
  EXPECT_EQ(dataOf(spectral).channels, brdf::Channels::spectral({450, 650}));
  EXPECT_EQ(dataOf(spectral).values, (std::vector<double>{4.5, 4.25, 6.5, 6.25}));
  EXPECT_FALSE(dataOf(spectral).isotropic) << "several azimuths of the light";
  expectPair(dataOf(spectral), 1, {0, 0.5, kThree}, {-kHalf, 0, kHalf});
  EXPECT_TRUE(mentions(spectral.report.assumptions, "angles: degrees (polar angles up to 45)"));
}

TEST(Pab, DsfIsDividedAndTheOtherSideIsAComponent) {
  const auto result = readData("pab_dsf.txt");
  const auto& data = dataOf(result);
  EXPECT_EQ(result.report.samples, 2u);
  EXPECT_EQ(result.report.metadata.at("sample"), "white by hand");
  expectPair(data, 0, {-kThree, 0, 0.5}, {0, 0, 1});
  expectPair(data, 1, {-kThree, 0, 0.5}, {kThree, 0, 0.5});
  EXPECT_NEAR(data.values[0], 0.5, 1e-15);
  EXPECT_NEAR(data.values[1], 1.0, 1e-15);
  // 0.75 at theta = 120 degrees leaves at 60 degrees from the back's normal: 0.75/cos(60).
  ASSERT_EQ(result.components.scatter.size(), 1u);
  EXPECT_EQ(result.components.scatter[0].kind, brdf::ComponentKind::FrontTransmission);
  const auto& through = dynamic_cast<const brdf::ScatteredBrdf&>(*result.components.scatter[0].brdf).data();
  expectPair(through, 0, {-kThree, 0, 0.5}, {kThree, 0, 0.5});
  EXPECT_NEAR(through.values[0], 1.5, 1e-14);
}

TEST(Pab, LitFromTheBackTheSheetIsTurnedOver) {
  const auto dir = measuredtest::folder("pab_back");
  brdf::writeFile(dir / "a.pab", "#intheta 120\n#inphi 90\n#format: theta phi BTDF\n150 90 2\n30 90 4\n");
  const auto result = brdf::readMeasured(dir / "a.pab");
  expectPair(dataOf(result), 0, {0, -kThree, 0.5}, {0, -0.5, kThree});
  EXPECT_TRUE(mentions(result.report.warnings, "back reflection"));
  EXPECT_FALSE(result.components.front);
  ASSERT_EQ(result.components.scatter.size(), 2u);
  EXPECT_EQ(result.components.scatter[0].kind, brdf::ComponentKind::BackReflection);
  EXPECT_EQ(result.components.scatter[0].brdf, result.brdf) << "it stands in for the front";
  EXPECT_EQ(result.components.scatter[1].kind, brdf::ComponentKind::BackTransmission);
  const auto& through = dynamic_cast<const brdf::ScatteredBrdf&>(*result.components.scatter[1].brdf).data();
  expectPair(through, 0, {0, -kThree, 0.5}, {0, -0.5, kThree});
  EXPECT_EQ(through.values[0], 4);
}

TEST(Pab, AFolderIsOneBrdfOfSeveralIncidences) {
  const auto result = readData("pab_folder");
  const auto& data = dataOf(result);
  EXPECT_EQ(result.report.format, "pab");
  EXPECT_EQ(result.report.metadata.at("incidences"), "2");
  ASSERT_EQ(data.pairs.size(), 4u);
  EXPECT_EQ(data.values, (std::vector<double>{1, 0.5, 3, 2}));
  expectPair(data, 1, {0, 0, 1}, {0, 0.5, kThree});
  expectPair(data, 2, {kHalf, 0, kHalf}, {-kHalf, 0, kHalf});
}

TEST(Pab, SpectralColumnsAreSortedByWavelength) {
  const auto result = readData("pab_spectral.txt");
  const auto& data = dataOf(result);
  EXPECT_EQ(data.channels, brdf::Channels::spectral({450, 650}));
  EXPECT_EQ(data.values, (std::vector<double>{4.5, 0.45, 6.5, 0.65}));
}

TEST(Bird, GathersWavelengthsUnitsAndUncertainties) {
  const auto result = readData("bird.json");
  const auto& data = dataOf(result);
  EXPECT_EQ(result.report.format, "bird");
  EXPECT_EQ(data.channels, brdf::Channels::spectral({550, 650}));
  EXPECT_EQ(data.values, (std::vector<double>{0.55, 5.5, 0.65, 6.5}));
  EXPECT_NEAR(data.uncertainty[0], 0.011, 1e-15) << "2 percent";
  EXPECT_NEAR(data.uncertainty[3], 0.13, 1e-15);
  EXPECT_TRUE(data.isotropic);
  expectPair(data, 0, {0.5, 0, kThree}, brdf::fromSpherical(0.5, 3));
}

TEST(Bird, TwoOrthogonalPolarisationsAverage) {
  const auto result = readData("bird_polarised.json");
  const auto& data = dataOf(result);
  ASSERT_EQ(data.pairs.size(), 2u);
  EXPECT_NEAR(data.values[0], 0.3, 1e-15);
  EXPECT_NEAR(data.values[1], 0.6, 1e-15);
  EXPECT_NEAR(data.uncertainty[0], 0.025, 1e-15) << "sqrt(0.03^2 + 0.04^2)/2";
  EXPECT_NEAR(data.uncertainty[1], 0.05, 1e-15);
  EXPECT_TRUE(mentions(result.report.assumptions, "unpolarised"));
}

TEST(BrdfLab, SparseTextAndQtExport) {
  const auto sparse = readData("brdflab_sparse.txt");
  EXPECT_EQ(sparse.report.format, "brdflab-text");
  EXPECT_EQ(dataOf(sparse).values, (std::vector<double>{0.1, 0.4, 0.2, 0.5, 0.3, 0.6}));
  expectPair(dataOf(sparse), 1, brdf::fromSpherical(0.5, 1), brdf::fromSpherical(0.25, 3));
  EXPECT_FALSE(dataOf(sparse).isotropic);
  for (const char* name : {"brdflab_export8.qbrdf", "brdflab_export4.qbrdf"}) {
    const auto result = readData(name);
    EXPECT_EQ(result.report.format, "brdflab-export");
    EXPECT_EQ(dataOf(result).values, (std::vector<double>{0.5, 0.25}));
    EXPECT_NEAR(dataOf(result).pairs.wo[0][0], 0.6, 1e-7);
    EXPECT_NEAR(dataOf(result).pairs.wi[1][1], 0.6, 1e-7);
  }
}

TEST(Csv, StatesItsConventions) {
  const auto result = readData("conventions.csv");
  const auto& data = dataOf(result);
  EXPECT_TRUE(data.isotropic);
  expectPair(data, 0, {0.5, 0, kThree}, brdf::fromSpherical(brdf::kPi / 3, 3));
  EXPECT_NEAR(data.values[0], 0.5, 1e-15);
  EXPECT_NEAR(data.uncertainty[0], 0.02, 1e-16);
  EXPECT_TRUE(mentions(result.report.assumptions, "quantity: brdf_cos (the file says so)"));
  const auto overridden = readData("conventions.csv", {"quantity=brdf", "symmetry=anisotropic"});
  EXPECT_EQ(dataOf(overridden).values[0], 0.25);
  EXPECT_FALSE(dataOf(overridden).isotropic);
}

TEST(AltaFiles, TheRetroReflectorPeaksInTheMirrorAndTheRetroDirection) {
  const auto path = std::filesystem::path(BRDF_SHARED_DIR) / "data/measured/retro-3M-jaune.dat";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no file " << path;
  const auto result = brdf::readMeasured(path);
  const auto& data = dataOf(result);
  EXPECT_EQ(result.report.samples, 7397u);
  EXPECT_EQ(data.channels, brdf::Channels::monochrome());
  // Lit at 30 degrees the tape sends most back to the light: the largest value lies within 2 degrees of it.
  double largest = 0, cosine = 0;
  for (std::size_t i = 0; i < data.pairs.size(); ++i) {
    const auto& [wi, wo] = data.pairs;
    if (!data.valid[i] || std::abs(wi[2][i] - kThree) > 1e-6 || data.values[i] <= largest) continue;
    largest = data.values[i];
    cosine = wi[0][i] * wo[0][i] + wi[1][i] * wo[1][i] + wi[2][i] * wo[2][i];
  }
  EXPECT_GT(cosine, std::cos(brdf::radians(2)));
  // The value at the peak, from the file's line: 11.4906... over the cosine of the viewer.
  EXPECT_NEAR(largest, 11.49064690026954 / std::cos(std::hypot(0.52354358370989562, 0.018276973248047)), 1e-12);
}
