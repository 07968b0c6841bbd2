#include <brdf/base/Error.h>
#include <brdf/fit/Fit.h>
#include <brdf/material/TableBrdf.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "SyntheticTarget.h"

namespace brdf {
namespace {

LobeRequest lobe(const std::string& name) { return {findModel(name), {}, {}, {}}; }

bool noted(const FitReport& report, const std::string& text) {
  return std::ranges::any_of(report.notes,
                             [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

TEST(Fit, ReportsWhatItUsedWithTheZeroModelBesideIt) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*GGX(alpha=0.2, ior=1.5)", 1000, 1e-3);
  const FitReport report = fit(target, {lobe("Lambertian"), lobe("GGX")}, {});
  EXPECT_EQ(report.metric, "rms");
  EXPECT_EQ(report.optimizer, "lm");
  EXPECT_EQ(report.strategy, "separable");
  EXPECT_EQ(report.samples, 1000u);
  EXPECT_EQ(report.channels, 1u);
  EXPECT_TRUE(report.converged);
  EXPECT_FALSE(report.termination.empty());
  EXPECT_GT(report.evaluations, 0u);
  EXPECT_EQ(report.metrics.size(), metricNames().size() - 1);  // ngan: scattered samples have no solid angles
  EXPECT_EQ(report.zeroModel.size(), report.metrics.size());
  EXPECT_EQ(report.error, report.metrics.at("rms"));
  EXPECT_NEAR(report.error, 1e-3, 1e-4);  // the noise
  // scale and parameters of every lobe, in order
  ASSERT_GE(report.parameters.size(), 4u);
  EXPECT_EQ(report.parameters[0].lobe, "Lambertian");
  EXPECT_EQ(report.parameters[0].name, "scale");
  EXPECT_TRUE(report.parameters[0].standardError.has_value());
}

TEST(Fit, JointAndSeparableFindTheSameMinimum) {
  const ScatteredBrdf target = syntheticTarget("(0.3,0.2,0.1)*Lambertian + 0.5*CookTorrance(m=0.2, ior=1.5)", 1000);
  FitOptions options;
  options.tolerance = 1e-12;
  const FitReport separable = fit(target, {lobe("Lambertian"), lobe("GGX")}, options);
  options.strategy = Strategy::Joint;
  const FitReport joint = fit(target, {lobe("Lambertian"), lobe("GGX")}, options);
  EXPECT_EQ(joint.strategy, "joint");
  ASSERT_EQ(joint.parameters.size(), separable.parameters.size());
  for (std::size_t k = 0; k < joint.parameters.size(); ++k) {
    EXPECT_NEAR(joint.parameters[k].value, separable.parameters[k].value,
                1e-4 * std::abs(separable.parameters[k].value))
        << joint.parameters[k].name;
    ASSERT_EQ(joint.parameters[k].standardError.has_value(), separable.parameters[k].standardError.has_value());
  }
  EXPECT_NEAR(joint.error, separable.error, 1e-9 * separable.error);
}

TEST(Fit, HoldsWhatIsFixedAndStaysInsideTheBounds) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*GGX(alpha=0.2, ior=1.5)", 500);
  const FitReport report = fit(target,
                               {LobeRequest{findModel("Lambertian"), {{"scale", 0.25}}, {}, {}},
                                LobeRequest{findModel("GGX"), {{"alpha", 0.3}}, {}, {}}},
                               {});
  for (const FittedParameter& fitted : report.parameters) {
    if (fitted.lobe == "Lambertian") {
      EXPECT_EQ(fitted.value, 0.25);
      EXPECT_TRUE(fitted.fixed);
    }
    if (fitted.name == "alpha" || fitted.name == "alpha_y") {
      EXPECT_EQ(fitted.value, 0.3);
      EXPECT_TRUE(fitted.fixed);
      EXPECT_FALSE(fitted.standardError.has_value());
    }
    EXPECT_GE(fitted.value, fitted.minimum);
    EXPECT_LE(fitted.value, fitted.maximum);
  }
}

TEST(Fit, NamesAParameterOnItsBoundAndGivesItNoStandardError) {
  // Narrower than the model allows: a data set of one sharp peak fitted with a broad lobe's bound in the way.
  const ScatteredBrdf target = syntheticTarget("0.2*Lambertian + 0.5*AshikhminShirley(nu=100, F0=1)", 1000);
  const FitReport report = fit(target, {lobe("Lambertian"), lobe("AshikhminShirley")}, {});
  const auto f0 = std::ranges::find(report.parameters, "F0", &FittedParameter::name);
  ASSERT_NE(f0, report.parameters.end());
  EXPECT_NEAR(f0->value, 1, 1e-6);
  EXPECT_TRUE(f0->atBound);
  EXPECT_FALSE(f0->standardError.has_value());
  EXPECT_TRUE(noted(report, "F0 of AshikhminShirley is on its bound"));
}

TEST(Fit, SaysWhichParametersTheDataDoNotDetermine) {
  // Two Lambertian lobes: only the sum of their scales is seen.
  const ScatteredBrdf target = syntheticTarget("0.4*Lambertian", 300, 1e-4);
  const FitReport report = fit(target, {lobe("Lambertian"), lobe("Lambertian")}, {});
  EXPECT_TRUE(noted(report, "scale of Lambertian#1 and scale of Lambertian#2 are not separately determined"))
      << (report.notes.empty() ? "" : report.notes[0]);
  for (const FittedParameter& fitted : report.parameters) EXPECT_FALSE(fitted.standardError.has_value());
  EXPECT_NEAR(report.parameters[0].value + report.parameters[1].value, 0.4, 1e-3);
}

TEST(Fit, AnIsotropicTargetKeepsTheRoughnessesAlike) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.1*Ward(ax=0.2)", 500, 1e-3);
  ASSERT_EQ(target.symmetry(), Symmetry::Isotropic);
  const FitReport report = fit(target, {lobe("Lambertian"), lobe("Ward")}, {});
  const auto ax = std::ranges::find(report.parameters, "ax", &FittedParameter::name);
  const auto ay = std::ranges::find(report.parameters, "ay", &FittedParameter::name);
  EXPECT_EQ(ax->value, ay->value);
  EXPECT_EQ(ax->standardError, ay->standardError);
  EXPECT_TRUE(noted(report, "ay of Ward is held equal to ax"));
  EXPECT_EQ(report.material->symmetry(), Symmetry::Isotropic);
}

TEST(Fit, ATableThatDoesNotChangeWhenTurnedKeepsThemAlikeToo) {
  TableLayout layout;
  layout.thetaH = layout.thetaD = 15;
  layout.phiD = 24;
  const auto table =
      TableBrdf::tabulate(*parseMaterialExpression("0.3*Lambertian + 0.5*GGX(alpha=0.3, ior=1.6)"), layout);
  const FitReport report = fit(*table, {lobe("Lambertian"), lobe("GGX")}, {});
  for (const FittedParameter& fitted : report.parameters) {
    if (fitted.name == "alpha" || fitted.name == "alpha_y") {
      EXPECT_NEAR(fitted.value, 0.3, 1e-7);
    }
  }
  EXPECT_LT(report.error, 1e-9 * report.zeroModel.at("rms"));
}

TEST(Fit, CallsAFitWeakThatExplainsLittle) {
  const ScatteredBrdf target = syntheticTarget("0.5*GGX(alpha=0.05, ior=1.5)", 1000);
  const FitReport report = fit(target, {lobe("Lambertian")}, {});
  EXPECT_TRUE(report.converged);
  EXPECT_TRUE(noted(report, "weak fit"));
}

TEST(Fit, ALobeWithoutAShareIsNamed) {
  const ScatteredBrdf target = syntheticTarget("0.5*Lambertian", 300);
  const FitReport report =
      fit(target, {lobe("Lambertian"), LobeRequest{findModel("Ward"), {{"scale", 0}}, {}, {}}}, {});
  EXPECT_TRUE(noted(report, "Ward has no share"));
  EXPECT_NEAR(report.parameters[0].value, 0.5, 1e-9);
}

TEST(Fit, LeavesOutSamplesBeyondTheThetaLimitAndInvalidOnes) {
  ScatteredSamples samples = synthesize(*parseMaterialExpression("0.5*Lambertian"), 1000);
  samples.valid.assign(1000, 1);
  std::size_t expected = 0;
  for (std::size_t i = 0; i < 1000; ++i) {
    if (i % 7 == 0) {
      samples.valid[i] = 0;
      samples.values[i] = 1e6;
    }
    const double limit = std::cos(radians(60));
    if (samples.pairs.wi[2][i] < limit || samples.pairs.wo[2][i] < limit)
      samples.values[i] = 1e6;
    else if (samples.valid[i])
      ++expected;
  }
  FitOptions options;
  options.maximumTheta = 60;
  const FitReport report = fit(ScatteredBrdf(std::move(samples), "partly spoiled"), {lobe("Lambertian")}, options);
  EXPECT_EQ(report.samples, expected);
  EXPECT_NEAR(report.parameters[0].value, 0.5, 1e-12);
}

TEST(Fit, TheProgressFunctionSeesFallingErrorsAndStopsTheFit) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*CookTorrance(m=0.2, ior=1.5)", 1000);
  FitOptions options;
  std::size_t calls = 0;
  options.progress = [&](std::size_t iteration, double error) {
    EXPECT_EQ(iteration, ++calls);
    EXPECT_GE(error, 0);
    return calls < 5;
  };
  const FitReport report = fit(target, {lobe("Lambertian"), lobe("GGX")}, options);
  EXPECT_EQ(calls, 5u);
  EXPECT_FALSE(report.converged);
  EXPECT_NE(report.termination.find("stopped"), std::string::npos);
  EXPECT_LT(report.error, report.zeroModel.at("rms"));
}

TEST(Fit, RefusesWhatCannotBe) {
  const ScatteredBrdf target = syntheticTarget("0.5*Lambertian", 50);
  const auto refusal = [&](const Brdf& measured, const std::vector<LobeRequest>& lobes, const FitOptions& options) {
    try {
      fit(measured, lobes, options);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Value) << error.what();
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  FitOptions options;
  options.metric = "psnr";
  EXPECT_NE(refusal(target, {lobe("Lambertian")}, options).find("cuberoot"), std::string::npos);
  options = {};
  options.optimizer = "magic";
  EXPECT_NE(refusal(target, {lobe("Lambertian")}, options).find("sbplx"), std::string::npos);
  options = {};
  options.metric = "log";
  options.strategy = Strategy::Separable;
  EXPECT_NE(refusal(target, {lobe("Lambertian")}, options).find("joint"), std::string::npos);
  EXPECT_NE(refusal(target, {}, {}).find("at least one"), std::string::npos);
  EXPECT_NE(refusal(target, {LobeRequest{findModel("GGX"), {{"alpha", -1}}, {}, {}}}, {}).find("alpha"),
            std::string::npos);
  EXPECT_NE(refusal(target, {LobeRequest{findModel("GGX"), {{"alhpa", 0.1}}, {}, {}}}, {}).find("alpha"),
            std::string::npos);
  EXPECT_NE(refusal(target, {LobeRequest{findModel("Ward"), {}, {}, {{"ax", "ax"}}}}, {}).find("tied"),
            std::string::npos);
  options = {};
  options.samples.sampling = Sampling::All;
  EXPECT_NE(refusal(*parseMaterialExpression("0.5*Lambertian"), {lobe("GGX")}, options).find("no samples"),
            std::string::npos);
  options.samples = {Sampling::Hemisphere, 100'000'000, 1, false};
  EXPECT_NE(refusal(target, {lobe("GGX")}, options).find("at most 10000000"), std::string::npos);
  ScatteredSamples invalid = synthesize(*parseMaterialExpression("0.5*Lambertian"), 20);
  invalid.valid.assign(20, 0);
  EXPECT_NE(refusal(ScatteredBrdf(invalid, "nothing valid"), {lobe("GGX")}, {}).find("no valid sample"),
            std::string::npos);
}

}  // namespace
}  // namespace brdf
