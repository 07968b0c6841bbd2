// The GLSL of every registered lobe (value, density, draw) against the processor in double at the same rounded inputs.
// BRDF_AUDIT=1 in the environment prints the worst of each case.
#include "ProbeSupport.h"

#include <brdf/base/Text.h>
#include <brdf/check/Cases.h>
#include <brdf/models/Microfacet.h>
#include <brdf/models/Model.h>
#include <brdf/sampling/Sequence.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "../models/ModelNames.h"

namespace brdf {
namespace {

/// Whether the parameter is a roughness, and how it follows from one: as it is, as exponent 2/r^2, as width r^2 in
/// tan^2.
enum class Sharpness { None, Roughness, Exponent, Width };
Sharpness sharpness(const Parameter& p) {
  if (p.label.find("roughness") != std::string::npos) return Sharpness::Roughness;
  if (p.label == "inverse width") return Sharpness::Exponent;
  if (p.label.find("exponent") == 0 && p.scale == Parameter::Scale::Logarithmic) return Sharpness::Exponent;
  return p.label == "width" ? Sharpness::Width : Sharpness::None;
}

/// The value that a shader's rounded number stands for.
double asShadersGet(const Parameter& p, double value) {
  const double rounded = static_cast<double>(p.shaderValue(value));
  return p.isLogarithmInShaders() ? std::exp(rounded) : rounded;
}

/// The model's parameters with every roughness set to `roughness` (`stretch` times that where a parameter follows
/// another: across the tangent), the others at their defaults; inside the bounds, and rounded to float as shaders get
/// them.
ParameterCase withRoughness(const Model& model, double roughness, double stretch = 1) {
  ParameterCase set{model.defaults(), "roughness " + formatNumber(roughness) + (stretch == 1 ? "" : ", stretched")};
  for (std::size_t k = 0; k < set.values.size(); ++k) {
    const Parameter& p = model.parameters()[k];
    const double r = p.follows.empty() ? roughness : stretch * roughness;
    const Sharpness kind = sharpness(p);
    if (kind == Sharpness::Roughness) set.values[k] = r;
    if (kind == Sharpness::Exponent) set.values[k] = 2 / (r * r);
    if (kind == Sharpness::Width) set.values[k] = r * r;
    set.values[k] = asShadersGet(p, std::clamp(set.values[k], p.minimum, p.maximum));
  }
  return set;
}

std::string parameterArguments(const Model& model) {
  std::string text;
  for (std::size_t k = 0; k < model.parameters().size(); ++k) text += ", p" + std::to_string(k);
  return text;
}

/// Models whose sampler is sharper than the roughness set here: SGD draws at sqrt(0.1) of its width, He and Torrance's
/// roughness is a height. Disney's stretches the random number that also chooses among four samplers.
const std::set<std::string> kSharperSamplers = {"SGD", "HeTorrance", "Disney"};

class EveryLobe : public test::GlslTest, public testing::WithParamInterface<std::string> {
 protected:
  ModelPointer model_ = findModel(GetParam());

  std::string source() const { return Model::glslPrelude() + model_->glsl(); }

  std::vector<vtkBRDFShaderProbe::Column> columns(std::size_t count, const ParameterCase& parameters) const {
    std::vector<vtkBRDFShaderProbe::Column> result;
    for (std::size_t k = 0; k < parameters.values.size(); ++k)
      result.push_back({"p" + std::to_string(k),
                        std::vector<float>(count, model_->parameters()[k].shaderValue(parameters.values[k]))});
    return result;
  }

  /// Value and density by the shader.
  std::vector<std::vector<float>> shaded(const ParameterCase& parameters, const CheckPairs& set) {
    auto inputs = columns(set.size(), parameters);
    const DirectionPairBuffer<float> narrow = set.narrow();
    const char* const names[] = {"ix", "iy", "iz", "ox", "oy", "oz"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      inputs.push_back({names[axis], narrow.wi[axis]});
      inputs.push_back({names[3 + axis], narrow.wo[axis]});
    }
    const std::string name = "brdf_" + model_->name(),
                      arguments = "(vec3(ix, iy, iz), vec3(ox, oy, oz)" + parameterArguments(*model_) + ")";
    return probe().Evaluate(source(), inputs, {name + arguments, name + "_pdf" + arguments});
  }

  /// Worst relative difference of the value and the density over the pairs.
  void expectAgreement(const ParameterCase& parameters, const CheckPairs& set, double relative) {
    const std::size_t count = set.size();
    const auto got = shaded(parameters, set);
    std::vector<double> exact(count), density(count);
    model_->evaluate(set.pairs.view(), parameters.values, exact.data());
    model_->pdf(set.pairs.view(), parameters.values, density.data());
    expectClose("value", parameters, set, got[0], exact, relative);
    expectClose("density", parameters, set, got[1], density, relative);
  }

  /// Values below 1e-16 of the lobe's peak count as zero: a double has no digit of them left beside the peak, the
  /// exponentials that make them have arguments above 37 and lose that many float roundings, and shaders flush
  /// exp(-88) to 0 before a large factor can bring it back.
  void expectClose(const char* what, const ParameterCase& parameters, const CheckPairs& set,
                   const std::vector<float>& got, const std::vector<double>& exact, double relative) const {
    const double zero = std::max(1e-36, 1e-16 * *std::max_element(exact.begin(), exact.end()));
    double worst = 0;
    std::size_t at = 0;
    for (std::size_t k = 0; k < got.size(); ++k) {
      if (exact[k] < zero && got[k] < 2 * zero && got[k] >= 0) continue;
      const double error = std::fabs(got[k] - exact[k]) / exact[k];
      if (!(error <= worst)) worst = error, at = k;
    }
    const Declaration* const looser = model_->declared("float_accuracy");
    EXPECT_LE(worst, looser == nullptr ? relative : looser->allowed)
        << what << " of " << parameterText(*model_, parameters.values) << " (" << parameters.name << "), "
        << directionText(set.wi(at), set.wo(at)) << ": " << got[at] << " instead of " << exact[at];
    if (std::getenv("BRDF_AUDIT") != nullptr)
      std::printf("%-24s %-8s %-28s worst relative %.2e at %s, value %g\n", model_->name().c_str(), what,
                  parameters.name.c_str(), worst, directionText(set.wi(at), set.wo(at)).c_str(), exact[at]);
  }
};

CheckPairs pairsOf(unsigned seed) { return adversarialPairs(300, seed, false).rounded(); }

TEST_P(EveryLobe, AgreesToFiveDigitsAtRoughnessATenthAndAbove) {
  const CheckPairs set = pairsOf(31);
  for (const double roughness : {0.1, 0.2, 0.5, 1.0}) {
    expectAgreement(withRoughness(*model_, roughness), set, 1e-5);
    expectAgreement(withRoughness(*model_, roughness, roughness > 0.5 ? 0.3 : 3), set, 1e-5);
  }
}

TEST_P(EveryLobe, AgreesToFourDigitsAtRoughnessAHundredth) {
  const CheckPairs set = pairsOf(32);
  expectAgreement(withRoughness(*model_, 0.01), set, 1e-4);
  expectAgreement(withRoughness(*model_, 0.01, 3), set, 1e-4);
}

TEST_P(EveryLobe, IsFiniteAndNotNegativeAtItsSoftBounds) {
  const CheckPairs set = pairsOf(33);
  for (const ParameterCase& parameters : softCases(*model_, 2, 34)) {
    for (const auto& column : shaded(parameters, set))
      for (std::size_t k = 0; k < set.size(); ++k)
        ASSERT_TRUE(column[k] >= 0 && std::isfinite(column[k]))
            << parameterText(*model_, parameters.values) << " " << directionText(set.wi(k), set.wo(k)) << ": "
            << column[k];
  }
}

TEST_P(EveryLobe, DrawsTheSameDirections) {
  constexpr std::size_t count = 4000;
  std::mt19937_64 random(35);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::uniform_real_distribution<double> wide(0, 1);
  for (const double roughness : {0.01, 0.1, 0.5}) {
    const ParameterCase parameters = withRoughness(*model_, roughness);
    auto inputs = columns(count, parameters);
    std::vector<float> wo[3], u[2];
    std::vector<double> wideWo[3], wideU[2], wi[3];
    for (std::size_t k = 0; k < count; ++k) {
      const double grazing = kPi / 2 - radians(std::pow(10.0, 1 - 4 * uniform(random)));
      Direction v;
      if (k % 2) {
        const double a = wide(random), b = wide(random);
        v = cosineDirection(a, b);
      } else {
        v = fromSpherical(grazing, 6.28 * uniform(random));
      }
      for (std::size_t axis = 0; axis < 3; ++axis) wo[axis].push_back(static_cast<float>(v[axis]));
      for (auto& numbers : u) numbers.push_back(std::min(uniform(random), 0x1.fffffep-1f));
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      wideWo[axis].assign(wo[axis].begin(), wo[axis].end()), wi[axis].resize(count);
    for (std::size_t k = 0; k < 2; ++k) wideU[k].assign(u[k].begin(), u[k].end());
    model_->sample({wideWo[0].data(), wideWo[1].data(), wideWo[2].data()}, {wideU[0].data(), wideU[1].data()},
                   parameters.values, {wi[0].data(), wi[1].data(), wi[2].data()}, count);
    for (std::size_t axis = 0; axis < 3; ++axis) inputs.push_back({std::string(1, "xyz"[axis]), wo[axis]});
    inputs.push_back({"u", u[0]});
    inputs.push_back({"v", u[1]});
    const std::string call =
        "brdf_" + model_->name() + "_sample(vec3(x, y, z), vec2(u, v)" + parameterArguments(*model_) + ")";
    const auto got = probe().Evaluate(source(), inputs, {call + ".x", call + ".y", call + ".z"});
    double worst = 0;
    std::size_t at = 0, disagreeing = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const bool here = wi[2][k] > 0, there = got[2][k] > 0;
      if (here != there) {
        // Rounding may decide which side of the horizon a draw falls on, within a few float ulps.
        ++disagreeing;
        EXPECT_LT(std::max(wi[2][k], static_cast<double>(got[2][k])), 1e-5);
        continue;
      }
      const double distance = std::hypot(got[0][k] - wi[0][k], got[1][k] - wi[1][k], got[2][k] - wi[2][k]);
      if (!(distance <= worst)) worst = distance, at = k;
    }
    const bool sharp = roughness < 0.1 || kSharperSamplers.contains(model_->name());
    EXPECT_LE(worst, sharp ? 1e-4 : 1e-5)
        << parameterText(*model_, parameters.values) << " from " << u[0][at] << ", " << u[1][at] << " at "
        << directionText({wi[0][at], wi[1][at], wi[2][at]}, {wo[0][at], wo[1][at], wo[2][at]});
    EXPECT_LE(disagreeing, count / 100);
    if (std::getenv("BRDF_AUDIT") != nullptr)
      std::printf("%-24s draw     %-28s worst distance %.2e, %zu on the other side of the horizon\n",
                  model_->name().c_str(), parameters.name.c_str(), worst, disagreeing);
  }
}

class PublishedLobe : public EveryLobe {};

TEST_P(PublishedLobe, AgreesWhereAParameterIsBeyondFloat) {
  // Bagher and others' fits of chrome-steel (G), tungsten-carbide (B), ss440 (G), one channel each: c of 1.6e+109
  // to 7.9e+91 with exponents of hundreds, whose product is of order 1.
  const CheckPairs set = pairsOf(36);
  const char* const names[] = {"alpha", "p", "F0", "F1", "K", "Lambda", "c", "k", "theta0"};
  const double fits[][9] = {
      {3.13288e-05, 0.152758, 2.06813e-11, -0.265326, 28628.9, 68.7898, 1.63655e+109, 257.536, 1.2003},
      {4.80196e-05, 0.26732, 1.09586e-11, -1.0, 16683.5, 6.81602, 6.81451e+92, 218.975, 1.19745},
      {4.86278e-05, 0.259135, 5.7223e-13, -0.223179, 16625.7, 7.33446, 7.92907e+91, 215.021, 1.20059}};
  for (const auto& fit : fits) {
    ParameterCase parameters{model_->defaults(), "published"};
    for (std::size_t k = 0; k < std::size(names); ++k) {
      const std::size_t index = model_->parameterIndex(names[k]);
      parameters.values[index] = asShadersGet(model_->parameters()[index], fit[k]);
    }
    EXPECT_GT(parameters.values[model_->parameterIndex("c")], 1e38);
    // The shadowing factor passes through zero with a slope of k: its error is judged beside the unshadowed value.
    std::vector<double> lit = parameters.values;
    lit[model_->parameterIndex("Lambda")] = 0;
    const std::vector<float> got = shaded(parameters, set)[0];
    std::vector<double> exact(set.size()), unshadowed(set.size());
    model_->evaluate(set.pairs.view(), parameters.values, exact.data());
    model_->evaluate(set.pairs.view(), lit, unshadowed.data());
    std::size_t shadowed = 0;
    for (std::size_t k = 0; k < set.size(); ++k) {
      if (unshadowed[k] < 1e-30) continue;
      shadowed += exact[k] < 0.9 * unshadowed[k];
      ASSERT_NEAR(got[k], exact[k], 1e-3 * unshadowed[k])
          << parameterText(*model_, parameters.values) << " " << directionText(set.wi(k), set.wo(k));
    }
    EXPECT_GT(shadowed, 20u);  // the factor does act
  }
}

INSTANTIATE_TEST_SUITE_P(ShiftedGamma, PublishedLobe, testing::Values("SGD"),
                         [](const auto& name) { return name.param; });

INSTANTIATE_TEST_SUITE_P(Registry, EveryLobe, testing::ValuesIn(test::modelNames()),
                         [](const auto& name) { return name.param; });

// Every distribution, Fresnel and shadowing term, those with integrals in each of their forms. Lobes of a distribution
// with two widths are stretched by the tests above.
INSTANTIATE_TEST_SUITE_P(Composed, EveryLobe,
                         testing::Values("Microfacet_GGX_Dielectric_Smith", "Microfacet_GGX_Conductor_Kelemen",
                                         "Microfacet_Beckmann_Conductor_Smith",
                                         "Microfacet_Beckmann_Schlick_SmithSeparable",
                                         "Microfacet_Phong_Schlick_VGroove", "Microfacet_Phong_Constant_Smith",
                                         "Microfacet_StudentT_Constant_Smith", "Microfacet_StudentT_Dielectric_Neumann",
                                         "Microfacet_EPD_Conductor_Smith", "Microfacet_EPD_Schlick_SmithSeparable",
                                         "Microfacet_ABC_Dielectric_Smith", "Microfacet_ABC_Conductor_SmithSeparable",
                                         "Microfacet_ABC_Constant_None"),
                         [](const auto& name) { return name.param; });

TEST(ComposedLobes, NameEveryTerm) {
  const auto& suite = *testing::UnitTest::GetInstance();
  std::set<std::string> names;
  for (int s = 0; s < suite.total_test_suite_count(); ++s)
    for (int k = 0; k < suite.GetTestSuite(s)->total_test_count(); ++k)
      names.insert(suite.GetTestSuite(s)->GetTestInfo(k)->name());
  for (const auto* terms :
       {&microfacetTerms().distributions, &microfacetTerms().fresnels, &microfacetTerms().shadowings})
    for (const std::string& term : *terms)
      EXPECT_TRUE(std::ranges::any_of(names, [&](const std::string& name) {
        return name.find("Microfacet_") != std::string::npos &&
               (name + "_").find("_" + term + "_") != std::string::npos;
      })) << term;
}

}  // namespace
}  // namespace brdf
