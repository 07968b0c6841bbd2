#include <brdf/base/Text.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

TEST(Text, NumbersParseWholeOrNotAtAll) {
  EXPECT_EQ(brdf::parseNumber(" 1.5e-3\r"), 1.5e-3);
  EXPECT_EQ(brdf::parseNumber("+2"), 2.0);
  EXPECT_EQ(brdf::parseNumber("-.5"), -.5);
  for (const char* bad : {"", "1,5", "1 2", "+-2", "0x10", "1e", "abc"}) EXPECT_FALSE(brdf::parseNumber(bad)) << bad;
  EXPECT_TRUE(std::isnan(*brdf::parseNumber("nan")));
}

TEST(Text, NumbersOutOfRangeBecomeZeroOrInfinity) {
  EXPECT_EQ(brdf::parseNumber("1e-999"), 0.0);
  EXPECT_EQ(brdf::parseNumber("-1e999"), -std::numeric_limits<double>::infinity());
}

TEST(Text, FormattedNumbersReadBackExactly) {
  for (double value : {0.1, 1.0 / 3, 6.02e23, 5e-324, -0.0, 1e22})
    EXPECT_EQ(brdf::parseNumber(brdf::formatNumber(value)), value);
  EXPECT_EQ(brdf::formatNumber(1.0 / 3, 3), "0.333");
}

TEST(Text, SplitKeepsEmptyPieces) {
  const auto pieces = brdf::split(" a ,, b", ',');
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[0], "a");
  EXPECT_EQ(pieces[1], "");
  EXPECT_EQ(pieces[2], "b");
}
