// Material expressions: what they mean, what is refused and where.
#include <brdf/base/Error.h>
#include <brdf/check/Cases.h>
#include <brdf/material/LobeSum.h>
#include <gtest/gtest.h>

#include <random>

#include <clocale>

namespace brdf {
namespace {

double lobeParameter(const LobeSum& material, std::size_t lobe, const std::string& name, std::size_t channel = 0) {
  const Lobe& l = material.lobes().at(lobe);
  return l.parametersOf(channel).at(l.model->parameterIndex(name));
}

TEST(MaterialExpression, SumsLobesWithScalesAndNamedParameters) {
  const auto material = parseMaterialExpression("(0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2, ior=1.7)");
  ASSERT_EQ(material->lobes().size(), 2u);
  EXPECT_EQ(material->channels(), Channels::rgb());
  EXPECT_EQ(material->lobes()[0].scale, (std::vector<double>{0.3, 0.1, 0.05}));
  EXPECT_EQ(material->lobes()[1].scale, std::vector<double>{0.04});
  EXPECT_EQ(lobeParameter(*material, 1, "ior"), 1.7);
  EXPECT_EQ(lobeParameter(*material, 1, "alpha_y"), 0.2) << "follows alpha";
  EXPECT_TRUE(material->lobes()[1].channelIndependent());
}

TEST(MaterialExpression, ReadsItsFormsAlike) {
  const auto same = [](const char* a, const char* b) {
    EXPECT_EQ(parseMaterialExpression(a)->description(), parseMaterialExpression(b)->description())
        << a << " and " << b;
  };
  same("GGX", "GGX()");
  same("GGX", "1*GGX");
  same("GGX", " ( 1.0 ) * GGX ( ) ");
  same("0.5*Lambertian", "5e-1*Lambertian");
  same("0.5*Lambertian", ".5 * Lambertian");
  same("0.5*Lambertian", "0.25*2*Lambertian");
  same("(0.1,0.2,0.4)*Lambertian", "0.1*(1,2,4)*Lambertian");
  same("4*(0.1,0.2,0.3)*Lambertian", "(0.1,0.2,0.3)*4*Lambertian");
  same("GGX(alpha=0.3,ior=2)", "GGX(ior=2,\n alpha=0.3)");
  same("GGX(alpha=0.3)", "GGX(alpha=0.3, alpha_y=0.3)");
  same("GGX(alpha=(0.3,0.2,0.1))", "GGX(alpha=(0.3,0.2,0.1), alpha_y=(0.3,0.2,0.1))");
  same("Lambertian+Lambertian", "Lambertian + Lambertian");
}

TEST(MaterialExpression, ReadsNumbersWhateverTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const bool changed =
      std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr || std::setlocale(LC_ALL, "fr_FR.UTF-8") != nullptr;
  const auto material = parseMaterialExpression("(0.25,0.5,0.75)*Lambertian");
  const std::string text = material->description();
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(material->lobes()[0].scale[1], 0.5);
  EXPECT_EQ(text, "(0.25,0.5,0.75)*Lambertian");
  if (!changed) GTEST_SKIP() << "no locale with a decimal comma is installed; only the C locale was tried";
}

TEST(MaterialExpression, SpectralChannelsAreNamedByTheCaller) {
  const auto material = parseMaterialExpression("(0.1,0.2)*Lambertian + GGX", Channels::spectral({500, 600}));
  EXPECT_EQ(material->channels().count(), 2u);
  EXPECT_EQ(parseMaterialExpression("Lambertian", Channels::rgb())->channels().count(), 3u);
}

struct Wrong {
  const char* text;
  Error::Kind kind;
  const char* where;
  const char* what;
};

class WrongExpression : public testing::TestWithParam<Wrong> {};

TEST_P(WrongExpression, IsRefusedWithItsColumn) {
  try {
    parseMaterialExpression(GetParam().text);
    FAIL() << "accepted: " << GetParam().text;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), GetParam().kind) << error.what();
    const std::string where = GetParam().kind == Error::Kind::Formula && GetParam().where[0] == 'c'
                                  ? "material expression, " + std::string(GetParam().where)
                                  : GetParam().where;
    EXPECT_EQ(error.details().where, where) << GetParam().text;
    EXPECT_NE(error.details().what.find(GetParam().what), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

constexpr auto kFormula = Error::Kind::Formula;
constexpr auto kValue = Error::Kind::Value;

INSTANTIATE_TEST_SUITE_P(
    Table, WrongExpression,
    testing::Values(Wrong{"", kFormula, "column 1", "expected a lobe"},
                    Wrong{"   ", kFormula, "column 4", "expected a lobe"},
                    Wrong{"GXG", kFormula, "column 1", "unknown lobe"},
                    Wrong{"Lambertian + Phnog", kFormula, "column 14", "unknown lobe"},
                    Wrong{"Lambertian +", kFormula, "column 13", "expected a lobe"},
                    Wrong{"Lambertian Lambertian", kFormula, "column 12", "expected '+'"},
                    Wrong{"Lambertian - Lambertian", kFormula, "column 12", "expected '+'"},
                    Wrong{"0.5 Lambertian", kFormula, "column 5", "expected '*'"},
                    Wrong{"0.5*", kFormula, "column 5", "expected a lobe"},
                    Wrong{"0.5.5*Lambertian", kFormula, "column 1", "expected a number"},
                    Wrong{"*Lambertian", kFormula, "column 1", "expected a number"},
                    Wrong{"(0.1,0.2,)*Lambertian", kFormula, "column 10", "expected a number"},
                    Wrong{"(0.1,0.2,0.3*Lambertian", kFormula, "column 13", "expected ')'"},
                    Wrong{"GGX(alpha=0.2", kFormula, "column 14", "expected ')'"},
                    Wrong{"GGX(beta=0.2)", kFormula, "column 5", "unknown parameter"},
                    Wrong{"GGX(alpha)", kFormula, "column 10", "expected '='"},
                    Wrong{"GGX(alpha=)", kFormula, "column 11", "expected a number"},
                    Wrong{"GGX(alpha=0.2,)", kFormula, "column 15", "expected a parameter"},
                    Wrong{"GGX(alpha=0.2, alpha=0.3)", kFormula, "column 16", "given twice"},
                    Wrong{"GGX(0.2)", kFormula, "column 5", "expected a parameter"},
                    Wrong{"Lambertian(x=1)", kFormula, "column 12", "unknown parameter"},
                    Wrong{"(1,2,3)*GGX(alpha=(0.1,0.2))", kFormula, "column 20", "lists of different lengths"},
                    Wrong{"(1,2)*Lambertian", kFormula, "material expression", "one value a channel"},
                    Wrong{"GGX(alpha=0)", kValue, "GGX.alpha", "out of bounds"},
                    Wrong{"GGX(alpha=nan)", kValue, "GGX.alpha", "out of bounds"},
                    Wrong{"GGX(ior=(1.5,1.5,0.5))", kValue, "GGX.ior", "out of bounds"},
                    Wrong{"-0.5*Lambertian", kValue, "scale of Lambertian", "out of bounds"},
                    Wrong{"inf*Lambertian", kFormula, "column 1", "unknown lobe"},
                    Wrong{"1e999*Lambertian", kValue, "scale of Lambertian", "out of bounds"},
                    Wrong{"nan*Lambertian", kFormula, "column 1", "unknown lobe"}));

TEST(MaterialExpression, NamesTheNearestLobe) {
  try {
    parseMaterialExpression("Lamberian");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(error.details().allowed.find("did you mean Lambertian?"), std::string::npos) << error.what();
  }
}

TEST(MaterialExpression, SurvivesEveryByteAndLongText) {
  for (int byte = 0; byte < 256; ++byte) try {
      parseMaterialExpression("Lambertian " + std::string(1, static_cast<char>(byte)) + " GGX");
    } catch (const Error&) {
    }
  EXPECT_THROW(parseMaterialExpression(std::string(100'000, '(')), Error);
  std::string sum = "Lambertian";
  for (int k = 0; k < 200; ++k) sum += "+Lambertian";
  EXPECT_EQ(parseMaterialExpression(sum)->lobes().size(), 201u);
}

TEST(MaterialExpression, DescriptionsReadBackToIdenticalValues) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(0, 1);
  const CheckPairs set = adversarialPairs(10, 5, false);
  for (const ModelPointer& model : allModels())
    for (const ParameterCase& parameters : softCases(*model, 4, 6))
      for (const bool rgb : {false, true}) {
        const std::size_t channels = rgb ? 3 : 1;
        Lobe lobe{model, {}, {}};
        for (std::size_t c = 0; c < channels; ++c) lobe.scale.push_back(uniform(random));
        for (const double value : parameters.values) lobe.parameters.push_back({value});
        if (rgb && !lobe.parameters.empty()) {
          const Parameter& p = model->parameters()[0];
          lobe.parameters[0] = {p.softMinimum, p.defaultValue, p.softMaximum};
        }
        const LobeSum original({lobe, Lobe{findModel("Lambertian"), {}, {uniform(random)}}},
                               rgb ? Channels::rgb() : Channels::monochrome());
        const auto back = parseMaterialExpression(original.description());
        std::vector<double> first(channels * set.size()), second(first.size());
        original.evaluate(set.pairs.view(), first.data(), nullptr);
        back->evaluate(set.pairs.view(), second.data(), nullptr);
        EXPECT_EQ(first, second) << original.description();
        EXPECT_EQ(back->description(), original.description());
      }
}

}  // namespace
}  // namespace brdf
