// Values and derivatives of every registered model against 50-digit arithmetic from the same rounded inputs.
// BRDF_AUDIT=1 in the environment prints the worst of each case.
#include <brdf/base/Text.h>
#include <brdf/formula/Extended.h>
#include <brdf/models/FormulaModel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ModelKit.h"

namespace brdf {
namespace {

using test::PairSet;
using test::ParameterSet;

formula::InputLane lane(const Direction& wi, const Direction& wo) { return {wi[0], wi[1], wi[2], wo[0], wo[1], wo[2]}; }

class EveryModel : public testing::TestWithParam<std::string> {
 protected:
  ModelPointer model_ = findModel(GetParam());
  const FormulaModel& formula() const { return dynamic_cast<const FormulaModel&>(*model_); }

  /// Pairs of each kind to spend on a model: fewer on a slow one.
  std::size_t pairs(std::size_t usual) const {
    return test::isSlow(*model_) ? std::max<std::size_t>(usual / 20, 1) : usual;
  }

  std::vector<double> exact(const PairSet& set, const std::vector<double>& parameters) const {
    std::vector<double> values;
    for (std::size_t k = 0; k < set.size(); ++k)
      values.push_back(formula::evaluateExtended(formula().graph(), {formula().valueNode()}, lane(set.wi(k), set.wo(k)),
                                                 parameters)[0]);
    return values;
  }
  std::vector<double> evaluated(const PairSet& set, const std::vector<double>& parameters) const {
    std::vector<double> values(set.size());
    model_->evaluate(set.pairs.view(), parameters, values.data());
    return values;
  }
  std::vector<float> evaluatedNarrow(const PairSet& set, const std::vector<double>& parameters) const {
    std::vector<float> values(set.size());
    const DirectionPairBuffer<float> narrow = set.narrow();
    model_->evaluate(narrow.view(), parameters, values.data());
    return values;
  }

  /// Every value must be within `relative` of the exact one, plus what an exponential loses: one unit of the last place
  /// for each unit of its argument, and the argument is ln(peak/value) at most. Values below `tiny` count as 0: there
  /// the format itself has no digits left. In float so do those below 1e-16 of the peak: float's exponentials underflow
  /// there before a large factor brings them back. Where a term passes through zero, one unit of the last place of the
  /// peak.
  template <class T>
  void expectClose(const PairSet& set, const std::vector<T>& got, const std::vector<double>& exactValues,
                   const ParameterSet& parameters, double relative, double perExponent, double tiny) const {
    const test::Conditioning* loose = test::illConditioned(*model_);
    if (loose != nullptr) relative = std::max(relative, sizeof(T) == 4 ? loose->relativeNarrow : loose->relative);
    double peak = 0;
    for (const double value : exactValues)
      if (std::isfinite(value)) peak = std::max(peak, value);
    if (sizeof(T) == sizeof(float)) tiny = std::max(tiny, 1e-16 * peak);
    double worst = 0, worstRelative = 0;
    std::size_t at = 0;
    for (std::size_t k = 0; k < got.size(); ++k) {
      const double value = got[k], truth = exactValues[k];
      ASSERT_TRUE(std::isfinite(truth) || truth > 0)
          << "the formula itself has no value: " << test::text(*model_, parameters.values) << " "
          << test::text(set.wi(k), set.wo(k));
      if (std::max(std::fabs(value), std::fabs(truth)) <= tiny) continue;
      // Beyond the largest number of T the right answer is infinity.
      if (truth >= static_cast<double>(std::numeric_limits<T>::max()) * 0.999 && value > 0 && std::isinf(value))
        continue;
      const double rounding =
          loose != nullptr && loose->passesThroughZero ? std::numeric_limits<T>::epsilon() * peak : 0;
      const double error = std::max(0.0, std::fabs(value - truth) - rounding) / std::max(std::fabs(truth), tiny);
      const double allowed = relative + perExponent * std::max(0.0, std::log(peak / std::max(truth, tiny)));
      if (!(error / allowed <= worst)) worst = error / allowed, worstRelative = error, at = k;
    }
    EXPECT_LE(worst, 1) << test::text(*model_, parameters.values) << " (" << parameters.name << "), " << set.kinds[at]
                        << " " << test::text(set.wi(at), set.wo(at)) << ": "
                        << formatNumber(static_cast<double>(got[at]), 17) << " instead of "
                        << formatNumber(exactValues[at], 17) << ", relative " << worstRelative;
    if (std::getenv("BRDF_AUDIT") != nullptr)
      std::printf("%-24s %-22s %-6s worst relative %.2e (%.2f of allowed) at %s\n", model_->name().c_str(),
                  parameters.name.c_str(), sizeof(T) == 4 ? "float" : "double", worstRelative, worst, set.kinds[at]);
  }
};

TEST_P(EveryModel, IsExactInDoubleAtDefaults) {
  const PairSet set = test::makePairs(pairs(100), 1);
  const ParameterSet parameters = test::defaults(*model_);
  expectClose(set, evaluated(set, parameters.values), exact(set, parameters.values), parameters, 1e-12, 0, 1e-290);
}

TEST_P(EveryModel, IsExactInDoubleInsideAndAtTheSoftBounds) {
  const PairSet set = test::makePairs(pairs(40), 2);
  for (const ParameterSet& parameters : test::softSets(*model_, 4, 3))
    expectClose(set, evaluated(set, parameters.values), exact(set, parameters.values), parameters, 1e-12, 0, 1e-290);
}

TEST_P(EveryModel, IsExactInDoubleAtTheHardBounds) {
  const PairSet set = test::makePairs(pairs(30), 4);
  for (const ParameterSet& parameters : test::hardSets(*model_, 4, 5))
    expectClose(set, evaluated(set, parameters.values), exact(set, parameters.values), parameters, 1e-11, 1e-14,
                1e-290);
}

TEST_P(EveryModel, IsExactToSixDigitsInFloatAtDefaultsAndSoftBounds) {
  const PairSet set = test::makePairs(pairs(40), 6, false).rounded();
  std::vector<ParameterSet> sets = test::softSets(*model_, 4, 7);
  sets.push_back(test::defaults(*model_));
  for (const ParameterSet& parameters : sets)
    expectClose(set, evaluatedNarrow(set, parameters.values), exact(set, parameters.values), parameters, 1e-5, 1e-6,
                1e-30);
}

TEST_P(EveryModel, IsFiniteAndNotNegativeInFloatAndDoubleEverywhere) {
  std::vector<ParameterSet> sets = test::hardSets(*model_, 12, 8);
  for (ParameterSet& set : test::softSets(*model_, 12, 9)) sets.push_back(std::move(set));
  sets.push_back(test::defaults(*model_));
  const PairSet set = test::makePairs(200, 10), rounded = set.rounded();
  for (const ParameterSet& parameters : sets) {
    const std::vector<double> wide = evaluated(set, parameters.values);
    const std::vector<float> narrow = evaluatedNarrow(set, parameters.values);
    const std::vector<double> wideThere = evaluated(rounded, parameters.values);
    for (std::size_t k = 0; k < set.size(); ++k) {
      // Infinity is right where the exact value exceeds what the format holds, or a factor of 10 before.
      ASSERT_TRUE(wide[k] >= 0 && std::isfinite(wide[k]))
          << test::text(*model_, parameters.values) << " " << test::text(set.wi(k), set.wo(k)) << ": " << wide[k];
      ASSERT_TRUE(narrow[k] >= 0 &&
                  (std::isfinite(narrow[k]) || wideThere[k] > 0.1 * std::numeric_limits<float>::max()))
          << "float: " << test::text(*model_, parameters.values) << " " << test::text(set.wi(k), set.wo(k)) << ": "
          << narrow[k];
    }
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
  for (const ParameterSet& parameters : test::softSets(*model_, 2, 11)) {
    std::vector<double> values(pairs.size(), -1), density(pairs.size(), -1);
    model_->evaluate(pairs.view(), parameters.values, values.data());
    model_->pdf(pairs.view(), parameters.values, density.data());
    EXPECT_EQ(values, std::vector<double>(pairs.size(), 0));
    EXPECT_EQ(density, std::vector<double>(pairs.size(), 0));
  }
}

TEST_P(EveryModel, DerivativesAgreeWithExtendedPrecisionDifferences) {
  // Relative to the derivative, with a floor relative to the value: 1e-7 of (value / parameter), the change that a
  // relative change of the parameter by one part makes.
  const PairSet set = test::makePairs(pairs(6), 12, false);
  std::vector<ParameterSet> sets = test::softSets(*model_, 2, 13);
  sets.push_back(test::defaults(*model_));
  const test::Conditioning* loose = test::illConditioned(*model_);
  const std::size_t parameterCount = model_->parameters().size();
  std::vector<std::size_t> which(parameterCount);
  for (std::size_t k = 0; k < parameterCount; ++k) which[k] = k;
  std::vector<double> got((parameterCount + 1) * set.size());
  for (ParameterSet& parameters : sets) {
    // A difference needs both sides, and outside the hard bounds a model promises nothing.
    for (std::size_t k = 0; k < parameterCount; ++k) {
      const Parameter& p = model_->parameters()[k];
      const double inside = 1e-6 * (p.maximum - p.minimum);
      parameters.values[k] = std::clamp(parameters.values[k], p.minimum == 0 ? 0.0 : p.minimum, p.maximum - inside);
      if (parameters.values[k] == p.minimum && p.minimum != 0) parameters.values[k] += inside;
    }
    model_->evaluateWithDerivatives(set.pairs.view(), parameters.values, which, got.data());
    const std::vector<double> exactValues = exact(set, parameters.values);
    const double peak = *std::max_element(exactValues.begin(), exactValues.end());
    for (std::size_t i = 0; i < set.size(); ++i)
      for (std::size_t k = 0; k < parameterCount; ++k) {
        const double truth = formula::differenceExtended(formula().graph(), formula().valueNode(),
                                                         lane(set.wi(i), set.wo(i)), parameters.values, k);
        const double slope = got[(k + 1) * set.size() + i];
        // At the kink of a clamp rounding decides the side.
        if (loose != nullptr && loose->passesThroughZero && exactValues[i] < 1e-12 * peak) continue;
        const double floor = 1e-9 * std::fabs(got[i]) / std::max(std::fabs(parameters.values[k]), 1e-3) + 1e-290;
        ASSERT_NEAR(slope, truth, 1e-7 * std::fabs(truth) + floor)
            << test::text(*model_, parameters.values) << " d/d" << model_->parameters()[k].name << ", " << set.kinds[i]
            << " " << test::text(set.wi(i), set.wo(i));
      }
  }
}

TEST_P(EveryModel, DerivativesAreFiniteAtTheHardBounds) {
  const PairSet set = test::makePairs(50, 14);
  const std::size_t parameterCount = model_->parameters().size();
  std::vector<std::size_t> which(parameterCount);
  for (std::size_t k = 0; k < parameterCount; ++k) which[k] = k;
  std::vector<double> got((parameterCount + 1) * set.size()), values(set.size());
  for (const ParameterSet& parameters : test::hardSets(*model_, 4, 15)) {
    model_->evaluateWithDerivatives(set.pairs.view(), parameters.values, which, got.data());
    model_->evaluate(set.pairs.view(), parameters.values, values.data());
    for (std::size_t i = 0; i < set.size(); ++i) {
      ASSERT_NEAR(got[i], values[i], 1e-12 * values[i]) << "the value beside its derivatives";
      for (std::size_t k = 0; k < parameterCount; ++k)
        ASSERT_TRUE(std::isfinite(got[(k + 1) * set.size() + i]))
            << test::text(*model_, parameters.values) << " d/d" << model_->parameters()[k].name << ", " << set.kinds[i]
            << " " << test::text(set.wi(i), set.wo(i)) << ": " << got[(k + 1) * set.size() + i];
    }
  }
}

TEST_P(EveryModel, IsReciprocalUnlessItSaysOtherwise) {
  const PairSet set = test::makePairs(100, 16);
  PairSet swapped;
  for (std::size_t k = 0; k < set.size(); ++k) swapped.add(set.wo(k), set.wi(k), set.kinds[k]);
  std::vector<ParameterSet> sets = test::softSets(*model_, 4, 17);
  sets.push_back(test::defaults(*model_));
  double worst = 0;
  for (const ParameterSet& parameters : sets) {
    const std::vector<double> there = evaluated(set, parameters.values), back = evaluated(swapped, parameters.values);
    for (std::size_t k = 0; k < set.size(); ++k)
      if (const double size = std::max(there[k], back[k]); size > 1e-290)
        worst = std::max(worst, std::fabs(there[k] - back[k]) / size);
  }
  if (model_->reciprocal()) {
    EXPECT_LE(worst, 1e-12);
  } else {
    EXPECT_GT(worst, 1e-6) << "declared not reciprocal, but it is";
  }
}

TEST_P(EveryModel, DependsOnTheAzimuthDifferenceOnlyWhenItSaysIsotropic) {
  const PairSet set = test::makePairs(60, 18);
  PairSet turned, flipped;
  const double c = std::cos(1.234), s = std::sin(1.234);
  const auto turn = [&](const Direction& w) { return Direction{c * w[0] - s * w[1], s * w[0] + c * w[1], w[2]}; };
  const auto flip = [](const Direction& w) { return Direction{w[0], -w[1], w[2]}; };
  for (std::size_t k = 0; k < set.size(); ++k) {
    turned.add(turn(set.wi(k)), turn(set.wo(k)), set.kinds[k]);
    flipped.add(flip(set.wi(k)), flip(set.wo(k)), set.kinds[k]);
  }
  const ParameterSet parameters = test::defaults(*model_);
  const std::vector<double> here = evaluated(set, parameters.values), there = evaluated(turned, parameters.values),
                            mirrored = evaluated(flipped, parameters.values);
  for (std::size_t k = 0; k < set.size(); ++k) {
    // Turning rounds the directions: 1e-16 of them, which a lobe magnifies by its slope.
    if (model_->isotropic()) {
      EXPECT_NEAR(here[k], there[k], 1e-9 * here[k] + 1e-280) << set.kinds[k];
    }
    EXPECT_NEAR(here[k], mirrored[k], 1e-12 * here[k] + 1e-280) << set.kinds[k];
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryModel, testing::ValuesIn(test::modelNames()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace brdf
