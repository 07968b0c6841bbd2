// Every registered model passes its audit (check/Check.h; that each check can fail is tested there), and what the audit
// leaves out: the horizon, derivatives at the hard bounds, the mirror image, the ends of the random numbers.
#include <brdf/check/Cases.h>
#include <brdf/check/Check.h>
#include <brdf/models/FormulaModel.h>
#include <brdf/models/Microfacet.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ModelNames.h"

namespace brdf {
namespace {

class EveryModel : public testing::TestWithParam<std::string> {
 protected:
  ModelPointer model_ = findModel(GetParam());

  std::vector<double> evaluated(const DirectionPairBuffer<double>& pairs, const std::vector<double>& parameters) const {
    std::vector<double> values(pairs.size());
    model_->evaluate(pairs.view(), parameters, values.data());
    return values;
  }
  std::vector<std::size_t> everyParameter() const {
    std::vector<std::size_t> which(model_->parameters().size());
    for (std::size_t k = 0; k < which.size(); ++k) which[k] = k;
    return which;
  }
  std::vector<ParameterCase> softAndHard() const {
    std::vector<ParameterCase> cases = softCases(*model_, 2, 21);
    for (ParameterCase& one : hardCases(*model_, 4, 22)) cases.push_back(std::move(one));
    return cases;
  }
};

TEST_P(EveryModel, PassesItsAudit) {
  CheckOptions options;
  options.seed = 11;  // another than the command line's
  for (const Check& check : checkModel(*model_, options).checks) {
    EXPECT_TRUE(check.passed) << check.name << ": " << check.worst << " of " << check.allowed << " allowed at "
                              << check.at;
    if (check.name == "reciprocity" && !model_->reciprocal()) {
      EXPECT_GT(check.worst, 1e-6) << "declared not reciprocal, but it is";
    }
  }
}

TEST_P(EveryModel, ShowsTheAuditItsMicrofacetDistributions) {
  const auto& record = dynamic_cast<const FormulaModel&>(*model_);
  for (const std::string& function : record.functionsUsed())
    if (function.starts_with("D_")) {
      EXPECT_FALSE(record.distributions().empty()) << "calls " << function << " without assigning D";
    }
}

TEST_P(EveryModel, IsZeroBelowAndOnTheHorizon) {
  DirectionPairBuffer<double> pairs;
  for (const double z : {0.0, -0.0, -1e-300, -0.5, -1.0}) {
    const Direction below{std::sqrt(1 - z * z), 0, z};
    pairs.push(below, {0, 0, 1});
    pairs.push({0, 0, 1}, below);
    pairs.push(below, below);
  }
  for (const ParameterCase& one : softCases(*model_, 2, 11)) {
    std::vector<double> density(pairs.size(), -1);
    model_->pdf(pairs.view(), one.values, density.data());
    EXPECT_EQ(evaluated(pairs, one.values), std::vector<double>(pairs.size(), 0));
    EXPECT_EQ(density, std::vector<double>(pairs.size(), 0));
  }
}

TEST_P(EveryModel, DerivativesAreFiniteAtTheHardBounds) {
  const CheckPairs set = adversarialPairs(50, 14, true);
  const std::vector<std::size_t> which = everyParameter();
  std::vector<double> got((which.size() + 1) * set.size());
  for (const ParameterCase& one : hardCases(*model_, 4, 15)) {
    model_->evaluateWithDerivatives(set.pairs.view(), one.values, which, got.data());
    const std::vector<double> values = evaluated(set.pairs, one.values);
    for (std::size_t i = 0; i < set.size(); ++i) {
      ASSERT_NEAR(got[i], values[i], 1e-12 * values[i]) << "the value beside its derivatives";
      for (std::size_t k = 0; k < which.size(); ++k)
        ASSERT_TRUE(std::isfinite(got[(k + 1) * set.size() + i]))
            << parameterText(*model_, one.values) << " d/d" << model_->parameters()[k].name << " "
            << directionText(set.wi(i), set.wo(i)) << ": " << got[(k + 1) * set.size() + i];
    }
  }
}

TEST_P(EveryModel, IsItsOwnMirrorImageAcrossTheTangent) {
  const CheckPairs set = adversarialPairs(60, 18, true);
  DirectionPairBuffer<double> flipped = set.pairs;
  for (auto* const y : {&flipped.wi[1], &flipped.wo[1]})
    for (double& value : *y) value = -value;
  const std::vector<double> here = evaluated(set.pairs, model_->defaults()),
                            there = evaluated(flipped, model_->defaults());
  for (std::size_t k = 0; k < set.size(); ++k)
    EXPECT_NEAR(here[k], there[k], 1e-12 * here[k] + 1e-280) << directionText(set.wi(k), set.wo(k));
}

TEST_P(EveryModel, DrawsUnitDirectionsAboveTheHorizonOrNoneAlsoAtTheEndsOfTheRandomNumbers) {
  std::vector<double> numbers{0, 0x1p-53, 0.5, 1 - 0x1p-53};
  for (int k = 1; k < 20; ++k) numbers.push_back(std::fmod(0.6180339887498949 * k, 1.0));  // the golden ratio
  for (const ParameterCase& one : softAndHard())
    for (const double angle : {0.0, 45.0, 89.0, 89.9999, 90.0}) {
      const Direction wo = fromSpherical(radians(angle), 2.1);
      for (const double u : numbers)
        for (const double v : numbers) {
          Direction wi{};
          model_->sample({&wo[0], &wo[1], &wo[2]}, {&u, &v}, one.values, {&wi[0], &wi[1], &wi[2]}, 1);
          const bool none = wi == Direction{0, 0, 0};
          ASSERT_TRUE(none || (wi[2] > 0 && std::fabs(std::sqrt(dot(wi, wi)) - 1) < 1e-12))
              << parameterText(*model_, one.values) << " from " << u << ", " << v << ": " << directionText(wi, wo);
        }
    }
}

TEST_P(EveryModel, DrawsWhereverItReflects) {
  const CheckPairs set = adversarialPairs(200, 23, true);
  for (const ParameterCase& one : softAndHard()) {
    const std::vector<double> values = evaluated(set.pairs, one.values);
    std::vector<double> density(set.size());
    model_->pdf(set.pairs.view(), one.values, density.data());
    for (std::size_t k = 0; k < set.size(); ++k) {
      const auto where = [&] {
        return parameterText(*model_, one.values) + " " + directionText(set.wi(k), set.wo(k)) + ", value ";
      };
      ASSERT_TRUE(density[k] >= 0 && std::isfinite(density[k])) << where() << values[k] << ", density " << density[k];
      if (values[k] * set.wi(k)[2] > 1e-250) {
        ASSERT_GT(density[k], 0) << where() << values[k];
      }
    }
  }
}

TEST(Microfacet, EveryComposedDistributionIsNormalised) {
  for (const std::string& distribution : microfacetTerms().distributions) {
    const Audit audit = checkModel(*composeMicrofacet(distribution, "Constant", "None"), {.effort = 0.1});
    const auto found = std::find_if(audit.checks.begin(), audit.checks.end(),
                                    [](const Check& check) { return check.name == "normalisation"; });
    ASSERT_NE(found, audit.checks.end()) << distribution;
    EXPECT_TRUE(found->passed) << distribution << " " << found->worst << " " << found->at;
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryModel, testing::ValuesIn(test::modelNames()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace brdf
