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

/// A record with the given pieces, right everywhere else.
std::string record(const std::string& parameters, const std::string& equation = "m / pi",
                   const std::string& sampler = "", const std::string& attributes = R"(name="Test" title="A test")") {
  return "<model " + attributes + "><description>words</description>" + parameters + "<equation>" + equation +
         "</equation>" + sampler + "</model>";
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

const std::string kParameterPlace = "test.xml, parameter m";

INSTANTIATE_TEST_SUITE_P(
    Table, WrongRecord,
    testing::Values(
        Wrong{"", Error::Kind::Format, "not well-formed XML", "test.xml, byte 0"},
        Wrong{"<model><x></model>", Error::Kind::Format, "not well-formed XML", "test.xml, byte 12"},
        Wrong{"<lobe/>", Error::Kind::Format, "wrong root element", "test.xml"},
        Wrong{"<model title='t'><equation>1</equation></model>", Error::Kind::Format, "missing attribute 'name'",
              "test.xml"},
        Wrong{"<model name='n'><equation>1</equation></model>", Error::Kind::Format, "missing attribute 'title'",
              "test.xml"},
        Wrong{"<model name='n' title='t'/>", Error::Kind::Format, "missing <equation>", "test.xml"},
        Wrong{record(kParameter, "m", "", R"(name="T" title="t" isotropic="maybe")"), Error::Kind::Format, "isotropic",
              "test.xml"},
        Wrong{record(R"(<parameter default="1" min="0" max="2"/>)"), Error::Kind::Format, "missing attribute 'name'",
              "test.xml"},
        Wrong{record(R"(<parameter name="m" default="1" min="0"/>)"), Error::Kind::Format, "missing attribute 'max'",
              kParameterPlace},
        Wrong{record(R"(<parameter name="m" default="1" min="zero" max="2"/>)"), Error::Kind::Format, "is no number",
              kParameterPlace},
        Wrong{record(R"(<parameter name="m" default="3" min="0" max="2"/>)"), Error::Kind::Format,
              "bounds out of order", kParameterPlace},
        Wrong{record(R"(<parameter name="m" default="1" min="2" max="0"/>)"), Error::Kind::Format,
              "bounds out of order", kParameterPlace},
        Wrong{record(R"(<parameter name="m" default="1" min="0" max="2" softMin="-1"/>)"), Error::Kind::Format,
              "bounds out of order", kParameterPlace},
        Wrong{record(R"(<parameter name="m" default="1" min="nan" max="2"/>)"), Error::Kind::Format, "",
              kParameterPlace},
        Wrong{record(R"(<parameter name="m" default="1" min="0" max="2" scale="cubic"/>)"), Error::Kind::Format,
              "unknown scale", kParameterPlace},
        Wrong{record(R"(<parameter name="m" default="1" min="0" max="2" follows="x"/>)"), Error::Kind::Value,
              "unknown parameter", "Test"},
        Wrong{record(kParameter, "m", R"(<declares check="nothing">why</declares>)"), Error::Kind::Format,
              "unknown check", "test.xml, declaration of nothing"},
        Wrong{record(kParameter, "m", R"(<declares check="energy"/>)"), Error::Kind::Format, "missing reason",
              "test.xml, declaration of energy"},
        Wrong{record(kParameter, "m", R"(<declares check="float_accuracy">why</declares>)"), Error::Kind::Format,
              "missing attribute 'allowed' of <declares>", "test.xml, declaration of float_accuracy"},
        Wrong{record(kParameter, "m", R"(<sampler name="Cosine"/><sampler name="Cosine"/>)"), Error::Kind::Format,
              "missing attribute 'share' of <sampler>", "test.xml"},
        Wrong{record(kParameter, "m", R"(<sampler name="Magic"/>)"), Error::Kind::Value, "unknown sampler", "test.xml"},
        Wrong{record(kParameter, "m", R"(<sampler name="HalfBeckmann" arguments="m"/>)"), Error::Kind::Format,
              "wrong number of arguments to sampler HalfBeckmann", "test.xml"},
        Wrong{record(kParameter, "m", R"(<sampler name="HalfBeckmann" arguments="m, q"/>)"), Error::Kind::Formula,
              "unknown name", "test.xml, sampler of Test, line 1, column 1"},
        Wrong{record(kParameter, "m +\n rough"), Error::Kind::Formula, "unknown name",
              "test.xml, equation of Test, line 2, column 2"},
        Wrong{record(kParameter, "D_GGX(m)"), Error::Kind::Formula, "wrong number of arguments to D_GGX",
              "test.xml, equation of Test, line 1, column 1"}));

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
