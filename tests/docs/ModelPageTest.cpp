// What a model's page says.
#include <brdf/formula/MathPrinter.h>
#include <brdf/models/FormulaModel.h>
#include <brdf/models/Microfacet.h>
#include <brdf/reference/ModelPage.h>
#include <gtest/gtest.h>

#include <cmath>

namespace brdf {
namespace {

void expectAlbedo(const char* model, std::size_t which, double truth) {
  const MeasuredAlbedo albedo = measuredAlbedos(findModel(model)).at(which);
  EXPECT_NEAR(albedo.value, truth, albedo.bound) << model << " at " << albedo.degrees;
  EXPECT_LE(albedo.bound, 3e-4 * std::max(truth, 0.04)) << model << " at " << albedo.degrees;
}

TEST(MeasuredAlbedo, IsThatOfClosedForms) {
  for (const std::size_t angle : {0u, 1u}) expectAlbedo("Lambertian", angle, 1);
  // cos^(k-1) theta times the integral of cos^k over the hemisphere, over pi: 2 cos^(k-1)/(k+1); k is 1.3.
  expectAlbedo("Minnaert", 0, 2 / 2.3);
  expectAlbedo("Minnaert", 1, 2 * std::pow(0.5, 0.3) / 2.3);
  // Normalised for normal incidence: (n+2)/(2 pi) times the integral of cos^(n+1).
  expectAlbedo("Phong", 0, 1);
  // (1 - R_s) (1 - 1/32): the integral over the other direction is 23/28.
  expectAlbedo("AshikhminShirleyDiffuse", 0, 0.96 * 31 / 32);
  // A - with no azimuthal term at normal incidence - of sigma = 0.3: 1 - 0.045/0.42.
  expectAlbedo("OrenNayar", 0, 1 - 0.5 * 0.09 / (0.09 + 0.33));
}

TEST(MeasuredAlbedo, IsWrittenToTheDecimalsThatItsBoundHas) {
  EXPECT_EQ((MeasuredAlbedo{0, 0.0401234, 1e-5}.text("+-")), "0.04012 +- 0.00001");
  EXPECT_EQ((MeasuredAlbedo{0, 2.30084, 5e-4}.text("+-")), "2.3008 +- 0.0005");
  EXPECT_EQ((MeasuredAlbedo{0, 1234.56, 5}.text("+-")), "1235 +- 5");
}

TEST(ModelPage, ShowsEveryFieldOfTheRecord) {
  const auto model = std::make_shared<FormulaModel>(
      R"xml(<model name="Probe" title="The title" reciprocal="no" clamp="yes" isotropic="no">
        <description>Some words.</description>
        <parameter name="ax" label="a label" symbol="alpha_x" unit="rad" default="0.25" min="0.125" max="2" softMin="0.2"
          softMax="1.5" scale="log">What it does.</parameter>
        <equation>F_Schlick(ax) / pi</equation><sampler name="HalfBeckmann" arguments="ax, 2 * ax" cosine="0.3"/>
        <reference authors="First, Second" year="1999" title="A paper" venue="A journal 1(2)" doi="10.1/xyz" equations="(7)"/>
      </model>)xml",
      "probe.xml");
  const char* both[] = {"Probe",
                        "The title",
                        "Some words.",
                        "ax",
                        "rad",
                        "0.25",
                        "0.125 to 2",
                        "0.2 to 1.5",
                        "log",
                        "What it does.",
                        "F_Schlick(ax) / pi",
                        "HalfBeckmann",
                        "2 * ax",
                        "0.3",
                        "First, Second 1999",
                        "A paper",
                        "A journal 1(2)",
                        "10.1/xyz",
                        "(7)",
                        "not reciprocal",
                        "Not reciprocal:",
                        "replaced by 0",
                        "Schlick's approximation",
                        "±",
                        "60"};
  for (const std::string& page : {modelPageText(model), modelPageMarkdown(model)})
    for (const char* part : both) EXPECT_NE(page.find(part), std::string::npos) << part << "\n" << page;
  for (const char* part :
       {"\\frac{F_{\\mathrm{Schlick}}\\left(\\alpha_{x}\\right)}{\\pi}", "$\\alpha_{x}$", "https://doi.org/10.1/xyz"})
    EXPECT_NE(modelPageMarkdown(model).find(part), std::string::npos) << part;
}

TEST(ModelPage, HasTheRecordOfEveryRegisteredModel) {
  for (const ModelPointer& model : allModels()) {
    EXPECT_FALSE(model->description().empty()) << model->name();
    EXPECT_FALSE(model->references().empty()) << model->name();
    for (const Parameter& p : model->parameters())
      EXPECT_FALSE(p.description.empty()) << model->name() << "." << p.name;
    for (const Reference& reference : model->references())  // 10.5555 is the registry's prefix for tests: not resolved
      EXPECT_TRUE(reference.doi.empty() || (reference.doi.starts_with("10.") && !reference.doi.starts_with("10.5555")))
          << model->name() << " " << reference.doi;
    const std::string firstLine = model->equation().substr(0, model->equation().find('\n'));
    EXPECT_NE(modelPageText(model).find(firstLine), std::string::npos) << model->name();
  }
}

TEST(MicrofacetTerms, HaveTheNamesThatCompose) {
  const MicrofacetTerms& names = microfacetTerms();
  const auto namesOf = [](char kind) {
    std::vector<std::string> result;
    for (const MicrofacetTerm& term : microfacetTermsOf(kind)) result.push_back(term.name);
    return result;
  };
  EXPECT_EQ(namesOf('D'), names.distributions);
  EXPECT_EQ(namesOf('F'), names.fresnels);
  EXPECT_EQ(namesOf('G'), names.shadowings);
  EXPECT_THROW(microfacetTermsOf('X'), std::runtime_error);
}

}  // namespace
}  // namespace brdf
