#include <brdf/base/Parallel.h>
#include <brdf/base/Text.h>
#include <brdf/fit/Fit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "SyntheticTarget.h"

namespace brdf {
namespace {

LobeRequest lobe(const std::string& name) { return {findModel(name), {}, {}, {}}; }

const FittedParameter& parameter(const FitReport& report, const std::string& lobeName, const std::string& name,
                                 std::size_t channel = 0) {
  for (const FittedParameter& fitted : report.parameters)
    if (fitted.lobe == lobeName && fitted.name == name && fitted.channel.value_or(channel) == channel) return fitted;
  throw std::runtime_error("no parameter " + name + " of " + lobeName);
}

struct Truth {
  std::string expression;
  std::string lobe;
  std::vector<std::pair<std::string, double>> parameters;
};

const std::vector<Truth> kTruths = {
    {"0.3*Lambertian + 0.05*GGX(alpha=0.3, ior=1.5)", "GGX", {{"alpha", 0.3}, {"ior", 1.5}}},
    {"0.1*Lambertian + 0.8*GGX(alpha=0.02, ior=1.8)", "GGX", {{"alpha", 0.02}, {"ior", 1.8}}},
    {"0.3*Lambertian + 0.5*CookTorrance(m=0.12, ior=1.4)", "CookTorrance", {{"m", 0.12}, {"ior", 1.4}}},
    {"0.3*Lambertian + 0.1*Ward(ax=0.08)", "Ward", {{"ax", 0.08}}},
    {"0.2*Lambertian + 0.1*Ward(ax=0.05, ay=0.3)", "Ward", {{"ax", 0.05}, {"ay", 0.3}}},
    {"0.3*Lambertian + 0.2*BlinnPhong(n=900)", "BlinnPhong", {{"n", 900}}},
    {"0.3*Lambertian + 0.7*AshikhminShirley(nu=200, F0=0.1)", "AshikhminShirley", {{"nu", 200}, {"F0", 0.1}}},
};

TEST(Recovery, NoiseFreeSamplesGiveBackTheParametersFromTheDefaultStart) {
  for (const Truth& truth : kTruths)
    for (const char* metric : {"rms", "rms_cos", "log", "cuberoot", "relative", "huber"}) {
      const ScatteredBrdf target = syntheticTarget(truth.expression, 3000);
      FitOptions options;
      options.metric = metric;
      options.tolerance = 1e-12;
      const FitReport report = fit(target, {lobe("Lambertian"), lobe(truth.lobe)}, options);
      EXPECT_TRUE(report.converged) << truth.expression << " " << metric << ": " << report.termination;
      EXPECT_LE(report.error, 1e-9 * report.zeroModel.at(metric)) << truth.expression << " " << metric;
      for (const auto& [name, value] : truth.parameters)
        EXPECT_NEAR(parameter(report, truth.lobe, name).value, value, 1e-6 * value)
            << truth.expression << " " << metric << " " << name;
    }
}

TEST(Recovery, FarStartsComeBackWithTheScanAndWithAShapeReadOffTheData) {
  // From the other end of the soft range the lobe misses the data, and every derivative vanishes with its scale. All
  // models, and every optimizer, are in docs/fitting-optimizers.md.
  const std::vector<std::tuple<std::string, std::string, std::map<std::string, double>>> cases = {
      {"0.3*Lambertian + 0.7*AshikhminShirley(nu=25.9, F0=0.215)", "AshikhminShirley", {{"nu", 1.22e4}, {"F0", 0.95}}},
      {"0.3*Lambertian + 0.7*CookTorrance(m=0.0106, ior=2.38)", "CookTorrance", {{"m", 0.472}, {"ior", 3.75}}},
      {"0.3*Lambertian + 0.7*LowMicrofacet(B=477, C=0.25, ior=1.4)", "LowMicrofacet", {{"B", 8e4}, {"C", 3}}},
      {"0.3*Lambertian + 0.7*WardDuer(ax=0.0152)", "WardDuer", {{"ax", 0.472}}},
  };
  for (const auto& [expression, name, start] : cases)
    for (const bool scan : {true, false}) {
      const ScatteredBrdf target = syntheticTarget(expression, 2000);
      FitOptions options;
      options.scan = scan;
      options.dataStart = !scan;
      const FitReport report = fit(target, {lobe("Lambertian"), {findModel(name), {}, start, {}}}, options);
      EXPECT_LE(report.error, 1e-4 * report.zeroModel.at("rms")) << expression << " scan " << scan;
    }
}

TEST(Recovery, ScalesOfEveryChannelComeBackWithASharedShape) {
  const ScatteredBrdf target = syntheticTarget("(0.3,0.1,0.05)*Lambertian + (0.5,0.4,0)*GGX(alpha=0.2, ior=1.6)", 2000);
  const FitReport report = fit(target, {lobe("Lambertian"), lobe("GGX")}, {});
  EXPECT_EQ(report.channels, 3u);
  EXPECT_EQ(report.material->channels(), Channels::rgb());
  const std::vector<double> diffuse{0.3, 0.1, 0.05}, specular{0.5, 0.4, 0};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(parameter(report, "Lambertian", "scale", c).value, diffuse[c], 1e-7);
    EXPECT_NEAR(parameter(report, "GGX", "scale", c).value, specular[c], 1e-6);
  }
  EXPECT_NEAR(parameter(report, "GGX", "alpha").value, 0.2, 1e-6);
}

TEST(Recovery, ChannelsWithTheirOwnShapesAreFoundPerChannel) {
  const ScatteredBrdf target =
      syntheticTarget("(0.3,0.1,0.05)*Lambertian + (0.5,0.4,0.3)*CookTorrance(m=(0.1,0.2,0.3), ior=1.5)", 2000);
  FitOptions options;
  options.combination = Combination::PerChannel;
  const FitReport report = fit(target, {lobe("Lambertian"), lobe("CookTorrance")}, options);
  EXPECT_NEAR(parameter(report, "CookTorrance", "m", 0).value, 0.1, 1e-6);
  EXPECT_NEAR(parameter(report, "CookTorrance", "m", 1).value, 0.2, 1e-6);
  EXPECT_NEAR(parameter(report, "CookTorrance", "m", 2).value, 0.3, 1e-6);
  EXPECT_LT(report.error, 1e-8);
  EXPECT_FALSE(report.material->lobes()[1].channelIndependent());
}

TEST(Recovery, TwoLobesOfOneModelAreToldApart) {
  const ScatteredBrdf target =
      syntheticTarget("0.2*Lambertian + 0.3*CookTorrance(m=0.05, ior=1.5) + 0.4*CookTorrance(m=0.4, ior=1.5)", 4000);
  const LobeRequest held{findModel("CookTorrance"), {{"ior", 1.5}}, {}, {}};
  const FitReport report = fit(target, {lobe("Lambertian"), held, held}, {});
  EXPECT_LT(report.error, 1e-7 * report.zeroModel.at("rms"));
  std::vector<double> widths;
  for (const FittedParameter& fitted : report.parameters)
    if (fitted.name == "m") widths.push_back(fitted.value);
  std::sort(widths.begin(), widths.end());
  EXPECT_NEAR(widths.at(0), 0.05, 1e-6);
  EXPECT_NEAR(widths.at(1), 0.4, 1e-5);
}

TEST(Recovery, StandardErrorsMatchTheScatterOverManyNoisyRuns) {
  // (estimate - truth) / standard error is standard normal: over R runs its mean square is 1 with standard deviation
  // sqrt(2 / R); four of those are allowed.
  constexpr int kRuns = 150;
  const double allowed = 4 * std::sqrt(2.0 / kRuns);
  for (const Strategy strategy : {Strategy::Separable, Strategy::Joint}) {
    double alpha = 0, scale = 0, diffuse = 0;
    for (int run = 0; run < kRuns; ++run) {
      const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.6*CookTorrance(m=0.25, ior=1.5)", 400, 2e-3,
                                                   static_cast<std::uint64_t>(run + 10));
      FitOptions options;
      options.strategy = strategy;
      options.scan = false;  // from the default start: near enough here
      const LobeRequest held{findModel("CookTorrance"), {{"ior", 1.5}}, {}, {}};
      const FitReport report = fit(target, {lobe("Lambertian"), held}, options);
      const auto squared = [&](const char* lobeName, const char* name, double truth) {
        const FittedParameter fitted = parameter(report, lobeName, name);
        const double z = (fitted.value - truth) / fitted.standardError.value();
        return z * z;
      };
      alpha += squared("CookTorrance", "m", 0.25);
      scale += squared("CookTorrance", "scale", 0.6);
      diffuse += squared("Lambertian", "scale", 0.3);
    }
    EXPECT_NEAR(alpha / kRuns, 1, allowed);
    EXPECT_NEAR(scale / kRuns, 1, allowed);
    EXPECT_NEAR(diffuse / kRuns, 1, allowed);
  }
}

TEST(Recovery, ResultsAreTheSameForEveryNumberOfThreads) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*GGX(alpha=0.1, ior=1.7)", 50000, 1e-3);
  for (const char* metric : {"rms", "cuberoot"}) {
    FitOptions options;
    options.metric = metric;
    options.starts = 2;
    const auto run = [&](std::size_t threads) {
      setThreadCount(threads);
      FitReport report = fit(target, {lobe("Lambertian"), lobe("GGX")}, options);
      setThreadCount(0);
      return report;
    };
    const FitReport one = run(1), two = run(2);
    EXPECT_EQ(one.material->description(), two.material->description());
    EXPECT_EQ(one.error, two.error);
    EXPECT_EQ(one.evaluations, two.evaluations);
  }
}

}  // namespace
}  // namespace brdf
