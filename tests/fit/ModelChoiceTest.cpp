#include <brdf/base/Error.h>
#include <brdf/fit/FitProblem.h>
#include <brdf/fit/LobeRequests.h>
#include <brdf/fit/ModelChoice.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "SyntheticTarget.h"

namespace brdf {
namespace {

std::vector<CandidateLobes> candidates() {
  std::vector<CandidateLobes> list;
  for (const char* text : {"Lambertian", "Lambertian + BlinnPhong", "Lambertian + GGX"}) {
    list.push_back({text, parseLobeRequests(text)});
  }
  return list;
}

TEST(ModelChoice, TheLobesThatMadeTheDataComeFirst) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*GGX(alpha=0.3, ior=1.5)", 600, 1e-3);
  for (const std::size_t parts : {0, 4}) {
    FitOptions options;
    options.crossValidation = parts;
    const FitReport report = fitBest(target, candidates(), options);
    ASSERT_EQ(report.candidates.size(), 3u);
    EXPECT_EQ(report.candidates[0].lobes, "Lambertian + GGX");
    EXPECT_EQ(report.candidates[0].error, report.error);
    EXPECT_EQ(report.material->lobes().size(), 2u);
    EXPECT_EQ(report.candidates[0].crossValidation.has_value(), parts > 0);
    for (std::size_t k = 1; k < 3; ++k) {
      EXPECT_LE(report.candidates[k - 1].bic, report.candidates[k].bic);
    }
  }
  EXPECT_THROW(fitBest(target, {}, {}), Error);
}

TEST(ModelChoice, AWishToStopKeepsTheBestOfThoseComplete) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*GGX(alpha=0.3, ior=1.5)", 300, 1e-3);
  FitOptions options;
  std::size_t calls = 0;
  options.progress = [&](std::size_t, double) { return ++calls < 3; };  // in the second
  const FitReport report = fitBest(target, candidates(), options);
  EXPECT_FALSE(report.converged);
  EXPECT_NE(report.termination.find("stopped"), std::string::npos);
  ASSERT_EQ(report.candidates.size(), 1u);
  EXPECT_EQ(report.candidates[0].lobes, "Lambertian");
}

TEST(ModelChoice, AProgressiveFitReportsEveryStage) {
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*GGX(alpha=0.3, ior=1.5)", 400, 1e-3);
  const FitReport report = fitProgressively(target, parseLobeRequests("Lambertian + GGX + Ward"), {});
  ASSERT_EQ(report.candidates.size(), 3u);
  EXPECT_EQ(report.candidates[1].lobes, "Lambertian + GGX");
  EXPECT_LT(report.candidates[1].error, report.candidates[0].error);
  EXPECT_LE(report.candidates[2].error, report.candidates[1].error * (1 + 1e-6));
  EXPECT_EQ(report.candidates[2].error, report.error);
}

TEST(LobeRequests, TiedParametersStayEqual) {
  auto requests = parseLobeRequests("Lambertian + Ward(ax=0.1)");
  tieParameter(requests, "Ward.ay = ax");
  auto truth = synthesize(*parseMaterialExpression("0.3*Lambertian + 0.1*Ward(ax=0.1, ay=0.2)"), 500);
  truth.isotropic = false;  // else they are tied in any case
  const FitReport report = fit(ScatteredBrdf(truth, "brushed"), requests, {});
  const auto ax = std::ranges::find(report.parameters, "ax", &FittedParameter::name);
  const auto ay = std::ranges::find(report.parameters, "ay", &FittedParameter::name);
  EXPECT_EQ(ax->value, ay->value);
  EXPECT_GT(ax->value, 0.1);
  EXPECT_LT(ax->value, 0.2);
}

TEST(LobeRequests, ParametersOfTwoLobesStayEqual) {
  // The index of refraction of the two layers is one number; told apart, noise would move them.
  const auto target = syntheticTarget(
      "0.2*Lambertian + (0.3,0.2,0.1)*GGX(alpha=0.1, ior=1.7) + (0.5,0.6,0.7)*GGX(alpha=0.4, ior=1.7)", 4000);
  for (const Strategy strategy : {Strategy::Separable, Strategy::Joint}) {
    auto requests = parseLobeRequests("Lambertian + GGX(alpha=0.15) + GGX(alpha=0.3)");
    tieParameter(requests, "GGX#1.ior = GGX#2.ior");
    FitOptions options;
    options.strategy = strategy;
    const FitReport report = fit(target, requests, options);
    EXPECT_LT(report.error, 1e-7 * report.zeroModel.at("rms"));
    std::vector<double> indices;
    for (const FittedParameter& p : report.parameters)
      if (p.name == "ior") {
        indices.push_back(p.value);
        EXPECT_TRUE(p.standardError);
      }
    ASSERT_EQ(indices.size(), 2u);
    EXPECT_EQ(indices[0], indices[1]);
    EXPECT_NEAR(indices[0], 1.7, 1e-5);
  }
}

TEST(LobeRequests, ATieToAFixedParameterHoldsBoth) {
  auto requests = parseLobeRequests("GGX + CookTorrance");
  tieParameter(requests, "CookTorrance.ior = GGX.ior");
  requests[0].fixed["ior"] = 1.8;
  const FitProblem problem(requests, Symmetry::Isotropic);
  for (const ShapeCoordinate& coordinate : problem.coordinates())
    for (const auto& [lobe, parameter] : coordinate.parameters)
      EXPECT_NE(problem.model(lobe).parameters()[parameter].name, "ior");
  const auto parameters = problem.parameters(problem.start());
  EXPECT_EQ(parameters[1][requests[1].model->parameterIndex("ior")], 1.8);
}

TEST(LobeRequests, TiesThatCannotBeAreRefused) {
  auto requests = parseLobeRequests("Lambertian + Ward + GGX");
  const auto refusal = [&](const char* text) {
    try {
      tieParameter(requests, text);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(refusal("ay").find("ay=ax"), std::string::npos);
  EXPECT_NE(refusal("GGX#2.alpha=GGX#1.alpha").find("no lobe has such"), std::string::npos);
  EXPECT_NE(refusal("GGX#0.alpha=Ward.ax").find("malformed"), std::string::npos);
  requests = parseLobeRequests("GGX + GGX + Ward");
  EXPECT_NE(refusal("Ward.ax=GGX.alpha").find("must name one each"), std::string::npos);
  EXPECT_EQ(refusal("GGX#2.alpha=Ward.ax"), "accepted");
  EXPECT_NE(refusal("ay=beta").find("Ward.ax"), std::string::npos);
}

TEST(LobeRequests, AFitGoesOnFromAMaterial) {
  const auto material = parseMaterialExpression("(0.1,0.2,0.3)*Lambertian + 0.5*GGX(alpha=(0.1,0.2,0.3), ior=1.6)");
  const std::vector<LobeRequest> requests = requestsFrom(*material);
  ASSERT_EQ(requests.size(), 2u);
  EXPECT_EQ(requests[1].model->name(), "GGX");
  EXPECT_NEAR(requests[1].start.at("alpha"), 0.2, 1e-15);
  EXPECT_EQ(requests[1].start.at("ior"), 1.6);
  // From its own answer, without a scan, a fit has nothing left to do.
  const ScatteredBrdf target = syntheticTarget("0.3*Lambertian + 0.5*CookTorrance(m=0.2, ior=1.5)", 400);
  FitOptions options;
  options.tolerance = 1e-10;
  const FitReport first = fit(target, parseLobeRequests("Lambertian + GGX"), options);
  options.scan = false;
  const FitReport again = fit(target, requestsFrom(*first.material), options);
  EXPECT_NEAR(again.error, first.error, 1e-9 * first.error);
  EXPECT_LT(again.evaluations, first.evaluations / 2);
}

}  // namespace
}  // namespace brdf
