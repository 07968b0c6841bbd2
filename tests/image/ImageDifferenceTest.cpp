#include <brdf/base/Error.h>
#include <brdf/io/ImageDifference.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brdf {
namespace {

Image ramp(std::size_t width, std::size_t height) {
  Image image(width, height, 3);
  for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<float>(i);
  return image;
}

TEST(ImageDifference, OfAPictureToItselfIsNothing) {
  Image image = ramp(5, 4);
  image.pixel(2, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  image.pixel(3, 1)[1] = std::numeric_limits<float>::infinity();
  const ImageDifference difference = imageDifference(image, image, {0, 0, 0});
  EXPECT_TRUE(difference.within);
  EXPECT_EQ(difference.outliers, 0u);
  EXPECT_EQ(difference.worst, 0);
  EXPECT_EQ(difference.rms, 0);
}

TEST(ImageDifference, CountsPixelsBeyondTheToleranceAndFindsTheWorst) {
  const Image baseline = ramp(10, 10);
  Image image = baseline;
  image.pixel(4, 3)[1] += 2;  // of 103: 2 / (0.5 + 1.03) = 1.307 times the tolerance
  image.pixel(7, 8)[0] -= 6;  // of 261: 6 / (0.5 + 2.61) = 1.929
  image.pixel(9, 9)[2] += 1;  // of 299: 1 / (0.5 + 2.99), within
  const ImageTolerance tolerance{0.5, 0.01, 0.015};
  const ImageDifference difference = imageDifference(image, baseline, tolerance);
  EXPECT_EQ(difference.outliers, 2u);
  EXPECT_NEAR(difference.worst, 6 / 3.11, 1e-12);
  EXPECT_EQ(difference.worstX, 7u);
  EXPECT_EQ(difference.worstY, 8u);
  EXPECT_NEAR(difference.rms, std::sqrt((4 + 36 + 1) / 300.0), 1e-12);
  EXPECT_FALSE(difference.within) << "2 of 100 pixels, 1.5 allowed";
  EXPECT_TRUE(imageDifference(image, baseline, {0.5, 0.01, 0.02}).within);
}

TEST(ImageDifference, WhatIsNotFiniteInOnePictureAloneIsFarther) {
  const Image baseline = ramp(3, 3);
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Image image = baseline;
    image.pixel(1, 2)[0] = bad;
    for (const auto& [a, b] : {std::pair{image, baseline}, std::pair{baseline, image}}) {
      const ImageDifference difference = imageDifference(a, b, {1e9, 1, 0});
      EXPECT_FALSE(difference.within);
      EXPECT_EQ(difference.outliers, 1u);
      EXPECT_TRUE(std::isinf(difference.worst));
      EXPECT_EQ(difference.rms, 0) << "over what is finite in both";
    }
  }
}

TEST(ImageDifference, RefusesWhatCannotBeCompared) {
  EXPECT_THROW(imageDifference(ramp(3, 4), ramp(4, 3), {}), Error);
  EXPECT_THROW(imageDifference({}, {}, {}), Error);
  for (const ImageTolerance& wrong : {ImageTolerance{-1, 0, 0}, ImageTolerance{0, -1, 0}, ImageTolerance{0, 0, 1.5},
                                      ImageTolerance{std::nan(""), 0, 0}})
    EXPECT_THROW(imageDifference(ramp(2, 2), ramp(2, 2), wrong), Error);
}

}  // namespace
}  // namespace brdf
