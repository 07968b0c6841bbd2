#include <brdf/fit/StoredFit.h>
#include <gtest/gtest.h>

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
