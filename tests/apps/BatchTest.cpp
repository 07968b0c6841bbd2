#include "Program.h"

#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/fit/StoredFit.h>
#include <brdf/io/Container.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A glossy measurement of few samples; `width` of the highlight in radians.
void writeMeasurement(const fs::path& path, double width) {
  std::string text = "# isotropic\ntheta_i,theta_o,phi_o,value_0\n";
  const double degree = std::acos(-1.0) / 180;
  for (int i = 5; i < 80; i += 15)
    for (int o = 0; o < 80; o += 10)
      for (int p = 0; p <= 180; p += 30) {
        const double x = std::sin(i * degree) + std::sin(o * degree) * std::cos(p * degree);
        const double y = std::sin(o * degree) * std::sin(p * degree);
        const double half = std::atan2(std::hypot(x, y), std::cos(i * degree) + std::cos(o * degree)) / width;
        text += std::to_string(i) + "," + std::to_string(o) + "," + std::to_string(p) + "," +
                brdf::formatNumber(0.1 + 0.5 * std::exp(-half * half)) + "\n";
      }
  brdf::writeFile(path, text);
}

Json job(const Json& fits) {
  return {{"targets", {"a.csv", {{"name", "second"}, {"material", "b.csv"}}}}, {"fits", fits}};
}

void writeJob(const fs::path& folder, const Json& content) {
  writeMeasurement(folder / "a.csv", 0.4);
  writeMeasurement(folder / "b.csv", 0.2);
  brdf::writeFile(folder / "job.json", content.dump());
}

const Json kFits = {{"lobes", {"Lambertian + GGX", "Lambertian + Ward"}}, {"metric", {"rms", "log"}}};

/// The report of a batch without the times that its fits took.
Json timeless(Json report) {
  for (Json& result : report["results"]) result["report"].erase("seconds");
  return report;
}

/// The lines that a run told of finished fits with.
std::size_t finishedFits(const Outcome& run) {
  std::size_t count = 0;
  for (const auto line : brdf::split(run.out, '\n')) count += line.starts_with("[");
  return count;
}

}  // namespace

TEST(Batch, DoesEveryCombinationAsFitDoesAndKeepsItInTheContainer) {
  const auto folder = scratchFolder();
  writeJob(folder, job(kFits));
  const Json report = reportOf(folder, {"batch", "job.json"});
  ASSERT_EQ(report["results"].size(), 8u);
  EXPECT_EQ(report["fitted"], 8);
  const brdf::Container container(folder / "job-results" / "results.vtkhdf");
  ASSERT_EQ(container.entries().size(), 8u);
  std::size_t entry = 0;
  for (const char* target : {"a.csv", "b.csv"})
    for (const char* lobes : {"Lambertian + GGX", "Lambertian + Ward"})
      for (const char* metric : {"rms", "log"}) {
        Json own = reportOf(folder, {"fit", target, "--lobes", lobes, "--metric", metric});
        Json kept = report["results"][entry]["report"];
        for (Json* fit : {&own, &kept}) fit->erase("seconds");
        EXPECT_EQ(kept, own) << target << lobes << metric;
        const brdf::FitReport stored = brdf::loadFit(container, entry);
        EXPECT_EQ(stored.error, own["error"].get<double>());
        EXPECT_EQ(stored.material->description(), own["material"].get<std::string>());
        ++entry;
      }
  EXPECT_EQ(report["results"][4]["target"], "second");
}

TEST(Batch, GoesOnWhereItWasAndDoesNothingTwice) {
  const auto folder = scratchFolder();
  writeJob(folder, job(kFits));
  const Outcome first = runBrdf(folder, {"batch", "job.json", "--json", "first.json"});
  EXPECT_EQ(first.exitCode, 0) << first.err;
  EXPECT_EQ(finishedFits(first), 8u);
  // As after a crash: the results gone, the last record cut short.
  const fs::path journal = folder / "job-results/journal-0.jsonl";
  fs::resize_file(journal, fs::file_size(journal) - 10);
  fs::remove(folder / "job-results/results.csv");
  fs::remove(folder / "job-results/results.vtkhdf");
  brdf::writeFile(folder / "job-results/.results.part123-0.vtkhdf", "half");
  const Outcome second = runBrdf(folder, {"batch", "job.json", "--json", "second.json"});
  EXPECT_EQ(second.exitCode, 0) << second.err;
  EXPECT_EQ(finishedFits(second), 1u) << second.out;
  EXPECT_NE(second.out.find("1 lines of the journals are not whole"), std::string::npos) << second.out;
  EXPECT_EQ(filesIn(folder / "job-results"),
            (std::vector<std::string>{"journal-0.jsonl", "lock", "results.csv", "results.vtkhdf"}));
  EXPECT_EQ(timeless(Json::parse(brdf::readFile(folder / "second.json"))),
            timeless(Json::parse(brdf::readFile(folder / "first.json"))));
  EXPECT_EQ(finishedFits(runBrdf(folder, {"batch", "job.json"})), 0u);
}

TEST(Batch, AChangedJobOrTargetIsDoneAnewAndOnlyThat) {
  const auto folder = scratchFolder();
  writeJob(folder, job(kFits));
  ASSERT_EQ(runBrdf(folder, {"batch", "job.json"}).exitCode, 0);
  Json fits = kFits;
  fits["metric"].push_back("cuberoot");
  brdf::writeFile(folder / "job.json", job(fits).dump());
  const Outcome more = runBrdf(folder, {"batch", "job.json"});
  EXPECT_EQ(finishedFits(more), 4u) << more.out;

  writeMeasurement(folder / "b.csv", 0.3);
  const Json before = Json::parse(runBrdf(folder, {"batch", "job.json", "--plan", "--json", "-"}).out);
  EXPECT_EQ(before["open"], 6);
  const Outcome other = runBrdf(folder, {"batch", "job.json"});
  EXPECT_EQ(finishedFits(other), 6u) << other.out;

  fits["max-theta"] = 60;
  brdf::writeFile(folder / "job.json", job(fits).dump());
  EXPECT_EQ(finishedFits(runBrdf(folder, {"batch", "job.json"})), 12u);
  EXPECT_EQ(reportOf(folder, {"batch", "job.json"})["fitted"], 12);
}

TEST(Batch, AFitThatFailsIsRecordedAndTheOthersAreDone) {
  const auto folder = scratchFolder();
  writeJob(folder, job({{"metric", {"rms", "log"}}, {"strategy", "separable"}}));  // log has no linear scales
  const Outcome run = runBrdf(folder, {"batch", "job.json", "--json", "out.json"});
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_NE(run.err.find("2 failed"), std::string::npos) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  const Json report = Json::parse(brdf::readFile(folder / "out.json"));
  EXPECT_EQ(report["fitted"], 2);
  EXPECT_NE(report["results"][1]["failed"].get<std::string>().find("quadratic"), std::string::npos) << report;
  EXPECT_EQ(finishedFits(runBrdf(folder, {"batch", "job.json"})), 0u);
  EXPECT_EQ(finishedFits(runBrdf(folder, {"batch", "job.json", "--retry"})), 2u);
}

TEST(Batch, TargetsOfOneContentAreFittedOnceAndHaveRowsOfTheirOwn) {
  const auto folder = scratchFolder();
  writeJob(folder, job(kFits));
  fs::copy_file(folder / "a.csv", folder / "b.csv", fs::copy_options::overwrite_existing);
  EXPECT_EQ(finishedFits(runBrdf(folder, {"batch", "job.json"})), 4u);
  const Json report = reportOf(folder, {"batch", "job.json"});
  EXPECT_EQ(report["fitted"], 8);
  EXPECT_EQ(report["results"][1]["report"], report["results"][5]["report"]);
  EXPECT_EQ(report["results"][5]["target"], "second");
  EXPECT_EQ(brdf::Container(folder / "job-results/results.vtkhdf").entries().size(), 8u);
}

TEST(Batch, WhatAppearsTwiceIsDoneOnce) {
  const auto folder = scratchFolder();
  writeJob(folder, job(Json::array({{{"lobes", "Lambertian + Ward"}, {"metric", {"rms", "log"}}},
                                    {{"title", "again"}, {"metric", "rms"}, {"lobes", "Lambertian + Ward"}}})));
  EXPECT_EQ(finishedFits(runBrdf(folder, {"batch", "job.json"})), 4u);
}

TEST(Batch, AnOptionMayBeGivenSeveralTimesAndAFlagMayBeOnOrOff) {
  const auto folder = scratchFolder();
  writeJob(folder, job({{"fix", Json::array({Json::array({"GGX.alpha=0.3", "GGX.ior=1.6"}), "GGX.ior=1.4"})},
                        {"progressive", {true, false}}}));
  const Json report = reportOf(folder, {"batch", "job.json"});
  ASSERT_EQ(report["results"].size(), 8u);
  EXPECT_NE(report["results"][0]["report"]["material"].get<std::string>().find("alpha=0.3, ior=1.6"),
            std::string::npos);
  EXPECT_NE(report["results"][2]["report"]["material"].get<std::string>().find("ior=1.4"), std::string::npos);
}

TEST(Batch, AFaultOfTheJobIsToldWithItsPlaceBeforeAnythingIsFitted) {
  const auto folder = scratchFolder();
  writeJob(folder, {});
  const std::pair<std::string, std::vector<const char*>> faults[] = {
      {"{\"targets\": [\"a.csv\"],\n \"fits\": {\"metric\": rms}}", {"job.json, line 2", "not JSON"}},
      {"[]", {"not a job"}},
      {R"({"fits": {}})", {"no targets"}},
      {R"({"target": ["a.csv"], "fits": {}})", {"\"target\"", "nearest: targets"}},
      {R"({"targets": [], "fits": {}})", {"targets"}},
      {R"({"targets": ["missing.csv"], "fits": {}})", {"no such file", "missing.csv"}},
      {R"({"targets": ["0.3*Lambertain"], "fits": {}})", {"Lambertian"}},
      {R"({"targets": ["a.csv", "a.csv"], "fits": {}})", {"two targets of one name", "targets[1]"}},
      {R"({"targets": [{"materail": "a.csv"}], "fits": {}})", {"targets[0]", "nearest: material"}},
      {R"({"targets": ["a.csv"], "fits": []})", {"no fits"}},
      {R"({"targets": ["a.csv"], "fits": {"metric": []}})", {"empty list", "fits: metric"}},
      {R"({"targets": ["a.csv"], "fits": {"metrik": "rms"}})", {"--metrik", "--metric (nearest)"}},
      {R"({"targets": ["a.csv"], "fits": [{}, {"metric": "rmss"}]})", {"fits[1]", "rmss", "rms_cos"}},
      {R"({"targets": ["a.csv"], "fits": {"lobes": "Lambertain"}})", {"--lobes", "Lambertian"}},
      {R"({"targets": ["a.csv"], "fits": {"max-theta": 91}})", {"--max-theta", "91", "0 to 90"}},
      {R"({"targets": ["a.csv"], "fits": {"--metric": "rms"}})", {"--metric", "without its dashes"}},
      {R"({"targets": ["a.csv"], "fits": {"help": true}})", {"not an option of a fit"}},
      {R"({"targets": ["a.csv"], "fits": {"fix": {"ior": 1.5}}})", {"fits: fix", "not a value"}}};
  for (const auto& [text, expected] : faults) {
    brdf::writeFile(folder / "job.json", text);
    const Outcome run = runBrdf(folder, {"batch", "job.json", "--out", "out"});
    EXPECT_NE(run.exitCode, 0) << text;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    for (const char* words : expected) EXPECT_NE(run.err.find(words), std::string::npos) << words << "\n" << run.err;
    EXPECT_FALSE(fs::exists(folder / "out")) << text;
  }
}

TEST(Batch, TooManyFitsAreRefusedBeforeMemoryIsTaken) {
  const auto folder = scratchFolder();
  Json seeds = Json::array();
  for (int seed = 0; seed < 1000; ++seed) seeds.push_back(seed);
  writeJob(folder, job({{"seed", seeds}, {"starts", seeds}}));
  const Outcome run = runBrdf(folder, {"batch", "job.json"});
  EXPECT_NE(run.exitCode, 0);
  EXPECT_NE(run.err.find("too many fits"), std::string::npos) << run.err;
}

TEST(Batch, CtrlCKeepsWhatIsDoneAndTheNextStartGoesOn) {
  const auto folder = scratchFolder();
  Json seeds = Json::array();
  for (int seed = 1; seed <= 200; ++seed) seeds.push_back(seed);
  writeJob(folder, job({{"seed", seeds}, {"starts", 100}}));
  const Outcome stopped = runLine(folder, "{ '" BRDF_PROGRAM
                                          "' batch job.json > out & p=$!;"
                                          " until grep -q '^\\[2/' out; do sleep 0.02; done; kill -INT $p; wait $p; }");
  EXPECT_EQ(stopped.exitCode, 1);
  EXPECT_NE(stopped.err.find("the same command goes on"), std::string::npos) << stopped.err;
  const Json left = Json::parse(runBrdf(folder, {"batch", "job.json", "--plan", "--json", "-"}).out);
  EXPECT_GE(left["fitted"], 2);
  EXPECT_GT(left["open"], 0);
  EXPECT_EQ(left["fitted"].get<int>() + left["open"].get<int>(), 400);
  EXPECT_EQ(brdf::Container(folder / "job-results/results.vtkhdf").entries().size(), left["fitted"].get<std::size_t>());
}

TEST(Batch, OneBatchAtATimeWorksInAFolder) {
  const auto folder = scratchFolder();
  writeJob(folder, job(kFits));
  ASSERT_EQ(runBrdf(folder, {"batch", "job.json"}).exitCode, 0);
  const Outcome second = runLine(folder, "{ flock job-results/lock '" BRDF_PROGRAM "' batch job.json > /dev/null; }");
  EXPECT_EQ(second.exitCode, 1);
  EXPECT_NE(second.err.find("another batch is at work"), std::string::npos) << second.err;
}

TEST(Batch, TheReportHasATableForEachPartWithTheBestInBoldAndTheNote) {
  const auto folder = scratchFolder();
  Json content = job(Json::array(
      {{{"title", "First part"}, {"lobes", {"Lambertian", "Lambertian + GGX"}}},
       {{"title", "Second part"}, {"lobes", "Lambertian"}, {"strategy", {"joint", "separable"}}, {"metric", "log"}}}));
  content["note"] = "surrogate";
  writeJob(folder, content);
  const Outcome run = runBrdf(folder, {"batch", "job.json", "--report", "report", "--json", "all.json"});
  EXPECT_EQ(run.exitCode, 1);  // log has no linear scales
  const Json all = Json::parse(brdf::readFile(folder / "all.json"));
  const std::string report = brdf::readFile(folder / "report/report.md");
  for (const char* words : {"## First part", "## Second part", "**surrogate**", "| Lambertian + GGX | **",
                            "second, strategy separable: ", "quadratic"})
    EXPECT_NE(report.find(words), std::string::npos) << words << "\n" << report;
  const Json& fit = all["results"][1]["report"];
  const double ratio = fit["error"].get<double>() / fit["zero_model"]["rms"].get<double>();
  EXPECT_NE(report.find("**" + brdf::formatNumber(ratio, 3) + "**"), std::string::npos) << report;
  const std::string table = brdf::readFile(folder / "report/table-1.csv");
  const auto lines = brdf::split(table, '\n');
  ASSERT_EQ(lines.size(), 6u);  // a heading, two targets by two sums of lobes, the end
  for (std::size_t k = 1; k < 5; ++k) EXPECT_TRUE(lines[k].ends_with("\"surrogate\"")) << lines[k];
  if (report.find("No pictures") != std::string::npos) GTEST_SKIP() << "no pictures here: " << report;
  EXPECT_EQ(filesIn(folder / "report"),
            (std::vector<std::string>{"error-map-1-1.png", "error-map-1-2.png", "errors-1.png", "errors-2.png",
                                      "lobes-1-1.png", "lobes-1-2.png", "report.md", "spheres-1.png", "table-1.csv",
                                      "table-2.csv"}));
}

namespace {

/// Runs scripts/section7.sh with a program that makes small measurements and plans instead of fitting.
Outcome planSection7(const fs::path& folder, const std::string& arguments) {
  writeMeasurement(folder / "small.csv", 0.3);
  brdf::writeFile(folder / "planner.sh", "#!/bin/sh\nif [ \"$1\" = convert ]; then cp '" + folder.string() +
                                             "/small.csv' \"$3\"; echo \"# $2\" >> \"$3\"; else exec '" BRDF_PROGRAM
                                             "' \"$@\" --plan; fi\n");
  fs::permissions(folder / "planner.sh", fs::perms::owner_all);
  return runLine(folder,
                 "BRDF=" + (folder / "planner.sh").string() + " " BRDF_SOURCE_DIR "/scripts/section7.sh " + arguments);
}

}  // namespace

TEST(Section7, WithoutTheMeasurementsEveryFitSaysSurrogate) {
  const auto folder = scratchFolder();
  const Outcome run = planSection7(folder, "--merl none --out out");
  EXPECT_EQ(run.exitCode, 0) << run.err;
  std::size_t fits = 0;
  for (const auto line : brdf::split(run.out, '\n'))
    if (line.ends_with(")") && line.find(": Lambertian + ") != std::string_view::npos) {
      EXPECT_NE(line.find("(surrogate)"), std::string_view::npos) << line;
      ++fits;
    }
  EXPECT_EQ(fits, 76u) << run.out;
  EXPECT_NE(Json::parse(brdf::readFile(folder / "out/section7.json"))["note"].get<std::string>().find("surrogate"),
            std::string::npos);
}

TEST(Section7, WithAllFourMeasurementsItFitsThoseAndWithThreeOnlySurrogates) {
  const auto folder = scratchFolder();
  fs::create_directories(folder / "merl");
  int number = 0;
  for (const char* name : {"red-fabric", "orange-paint", "pearl-paint"})
    writeMeasurement(folder / "merl" / (std::string(name) + ".binary"), 0.2 + 0.1 * ++number);
  EXPECT_NE(planSection7(folder, "--merl merl --out three").out.find("(surrogate)"), std::string::npos);
  writeMeasurement(folder / "merl/blue-metallic-paint.binary", 0.6);
  const Outcome run = planSection7(folder, "--merl merl --out four");
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.out.find("surrogate"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("blue-metallic-paint: Lambertian + Ward"), std::string::npos) << run.out;
}

TEST(Section7, WrongUsageIsToldInOneLine) {
  const auto folder = scratchFolder();
  for (const char* arguments : {"--nonsense", "--merl", "--ranks 0", "--ranks two"}) {
    const Outcome run = planSection7(folder, arguments);
    EXPECT_EQ(run.exitCode, 2) << arguments;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}
