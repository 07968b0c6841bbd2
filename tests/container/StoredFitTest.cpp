#include <brdf/fit/StoredFit.h>
#include <gtest/gtest.h>

#include <cmath>

#include "Samples.h"

using samples::errorOf;
using samples::freshFolder;

TEST(StoredFit, AReportComesBackWithItsMaterial) {
  brdf::FitReport written;
  written.material = brdf::parseMaterialExpression("(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)");
  written.metric = "rms_cos";
  written.optimizer = "lm";
  written.strategy = "separable";
  written.error = 1.0 / 3;
  written.metrics = {{"rms", 0.1}, {"rms_cos", 1.0 / 3}};
  written.zeroModel = {{"rms", 0.7}, {"rms_cos", 0.9}};
  written.seconds = 0.125;
  written.evaluations = 17;
  written.iterations = 9;
  written.samples = 1439;
  written.channels = 3;
  written.converged = true;
  written.termination = "the steps became small";
  written.notes = {"one", "alpha is at its bound"};
  written.parameters.resize(2);
  written.parameters[0] = {"scale", "Lambertian", 0, 2, 0.05, 1e-4, 0, 1e9, false, false};
  written.parameters[1] = {"alpha", "GGX", 1, std::nullopt, 0.2, std::nullopt, 1e-4, 1, true, true};

  written.metricFormula = "f - t";
  written.sampling = "all";
  written.weights = "none";
  written.channelNames = "rgb";
  written.maximumTheta = 75;
  written.offered = 2000;
  written.constantModel = {0.1, 0.2, 0.3};
  written.constantError = 0.5;
  written.covariance = {{0, 1}, {1, 0.5, 0.5, 2}};
  written.history = {{0, 1, 0.5}, {1, 7, 0.25}};
  written.regions = {{"retro", 20, 0.1, 0.75, -0.02, 0.3}};
  written.worst = {{{0, 0.6, 0.8}, {0.6, 0, 0.8}, 2, 1.5, 1.25, 0.125}};
  written.degrees = 8;
  written.aic = -120;
  written.bic = -100;
  written.crossValidation = brdf::CrossValidation{0.3, 0.01, {0.2, 0.4}};

  const auto path = freshFolder("fit") / "a.vtkhdf";
  brdf::ContainerWriter writer(path);
  const brdf::h5::Group open = writer.add("fit", *written.material, {});  // left open past the commit
  brdf::storeFit(open, written);
  brdf::storeFit(writer.add("nothing fitted", *written.material, {}), {});
  writer.add("no fit", *written.material, {});
  writer.commit();

  const brdf::Container container(path);
  EXPECT_TRUE(container.entries()[0].isFit);
  EXPECT_FALSE(container.entries()[2].isFit);
  const brdf::FitReport read = brdf::loadFit(container, 0);
  EXPECT_EQ(read.material->description(), written.material->description());
  EXPECT_EQ(read.metric, written.metric);
  EXPECT_EQ(read.optimizer, written.optimizer);
  EXPECT_EQ(read.strategy, written.strategy);
  EXPECT_EQ(read.error, written.error);
  EXPECT_EQ(read.metrics, written.metrics);
  EXPECT_EQ(read.zeroModel, written.zeroModel);
  EXPECT_EQ(read.seconds, written.seconds);
  EXPECT_EQ(read.evaluations, written.evaluations);
  EXPECT_EQ(read.iterations, written.iterations);
  EXPECT_EQ(read.samples, written.samples);
  EXPECT_EQ(read.channels, written.channels);
  EXPECT_EQ(read.converged, written.converged);
  EXPECT_EQ(read.termination, written.termination);
  EXPECT_EQ(read.notes, written.notes);
  EXPECT_EQ(read.metricFormula, written.metricFormula);
  EXPECT_EQ(read.sampling, written.sampling);
  EXPECT_EQ(read.weights, written.weights);
  EXPECT_EQ(read.channelNames, written.channelNames);
  EXPECT_EQ(read.maximumTheta, written.maximumTheta);
  EXPECT_EQ(read.offered, written.offered);
  EXPECT_EQ(read.constantModel, written.constantModel);
  EXPECT_EQ(read.constantError, written.constantError);
  EXPECT_EQ(read.covariance.parameters, written.covariance.parameters);
  EXPECT_EQ(read.covariance.matrix, written.covariance.matrix);
  EXPECT_NEAR(read.covariance.correlations()[1], 0.5 / std::sqrt(2), 1e-15);
  ASSERT_EQ(read.history.size(), 2u);
  EXPECT_EQ(read.history[1].run, 1u);
  EXPECT_EQ(read.history[1].iteration, 7u);
  EXPECT_EQ(read.history[1].error, 0.25);
  ASSERT_EQ(read.regions.size(), 1u);
  EXPECT_EQ(read.regions[0].region, "retro");
  EXPECT_EQ(read.regions[0].samples, 20u);
  EXPECT_EQ(read.regions[0].share, 0.75);
  EXPECT_EQ(read.regions[0].meanDifference, -0.02);
  ASSERT_EQ(read.worst.size(), 1u);
  EXPECT_EQ(read.worst[0].wi, written.worst[0].wi);
  EXPECT_EQ(read.worst[0].wo, written.worst[0].wo);
  EXPECT_EQ(read.worst[0].channel, 2u);
  EXPECT_EQ(read.worst[0].fitted, 1.25);
  EXPECT_EQ(read.degrees, 8u);
  EXPECT_EQ(read.aic, -120);
  EXPECT_EQ(read.bic, -100);
  ASSERT_TRUE(read.crossValidation.has_value());
  EXPECT_EQ(read.crossValidation->partErrors, written.crossValidation->partErrors);
  ASSERT_EQ(read.parameters.size(), written.parameters.size());
  for (std::size_t i = 0; i < read.parameters.size(); ++i) {
    const brdf::FittedParameter &a = read.parameters[i], &b = written.parameters[i];
    EXPECT_EQ(std::tie(a.name, a.lobe, a.lobeIndex, a.channel, a.value, a.standardError, a.minimum, a.maximum, a.fixed,
                       a.atBound),
              std::tie(b.name, b.lobe, b.lobeIndex, b.channel, b.value, b.standardError, b.minimum, b.maximum, b.fixed,
                       b.atBound));
  }
  EXPECT_TRUE(brdf::loadFit(container, 1).parameters.empty());
  EXPECT_NE(errorOf([&] { brdf::loadFit(container, 2); }).find("no fit"), std::string::npos);
}
