// Success of every optimizer on fixed lists of cases, and of ours beside Ceres on NIST's: the tables of
// docs/fitting-optimizers.md. See `optimizer_study` without arguments.
#include <brdf/base/Text.h>
#include <brdf/fit/Cost.h>
#include <brdf/fit/DataStart.h>
#include <brdf/fit/StartSearch.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

#include "../tests/fit/NistProblems.h"
#include "StudyCases.h"

namespace brdf::study {
namespace {

struct Outcome {
  double error = 0;
  std::vector<std::vector<double>> parameters;
  std::size_t evaluations = 0;
};

/// What a case is made of, ready to be fitted.
struct Ready {
  FitData data;
  FitProblem problem;
  ChannelRange channels;

  explicit Ready(const Case& one)
      : data(FitData::read(*one.target->samples(), findMetric(one.metric), {})),
        problem(one.lobes, one.target->symmetry()),
        channels{0, data.channels} {}

  Outcome run(const Optimizer& optimizer, const std::vector<double>& start) const {
    OptimizerResult result;
    if (data.metric->quadratic()) {
      SeparableCost cost(problem, data, channels);
      result = optimizer.minimize(cost, start, {});
    } else {
      JointCost cost(problem, data, channels);
      result = optimizer.minimize(cost, cost.join(start, solveScales(problem, data, channels, start)), {});
      result.x.resize(problem.coordinates().size());
    }
    return {std::sqrt(result.squaredError / (data.totalWeight * static_cast<double>(data.channels))),
            problem.parameters(result.x), result.evaluations};
  }
};

/// The optimizer by itself: one run from the case's start, nothing before and nothing after.
Outcome runAlone(const Case& one, const Optimizer& optimizer) {
  const Ready ready(one);
  return ready.run(optimizer, ready.problem.start());
}

/// As a user gets it from `brdf fit`: shapes are scanned for starts, the case's start among them.
Outcome runFit(const Case& one, const Optimizer& optimizer, bool scan = true) {
  FitOptions options;
  options.optimizer = optimizer.name;
  options.metric = one.metric;
  options.scan = scan;
  const FitReport report = fit(*one.target, one.lobes, options);
  Outcome outcome{report.error, {}, report.evaluations};
  for (const Lobe& lobe : report.material->lobes()) {
    std::vector<double>& values = outcome.parameters.emplace_back();
    for (const std::vector<double>& value : lobe.parameters) values.push_back(value.front());
  }
  return outcome;
}

struct Count {
  std::size_t errors = 0, parameters = 0, evaluations = 0;
  std::vector<std::string> failures;

  void add(const Case& one, const Outcome& outcome) {
    evaluations += outcome.evaluations;
    const bool errorFound = outcome.error <= one.wantedError;
    if (errorFound) ++errors;
    if (errorFound && parametersFound(one, outcome.parameters)) ++parameters;
    if (!errorFound)
      failures.push_back(one.label + " (" + formatNumber(outcome.error / one.wantedError, 2) + ")");
    else if (!parametersFound(one, outcome.parameters))
      failures.push_back(one.label + " (other parameters)");
  }
};

void countSuccess(const std::vector<Case>& cases, bool known, std::span<const std::string_view> names) {
  std::vector<Optimizer> optimizers;
  for (const Optimizer& optimizer : allOptimizers())
    if (names.empty() || std::ranges::find(names, optimizer.name) != names.end()) optimizers.push_back(optimizer);
  std::map<std::string_view, std::array<Count, 2>> counts;
  for (const Optimizer& optimizer : optimizers) {
    for (const Case& one : cases) {
      counts[optimizer.name][0].add(one, runAlone(one, optimizer));
      counts[optimizer.name][1].add(one, runFit(one, optimizer));
    }
    std::fprintf(stderr, "%s done\n", std::string(optimizer.name).c_str());
  }
  std::printf(
      "Of %zu cases:\n\n| optimizer | alone%s | evaluations | in `brdf fit`%s | evaluations |\n|---|---|---|---|---|\n",
      cases.size(), known ? ": error, parameters too" : "", known ? ": error, parameters too" : "");
  for (const Optimizer& optimizer : optimizers) {
    std::printf("| %s ", std::string(optimizer.name).c_str());
    for (const Count& count : counts[optimizer.name]) {
      std::printf("| %zu", count.errors);
      if (known) std::printf(", %zu", count.parameters);
      std::printf(" | %zu ", count.evaluations);
    }
    std::printf("|\n");
  }
  for (int mode = 0; mode < 2; ++mode) {
    std::printf("\n%s, failures (error as a multiple of the one wanted):\n\n", mode == 0 ? "Alone" : "In `brdf fit`");
    for (const Optimizer& optimizer : optimizers) {
      const Count& count = counts[optimizer.name][static_cast<std::size_t>(mode)];
      std::printf("- %s: %s\n", std::string(optimizer.name).c_str(),
                  count.failures.empty() ? "none" : joined(count.failures).c_str());
    }
  }
}

/// Levenberg-Marquardt alone, by where it starts.
void countByStart(const std::vector<Case>& cases, bool known) {
  constexpr const char* kNames[] = {"the case's start", "read off the data", "best of the scan", "eight at random"};
  Count counts[std::size(kNames)];
  const Optimizer& optimizer = findOptimizer("lm");
  for (const Case& one : cases) {
    const Ready ready(one);
    if (ready.problem.coordinates().empty()) continue;
    counts[0].add(one, ready.run(optimizer, ready.problem.start()));
    counts[1].add(one, ready.run(optimizer, shapeFromData(ready.problem, ready.data)));
    counts[2].add(one, ready.run(optimizer, scanShapes(ready.problem, ready.data, 1).front().x));
    Outcome best;
    std::size_t evaluations = 0;
    for (const std::vector<double>& start : latinHypercube(ready.problem, 8, 1)) {
      const Outcome outcome = ready.run(optimizer, start);
      evaluations += outcome.evaluations;
      if (best.parameters.empty() || outcome.error < best.error) best = outcome;
    }
    best.evaluations = evaluations;
    counts[3].add(one, best);
  }
  std::printf("| start | found%s | evaluations |\n|---|---|---|\n", known ? ": error, parameters too" : "");
  for (std::size_t k = 0; k < std::size(kNames); ++k)
    std::printf("| %s | %zu%s | %zu |\n", kNames[k], counts[k].errors,
                known ? (", " + std::to_string(counts[k].parameters)).c_str() : "", counts[k].evaluations);
  for (std::size_t k = 0; k < std::size(kNames); ++k)
    std::printf("\n- %s, failures: %s\n", kNames[k],
                counts[k].failures.empty() ? "none" : joined(counts[k].failures).c_str());
}

void listCases(const std::vector<Case>& cases) {
  std::printf("| case | truth | determined |\n|---|---|---|\n");
  for (const Case& one : cases) {
    std::vector<std::string> names;
    for (const auto& [name, value] : one.truth) names.push_back(name);
    std::printf("| %s | %s | %s |\n", one.label.c_str(), one.name.c_str(), joined(names).c_str());
  }
}

/// Ceres' digits by "name,start", from what ceres_nist prints.
std::map<std::string, std::string> ceresDigits(const char* path) {
  std::map<std::string, std::string> digits;
  std::ifstream file(path ? path : "");
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line);
    std::string name, start, value;
    if (std::getline(in, name, ',') && std::getline(in, start, ',') && std::getline(in, value, ','))
      digits[name + "," + start] = value;
  }
  return digits;
}

void nist(const char* ceresPath) {
  const auto ceres = ceresDigits(ceresPath);
  std::printf(
      "| problem | difficulty | start | digits, ours | iterations | digits, Ceres |\n|---|---|---|---|---|---|\n");
  for (NistProblem& problem : nistProblems(BRDF_SOURCE_DIR "/tests/data/nist"))
    for (std::size_t start = 0; start < 2; ++start) {
      OptimizerOptions options;
      options.tolerance = 1e-13;
      options.maximumIterations = 5000;
      const OptimizerResult result = levenbergMarquardt(problem.curve, problem.starts[start], options);
      const auto found = ceres.find(problem.name + "," + std::to_string(start + 1));
      std::printf("| %s | %s | %zu | %.1f | %zu | %s |\n", problem.name.c_str(), problem.difficulty.c_str(), start + 1,
                  correctDigits(result.x, problem.certified), result.iterations,
                  found == ceres.end() ? "" : found->second.c_str());
    }
}

}  // namespace
}  // namespace brdf::study

int main(int count, char** arguments) {
  using namespace brdf::study;
  const std::vector<std::string_view> rest(arguments + std::min(count, 2), arguments + count);
  const std::string what = count > 1 ? arguments[1] : "";
  if (what == "nist")
    nist(count > 2 ? arguments[2] : nullptr);
  else if (what == "cases")
    listCases(recoveryCases());
  else if (what == "reference")
    countSuccess(referenceCases(BRDF_SHARED_DIR), false, rest);
  else if (what == "recovery")
    countSuccess(recoveryCases(), true, rest);
  else if (what == "starts") {
    std::printf("Reference fits:\n\n");
    countByStart(referenceCases(BRDF_SHARED_DIR), false);
    std::printf("\nKnown truths:\n\n");
    countByStart(recoveryCases(), true);
  } else
    return std::printf(
               "optimizer_study nist [FILE of ceres_nist] | cases | starts | reference [OPTIMIZER...] | recovery "
               "[OPTIMIZER...]\n"),
           2;
}
