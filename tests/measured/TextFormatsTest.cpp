#include <brdf/material/ChannelView.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/measured/Format.h>

#include "MeasuredSupport.h"

namespace {

using measuredtest::dataOf;
using measuredtest::errorOf;
using measuredtest::folder;

const std::string kCornell =
    "# a comment\r\n2  # wavelengths follow\r\n450 650\r\n"
    "0.5 0 0.4 3.0 0.1 0.2\r\n"
    "0.5 0 0.4 -2.0\r\n0.3\t0.4\r\n"  // a record may run over lines
    "0.1 0.2 0.3 0.4 0.5 0.6";        // no newline at the end

brdf::ReadResult readText(const std::filesystem::path& dir, const std::string& name, const std::string& text) {
  brdf::writeFile(dir / name, text);
  return brdf::readMeasured(dir / name);
}

}  // namespace

TEST(Cornell, ReadsWavelengthsAnglesAndValues) {
  const auto dir = folder("cornell");
  for (const std::string& mark : {std::string(), std::string("\xEF\xBB\xBF")}) {
    const auto result = readText(dir, "a.brdf", mark + kCornell);
    EXPECT_EQ(result.report.format, "cornell");
    EXPECT_EQ(result.report.samples, 3u);
    EXPECT_EQ(result.report.invalid, 0u);
    for (const std::string& warning : result.report.warnings)  // these values do reflect more than they receive
      EXPECT_TRUE(warning.starts_with("energy:")) << warning;
    const auto& data = dataOf(result);
    EXPECT_EQ(data.channels, brdf::Channels::spectral({450, 650}));
    EXPECT_EQ(data.values, (std::vector<double>{0.1, 0.3, 0.5, 0.2, 0.4, 0.6}));
    const auto wo = brdf::fromSpherical(0.4, -2.0);
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(data.pairs.wo[axis][1], wo[axis]);
    EXPECT_TRUE(data.isotropic);
  }
}

TEST(Cornell, CountsDefectsAndKeepsNoise) {
  const auto result =
      readText(folder("cornell_defects"), "a.brdf",
               "1 550\n0.1 0 0.2 0 nan\n0.1 0 1.6 0 2\n0.1 0 0.3 0 -0.01\n0.1 0 0.4 0 inf\n0.1 0 0.2 1 1\n");
  EXPECT_EQ(result.report.samples, 5u);
  EXPECT_EQ(result.report.notFinite, 2u);
  EXPECT_EQ(result.report.belowHorizon, 1u);
  EXPECT_EQ(result.report.negative, 1u);
  EXPECT_EQ(result.report.invalid, 3u);
  EXPECT_EQ(dataOf(result).valid, (std::vector<std::uint8_t>{0, 0, 1, 0, 1}));
  EXPECT_EQ(dataOf(result).values[2], -0.01);
}

TEST(Cornell, AnglesThatLookLikeDegreesAreWarnedOf) {
  const auto result = readText(folder("cornell_degrees"), "a.brdf", "1 550\n45 0 30 180 1\n");
  ASSERT_FALSE(result.report.warnings.empty());
  EXPECT_NE(result.report.warnings[0].find("degrees"), std::string::npos);
}

TEST(Cornell, BrokenFilesAreErrorsThatNameTheLine) {
  const auto dir = folder("cornell_broken");
  const struct {
    const char *text, *expected;
  } cases[] = {
      {"2 450 650\n0.1 0 0.2 0 1\n", "line 3"},                // a value is missing
      {"2 450 650\n0.1 0 0.2 0 1 x\n", "line 2"},              // no number
      {"2 450 650\n", "no sample"},                            // nothing but a header
      {"2 650 450\n0.1 0 0.2 0 1 1\n", "ascending"},           // wavelengths out of order
      {"1000000000 400\n0.1 0 0.2 0 1\n", "from 1 to 10000"},  // an oversized header
      {"2.5 400\n", "whole number"},
      {"0\n", "from 1 to 10000"},
      {"2 450 650\n0.1 inf 0.2 0 1 1\n", "not finite"},
      {"some words\n", "no number"},
      {"# nothing else\n", "the file ends"},
      {"", "empty"},
  };
  for (const auto& [text, expected] : cases) {
    const std::string error = errorOf([&] { readText(dir, "a.brdf", text); });
    EXPECT_NE(error.find(expected), std::string::npos) << "\"" << text << "\" gave: " << error;
    EXPECT_NE(error.find("a.brdf"), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

TEST(Cornell, RoundTripKeepsValuesExactlyAndDirectionsToRounding) {
  const auto dir = folder("cornell_round_trip");
  const auto first = readText(dir, "a.brdf", kCornell);
  const auto losses = brdf::writeMeasured(*first.brdf, dir / "b.brdf").losses;
  EXPECT_TRUE(losses.empty());
  const auto second = brdf::readMeasured(dir / "b.brdf");
  EXPECT_EQ(dataOf(second).channels, dataOf(first).channels);
  EXPECT_EQ(dataOf(second).values, dataOf(first).values);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(dataOf(second).pairs.wi[axis][i], dataOf(first).pairs.wi[axis][i], 3e-16);
      EXPECT_NEAR(dataOf(second).pairs.wo[axis][i], dataOf(first).pairs.wo[axis][i], 3e-16);
    }
}

TEST(Cornell, WritingAnAnalyticOneSaysWhatIsLost) {
  const auto dir = folder("cornell_analytic");
  const measuredtest::FunctionBrdf function(measuredtest::glossy);
  const auto report = brdf::writeMeasured(function, dir / "a.brdf");
  EXPECT_EQ(report.losses.size(), 2u);  // the grid, and the colour
  const auto back = brdf::readMeasured(dir / "a.brdf");
  const auto wi = brdf::fromSpherical(brdf::radians(30), 0),
             wo = brdf::fromSpherical(brdf::radians(25), brdf::radians(175));
  const auto expected = function.evaluate(wi, wo), value = back.brdf->evaluate(wi, wo);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(value[2 - c], expected[c], 1e-9 * expected[c]);
}

TEST(Csv, RoundTripIsExact) {
  const auto dir = folder("csv_round_trip");
  const auto first = readText(dir, "a.brdf", kCornell);
  brdf::writeMeasured(*first.brdf, dir / "b.csv");
  const auto second = brdf::readMeasured(dir / "b.csv");
  EXPECT_EQ(second.report.format, "csv");
  EXPECT_EQ(dataOf(second).channels, dataOf(first).channels);
  EXPECT_EQ(dataOf(second).isotropic, true);
  EXPECT_EQ(dataOf(second).values, dataOf(first).values);
  EXPECT_EQ(dataOf(second).pairs.wi, dataOf(first).pairs.wi);
  EXPECT_EQ(dataOf(second).pairs.wo, dataOf(first).pairs.wo);
}

TEST(Csv, ColumnsAreFoundByName) {
  const auto result =
      readText(folder("csv_columns"), "a.csv",
               "value_0,note,wo_z,wi_x,wi_y,wi_z,wo_x,wo_y\n0.5,1,1,0,0,1,0,0\n\n0.25,1,0.8,0,0.6,0.8,0.6,0\n");
  EXPECT_EQ(result.report.samples, 2u);
  ASSERT_FALSE(result.report.warnings.empty());
  EXPECT_NE(result.report.warnings[0].find("\"note\" is ignored"), std::string::npos);
  EXPECT_EQ(dataOf(result).channels, brdf::Channels::monochrome());
  EXPECT_EQ(dataOf(result).values, (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(dataOf(result).pairs.wi[1][1], 0.6);
}

TEST(Csv, BrokenFilesAreErrorsThatNameTheLine) {
  const auto dir = folder("csv_broken");
  const std::string header = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z,value_0\n";
  const struct {
    std::string text;
    const char* expected;
  } cases[] = {
      {header, "no sample"},
      {header + "0,0,1,0,0,1\n", "number of columns"},
      {header + "0,0,1,0,0,1,x\n", "no number"},
      {header + "0,0,1,0,0,2,1\n", "unit length"},
      {header + "0,0,1,0,0,nan,1\n", "unit length"},
      {"wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n", "missing"},
      {"wi_x,wi_y,wi_z,wo_x,wo_y,wo_z,value_0,value_2\n", "missing"},
      {"wi_x,wi_y,wi_z,wo_x,wo_y,wo_z,value_0,value_0\n", "twice"},
      {"wi_x,wi_y,wi_z,wo_x,wo_y,wo_z,value_99999999999\n", "column name"},
      {"wi_x,wi_y,wi_z,wo_x,wo_y,wo_z,value_0,value_1\n0,0,1,0,0,1,1,1\n", "no meaning"},
  };
  for (const auto& [text, expected] : cases) {
    const std::string error = errorOf([&] { readText(dir, "a.csv", text); });
    EXPECT_NE(error.find(expected), std::string::npos) << text << " gave: " << error;
    EXPECT_NE(error.find("line "), std::string::npos) << error;
  }
}

TEST(Formats, WrongFilesAreErrorsThatSayWhatIsRead) {
  const auto dir = folder("formats");
  EXPECT_NE(errorOf([&] { brdf::readMeasured(dir / "missing.brdf"); }).find("no such file"), std::string::npos);
  EXPECT_NE(errorOf([&] { brdf::readMeasured(dir); }).find("a folder"), std::string::npos);
  const std::string error = errorOf([&] { readText(dir, "picture.png", std::string("\x89PNG\r\n\x1a\n\0\0\0", 11)); });
  EXPECT_NE(error.find("no format recognises"), std::string::npos) << error;
  EXPECT_NE(error.find("cornell"), std::string::npos) << error;
}

TEST(Formats, ContentDecidesAndNotTheExtension) {
  EXPECT_EQ(readText(folder("formats_content"), "a.csv", kCornell).report.format, "cornell");
}

TEST(Formats, UnwritableTargetsAreErrorsAndLeaveNothing) {
  const auto dir = folder("formats_write");
  const measuredtest::FunctionBrdf function(measuredtest::glossy);
  EXPECT_NE(errorOf([&] { brdf::writeMeasured(function, dir / "a.xyz"); }).find(".csv"), std::string::npos);
  EXPECT_NE(errorOf([&] { brdf::writeMeasured(function, dir / "none" / "a.csv"); }).find("no folder"),
            std::string::npos);
  EXPECT_THROW(brdf::writeMeasured(function, dir / "a.csv", "nonsense"), brdf::Error);
  EXPECT_TRUE(std::filesystem::is_empty(dir));
}

TEST(Formats, OutOfTreeFormatsJoinTheRegistry) {
  brdf::Format format;
  format.name = "outside";
  format.extension = ".outside";
  format.recognise = [](std::string_view head, std::uint64_t) { return head.starts_with("OUTSIDE") ? 100 : 0; };
  format.read = [](std::string_view, const std::filesystem::path&, const brdf::ReadOptions&) {
    return brdf::ReadResult{std::make_shared<measuredtest::FunctionBrdf>(measuredtest::glossy), {}};
  };
  brdf::registerFormat(format);
  const auto dir = folder("formats_outside");
  EXPECT_EQ(readText(dir, "a.dat", "OUTSIDE").report.format, "outside");
  const std::string error =
      errorOf([&] { brdf::writeMeasured(measuredtest::FunctionBrdf(measuredtest::glossy), dir / "a.outside"); });
  EXPECT_FALSE(error.empty());
}

TEST(CornellFiles, LuminanceHasTheRmsThatTheReferenceGives) {
  // ../shared/reference/best_fits.json, "zero_model": computed with the analytic yBar of Wyman et al., hence 0.5 %.
  const struct {
    const char* name;
    double rms, rmsCos;
  } cases[] = {{"garnet_red", 0.8678691279858068, 0.1729584303781394},
               {"acryl_blue", 0.7431901421366011, 0.22741635499646345}};
  for (const auto& [name, rms, rmsCos] : cases) {
    const auto path = std::filesystem::path(BRDF_SHARED_DIR) / "data/measured" / (std::string(name) + ".brdf");
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no file " << path;
    const auto result = brdf::readMeasured(path);
    EXPECT_EQ(result.report.samples, 1439u);
    EXPECT_EQ(result.report.invalid, 0u);
    ASSERT_EQ(result.brdf->channels().count(), 31u);
    EXPECT_EQ(result.brdf->channels().wavelengths.front(), 400);
    EXPECT_EQ(result.brdf->channels().wavelengths.back(), 700);
    const auto luminance = brdf::asLuminance(result.brdf);
    EXPECT_NEAR(measuredtest::rmsOfSamples(*luminance, 0), rms, 0.005 * rms);
    EXPECT_NEAR(measuredtest::rmsOfSamples(*luminance, 1), rmsCos, 0.005 * rmsCos);
  }
}
