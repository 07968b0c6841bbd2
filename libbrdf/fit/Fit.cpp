#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/Compare.h>
#include <brdf/fit/ConstantModel.h>
#include <brdf/fit/Cost.h>
#include <brdf/fit/DataStart.h>
#include <brdf/fit/SpherePicture.h>
#include <brdf/fit/StartSearch.h>
#include <brdf/fit/TargetSamples.h>
#include <brdf/fit/Uncertainty.h>
#include <brdf/material/ChannelView.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace brdf {
namespace {

// Shapes are scanned on this many samples (one chunk), and first polished on them where the data are several times
// more.
constexpr std::size_t kScanSamples = FitData::kChunkLength;
constexpr std::size_t kPolishSamples = 2 * kScanSamples;
// How many shapes of the scan are polished. Methods without derivatives are slow and get fewer.
constexpr std::size_t kKeptShapes = 4, kKeptShapesWithoutDerivatives = 2;
// A fit that explains less than this part of the zero model's squared error is called weak.
constexpr double kWeakFit = 0.9;

struct Solution {
  std::vector<double> shape;
  Scales scales;
  OptimizerResult outcome;
};

/// One fit in progress: what to fit with, and the counters that the report and the progress function share.
class Fitter {
 public:
  Fitter(const FitProblem& problem, const FitOptions& options, bool separable, FitReport& report)
      : problem_(problem),
        options_(options),
        optimizer_(findOptimizer(options.optimizer)),
        separable_(separable),
        report_(report) {}

  /// Fits a group of channels that share their shape.
  Solution solve(const FitData& data, ChannelRange channels) {
    const FitData scanData = data.subset(kScanSamples);
    const bool large = data.samples > 2 * kPolishSamples;
    const FitData polishData = large ? data.subset(kPolishSamples) : FitData{};

    std::vector<std::vector<double>> starts;
    if (options_.scan && !problem_.coordinates().empty()) {
      const std::size_t keep = optimizer_.usesDerivatives ? kKeptShapes : kKeptShapesWithoutDerivatives;
      for (Start& start : scanShapes(problem_, scanData.mean(channels.first, channels.count), keep))
        starts.push_back(std::move(start.x));
    }
    if (options_.dataStart && !problem_.coordinates().empty())
      starts.push_back(shapeFromData(problem_, scanData.mean(channels.first, channels.count)));
    if (starts.empty() || optimizer_.usesDerivatives) starts.push_back(problem_.start());
    std::ranges::copy(latinHypercube(problem_, options_.starts, options_.seed), std::back_inserter(starts));

    // A global method needs one start only, and Levenberg-Marquardt finishes what it found.
    if (optimizer_.global) starts.resize(1);
    std::optional<Solution> best;
    for (const std::vector<double>& start : starts) {
      Solution solution = run(optimizer_, large ? polishData : data, channels, start,
                              separable_ ? Scales{} : solveScales(problem_, scanData, channels, start));
      if (!best || solution.outcome.squaredError < best->outcome.squaredError) best = std::move(solution);
      if (stopped_) break;
    }
    if (stopped_ || !(large || optimizer_.global)) return *best;
    const Optimizer& last = optimizer_.global ? findOptimizer("lm") : optimizer_;
    Solution solution = run(last, data, channels, best->shape, best->scales);
    if (optimizer_.global)
      solution.outcome.termination = std::string(optimizer_.name) + ": " + best->outcome.termination +
                                     "; then Levenberg-Marquardt: " + solution.outcome.termination;
    return solution;
  }

  /// Goes on from a solution on other data of the same channels.
  Solution resume(const FitData& data, ChannelRange channels, const Solution& from) {
    if (stopped_) return from;
    return run(optimizer_.global ? findOptimizer("lm") : optimizer_, data, channels, from.shape, from.scales);
  }

 private:
  Solution run(const Optimizer& optimizer, const FitData& data, ChannelRange channels, std::vector<double> start,
               const Scales& scales) {
    const double residuals = data.totalWeight * static_cast<double>(channels.count);
    OptimizerOptions options;
    options.tolerance = options_.tolerance;
    options.maximumIterations = options_.maximumIterations;
    options.seed = options_.seed;
    options.progress = [&](double squaredError) {
      ++report_.iterations;
      if (options_.progress && !options_.progress(report_.iterations, std::sqrt(squaredError / residuals)))
        stopped_ = true;
      return !stopped_;
    };
    Solution solution;
    if (separable_) {
      SeparableCost cost(problem_, data, channels);
      solution.outcome = optimizer.minimize(cost, std::move(start), options);
      solution.shape = solution.outcome.x;
      solution.scales = cost.bestScales();
    } else {
      JointCost cost(problem_, data, channels);
      solution.outcome = optimizer.minimize(cost, cost.join(start, scales), options);
      solution.scales = cost.scalesOf(solution.outcome.x);
      solution.shape = solution.outcome.x;
      solution.shape.resize(problem_.coordinates().size());
    }
    report_.evaluations += solution.outcome.evaluations;
    return solution;
  }

  const FitProblem& problem_;
  const FitOptions& options_;
  const Optimizer& optimizer_;
  bool separable_;
  FitReport& report_;
  bool stopped_ = false;
};

std::string channelNames(const FitChannels& asked, const Channels& seen) {
  if (asked.kind == FitChannels::Kind::List) {
    std::string names;
    for (const std::size_t index : asked.list) names += (names.empty() ? "" : ",") + std::to_string(index);
    return names;
  }
  if (asked.kind == FitChannels::Kind::Luminance) return "luminance";
  return seen.kind == Channels::Kind::Rgb ? "rgb" : seen.kind == Channels::Kind::Spectral ? "spectral" : "monochrome";
}

std::string percent(double fraction) { return formatNumber(100 * fraction, 3) + " %"; }

}  // namespace

FitReport fit(const Brdf& target, const std::vector<LobeRequest>& requests, const FitOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const MetricPointer metric = findMetric(options.metric);
  findOptimizer(options.optimizer);
  if (options.strategy == Strategy::Separable && !metric->quadratic())
    throw Error(Error::Kind::Value,
                {"the separable strategy needs a metric that is quadratic in the BRDF: only then are the best scale "
                 "factors a linear least-squares problem",
                 "strategy", "separable with metric " + options.metric, "joint"});
  if (!(options.tolerance > 0))
    throw Error(Error::Kind::Value,
                {"tolerance out of bounds", "tolerance", formatNumber(options.tolerance), "above 0"});
  const BrdfPointer seen = selectChannels(BrdfPointer(BrdfPointer(), &target), options.channels);
  const TargetSamples samples = takeSamples(seen, options.samples, options.maximumTheta);
  // A picture sees too few directions to find a lobe from afar: pairs find it first, by the metric nearest to
  // lightness.
  const auto onSphere = std::dynamic_pointer_cast<const SphereMetric>(metric);
  const FitData data = FitData::read(*samples.set, onSphere ? findMetric("cuberoot") : metric, samples.rule);
  if (data.samples == 0)
    throw Error(Error::Kind::Value, {"the target has no valid sample", "target", target.description(), "at least 1"});

  const FitData picture = onSphere ? spherePicture(*seen, onSphere) : FitData{};
  const FitData& judged = onSphere ? picture : data;

  const FitProblem problem(requests, seen->symmetry());
  const bool separable = options.strategy != Strategy::Joint && metric->quadratic();
  FitReport report;
  report.metric = metric->name();
  report.metricFormula = judged.metric->formula();
  report.optimizer = options.optimizer;
  report.strategy = separable ? "separable" : "joint";
  report.samples = judged.samples;
  report.offered = samples.set->count();
  report.sampling = samples.sampling;
  report.weights = samples.weights;
  report.maximumTheta = options.maximumTheta;
  report.channelNames = channelNames(options.channels, seen->channels());
  report.channels = data.channels;
  report.notes = problem.notes();

  const bool perChannel = options.combination == Combination::PerChannel && data.channels > 1;
  std::vector<Lobe> lobes;
  for (std::size_t l = 0; l < problem.lobeCount(); ++l)
    lobes.push_back(
        {problem.modelPointer(l), std::vector<std::vector<double>>(problem.model(l).parameters().size()), {}});
  Fitter fitter(problem, options, separable, report);
  report.converged = true;
  const std::size_t groups = perChannel ? data.channels : 1;
  for (std::size_t group = 0; group < groups; ++group) {
    const ChannelRange channels{group, perChannel ? 1 : data.channels};
    Solution solution = fitter.solve(data, channels);
    if (onSphere) solution = fitter.resume(picture, channels, solution);
    const std::optional<std::size_t> own = perChannel ? std::optional(group) : std::nullopt;
    describeParameters(problem, judged, channels, own, solution.shape, solution.scales, report);
    const std::vector<std::vector<double>> values = problem.parameters(solution.shape);
    for (std::size_t l = 0; l < lobes.size(); ++l) {
      for (std::size_t p = 0; p < values[l].size(); ++p) lobes[l].parameters[p].push_back(values[l][p]);
      for (std::size_t c = 0; c < channels.count; ++c) lobes[l].scale.push_back(solution.scales[c * lobes.size() + l]);
    }
    report.converged = report.converged && solution.outcome.converged;
    // Of several channels the one that did not converge is the one to tell of.
    if (report.termination.empty() || !solution.outcome.converged) report.termination = solution.outcome.termination;
  }
  report.material = std::make_shared<LobeSum>(std::move(lobes), seen->channels());

  Comparison errors = compareOn(*samples.set, *report.material, nullptr, samples.rule, data.metric);
  const ConstantModel constant = bestConstant(judged);
  report.constantModel = constant.values;
  report.constantError = constant.error;
  report.metrics = std::move(errors.metrics);
  report.zeroModel = std::move(errors.zeroModel);
  if (onSphere) {
    const SphereErrors sphere = sphereErrors(picture, *report.material);
    report.metrics[report.metric] = sphere.error;
    report.zeroModel[report.metric] = sphere.zeroModel;
  }
  report.error = report.metrics.at(report.metric);
  const double zero = report.zeroModel.at(report.metric);
  const double explained = zero > 0 ? 1 - report.error * report.error / (zero * zero) : 0;
  if (explained < kWeakFit)
    report.notes.push_back("weak fit: it explains only " + percent(explained) + " of the zero model's squared error");
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return report;
}

BrdfPointer selectChannels(BrdfPointer target, const FitChannels& channels) {
  switch (channels.kind) {
    case FitChannels::Kind::Luminance:
      return asLuminance(std::move(target));
    case FitChannels::Kind::Rgb:
      return asRgb(std::move(target));
    case FitChannels::Kind::List:
      return selectedChannels(std::move(target), channels.list);
    default:
      return target;
  }
}

}  // namespace brdf
