#include <brdf/base/Error.h>
#include <brdf/fit/ModelChoice.h>

#include <algorithm>

namespace brdf {
namespace {

FitCandidate summary(const FitReport& report, std::string lobes) {
  FitCandidate candidate{std::move(lobes), report.error, report.degrees, report.aic, report.bic, {}, report.converged};
  if (report.crossValidation) candidate.crossValidation = report.crossValidation->error;
  return candidate;
}

bool better(const FitCandidate& a, const FitCandidate& b) {
  if (a.crossValidation && b.crossValidation) return *a.crossValidation < *b.crossValidation;
  return a.bic < b.bic;
}

/// The options with a progress function that remembers a wish to stop.
FitOptions watched(const FitOptions& options, bool& stopped) {
  FitOptions own = options;
  if (options.progress)
    own.progress = [&options, &stopped](std::size_t iteration, double error) {
      if (!options.progress(iteration, error)) stopped = true;
      return !stopped;
    };
  return own;
}

}  // namespace

FitReport fitBest(const Brdf& target, const std::vector<CandidateLobes>& candidates, const FitOptions& options) {
  if (candidates.empty()) throw Error(Error::Kind::Value, {"no lobes to choose among", "fit", "none", "at least one"});
  bool stopped = false;
  const FitOptions own = watched(options, stopped);
  FitReport best;
  std::vector<FitCandidate> list;
  for (const CandidateLobes& candidate : candidates) {
    FitReport report = fit(target, candidate.lobes, own);
    if (stopped && !list.empty()) break;
    list.push_back(summary(report, candidate.name));
    if (list.size() == 1 || better(list.back(), summary(best, {}))) best = std::move(report);
    if (stopped) break;
  }
  if (stopped) {
    best.converged = false;
    best.termination = "stopped on request";
  }
  std::ranges::stable_sort(list, better);
  if (candidates.size() > 1) best.candidates = std::move(list);
  return best;
}

FitReport fitProgressively(const Brdf& target, std::vector<LobeRequest> lobes, const FitOptions& options) {
  if (lobes.empty()) return fit(target, lobes, options);  // which says what is missing
  bool stopped = false;
  const FitOptions own = watched(options, stopped);
  FitReport report;
  std::vector<FitCandidate> stages;
  std::string name;
  for (std::size_t count = 1; count <= lobes.size() && !stopped; ++count) {
    name += (count > 1 ? " + " : "") + lobes[count - 1].model->name();
    report = fit(target, {lobes.begin(), lobes.begin() + static_cast<std::ptrdiff_t>(count)}, own);
    stages.push_back(summary(report, name));
    for (const FittedParameter& p : report.parameters)
      if (!p.channel && !p.fixed && p.name != "scale") lobes[p.lobeIndex].start[p.name] = p.value;
  }
  report.candidates = std::move(stages);
  return report;
}

}  // namespace brdf
