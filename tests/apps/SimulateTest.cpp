#include "Program.h"

#include <brdf/io/Container.h>
#include <brdf/material/GridBrdf.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using json = nlohmann::json;

TEST(Simulate, ATableReadsBackWithErrorsComponentsAndItsMaking) {
  const auto folder = scratchFolder();
  const json report =
      reportOf(folder, {"simulate", "spheres(count=20, radius=1)", "--facet", "dielectric(eta=1.5)", "--facet",
                        "dielectric(eta=1.33)", "--theta-i", "0,60", "--tolerance", "0.2", "--out", "water.vtkhdf"});
  EXPECT_TRUE(report["complete"]);
  EXPECT_EQ(report["facets"].size(), 2u);
  ASSERT_EQ(report["directions"].size(), 2u);
  for (const json& direction : report["directions"]) {
    const double sum = direction["reflected"][0]["value"].get<double>() +
                       direction["transmitted"][0]["value"].get<double>() +
                       direction["absorbed"][0]["value"].get<double>() + direction["lost"][0]["value"].get<double>();
    EXPECT_NEAR(sum, direction["sum"][0]["value"].get<double>(), 1e-9);
    EXPECT_NEAR(sum, 1, 5 * direction["sum"][0]["error"].get<double>() + 1e-9);
  }
  const brdf::Container file(folder / "water.vtkhdf");
  const auto grid = std::dynamic_pointer_cast<const brdf::GridBrdf>(file.load(0));
  ASSERT_TRUE(grid);
  EXPECT_FALSE(grid->data().standardError.empty());
  const brdf::Components components = file.components(0);
  EXPECT_TRUE(components.find(brdf::ComponentKind::FrontTransmission));
  EXPECT_NE(file.provenance(0).read.metadata.at("energy balance").find("\"lost\""), std::string::npos);
}

TEST(Simulate, APerfectMirrorIsASpecularComponent) {
  const auto folder = scratchFolder();
  reportOf(folder, {"simulate", "flat", "--theta-i", "0,80", "--out", "mirror.vtkhdf"});
  const brdf::Components components = brdf::Container(folder / "mirror.vtkhdf").components(0);
  ASSERT_EQ(components.specular.size(), 1u);
  EXPECT_EQ(components.specular[0].values, (std::vector<double>{1, 1}));
}

#ifdef BRDF_HAS_PICTURES
TEST(Simulate, TheGraphicsDeviceAnswersLikeTheProcessor) {
  const auto folder = scratchFolder();
  std::vector<json> reports;
  for (const char* backend : {"cpu", "gpu"})
    reports.push_back(reportOf(folder, {"simulate", "gaussian(rms=0.3, correlation=2)", "--facet",
                                        "conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2)", "--theta-i", "60", "--tolerance",
                                        "0.2", "--backend", backend, "--out", std::string(backend) + ".vtkhdf"}));
  for (std::size_t c = 0; c < 3; ++c) {
    const json &cpu = reports[0]["directions"][0]["reflected"][c], &gpu = reports[1]["directions"][0]["reflected"][c];
    EXPECT_GT(gpu["value"].get<double>(), 0.3);
    EXPECT_NEAR(cpu["value"].get<double>(), gpu["value"].get<double>(),
                5 * std::hypot(cpu["error"].get<double>(), gpu["error"].get<double>()));
  }
}
#endif

TEST(Simulate, AnInterruptKeepsTheDirectionsThatAreDone) {
  const auto folder = scratchFolder();
  // The first direction of light takes no time: all of it is specular.
  const Outcome outcome = runLine(
      folder,
      "{ '" BRDF_PROGRAM
      "' simulate 'grooves(width=10, spacing=10, angle=90)' --theta-i 0,30 --tolerance 1e-6 --rays 1000000000000 "
      "--out g.vtkhdf > out & p=$!; until grep -q rays out; do sleep 0.1; done; kill -INT $p; wait $p; }");
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
  EXPECT_EQ(filesIn(folder), (std::vector<std::string>{"g.vtkhdf", "out"}));
  const auto grid = std::dynamic_pointer_cast<const brdf::GridBrdf>(brdf::Container(folder / "g.vtkhdf").load(0));
  ASSERT_TRUE(grid);
  const auto& states = grid->data().states;  // theta_i is the slowest axis
  const std::size_t half = states.size() / 2;
  for (std::size_t k = 0; k < states.size(); ++k)
    ASSERT_EQ(states[k],
              k < half ? brdf::stateByte(brdf::CellState::Measured) : brdf::stateByte(brdf::CellState::Invalid));
}

TEST(Simulate, MistakesAreOneLineWithTheRightExitCode) {
  const auto folder = scratchFolder();
  const std::vector<std::pair<std::vector<std::string>, int>> cases = {
      {{"grooves(witdh=4)"}, 1},           {{"nosuch"}, 1},
      {{"flat", "--facet", "gold"}, 1},    {{"flat", "--backend", "abacus"}, 1},
      {{"flat", "--theta-i", "30,20"}, 1}, {{"flat", "--theta-i", "90"}, 2},
      {{"flat", "--theta-i", "x"}, 2},     {{"flat", "--tolerance", "0"}, 2},
      {{"flat", "--bins", "round"}, 2},    {{"flat", "--rays", "0"}, 2},
      {{"mesh(file=missing.ply)"}, 1}};
  for (auto [words, code] : cases) {
    words.insert(words.begin(), "simulate");
    const Outcome run = runBrdf(folder, words);
    EXPECT_EQ(run.exitCode, code) << words.back() << ": " << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  EXPECT_TRUE(filesIn(folder).empty());
}
