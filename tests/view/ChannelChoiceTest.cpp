#include "SimpleBrdfs.h"

#include <brdf/base/Error.h>
#include <brdf/view/ChannelChoice.h>

#include <gtest/gtest.h>

namespace brdf {
namespace {

BrdfPointer constant(double value, Channels channels) {
  return std::make_shared<test::FunctionBrdf>(test::constantBrdf(value, std::move(channels)));
}

double shown(const ChannelChoice& choice) {
  const auto values = choice.brdf->evaluate({0, 0, 1}, {0, 0, 1});
  EXPECT_EQ(values.size(), choice.weights.size());
  double sum = 0;
  for (std::size_t c = 0; c < values.size(); ++c) sum += choice.weights[c] * values[c];
  return sum;
}

TEST(ChannelChoice, AGreyHasTheSameLengthInEveryChoice) {
  const Channels spectral = Channels::spectral({400, 500, 550, 600, 700});
  for (const char* choice : {"luminance", "rgb", "2", "550nm"})
    EXPECT_NEAR(shown(chooseChannels(constant(0.25, spectral), choice)), 0.25, 1e-14) << choice;
  for (const char* choice : {"luminance", "rgb", "0"})
    EXPECT_NEAR(shown(chooseChannels(constant(0.25, {}), choice)), 0.25, 1e-14) << choice;
}

TEST(ChannelChoice, AWavelengthIsTheNearestMeasuredOne) {
  const auto brdf = constant(1, Channels::spectral({400, 500, 600}));
  EXPECT_EQ(chooseChannels(brdf, "540nm").label, "500 nm");
  EXPECT_EQ(chooseChannels(brdf, "560 nm").label, "600 nm");
  EXPECT_EQ(chooseChannels(brdf, "1").label, "500 nm");
  EXPECT_EQ(chooseChannels(constant(1, Channels::rgb()), "1").label, "channel 1");
}

TEST(ChannelChoice, RefusesWhatIsNotThere) {
  const auto rgb = constant(1, Channels::rgb());
  for (const char* choice : {"3", "-1", "1.5", "", "red", "550nm", "nan"})
    EXPECT_THROW(chooseChannels(rgb, choice), Error) << choice;
  const auto spectral = constant(1, Channels::spectral({400, 500, 600}));
  for (const char* choice : {"399nm", "601nm", "nm", "nannm"}) EXPECT_THROW(chooseChannels(spectral, choice), Error);
}

}  // namespace
}  // namespace brdf
