// Every check can fail: a model broken in one way is caught by the check of that name and by no other.
#include "../TestFolder.h"

#include <brdf/check/Check.h>
#include <brdf/check/Normalisation.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/LobeSum.h>
#include <brdf/models/FormulaModel.h>
#include <brdf/models/Registry.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>

namespace brdf {
namespace {

std::string record(const std::string& equation, const std::string& attributes = "", const std::string& sampler = "") {
  return "<model name='Probe' title='A probe' " + attributes +
         "><description>For the test.</description>"
         "<parameter name='a' label='factor' symbol='a' unit='1' default='0.5' min='0' max='1' softMin='0.1' "
         "softMax='0.9'>Scales it.</parameter><equation>" +
         equation + "</equation>" + sampler + "</model>";
}

CheckOptions quick() {
  CheckOptions options;
  options.effort = 0.5;
  return options;
}

std::set<std::string> failures(const Model& model) {
  std::set<std::string> names;
  for (const Check& check : checkModel(model, quick()).checks)
    if (!check.passed) names.insert(check.name);
  return names;
}

std::set<std::string> failures(const std::string& xml) { return failures(FormulaModel(xml, "test")); }

using Names = std::set<std::string>;

const Check& find(const Audit& audit, const std::string& name) {
  const auto found =
      std::find_if(audit.checks.begin(), audit.checks.end(), [&](const Check& check) { return check.name == name; });
  if (found == audit.checks.end()) throw std::runtime_error("no check " + name);
  return *found;
}

/// A right model with some of its functions replaced.
class Broken : public Model {
 public:
  explicit Broken(const std::string& xml) : right_(xml, "test") {
    name_ = right_.name();
    parameters_ = right_.parameters();
    equation_ = right_.equation();
    isotropic_ = right_.isotropic();
    reciprocal_ = right_.reciprocal();
  }
  std::function<void(const DirectionPairs<double>&, double*)> value, density;
  std::function<void(const DirectionPairs<float>&, float*)> narrow;
  double slope = 1;

  void evaluate(const DirectionPairs<double>& pairs, std::span<const double> p, double* out) const override {
    right_.evaluate(pairs, p, out);
    if (value) value(pairs, out);
  }
  void evaluate(const DirectionPairs<float>& pairs, std::span<const double> p, float* out) const override {
    right_.evaluate(pairs, p, out);
    if (narrow) narrow(pairs, out);
  }
  void evaluateWithDerivatives(const DirectionPairs<double>& pairs, std::span<const double> p,
                               std::span<const std::size_t> which, double* out) const override {
    right_.evaluateWithDerivatives(pairs, p, which, out);
    for (std::size_t k = pairs.count; k < (which.size() + 1) * pairs.count; ++k) out[k] *= slope;
  }
  void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u, std::span<const double> p,
              const std::array<double*, 3>& wi, std::size_t count) const override {
    right_.sample(wo, u, p, wi, count);
  }
  void pdf(const DirectionPairs<double>& pairs, std::span<const double> p, double* out) const override {
    right_.pdf(pairs, p, out);
    if (density) density(pairs, out);
  }
  std::vector<double> evaluateExtended(const Direction& wi, const Direction& wo,
                                       std::span<const double> p) const override {
    return right_.evaluateExtended(wi, wo, p);
  }
  std::string glsl() const override { return right_.glsl(); }
  formula::NodeId buildValue(formula::Graph& graph, std::span<const double> p) const override {
    return right_.buildValue(graph, p);
  }

 private:
  FormulaModel right_;
};

const std::string kRight = record("a / pi");

TEST(CheckModel, PassesARightModelAndNamesEveryCheckOnce) {
  const Audit audit = checkModel(FormulaModel(kRight, "test"), quick());
  Names names;
  for (const Check& check : audit.checks) {
    EXPECT_TRUE(check.passed) << check.name << " " << check.worst << " " << check.at;
    EXPECT_TRUE(names.insert(check.name).second) << check.name;
  }
  EXPECT_EQ(names, (Names{"finite", "non_negative", "double_accuracy", "float_accuracy", "conditioning",
                          "parameter_conditioning", "derivative", "reciprocity", "turning", "energy",
                          "sampler_directions", "sampler", "pdf_integral", "efficiency"}));
  EXPECT_NEAR(find(audit, "energy").worst, 0.9, 1e-3) << "the albedo of a Lambertian is its factor";
}

TEST(CheckModel, PassesAModelFileWrittenAtRunTime) {
  const std::filesystem::path file = testFolder("models") / "CheckTestProbe.xml";
  std::ofstream(file) << record("(20 + 80 * a + 2) / (2 * pi) * powerOfCosR(20 + 80 * a)", "",
                                "<sampler name='AxisCosinePower' arguments='-vx, -vy, vz, 20 + 80 * a'/>");
  const ModelPointer model = readModelFile(file);
  EXPECT_EQ(failures(*model), Names{});
}

TEST(CheckModel, CatchesAValueThatIsNotReciprocal) {
  EXPECT_EQ(failures(record("a / pi * (0.5 + 0.5 * uz)")), Names{"reciprocity"});
  EXPECT_EQ(failures(record("a / pi * (0.5 + 0.5 * uz)", "reciprocal='no'")), Names{}) << "declared";
}

TEST(CheckModel, CatchesANegativeValue) { EXPECT_EQ(failures(record("-0.1 * a")), Names{"non_negative"}); }

TEST(CheckModel, CatchesANaNAtGrazing) {
  EXPECT_EQ(failures(record("a / pi * sqrt(uz * vz - 1e-4)")), Names{"finite"});
}

TEST(CheckModel, CatchesAnAlbedoAboveOne) { EXPECT_EQ(failures(record("1.1 * (1 + a) / pi")), Names{"energy"}); }

TEST(CheckModel, CatchesADependenceOnTheAzimuthOfAnIsotropicModel) {
  EXPECT_EQ(failures(record("a / pi * (0.5 + 0.5 * ux * vx)")), Names{"turning"});
  EXPECT_EQ(failures(record("a / pi * (0.5 + 0.5 * ux * vx)", "isotropic='no'")), Names{}) << "declared";
}

TEST(CheckModel, CatchesCosineSamplingOfASharpLobe) {
  EXPECT_EQ(failures(record("a * 100 * powerOfCosR(10000)", "", "<sampler name='Cosine'/>")), Names{"efficiency"});
}

TEST(CheckModel, CatchesCosineSamplingFromTheExponentThatItsBoundStates) {
  // cos^n about the normal: (n + 2)^2/(4 n + 4) - 1, 9.99 at n = 41 and 10.5 at n = 43.
  const auto power = [](const char* n) {
    return record("a * 5 * powerOfCosine(" + std::string(n) + ", uz, 1 - uz)", "reciprocal='no'",
                  "<declares check='energy'>not the matter here</declares><sampler name='Cosine'/>");
  };
  EXPECT_EQ(failures(power("40")), Names{});
  EXPECT_EQ(failures(power("44")), Names{"efficiency"});
}

TEST(CheckModel, DrawsASharpLobeThatNamesNoSamplerByTables) {
  const FormulaModel sharp(record("a * 100 * powerOfCosR(10000)"), "test");
  const Audit audit = checkModel(sharp, quick());
  EXPECT_TRUE(audit.passed());
  EXPECT_LT(find(audit, "efficiency").worst, 1);
}

TEST(CheckModel, KeepsAModelToWhatItDeclaresInsteadOfTheLaw) {
  const auto bright = [](const char* allowed) {
    return FormulaModel(record("1.1 * (1 + a) / pi", "",
                               "<declares check='energy' allowed='" + std::string(allowed) + "'>bright</declares>"),
                        "test");
  };
  EXPECT_EQ(failures(bright("1.5")), Names{"energy"});
  const Audit audit = checkModel(bright("2.2"), quick());
  EXPECT_TRUE(audit.passed());
  EXPECT_TRUE(find(audit, "energy").declared);
  EXPECT_EQ(find(audit, "energy").note, "bright");
}

TEST(CheckModel, CatchesADistributionThatIsNotNormalised) {
  const auto power = [](const char* factor, const char* more = "") {
    return record("n = 2 * exp(12 * a); D = " + std::string(factor) +
                      " / (2 * pi) * exp(-0.5 * n * log1p(tan2_h)); D * 0.1 * exp(-12 * a)",
                  "",
                  std::string(more) + "<sampler name='HalfCosinePower' arguments='2 * exp(12 * a), 2 * exp(12 * a)'/>");
  };
  // The integral of (n + 2)/(2 pi) cos^(n + 1) is 1; the common (n + 8)/8 is not (n + 2)/2.
  EXPECT_EQ(failures(power("(n + 2)")), Names{});
  EXPECT_EQ(failures(power("(n + 8) / 4")), Names{"normalisation"});
  EXPECT_EQ(failures(power("(n + 8) / 4", "<declares check='normalisation'>as its author has it</declares>")), Names{});
}

TEST(Normalisation, IntegratesPeaksOfAnyWidthAndStretchToTheClosedForm) {
  const FormulaModel beckmann(
      "<model name='Probe' title='A probe' isotropic='no'><parameter name='x' default='1' min='1e-5' max='10'/>"
      "<parameter name='y' default='1' min='1e-5' max='10'/><equation>D = exp(-(sqr(Hx / x) + sqr(Hy / y)) / "
      "sqr(Hz)) / sqr(cos2_h)</equation></model>",
      "test");
  for (const double x : {1e-5, 1e-4, 0.3, 10.0})
    for (const double y : {1e-5, 0.02, 10.0})
      EXPECT_NEAR(distributionIntegral(beckmann, 0, std::array{x, y}) / (kPi * x * y), 1, 1e-9) << x << " " << y;
}

TEST(CheckModel, CatchesALossOfDigits) {
  Broken wide(kRight), narrow(kRight);
  wide.value = [](const auto& pairs, double* out) {
    for (std::size_t k = 0; k < pairs.count; ++k) out[k] *= 1 + 1e-10;
  };
  narrow.narrow = [](const auto& pairs, float* out) {
    for (std::size_t k = 0; k < pairs.count; ++k) out[k] *= 1.001f;
  };
  EXPECT_EQ(failures(wide), Names{"double_accuracy"});
  EXPECT_EQ(failures(narrow), Names{"float_accuracy"});
}

TEST(CheckModel, CatchesAWrongDerivative) {
  Broken model(kRight);
  model.slope = 1 + 1e-5;
  EXPECT_EQ(failures(model), Names{"derivative"});
}

TEST(CheckModel, CatchesADensityOfTheWrongTotal) {
  Broken model(kRight);
  model.density = [](const auto& pairs, double* out) {
    for (std::size_t k = 0; k < pairs.count; ++k) out[k] *= 1.02;
  };
  EXPECT_EQ(failures(model), Names{"pdf_integral"});
}

TEST(CheckModel, CatchesADensityThatIsNotTheSamplers) {
  Broken model(kRight);
  model.density = [](const auto& pairs, double* out) {
    for (std::size_t k = 0; k < pairs.count; ++k) out[k] *= pairs.wi[0][k] > 0 ? 1.2 : 0.8;
  };
  EXPECT_EQ(failures(model), Names{"sampler"});
}

TEST(CheckModel, CatchesDrawsWithoutADensity) {
  Broken model(kRight);
  model.density = [](const auto& pairs, double* out) {
    for (std::size_t k = 0; k < pairs.count; ++k)
      if (pairs.wi[2][k] > 0.9999) out[k] = 0;
  };
  EXPECT_TRUE(failures(model).contains("sampler_directions"));
}

TEST(CheckMaterial, AuditsASumAndEachOfItsLobes) {
  const Audit audit = checkMaterial(parseMaterialExpression("(0.3,0.2,0.1)*Lambertian + 0.5*Ward(ax=(0.1,0.2,0.3))"),
                                    "two lobes", quick());
  EXPECT_EQ(audit.kind, "lobes");
  EXPECT_NO_THROW(find(audit, "lobe 1: derivative"));
  EXPECT_NO_THROW(find(audit, "lobe 2: double_accuracy"));
  EXPECT_EQ(find(audit, "energy").allowed, std::numeric_limits<double>::infinity()) << "Ward's is not bounded";
}

TEST(CheckMaterial, CatchesASumThatReflectsMoreThanItReceives) {
  const Audit audit = checkMaterial(parseMaterialExpression("1.5*Lambertian"), "bright", quick());
  for (const Check& check : audit.checks) EXPECT_EQ(check.passed, check.name != "energy") << check.name;
  EXPECT_NEAR(find(audit, "energy").worst, 1.5, 2e-3);
}

/// What a device would answer to Probe's value a/pi and the density of the cosine, the value times `factor`.
GlslRunner device(float factor) {
  return [factor](const std::string&, const std::vector<GlslColumn>& columns, const auto& expressions) {
    std::vector<std::vector<float>> result(expressions.size());
    for (std::size_t k = 0; k < columns[0].values.size(); ++k) {
      float cosine = 0;
      for (const GlslColumn& column : columns)
        if (column.name == "iz") cosine = column.values[k];
      result[0].push_back(factor * columns[0].values[k] / 3.14159265f);
      result[1].push_back(cosine / 3.14159265f);
    }
    return result;
  };
}

TEST(CheckGlsl, FailsWhenTheShaderDiffersAndPassesWhenItDoesNot) {
  const FormulaModel model(kRight, "test");
  EXPECT_TRUE(checkGlsl(model, device(1)).passed);
  EXPECT_FALSE(checkGlsl(model, device(1.001f)).passed);
}

TEST(CheckGlsl, OfASumLooksAtEveryLobeAtItsOwnParameters) {
  const auto model = std::make_shared<FormulaModel>(kRight, "test");
  // Red and green in one lobe, and one lobe outside of the soft bounds, 0.1 to 0.9.
  const LobeSum sum({{model, {{0.25, 0.5, 0.75}}, {2.0}}, {model, {{0.95}}, {1.0}}}, Channels::rgb());
  for (const float factor : {1.0f, 1.001f}) {
    std::set<float> seen;
    const auto recording = [&](const std::string& source, const std::vector<GlslColumn>& columns,
                               const auto& expressions) {
      seen.insert(columns[0].values.begin(), columns[0].values.end());
      return device(factor)(source, columns, expressions);
    };
    const std::vector<Check> checks = checkGlsl(sum, recording);
    ASSERT_EQ(checks.size(), 2u);
    EXPECT_EQ(checks[0].name, "lobe 1: glsl");
    EXPECT_EQ(checks[0].passed, factor == 1.0f);
    EXPECT_TRUE(checks[1].passed) << "nothing is demanded outside of the soft bounds";
    EXPECT_NEAR(checks[1].worst, factor == 1.0f ? 0 : 10, 0.01) << "but it is measured";
    EXPECT_FALSE(checks[1].note.empty());
    EXPECT_EQ(seen, (std::set<float>{0.25f, 0.5f, 0.75f, 0.95f}));
  }
}

}  // namespace
}  // namespace brdf
