#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/io/ImageFile.h>
#include <brdf/io/ToneMap.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "../TestFolder.h"

namespace fs = std::filesystem;
using brdf::Image;

namespace {

fs::path freshFolder(const char* name) { return testFolder(name); }

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const brdf::Error& error) {
    return error.what();
  }
  return {};
}

const std::string hdrHeader = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X ";

}  // namespace

TEST(ImageFile, ExrRoundTripKeepsEveryFloat) {
  const fs::path folder = freshFolder("roundtrip");
  for (std::size_t channels : {1u, 3u, 4u}) {
    Image image(7, 5, channels);
    for (std::size_t i = 0; i < image.values.size(); ++i)
      image.values[i] = std::ldexp(1.0f + 0.37f * static_cast<float>(i), static_cast<int>(i % 60) - 30);
    image.values[0] = std::numeric_limits<float>::max();
    image.values[1] = -1e-30f;
    brdf::writeExr(image, folder / "a.exr");
    const Image back = brdf::readImage(folder / "a.exr");
    EXPECT_EQ(back.width, 7u);
    EXPECT_EQ(back.height, 5u);
    EXPECT_EQ(back.channels, channels);
    EXPECT_EQ(back.values, image.values);
  }
}

TEST(ImageFile, ShippedEnvironmentMapsRead) {
  for (const char* name : {"studio", "sunset", "venice"}) {
    const Image image =
        brdf::readImage(fs::path(BRDF_SOURCE_DIR) / "datasets/environments" / (std::string(name) + ".exr"));
    EXPECT_EQ(image.width, 512u);
    EXPECT_EQ(image.height, 256u);
    EXPECT_EQ(image.channels, 3u);
  }
}

TEST(ImageFile, TruncatedOrDamagedExrIsAnErrorThatNamesTheFile) {
  const fs::path folder = freshFolder("damaged");
  Image image(64, 64, 3);
  for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = std::sin(static_cast<float>(i));
  brdf::writeExr(image, folder / "good.exr");
  const std::string good = brdf::readFile(folder / "good.exr");
  for (std::size_t length : {4u, 20u, 100u, 300u, 2000u, 10000u}) {
    ASSERT_LT(length, good.size());
    brdf::writeFile(folder / "cut.exr", good.substr(0, length));
    EXPECT_NE(messageOf([&] { brdf::readImage(folder / "cut.exr"); }).find("cut.exr"), std::string::npos) << length;
  }
  brdf::writeFile(folder / "empty.exr", "");
  EXPECT_THROW(brdf::readImage(folder / "empty.exr"), brdf::Error);
  brdf::writeFile(folder / "text.exr", "hello, this is not a picture");
  EXPECT_THROW(brdf::readImage(folder / "text.exr"), brdf::Error);
  EXPECT_THROW(brdf::readImage(folder / "missing.exr"), brdf::Error);
}

TEST(ImageFile, HugeExrHeaderIsRefusedBeforeMemoryIsTaken) {
  const fs::path folder = freshFolder("huge");
  brdf::writeExr(Image(4, 4, 3), folder / "small.exr");
  std::string bytes = brdf::readFile(folder / "small.exr");
  const auto window = bytes.find(std::string("dataWindow\0box2i\0", 17));
  ASSERT_NE(window, std::string::npos);
  const auto setMaximum = [&](std::int32_t x, std::int32_t y) {  // box2i: xMin, yMin, xMax, yMax after the size
    std::memcpy(bytes.data() + window + 17 + 4 + 8, &x, 4);
    std::memcpy(bytes.data() + window + 17 + 4 + 12, &y, 4);
    brdf::writeFile(folder / "huge.exr", bytes);
  };
  setMaximum(9999, 9999);
  EXPECT_THROW(brdf::readImage(folder / "huge.exr"), brdf::Error);
  setMaximum(2000000000, 2000000000);
  EXPECT_THROW(brdf::readImage(folder / "huge.exr"), brdf::Error);
}

TEST(ImageFile, UnwritableExrLeavesNothingBehind) {
  const fs::path folder = freshFolder("unwritable");
  EXPECT_THROW(brdf::writeExr(Image(2, 2, 3), folder / "no-such-folder" / "a.exr"), brdf::Error);
  EXPECT_THROW(brdf::writeExr(Image(2, 2, 2), folder / "two.exr"), brdf::Error);
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST(ImageFile, RgbeMantissaIsTakenAtItsMiddle) {
  // (128 + 1/2) 2^(129 - 136), (64 + 1/2) 2^-7, (1 / 2) 2^-7; an exponent of 0 is black.
  const std::string bytes = hdrHeader + "2\n" + std::string("\x80\x40\x00\x81\xff\xff\xff\x00", 8);
  const Image image = brdf::readRadianceHdr(bytes, "a.hdr");
  EXPECT_FLOAT_EQ(image.values[0], 128.5f / 128);
  EXPECT_FLOAT_EQ(image.values[1], 64.5f / 128);
  EXPECT_FLOAT_EQ(image.values[2], 0.5f / 128);
  EXPECT_EQ(image.values[3], 0.0f);
}

TEST(ImageFile, RunLengthCodedHdrEqualsThePlainOne) {
  // Ten pixels: seven of (10, 20, 30, 130), three of (1, 2, 3, 131).
  std::string plain = hdrHeader + "10\n", planes = plain, old = plain;
  for (int i = 0; i < 10; ++i) plain += i < 7 ? "\x0a\x14\x1e\x82" : "\x01\x02\x03\x83";
  planes += std::string("\x02\x02\x00\x0a", 4);
  for (const char* plane : {"\x87\x0a\x03\x01\x01\x01", "\x87\x14\x83\x02", "\x87\x1e\x83\x03", "\x87\x82\x83\x83"})
    planes += plane;
  old += std::string("\x0a\x14\x1e\x82\x01\x01\x01\x06\x01\x02\x03\x83\x01\x01\x01\x02", 16);
  const Image image = brdf::readRadianceHdr(plain, "a.hdr");
  EXPECT_EQ(brdf::readRadianceHdr(planes, "a.hdr").values, image.values);
  EXPECT_EQ(brdf::readRadianceHdr(old, "a.hdr").values, image.values);
}

TEST(ImageFile, HdrExposureIsDividedOut) {
  const std::string pixel = "\x80\x80\x80\x81";
  const Image image =
      brdf::readRadianceHdr("#?RGBE\nEXPOSURE=4\nEXPOSURE=0.5\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + pixel, "a.hdr");
  EXPECT_FLOAT_EQ(image.values[0], 128.5f / 128 / 2);
}

TEST(ImageFile, BadHdrFilesAreErrors) {
  for (const std::string& bytes :
       {std::string("#?RADIANCE\n"), hdrHeader, hdrHeader + "x\n", hdrHeader + "-3\n", hdrHeader + "1e9\n",
        hdrHeader + "100\nabc", hdrHeader + "20000\n\x01\x01\x01\x01",
        hdrHeader + std::string("9\n\x02\x02\x00\x09\xff\x01", 8), hdrHeader + "1\n\x01\x01\x01\x01",
        std::string("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nabcd"),
        std::string("#?RADIANCE\nEXPOSURE=0\n\n-Y 1 +X 1\nabcd"), std::string("#?RADIANCE\n\n+X 1 -Y 1\nabcd")})
    EXPECT_NE(messageOf([&] { brdf::readRadianceHdr(bytes, "bad.hdr"); }).find("bad.hdr"), std::string::npos) << bytes;
}

TEST(ToneMap, SrgbCodesMatchTheStandard) {
  // IEC 61966-2-1: linear 0.2140 is code 127.5 of 255, 0.5 is 187.5 (0.735357), 0.0031308 the joint of the two pieces.
  EXPECT_NEAR(brdf::srgbEncoded(0.5), 0.7353569, 1e-6);
  EXPECT_NEAR(brdf::srgbEncoded(0.0031308), 0.0404499, 1e-6);
  Image image(8, 1, 1);
  image.values = {0, -1, 0.5f, 1, 7, std::numeric_limits<float>::infinity(), std::nanf(""), 0.001f};
  const auto codes = brdf::toneMapped(image, 0, brdf::ToneCurve::Clamp);
  EXPECT_EQ(codes, (std::vector<std::uint8_t>{0, 0, 188, 255, 255, 255, 0, 3}));
}

TEST(ToneMap, EveryCodeIsTheRoundedEncoding) {
  Image image(4096, 1, 1);
  for (std::size_t i = 0; i < image.width; ++i) image.values[i] = static_cast<float>(i) / 4096;
  for (auto curve : {brdf::ToneCurve::Clamp, brdf::ToneCurve::Reinhard, brdf::ToneCurve::Aces}) {
    const auto codes = brdf::toneMapped(image, 1, curve);
    for (std::size_t i = 0; i < image.width; ++i) {
      const double x = 2.0 * double(image.values[i]);
      const double y = curve == brdf::ToneCurve::Clamp      ? x
                       : curve == brdf::ToneCurve::Reinhard ? x / (1 + x)
                                                            : x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
      EXPECT_NEAR(codes[i], 255 * brdf::srgbEncoded(y), 0.501);
    }
  }
}
