#include <brdf/color/Colorimetry.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/material/TableBrdf.h>

#include "MeasuredSupport.h"

namespace {

using brdf::Channels;

/// Two samples at 31 wavelengths; the second is invalid.
brdf::BrdfPointer spectral(const std::function<double(double nanometres)>& spectrum) {
  brdf::ScatteredSamples samples;
  std::vector<double> wavelengths;
  for (int i = 0; i < 31; ++i) wavelengths.push_back(400 + 10 * i);
  samples.channels = Channels::spectral(wavelengths);
  samples.pairs.push(brdf::fromSpherical(0.5, 0), brdf::fromSpherical(0.5, 3.1));
  samples.pairs.push(brdf::fromSpherical(0.3, 0), brdf::fromSpherical(0.2, 3.1));
  for (const double wavelength : wavelengths) samples.values.insert(samples.values.end(), {spectrum(wavelength), 7.0});
  samples.valid = {1, 0};
  return std::make_shared<brdf::ScatteredBrdf>(std::move(samples), "two samples");
}

std::vector<double> firstSample(const brdf::Brdf& brdf) {
  std::vector<double> values(brdf.channels().count());
  brdf.samples()->read(0, 1, nullptr, values.data(), nullptr);
  return values;
}

}  // namespace

TEST(ChannelView, WhiteIsWhiteAsRgbAndOneInLuminance) {
  const auto white = spectral([](double) { return 1.0; });
  for (const double value : firstSample(*brdf::asRgb(white))) EXPECT_NEAR(value, 1, 1e-14);
  EXPECT_NEAR(firstSample(*brdf::asLuminance(white))[0], 1, 1e-14);
}

TEST(ChannelView, ColourComesOutOnSamplesAsInEvaluation) {
  const auto red = brdf::asRgb(spectral([](double w) { return w > 600 ? 0.8 : 0.05; }));
  EXPECT_EQ(red->channels(), Channels::rgb());
  const auto sample = firstSample(*red);
  EXPECT_GT(sample[0], 3 * sample[1]);
  const auto value = red->evaluate(brdf::fromSpherical(0.5, 0), brdf::fromSpherical(0.5, 3.1));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(value[c], sample[c], 1e-12);
}

TEST(ChannelView, InvalidStaysInvalid) {
  const auto view = brdf::asLuminance(spectral([](double) { return 1.0; }));
  std::uint8_t valid[2];
  double values[2];
  view->samples()->read(0, 2, nullptr, values, valid);
  EXPECT_EQ(valid[0], 1);
  EXPECT_EQ(valid[1], 0);
  EXPECT_EQ(values[1], 0);
}

TEST(ChannelView, WhatNeedsNoChangeIsTheSameObject) {
  const brdf::BrdfPointer rgb = std::make_shared<measuredtest::FunctionBrdf>(measuredtest::glossy);
  EXPECT_EQ(brdf::asRgb(rgb), rgb);
  const brdf::BrdfPointer grey =
      std::make_shared<measuredtest::FunctionBrdf>(measuredtest::glossy, Channels::monochrome());
  EXPECT_EQ(brdf::asLuminance(grey), grey);
  const auto threefold = brdf::asRgb(grey)->evaluate(brdf::fromSpherical(0.5, 0), brdf::fromSpherical(0.4, 3));
  EXPECT_EQ(threefold[0], threefold[1]);
  EXPECT_EQ(threefold[0], threefold[2]);
  EXPECT_GT(threefold[0], 0);
}

TEST(ChannelView, SelectedChannelsAreTheSourcesOwn) {
  const auto source = spectral([](double w) { return w; });
  const auto some = brdf::selectedChannels(source, std::vector<std::size_t>{3, 10});
  EXPECT_EQ(some->channels(), Channels::spectral({430, 500}));
  EXPECT_EQ(firstSample(*some), (std::vector<double>{430, 500}));
}

TEST(ChannelView, WrongSelectionsAreErrors) {
  const auto source = spectral([](double w) { return w; });
  EXPECT_NE(
      measuredtest::errorOf([&] { brdf::selectedChannels(source, std::vector<std::size_t>{31}); }).find("0 to 30"),
      std::string::npos);
  EXPECT_THROW(brdf::selectedChannels(source, std::vector<std::size_t>{}), brdf::Error);
  EXPECT_THROW(brdf::selectedChannels(source, std::vector<std::size_t>{5, 5}), brdf::Error);
  const brdf::BrdfPointer rgb = std::make_shared<measuredtest::FunctionBrdf>(measuredtest::glossy);
  EXPECT_THROW(brdf::selectedChannels(rgb, std::vector<std::size_t>{0, 2}), brdf::Error);
}

TEST(ChannelView, ColoursFollowTheSettings) {
  const auto white = spectral([](double) { return 1.0; });
  const auto red = spectral([](double w) { return w > 600 ? 0.8 : 0.05; });
  const auto a = brdf::colourSettings({"A", "10", "bradford"}), bare = brdf::colourSettings({"A", "2", "none"});
  for (const double value : firstSample(*brdf::asRgb(white, a))) EXPECT_NEAR(value, 1, 1e-14);
  EXPECT_GT(firstSample(*brdf::asRgb(red, a))[0], firstSample(*brdf::asRgb(red))[0]);
  EXPECT_GT(firstSample(*brdf::asRgb(white, bare))[0], 1.3);
  EXPECT_LT(firstSample(*brdf::asRgb(white, bare))[2], 0.5);
  EXPECT_GT(firstSample(*brdf::asLuminance(red, a))[0], 1.3 * firstSample(*brdf::asLuminance(red))[0]);
}

TEST(ChannelView, ReducedTablesKeepTheirCells) {
  brdf::TableData data;
  data.layout.thetaH = 3;
  data.layout.thetaD = 3;
  data.layout.phiD = 4;
  data.channels = Channels::spectral({450, 550, 650});
  const std::size_t cells = data.layout.cells();
  for (std::size_t i = 0; i < 3 * cells; ++i) data.values.push_back(0.1 + 0.01 * static_cast<double>(i));
  data.valid.assign(cells, 1);
  data.valid[5] = brdf::stateByte(brdf::CellState::Extrapolated);
  data.valid[7] = 0;
  const auto source = std::make_shared<brdf::TableBrdf>(data, "table");
  const auto settings = brdf::colourSettings({"F2", "2", "bradford"});
  const auto reduced = brdf::reducedToRgb(source, settings);
  const auto& table = dynamic_cast<const brdf::TableBrdf&>(*reduced);
  EXPECT_EQ(table.data().valid, data.valid);
  const auto weights = brdf::rgbWeights(data.channels.wavelengths, settings);
  for (std::size_t c = 0; c < 3; ++c) {
    double expected = 0;
    for (std::size_t k = 0; k < 3; ++k) expected += weights[3 * c + k] * source->data().values[k * cells + 2];
    EXPECT_NEAR(table.data().values[c * cells + 2], expected, 1e-15);
  }
}

TEST(ChannelView, SpectralLobesBecomeColouredLobes) {
  const auto channels = Channels::spectral({450, 550, 650});
  const auto sum = brdf::parseMaterialExpression("(0.1,0.2,0.6)*Lambertian + 0.5*GGX(alpha=0.3)", channels);
  for (const char* adaptation : {"bradford", "none"}) {
    const auto settings = brdf::colourSettings({"A", "2", adaptation});
    const auto lobes = brdf::lobesAsRgb(*sum, settings);
    ASSERT_TRUE(lobes);
    const auto wi = brdf::fromSpherical(0.5, 0), wo = brdf::fromSpherical(0.4, 3);
    const auto expected = brdf::asRgb(sum, settings)->evaluate(wi, wo), found = lobes->evaluate(wi, wo);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-13) << adaptation;
  }
  EXPECT_FALSE(brdf::lobesAsRgb(*brdf::parseMaterialExpression("GGX(alpha=(0.1,0.2,0.3))", channels)));
  EXPECT_FALSE(brdf::lobesAsRgb(*brdf::parseMaterialExpression("(0,1,0)*Lambertian", channels)));  // outside sRGB
}
