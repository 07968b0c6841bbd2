#include <brdf/base/Error.h>
#include <brdf/fit/Fit.h>
#include <brdf/fit/Metric.h>

#include <gtest/gtest.h>

#include <cmath>

namespace brdf {
namespace {

double value(const Metric& metric, double f, double cosine) {
  double g = 0;
  metric.transform(&f, &cosine, 1, &g);
  return g;
}

TEST(Metric, NamesAreTheContractOfTheCommandLine) {
  EXPECT_EQ(metricNames(), (std::vector<std::string>{"rms", "rms_cos", "log", "cuberoot"}));
}

TEST(Metric, TransformsAreThoseOfTheCommandLineContract) {
  EXPECT_DOUBLE_EQ(value(findMetric("rms"), 3, 0.5), 3);
  EXPECT_DOUBLE_EQ(value(findMetric("rms_cos"), 3, 0.5), 1.5);
  EXPECT_DOUBLE_EQ(value(findMetric("log"), 3, 0.5), std::log(2.5));
  EXPECT_DOUBLE_EQ(value(findMetric("cuberoot"), 16, 0.5), 2);
  EXPECT_DOUBLE_EQ(value(findMetric("cuberoot"), -16, 0.5), -2);
}

TEST(Metric, SlopesAgreeWithDifferencesAndInversesUndoTheTransforms) {
  for (const Metric& metric : allMetrics())
    for (const double f : {1e-3, 0.04, 1.0, 250.0})
      for (const double cosine : {0.05, 0.5, 1.0}) {
        double slope = 0, back = 0;
        metric.derivative(&f, &cosine, 1, &slope);
        const double step = 1e-5 * f;
        const double difference = (value(metric, f + step, cosine) - value(metric, f - step, cosine)) / (2 * step);
        EXPECT_NEAR(slope, difference, 1e-8 * std::abs(difference)) << metric.name << " at " << f;
        const double g = value(metric, f, cosine);
        metric.inverse(&g, &cosine, 1, &back);
        EXPECT_NEAR(back, f, 1e-13 * f) << metric.name;
      }
}

TEST(Metric, EverythingIsFiniteForEveryFiniteValue) {
  for (const Metric& metric : allMetrics())
    for (const double f : {-1e6, -1.0, -1e-300, 0.0, 1e-300, 1e12}) {
      const double cosine = 1e-9;
      double slope = 0;
      metric.derivative(&f, &cosine, 1, &slope);
      EXPECT_TRUE(std::isfinite(slope) && std::isfinite(value(metric, f, cosine))) << metric.name << " at " << f;
    }
}

TEST(Metric, AnUnknownNameIsAnErrorThatListsTheKnownOnes) {
  try {
    findMetric("l7");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Value);
    EXPECT_EQ(error.details().found, "l7");
    EXPECT_EQ(error.details().allowed, "rms, rms_cos, log, cuberoot");
  }
}

}  // namespace
}  // namespace brdf
