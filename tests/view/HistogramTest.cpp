#include <brdf/base/Error.h>
#include <brdf/view/Histogram.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

namespace brdf {
namespace {

std::uint64_t total(const Histogram& histogram) {
  return std::accumulate(histogram.count.begin(), histogram.count.end(), std::uint64_t{0});
}

TEST(Histogram, EqualBinsFromZeroForNumbersOfOneSize) {
  const std::vector<double> values{1, 2, 2.5, 3, 4};
  const Histogram histogram = makeHistogram(values, {}, 4);
  EXPECT_FALSE(histogram.logarithmic);
  EXPECT_EQ(histogram.edges, (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(histogram.count, (std::vector<std::uint64_t>{0, 1, 2, 2}));  // the last edge belongs to the last bin
  EXPECT_NEAR(histogram.share[3], 0.4, 1e-15);
}

TEST(Histogram, SignedNumbersKeepTheirSign) {
  const std::vector<double> values{-1, 0, 1, 1000};
  const Histogram histogram = makeHistogram(values, {}, 10);
  EXPECT_FALSE(histogram.logarithmic);
  EXPECT_EQ(histogram.edges.front(), -1);
  EXPECT_EQ(histogram.edges.back(), 1000);
  EXPECT_EQ(histogram.count.front(), 3u);
}

TEST(Histogram, NumbersOfManySizesHaveEqualRatios) {
  std::vector<double> values{0, 0, 1e-30};
  for (int k = 0; k < 1000; ++k) values.push_back(std::pow(10, -k / 100.0));
  const Histogram histogram = makeHistogram(values, {}, 16);
  ASSERT_TRUE(histogram.logarithmic);
  EXPECT_NEAR(histogram.edges[0], 1e-8, 1e-20);  // eight decades; what is smaller is in the first bin
  for (std::size_t k = 0; k < 16; ++k) EXPECT_NEAR(histogram.edges[k + 1] / histogram.edges[k], std::sqrt(10.0), 1e-9);
  EXPECT_EQ(total(histogram), values.size());
  EXPECT_NEAR(std::accumulate(histogram.share.begin(), histogram.share.end(), 0.0), 1, 1e-12);
}

TEST(Histogram, DegenerateNumbers) {
  EXPECT_TRUE(makeHistogram({}, {}, 5).count.empty());
  EXPECT_EQ(makeHistogram(std::array{3.0}, {}, 5).count, (std::vector<std::uint64_t>{1}));
  EXPECT_EQ(makeHistogram(std::array{0.0, 0.0}, {}, 5).count, (std::vector<std::uint64_t>{2}));
  EXPECT_EQ(total(makeHistogram(std::array{0.0, 0.0, 0.0, 7.0}, {}, 5)), 4u);
  EXPECT_THROW(makeHistogram(std::array{1.0}, {}, 0), Error);
  EXPECT_THROW(makeHistogram(std::array{1.0}, {}, 10'001), Error);
}

TEST(Distribution, QuantilesAreOrderStatisticsAndFollowTheWeights) {
  std::vector<double> values(100);
  for (std::size_t k = 0; k < 100; ++k) values[k] = static_cast<double>((k * 37) % 100 + 1);  // 1 to 100, shuffled
  const Distribution distribution(values, {});
  for (const auto& [share, value] : {std::pair{0.0, 1.0}, {0.01, 1.0}, {0.5, 50.0}, {0.95, 95.0}, {1.0, 100.0}})
    EXPECT_EQ(distribution.quantile(share), value) << share;
  const Distribution weighted(std::array{2.0, 3.0, 1.0}, std::array{0.0, 9.0, 1.0});
  EXPECT_EQ(weighted.quantile(0.05), 1);
  EXPECT_EQ(weighted.quantile(0.5), 3);
  EXPECT_EQ(Distribution({}, {}).quantile(0.5), 0);
}

}  // namespace
}  // namespace brdf
