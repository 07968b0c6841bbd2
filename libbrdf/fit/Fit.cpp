#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/Compare.h>
#include <brdf/fit/ConstantModel.h>
#include <brdf/fit/Cost.h>
#include <brdf/fit/DataStart.h>
#include <brdf/fit/Diagnostics.h>
#include <brdf/fit/SpherePicture.h>
#include <brdf/fit/StartSearch.h>
#include <brdf/fit/TargetSamples.h>
#include <brdf/fit/Uncertainty.h>
#include <brdf/material/ChannelView.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

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

  bool stopped() const { return stopped_; }

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
    double best = std::numeric_limits<double>::infinity();
    options.progress = [&](double squaredError) {
      ++report_.iterations;
      if (squaredError < best) {
        best = squaredError;
        report_.history.push_back({runs_, report_.iterations, std::sqrt(squaredError / residuals)});
      }
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
    ++runs_;
    return solution;
  }

  const FitProblem& problem_;
  const FitOptions& options_;
  const Optimizer& optimizer_;
  bool separable_;
  FitReport& report_;
  bool stopped_ = false;
  std::size_t runs_ = 0;
};

/// Channels fitted together, and what was found.
struct Group {
  ChannelRange channels;
  Solution solution;
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

/// Fits without each part in turn, from the solution on all, and judges on that part. Empty when stopped.
std::optional<CrossValidation> crossValidate(const FitProblem& problem, const FitOptions& options, bool separable,
                                             const FitData& data, Symmetry symmetry, const std::vector<Group>& groups) {
  const std::vector<std::uint8_t> parts = directionParts(data, symmetry, options.crossValidation);
  FitReport counters;  // of these fits, not of the one reported
  Fitter fitter(problem, options, separable, counters);
  CrossValidation result;
  double total = 0, sum = 0, squares = 0;
  const double channels = static_cast<double>(data.channels), count = static_cast<double>(options.crossValidation);
  for (std::size_t part = 0; part < options.crossValidation; ++part) {
    const auto number = static_cast<std::uint8_t>(part);
    const FitData training = data.select(parts, number, false), rest = data.select(parts, number, true);
    double squared = 0;
    for (const Group& group : groups) {
      const Solution solution = fitter.resume(training, group.channels, group.solution);
      JointCost cost(problem, rest, group.channels);
      squared += cost.squaredError(cost.join(solution.shape, solution.scales));
    }
    if (fitter.stopped()) return std::nullopt;
    const double meanSquare = squared / (rest.weightSum() * channels);
    result.partErrors.push_back(std::sqrt(meanSquare));
    total += squared;
    sum += meanSquare;
    squares += meanSquare * meanSquare;
  }
  result.error = std::sqrt(total / (data.totalWeight * channels));
  const double variance = std::max(0.0, squares - sum * sum / count) / (count - 1);
  if (result.error > 0) result.standardError = std::sqrt(variance / count) / (2 * result.error);
  return result;
}

/// Degrees of freedom and the criteria that weigh them against the error.
void addCriteria(const FitProblem& problem, const std::vector<Group>& groups, FitReport& report) {
  report.degrees = 1;
  for (const Group& group : groups) {
    report.degrees += problem.coordinates().size();
    for (std::size_t l = 0; l < problem.lobeCount(); ++l)
      if (!problem.fixedScale(l)) report.degrees += group.channels.count;
  }
  const double n = static_cast<double>(report.samples * report.channels), k = static_cast<double>(report.degrees);
  const double misfit = n * std::log(report.error * report.error);
  report.aic = misfit + 2 * k;
  report.bic = misfit + k * std::log(n);
}

/// Of weights 1 / variance: what the weighted residuals say of the variances and of the model.
void addChiSquare(const FitData& data, FitReport& report) {
  const double count = static_cast<double>(data.samples * data.channels);
  const double freedom = count - static_cast<double>(report.degrees);
  if (report.metric != "rms" || !(freedom > 0)) return;
  const double chiSquare = report.error * report.error * count / data.weightFactor;
  report.notes.push_back("reduced chi-square " + formatNumber(chiSquare / freedom, 4) + " on " + formatNumber(freedom) +
                         " degrees of freedom: 1 where the model describes the data and their errors are right");
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
  if (options.crossValidation == 1 || options.crossValidation > 100)
    throw Error(Error::Kind::Value, {"number of parts out of bounds", "cross-validation",
                                     std::to_string(options.crossValidation), "2 to 100, or 0 for none"});
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

  if (onSphere && options.crossValidation > 0)
    throw Error(Error::Kind::Value,
                {"a picture sums over directions, of which no block can be left out", "cross-validation",
                 "metric " + metric->name(), "a metric of pairs of directions"});
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
  if (onSphere) {
    report.sampling = "pixels of the picture of a sphere; the start from " + samples.sampling;
    report.offered = judged.samples;
  }
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
  std::vector<Group> groups;
  for (std::size_t group = 0; group < (perChannel ? data.channels : 1); ++group) {
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
    groups.push_back({channels, std::move(solution)});
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
  if (!onSphere) describeResiduals(data, report);
  addCriteria(problem, groups, report);
  if (samples.rule.noise) addChiSquare(data, report);
  if (options.crossValidation > 0 && !fitter.stopped())
    report.crossValidation = crossValidate(problem, options, separable, data, seen->symmetry(), groups);
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
