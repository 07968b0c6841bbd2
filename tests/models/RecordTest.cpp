// XML records of models: what is read, and what is said about one that is wrong.
#include <brdf/base/Error.h>
#include <brdf/models/FormulaModel.h>
#include <brdf/models/Library.h>
#include <brdf/sampling/SamplerChecks.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace brdf {
namespace {

const std::string kParameter = R"(<parameter name="m" default="0.5" min="0" max="2"/>)";

/// A record with the given pieces, right everywhere else: parameters on line 3, the equation on line 4 from column 11
/// on, samplers and what follows on line 5.
std::string record(const std::string& parameters, const std::string& equation = "m / pi",
                   const std::string& sampler = "", const std::string& attributes = R"(name="Test" title="A test")") {
  return "<model " + attributes + ">\n<description>words</description>\n" + parameters + "\n<equation>" + equation +
         "</equation>\n" + sampler + "\n</model>";
}

TEST(Record, GivesItsFieldsAndDefaultsToTheRest) {
  const FormulaModel model(
      record(
          R"(<parameter name="m" label="roughness" symbol="alpha" unit="rad" default="0.5" min="0.1" max="2" softMin="0.2"
                softMax="1" scale="log"> How rough. </parameter><parameter name="n" default="1" min="1" max="1" follows="m"/>)",
          "m * n",
          R"(<sampler name="Cosine"/><reference authors="A, B" year="1999" title="T" venue="V" doi="D" equations="1"/>)",
          R"(name="Test" title="A test" isotropic="no" reciprocal="no")"),
      "test.xml");
  model.compile();
  EXPECT_EQ(model.name(), "Test");
  EXPECT_EQ(model.description(), "words");
  EXPECT_EQ(model.equation(), "m * n");
  EXPECT_FALSE(model.isotropic());
  EXPECT_FALSE(model.reciprocal());
  ASSERT_EQ(model.parameters().size(), 2u);
  const Parameter& m = model.parameters()[0];
  EXPECT_EQ(m.label, "roughness");
  EXPECT_EQ(m.symbol, "alpha");
  EXPECT_EQ(m.unit, "rad");
  EXPECT_EQ(m.description, "How rough.");
  EXPECT_EQ(m.softMinimum, 0.2);
  EXPECT_EQ(m.scale, Parameter::Scale::Logarithmic);
  const Parameter& n = model.parameters()[1];
  EXPECT_EQ(n.label, "n");
  EXPECT_EQ(n.unit, "1");
  EXPECT_EQ(n.softMaximum, 1);
  EXPECT_EQ(n.follows, "m");
  ASSERT_EQ(model.references().size(), 1u);
  EXPECT_EQ(model.references()[0].year, 1999);
}

TEST(Record, DeclaresWhatTheModelDoesNotKeep) {
  const FormulaModel model(
      record(kParameter, "m / pi",
             R"(<declares check="energy">bright</declares><declares check="float_accuracy" allowed="1e-3">
                                       hard </declares>)"),
      "test.xml");
  ASSERT_EQ(model.declarations().size(), 2u);
  ASSERT_NE(model.declared("energy"), nullptr);
  EXPECT_TRUE(std::isinf(model.declared("energy")->allowed));
  EXPECT_EQ(model.declared("float_accuracy")->allowed, 1e-3);
  EXPECT_EQ(model.declared("float_accuracy")->reason, "hard");
  EXPECT_EQ(model.declared("normalisation"), nullptr);
}

TEST(Record, NamesNoSamplerWhenItHasNone) {
  EXPECT_FALSE(FormulaModel(record(kParameter), "test.xml").namesSampler());
  EXPECT_TRUE(FormulaModel(record(kParameter, "m / pi", R"(<sampler name="Cosine"/>)"), "test.xml").namesSampler());
}

TEST(Record, SamplersWithSharesDrawTheMixture) {
  // Share m about the x axis at 45 degrees, a tenth cosine-weighted, the rest about the normal.
  const FormulaModel model(record(kParameter, "m / pi",
                                  R"(<sampler name="AxisCosinePower" arguments="0, 0, 1, 20" cosine="0.1"/>
                                     <sampler name="AxisCosinePower" arguments="1, 0, 1, 80" share="m"/>)"),
                           "test.xml");
  const std::vector<double> parameters{0.3};
  const Direction wo = fromSpherical(0.4, 0.2);
  const SamplerTest found = testSampler(samplerOf(model, parameters), wo);
  EXPECT_GT(found.chiSquare.probability, 1e-4);
  EXPECT_LT(std::fabs(found.deviation), 5);
  DirectionPairBuffer<double> pairs;
  pairs.push({0, 0, 1}, wo);
  double density = 0;
  model.pdf(pairs.view(), parameters, &density);
  EXPECT_NEAR(density, (0.6 * 21 / 2 + 0.3 * 81 / 2 * std::pow(0.5, 40) + 0.1) / kPi, 1e-12);
}

TEST(Record, ClampReplacesNegativeValuesByZero) {
  const auto value = [](const std::string& attributes) {
    const FormulaModel model(record(kParameter, "m - 1", "", R"(name="Test" title="A test" )" + attributes),
                             "test.xml");
    const double z = 1, zero = 0;
    double out = 0;
    const DirectionPairs<double> pairs{{&zero, &zero, &z}, {&zero, &zero, &z}, 1};
    model.evaluate(pairs, std::vector{0.25}, &out);
    return out;
  };
  EXPECT_EQ(value(""), -0.75);
  EXPECT_EQ(value(R"(clamp="yes")"), 0);
}

struct Wrong {
  std::string xml;
  Error::Kind kind;
  std::string what, where;
};

class WrongRecord : public testing::TestWithParam<Wrong> {};

TEST_P(WrongRecord, IsRefusedWithItsPlace) {
  try {
    FormulaModel(GetParam().xml, "test.xml").compile();
    FAIL() << "accepted: " << GetParam().xml;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), GetParam().kind) << error.what();
    EXPECT_NE(error.details().what.find(GetParam().what), std::string::npos) << error.what();
    EXPECT_EQ(error.details().where, GetParam().where) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Elements, WrongRecord,
    testing::Values(
        Wrong{"", Error::Kind::Format, "not well-formed XML", "test.xml, line 1, column 1"},
        Wrong{"<model>\n<x></model>", Error::Kind::Format, "not well-formed XML", "test.xml, line 2, column 6"},
        Wrong{"<lobe/>", Error::Kind::Format, "wrong root element", "test.xml, line 1, column 2"},
        Wrong{"<model title='t'><equation>1</equation></model>", Error::Kind::Format, "missing attribute 'name'",
              "test.xml, line 1, column 2"},
        Wrong{"<model name='n'><equation>1</equation></model>", Error::Kind::Format, "missing attribute 'title'",
              "test.xml, line 1, column 2"},
        Wrong{"<model name='n' title='t'/>", Error::Kind::Format, "missing <equation>", "test.xml, line 1, column 2"},
        Wrong{record(kParameter, "m", "", R"(name="My lobe" title="t")"), Error::Kind::Format, "no identifier",
              "test.xml, line 1, column 14"},
        Wrong{record(kParameter, "m", "", R"(name="T" title="t" isotropic="maybe")"), Error::Kind::Format, "isotropic",
              "test.xml, line 1, column 38"},
        Wrong{record(kParameter, "m", "", R"(name="T" title="t" isotropc="no")"), Error::Kind::Format,
              "unknown attribute of <model>", "test.xml, line 1, column 37"},
        Wrong{record(kParameter, "m", R"(<sampeler name="Cosine"/>)"), Error::Kind::Format,
              "unknown element in <model>", "test.xml, line 5, column 2"},
        Wrong{record(kParameter, "m", R"(<declares check="nothing">why</declares>)"), Error::Kind::Format,
              "unknown check", "test.xml, line 5, column 18"},
        Wrong{record(kParameter, "m", R"(<declares check="energy"/>)"), Error::Kind::Format, "missing reason",
              "test.xml, line 5, column 2"},
        Wrong{record(kParameter, "m", R"(<declares check="float_accuracy">why</declares>)"), Error::Kind::Format,
              "missing attribute 'allowed' of <declares>", "test.xml, line 5, column 2"},
        Wrong{record(kParameter, "m", R"(<reference author="Me"/>)"), Error::Kind::Format,
              "unknown attribute of <reference>", "test.xml, line 5, column 20"}));

INSTANTIATE_TEST_SUITE_P(
    Parameters, WrongRecord,
    testing::Values(Wrong{record(R"(<parameter default="1" min="0" max="2"/>)"), Error::Kind::Format,
                          "missing attribute 'name'", "test.xml, line 3, column 2"},
                    Wrong{record(R"(<parameter name="m" default="1" min="0"/>)"), Error::Kind::Format,
                          "missing attribute 'max'", "test.xml, line 3, column 2"},
                    Wrong{record(R"(<parameter name="m" default="1" min="zero" max="2"/>)"), Error::Kind::Format,
                          "is no number", "test.xml, line 3, column 38"},
                    Wrong{record(R"(<parameter name="m" default="3" min="0" max="2"/>)"), Error::Kind::Format,
                          "parameter m: bounds out of order", "test.xml, line 3, column 30"},
                    Wrong{record(R"(<parameter name="m" default="1" min="2" max="0"/>)"), Error::Kind::Format,
                          "parameter m: bounds out of order", "test.xml, line 3, column 30"},
                    Wrong{record(R"(<parameter name="m" default="1" min="0" max="2" softMin="-1"/>)"),
                          Error::Kind::Format, "parameter m: bounds out of order", "test.xml, line 3, column 30"},
                    Wrong{record(R"(<parameter name="m" default="1" min="nan" max="2"/>)"), Error::Kind::Format,
                          "parameter m: hard bound", "test.xml, line 3, column 38"},
                    Wrong{record(R"(<parameter name="m" default="1" min="0" max="inf"/>)"), Error::Kind::Format,
                          "parameter m: hard bound", "test.xml, line 3, column 46"},
                    Wrong{record(R"(<parameter name="m" default="1" min="0" max="2" scale="cubic"/>)"),
                          Error::Kind::Format, "parameter m: unknown scale", "test.xml, line 3, column 56"},
                    Wrong{record(R"(<parameter name="m" default="1" min="0" max="2" scale="log"/>)"),
                          Error::Kind::Format, "parameter m: bounds", "test.xml, line 3, column 56"},
                    Wrong{record(R"(<parameter name="m" default="1" min="0" max="2" follows="x"/>)"),
                          Error::Kind::Format, "no parameter to follow", "test.xml, line 3, column 58"},
                    Wrong{record(R"(<parameter name="2m" default="1" min="0" max="2"/>)"), Error::Kind::Format,
                          "no identifier", "test.xml, line 3, column 18"},
                    Wrong{record(R"(<parameter name="uz" default="1" min="0" max="2"/>)"), Error::Kind::Format,
                          "a variable of the formula language has this name", "test.xml, line 3, column 18"},
                    Wrong{record(kParameter + "\n" + kParameter), Error::Kind::Format,
                          "a parameter before has this name", "test.xml, line 4, column 18"}));

INSTANTIATE_TEST_SUITE_P(
    Formulas, WrongRecord,
    testing::Values(Wrong{record(kParameter, "m", R"(<sampler name="Cosine"/><sampler name="Cosine"/>)"),
                          Error::Kind::Format, "missing attribute 'share' of <sampler>", "test.xml, line 5, column 26"},
                    Wrong{record(kParameter, "m", R"(<sampler name="Cosine" cosine="1.5"/>)"), Error::Kind::Format,
                          "share of sampler Cosine", "test.xml, line 5, column 32"},
                    Wrong{record(kParameter, "m", R"(<sampler name="Magic"/>)"), Error::Kind::Value, "unknown sampler",
                          "test.xml, line 5, column 16"},
                    Wrong{record(kParameter, "m", R"(<sampler name="HalfBeckmann" arguments="m"/>)"),
                          Error::Kind::Format, "wrong number of arguments to sampler HalfBeckmann",
                          "test.xml, line 5, column 16"},
                    Wrong{record(kParameter, "m", R"(<sampler name="HalfBeckmann" arguments="m, q"/>)"),
                          Error::Kind::Formula, "unknown name", "test.xml, sampler of Test, line 5, column 44"},
                    Wrong{record(kParameter, "m", R"(<sampler name="Cosine" cosine="0.1 + q"/>)"), Error::Kind::Formula,
                          "unknown name", "test.xml, sampler of Test, line 5, column 38"},
                    Wrong{record(kParameter, "m +\n rough"), Error::Kind::Formula, "unknown name",
                          "test.xml, equation of Test, line 5, column 2"},
                    Wrong{record(kParameter, "\n  m + rough"), Error::Kind::Formula, "unknown name",
                          "test.xml, equation of Test, line 5, column 7"},
                    Wrong{record(kParameter, "m § 2"), Error::Kind::Formula, "unexpected character",
                          "test.xml, equation of Test, line 4, column 13"},
                    Wrong{record(kParameter, "D_GGX(m)"), Error::Kind::Formula, "wrong number of arguments to D_GGX",
                          "test.xml, equation of Test, line 4, column 11"}));

TEST(Record, ACharacterBeyondAsciiIsShownWhole) {
  try {
    FormulaModel(record(kParameter, "m § 2"), "test.xml").compile();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.details().found, "'§'");
  }
}

TEST(Registry, ModelsHaveWhatTheirPagesNeed) {
  std::set<std::string> names;
  for (const ModelPointer& model : allModels()) {
    EXPECT_TRUE(names.insert(model->name()).second) << model->name() << " twice";
    EXPECT_FALSE(model->title().empty()) << model->name();
    EXPECT_FALSE(model->description().empty()) << model->name();
    EXPECT_FALSE(model->references().empty()) << model->name() << " cites nothing";
    for (const Reference& reference : model->references()) {
      EXPECT_TRUE(reference.year > 1700 || reference.venue.find("report") != std::string::npos) << model->name();
      EXPECT_FALSE(reference.authors.empty() || reference.title.empty() || reference.equations.empty())
          << model->name();
    }
    for (const Parameter& parameter : model->parameters()) {
      EXPECT_FALSE(parameter.description.empty() || parameter.unit.empty()) << model->name() << "." << parameter.name;
      if (parameter.scale == Parameter::Scale::Logarithmic) {
        EXPECT_GT(parameter.softMinimum, 0) << model->name() << "." << parameter.name << " is scanned in the logarithm";
      }
    }
    EXPECT_EQ(findModel(model->name()), model);
  }
}

TEST(Registry, UnknownNamesAreRefusedWithTheNearest) {
  try {
    findModel("GXG");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Value);
    EXPECT_NE(error.details().allowed.find("did you mean GGX?"), std::string::npos) << error.what();
  }
  EXPECT_THROW(findModel("GGX")->parameterIndex("beta"), Error);
  EXPECT_THROW(findModel("GGX")->checkBounds(0, 0), Error);
  EXPECT_THROW(findModel("GGX")->checkBounds(0, std::numeric_limits<double>::quiet_NaN()), Error);
  EXPECT_NO_THROW(findModel("GGX")->checkBounds(0, findModel("GGX")->parameters()[0].minimum));
}

TEST(Library, FunctionsAreDescribedAndUsable) {
  for (const LibraryFunction& entry : libraryFunctions()) {
    EXPECT_FALSE(entry.title.empty()) << entry.function.name;
    formula::Graph graph;
    formula::ParseOptions options;
    options.functions = &functionTable();
    options.tables = &tableMap();
    std::string call = entry.function.name + "(";
    for (std::size_t k = 0; k < entry.function.arguments.size(); ++k) call += k == 0 ? "0.5" : ", 0.5";
    EXPECT_NO_THROW(formula::parse(graph, call + ")", options)) << entry.function.name;
  }
}

}  // namespace
}  // namespace brdf
