#include "Program.h"

#include <brdf/base/File.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using nlohmann::json;

namespace {

const std::string kTruth = "0.3*Lambertian + 0.05*GGX(alpha=0.25, ior=1.5)";

std::set<std::string> keysOf(const json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

void expectKeys(const json& object, const std::set<std::string>& keys) {
  const auto present = keysOf(object);
  for (const std::string& key : keys) EXPECT_TRUE(present.count(key)) << "no " << key;
}

}  // namespace

TEST(Report, ModelsListEveryParameterWithinItsBounds) {
  const json models = reportOf(scratchFolder(), {"models"});
  ASSERT_TRUE(models.is_array());
  std::set<std::string> names;
  for (const json& model : models) {
    expectKeys(model, {"name", "parameters", "reference"});
    names.insert(model["name"]);
    EXPECT_NE(model["reference"], "") << model["name"];
    for (const json& p : model["parameters"]) {
      expectKeys(p, {"name", "default", "min", "max", "unit", "description"});
      EXPECT_LE(p["min"], p["default"]) << model["name"] << p["name"];
      EXPECT_LE(p["default"], p["max"]) << model["name"] << p["name"];
      EXPECT_NE(p["unit"], "");
      EXPECT_NE(p["description"], "");
    }
  }
  for (const char* name : {"Lambertian", "BlinnPhong", "Ward", "AshikhminShirley", "CookTorrance", "GGX"})
    EXPECT_TRUE(names.count(name)) << name;
}

TEST(Report, AModelsPageHasItsFormula) {
  const json page = reportOf(scratchFolder(), {"models", "GGX"});
  ASSERT_EQ(page.size(), 1u);
  EXPECT_NE(page[0]["equation"], "");
}

TEST(Report, InfoMeasuresTheAlbedoOfALambertian) {
  const json info = reportOf(scratchFolder(), {"info", "(0.5,0.25,1)*Lambertian"});
  EXPECT_EQ(info["kind"], "expression");
  EXPECT_EQ(info["channels"], 3);
  const std::vector<double> expected = {0.5, 0.25, 1};
  for (const json& albedo : info["albedo"])
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(albedo["value"][c].get<double>(), expected[c], 1e-9);
      EXPECT_LT(albedo["std_error"][c].get<double>(), 1e-9);
    }
  EXPECT_EQ(info["energy"]["violations"], 0);
  EXPECT_EQ(info["reciprocity"]["violations"], 0);
}

TEST(Report, InfoCountsTheAlbedosThatBreakEnergyConservation) {
  const json info = reportOf(scratchFolder(), {"info", "1.5*Lambertian"});
  EXPECT_EQ(info["energy"]["violations"], info["energy"]["tested"]);
  EXPECT_NEAR(info["energy"]["worst"].get<double>(), 1.5, 1e-9);
}

TEST(Report, AFitRecoversTheMaterialItsTableWasMadeOf) {
  const auto folder = scratchFolder();
  ASSERT_EQ(runBrdf(folder, {"convert", kTruth, "truth.binary"}).exitCode, 0);
  const json fit = reportOf(folder, {"fit", "truth.binary", "--lobes", "Lambertian + GGX", "--fix", "GGX.ior=1.5",
                                     "--channels", "luminance", "--max-theta", "75", "--out", "fit.vtkhdf"});
  expectKeys(fit, {"material", "metric", "error", "metrics", "zero_model", "seconds", "evaluations", "samples",
                   "channels", "converged", "termination", "parameters"});
  EXPECT_TRUE(fit["converged"]);
  EXPECT_EQ(fit["channels"], 1);
  for (const char* metric : {"rms", "rms_cos", "log", "cuberoot"}) {
    EXPECT_LT(fit["metrics"][metric].get<double>(), 1e-5 * fit["zero_model"][metric].get<double>()) << metric;
  }
  EXPECT_EQ(fit["error"], fit["metrics"]["rms"]);
  bool alphaSeen = false;
  for (const json& p : fit["parameters"]) {
    expectKeys(p, {"name", "lobe", "channel", "value", "std_error", "min", "max", "at_bound"});
    if (p["name"] == "alpha") {
      alphaSeen = true;
      EXPECT_NEAR(p["value"].get<double>(), 0.25, 1e-6);
    }
    if (p["name"] == "ior") {
      EXPECT_EQ(p["value"], 1.5);
    }
  }
  EXPECT_TRUE(alphaSeen);

  const json stored = reportOf(folder, {"compare", "fit.vtkhdf", fit["material"].get<std::string>()});
  EXPECT_EQ(stored["metrics"]["rms"], 0.0) << "the container holds another material than the report names";
}

TEST(Report, AFormulaIsFittedWhereAskedAndTheReportSaysWhere) {
  const json fit =
      reportOf(scratchFolder(), {"fit", kTruth, "--lobes", "Lambertian + GGX", "--fix", "ior=1.5", "--sampling",
                                 "importance", "--samples", "5000", "--seed", "3", "--metric", "huber:0.5"});
  EXPECT_LT(fit["error"].get<double>(), 1e-6 * fit["zero_model"]["huber:0.5"].get<double>());
  EXPECT_EQ(fit["target"]["weights"], "importance");
  EXPECT_EQ(fit["target"]["sampling"], "5000 draws by importance, seed 3");
  EXPECT_GT(fit["constant_model"]["error"], fit["error"]);
  EXPECT_EQ(fit["constant_model"]["values"].size(), 1u);
}

TEST(Report, OfSeveralLobesTheBestIsKeptAndAFitGoesOnFromIt) {
  const auto folder = scratchFolder();
  const json fit =
      reportOf(folder, {"fit", kTruth, "--samples", "2000", "--max-theta", "80", "--lobes", "Lambertian", "--lobes",
                        "Lambertian + GGX", "--fix", "ior=1.5", "--cross-validate", "3", "--out", "fit.vtkhdf"});
  ASSERT_EQ(fit["candidates"].size(), 2u);
  EXPECT_EQ(fit["candidates"][0]["lobes"], "Lambertian + GGX");
  EXPECT_LT(fit["cross_validation"]["error"].get<double>(), 1e-6);
  EXPECT_EQ(fit["regions"].size(), 4u);
  EXPECT_EQ(fit["covariance"]["parameters"].size(), 3u);
  const json again = reportOf(folder, {"fit", kTruth, "--samples", "2000", "--max-theta", "80", "--from", "fit.vtkhdf",
                                       "--fix", "ior=1.5", "--tie", "alpha_y=alpha"});
  EXPECT_LT(again["error"].get<double>(), 1e-6);
  EXPECT_LT(again["evaluations"], fit["evaluations"]);
}

TEST(Report, CompareIsZeroForTheSameMaterialAndTheZeroModelIsNot) {
  const json report = reportOf(scratchFolder(), {"compare", kTruth, kTruth});
  for (const char* metric : {"rms", "rms_cos", "log", "cuberoot"}) {
    EXPECT_EQ(report["metrics"][metric], 0.0) << metric;
    EXPECT_GT(report["zero_model"][metric], 0.0) << metric;
  }
}

TEST(Report, ConvertingATableToTheContainerLosesNothing) {
  const auto folder = scratchFolder();
  ASSERT_EQ(runBrdf(folder, {"convert", "(0.3,0.2,0.1)*Lambertian", "a.binary"}).exitCode, 0);
  const json report = reportOf(folder, {"convert", "a.binary", "a.vtkhdf"});
  const json& trip = report["round_trip"];
  EXPECT_LT(trip["metrics"]["rms"].get<double>(),
            1e-15 * trip["zero_model"]["rms"].get<double>());  // interpolation rounds
  EXPECT_EQ(report["losses"].size(), 0u);
}

TEST(Report, AnExportStatesItsErrorWhereAndUnderWhichConditions) {
  const auto folder = scratchFolder();
  const std::set<std::string> keys = {"material",  "format",    "out",     "exact",      "reason",
                                      "evaluated", "max_theta", "metrics", "zero_model", "samples",
                                      "sampling",  "worst",     "colour",  "notes"};
  const json exact = reportOf(folder, {"export", "0.5*Lambertian", "--format", "osl", "--out", "a.osl"});
  EXPECT_EQ(keysOf(exact), keys);
  EXPECT_TRUE(exact["exact"]);
  EXPECT_EQ(exact["reason"], "");
  EXPECT_EQ(exact["metrics"]["rms"], 0.0);
  EXPECT_EQ(exact["format"], "osl");
  EXPECT_EQ(exact["max_theta"], 80);
  expectKeys(exact["colour"], {"illuminant", "observer", "adaptation"});

  const json fitted = reportOf(folder, {"export", "0.4*Lambertian + 0.2*Ward(ax=0.3)", "--format", "osl", "--out",
                                        "b.osl", "--max-theta", "70"});
  EXPECT_EQ(keysOf(fitted), keys);
  EXPECT_FALSE(fitted["exact"]);
  EXPECT_NE(fitted["reason"], "");
  EXPECT_EQ(fitted["max_theta"], 70);
  expectKeys(fitted["worst"], {"difference", "evaluated", "material", "theta_i", "phi_i", "theta_o", "phi_o"});
  EXPECT_LE(fitted["worst"]["theta_i"].get<double>(), 70 + 1e-9);
  EXPECT_NEAR(fitted["worst"]["difference"].get<double>(),
              std::abs(fitted["worst"]["evaluated"].get<double>() - fitted["worst"]["material"].get<double>()), 1e-12);
  // `evaluated` is an expression that compares with the material as the report says.
  const json again =
      reportOf(folder, {"compare", fitted["evaluated"].get<std::string>(), fitted["material"], "--max-theta", "70"});
  EXPECT_NEAR(again["metrics"]["rms"].get<double>(), fitted["metrics"]["rms"].get<double>(),
              1e-9 * fitted["zero_model"]["rms"].get<double>());
}

TEST(Report, JsonGoesToAFileBesideTheTextToo) {
  const auto folder = scratchFolder();
  const Outcome run = runBrdf(folder, {"eval", "Lambertian", "--at", "0,0,0,0", "--json", "report.json"});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_NE(run.out, "");
  EXPECT_EQ(json::parse(brdf::readFile(folder / "report.json"))["values"].size(), 1u);
}

TEST(Report, NumbersDoNotDependOnTheLocale) {
  const Outcome run =
      runBrdf(scratchFolder(), {"eval", "0.5*Lambertian", "--at", "1.5,0,2.5,0"}, {{"LC_ALL", "de_DE.UTF-8"}});
  EXPECT_NE(run.out.find("0.15915494309189"), std::string::npos) << run.out << run.err;
}
