#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/fit/TargetSamples.h>
#include <brdf/view/ErrorMap.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

constexpr std::size_t kBlock = 65'536;
constexpr std::size_t kFewSamples = 100'000;
constexpr std::size_t kMostPairs = 20'000'000;
constexpr std::size_t kMostChannelNodes = 16'000'000;
constexpr std::size_t kWorstApart = 18;  // of the map's side: 5 degrees of a right angle

constexpr std::array<std::pair<std::string_view, ErrorDirections>, 3> kDirections{
    {{"automatic", ErrorDirections::Automatic},
     {"samples", ErrorDirections::Samples},
     {"chosen", ErrorDirections::Chosen}}};

/// Residuals become an average: sums of what is averaged, and of weights.
struct Sum {
  double value = 0, weight = 0;
  void add(const ErrorMeasure& measure, double residual, double w) {
    value += w * (measure.average == ErrorAverage::RootMeanSquare ? residual * residual
                  : measure.average == ErrorAverage::Absolute     ? std::abs(residual)
                                                                  : residual);
    weight += w;
  }
  double mean(const ErrorMeasure& measure) const {
    if (!(weight > 0)) return 0;
    return measure.average == ErrorAverage::RootMeanSquare ? std::sqrt(value / weight) : value / weight;
  }
};

/// Collects residuals into the nodes of a map.
class Accumulator {
 public:
  Accumulator(const Brdf& a, const Brdf& b, const ErrorMeasure& measure, const ErrorGrid& grid)
      : a_(a),
        b_(b),
        measure_(measure),
        channels_(a.channels().count()),
        symmetry_(std::max(a.symmetry(), b.symmetry())) {
    map_.grid = grid;
    const std::size_t nodes = grid.nodes() * grid.nodes();
    if (nodes * channels_ > kMostChannelNodes)
      throw Error(Error::Kind::Value, {"too many nodes for so many channels", "error map",
                                       std::to_string(nodes) + " times " + std::to_string(channels_),
                                       "fewer intervals, or luminance or rgb"});
    sums_.resize(nodes * channels_);
    overall_.resize(channels_);
    map_.count.assign(nodes, 0);
    worst_.resize(nodes);
  }

  /// `known` holds the values of the BRDF whose samples these are (`bKnown`: b's), planar; null: both are evaluated.
  /// `weights` null: all alike.
  void add(const DirectionPairs<double>& pairs, const double* weights, const double* known,
           const std::uint8_t* knownValid, bool bKnown) {
    valuesA_.resize(pairs.count * channels_);
    valuesB_.resize(pairs.count * channels_);
    validA_.resize(pairs.count);
    validB_.resize(pairs.count);
    fill(a_, pairs, bKnown ? nullptr : known, knownValid, valuesA_, validA_);
    fill(b_, pairs, bKnown ? known : nullptr, knownValid, valuesB_, validB_);
    pack(pairs, weights);
    residual_.resize(kept_.size() * channels_);
    target_.resize(kept_.size());
    const DirectionPairs<double> packed = packedPairs_.view();
    for (std::size_t c = 0; c < channels_; ++c) {
      measure_.metric->prepare(packedB_.data() + c * packed.count, packed, target_.data());
      measure_.metric->residual(packedA_.data() + c * packed.count, target_.data(), packed,
                                residual_.data() + c * packed.count);
    }
    for (std::size_t i = 0; i < kept_.size(); ++i) count(packed, i, weights ? weights[kept_[i]] : 1);
    if (weights)
      for (std::size_t i : kept_) map_.weights.push_back(weights[i]);
  }

  ErrorMap finish(std::size_t worst, std::string sampling) {
    const std::size_t nodes = map_.count.size();
    map_.mean.assign(nodes, 0);
    if (channels_ > 1) map_.channelMean.assign(nodes * channels_, 0);
    Sum all;
    for (std::size_t node = 0; node < nodes; ++node) {
      Sum combined;
      for (std::size_t c = 0; c < channels_; ++c) {
        const Sum& one = sums_[c * nodes + node];
        combined.value += one.value;
        combined.weight += one.weight;
        if (channels_ > 1) map_.channelMean[c * nodes + node] = one.mean(measure_);
      }
      map_.mean[node] = combined.mean(measure_);
      map_.largest = std::max(map_.largest, std::abs(map_.mean[node]));
    }
    for (const Sum& one : overall_) {
      map_.channelOverall.push_back(one.mean(measure_));
      all.value += one.value;
      all.weight += one.weight;
    }
    map_.overallMean = all.mean(measure_);
    map_.sampling = std::move(sampling);
    listWorst(worst);
    return std::move(map_);
  }

 private:
  void fill(const Brdf& brdf, const DirectionPairs<double>& pairs, const double* known, const std::uint8_t* knownValid,
            std::vector<double>& values, std::vector<std::uint8_t>& valid) const {
    if (known) {
      std::copy_n(known, values.size(), values.begin());
      std::copy_n(knownValid, valid.size(), valid.begin());
    } else {
      brdf.evaluateParallel(pairs, values.data(), valid.data());
    }
    for (std::size_t c = 0; c < channels_; ++c)
      for (std::size_t i = 0; i < pairs.count; ++i) valid[i] = valid[i] && std::isfinite(values[c * pairs.count + i]);
  }

  /// The pairs with two values, at a node of the grid.
  void pack(const DirectionPairs<double>& pairs, const double* weights) {
    kept_.clear();
    node_.clear();
    packedPairs_.resize(0);
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const Direction wi{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
      const Direction wo{pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
      const std::size_t node = map_.grid.nodeOf(wi, wo, symmetry_);
      if (node == ErrorGrid::kNowhere || (weights && !(weights[i] > 0))) continue;
      if (!validA_[i] || !validB_[i]) {
        ++map_.leftOut;
        continue;
      }
      kept_.push_back(i);
      node_.push_back(node);
      packedPairs_.push(wi, wo);
    }
    packedA_.resize(kept_.size() * channels_);
    packedB_.resize(kept_.size() * channels_);
    for (std::size_t c = 0; c < channels_; ++c)
      for (std::size_t k = 0; k < kept_.size(); ++k) {
        packedA_[c * kept_.size() + k] = valuesA_[c * pairs.count + kept_[k]];
        packedB_[c * kept_.size() + k] = valuesB_[c * pairs.count + kept_[k]];
      }
  }

  void count(const DirectionPairs<double>& packed, std::size_t i, double weight) {
    double sum = 0, squares = 0;
    for (std::size_t c = 0; c < channels_; ++c) {
      const double residual = residual_[c * packed.count + i];
      if (!std::isfinite(residual))
        throw Error(Error::Kind::Value, {"the metric has no finite value on these pairs", measure_.metric->name(), "",
                                         "a formula that is finite at every value of both, as with max(f, 0)"});
      sums_[c * map_.count.size() + node_[i]].add(measure_, residual, weight);
      overall_[c].add(measure_, residual, weight);
      sum += residual;
      squares += residual * residual;
    }
    const auto n = static_cast<double>(channels_);
    const double error = measure_.average == ErrorAverage::Signed ? sum / n : std::sqrt(squares / n);
    map_.errors.push_back(error);
    map_.count[node_[i]] += channels_;
    WorstPair& worst = worst_[node_[i]];
    if (!(std::abs(error) > std::abs(worst.error))) return;
    worst.error = error;
    worst.node = node_[i];
    worst.pair = {{packed.wi[0][i], packed.wi[1][i], packed.wi[2][i]},
                  {packed.wo[0][i], packed.wo[1][i], packed.wo[2][i]}};
    worst.a.resize(channels_);
    worst.b.resize(channels_);
    for (std::size_t c = 0; c < channels_; ++c) {
      worst.a[c] = packedA_[c * packed.count + i];
      worst.b[c] = packedB_[c * packed.count + i];
    }
  }

  void listWorst(std::size_t number) {
    std::erase_if(worst_, [](const WorstPair& one) { return one.error == 0; });
    std::sort(worst_.begin(), worst_.end(), [](const WorstPair& x, const WorstPair& y) {
      const double a = std::abs(x.error), b = std::abs(y.error);
      return a > b || (a == b && x.node < y.node);
    });
    const std::size_t nodes = map_.grid.nodes();
    const std::size_t apart = (map_.grid.intervals + kWorstApart - 1) / kWorstApart;
    std::vector<bool> taken(nodes * nodes);
    for (WorstPair& one : worst_) {
      if (map_.worst.size() == number) break;
      if (taken[one.node]) continue;
      const std::size_t x = one.node % nodes, y = one.node / nodes;
      for (std::size_t j = y < apart ? 0 : y - apart + 1; j < std::min(y + apart, nodes); ++j)
        for (std::size_t i = x < apart ? 0 : x - apart + 1; i < std::min(x + apart, nodes); ++i)
          taken[j * nodes + i] = true;
      map_.worst.push_back(std::move(one));
    }
  }

  const Brdf& a_;
  const Brdf& b_;
  const ErrorMeasure& measure_;
  std::size_t channels_;
  Symmetry symmetry_;
  ErrorMap map_;
  std::vector<Sum> sums_, overall_;
  std::vector<WorstPair> worst_;  // of each node
  std::vector<double> valuesA_, valuesB_, packedA_, packedB_, residual_, target_;
  std::vector<std::uint8_t> validA_, validB_;
  std::vector<std::size_t> kept_, node_;
  DirectionPairBuffer<double> packedPairs_;
};

void addSamples(Accumulator& accumulator, const SampleSet& samples, bool ofB, bool bySolidAngle) {
  DirectionPairBuffer<double> pairs;
  std::vector<double> values(kBlock * samples.channels().count()), weights(kBlock);
  std::vector<std::uint8_t> valid(kBlock);
  for (std::size_t first = 0; first < samples.count(); first += kBlock) {
    const std::size_t length = std::min(kBlock, samples.count() - first);
    samples.read(first, length, &pairs, values.data(), valid.data());
    if (bySolidAngle && !samples.solidAngles(first, length, weights.data()))
      throw Error(Error::Kind::Value, {"the metric weighs samples by their solid angle, which these do not have",
                                       "error map", "scattered samples", "another metric, or directions chosen"});
    accumulator.add(pairs.view(), bySolidAngle ? weights.data() : nullptr, values.data(), valid.data(), ofB);
  }
}

void addChosen(Accumulator& accumulator, const ErrorGrid& grid, std::size_t azimuths, Symmetry symmetry) {
  DirectionPairBuffer<double> pairs;
  std::vector<double> weights;
  const auto flush = [&] {
    if (pairs.size() > 0) accumulator.add(pairs.view(), weights.data(), nullptr, nullptr, false);
    pairs.resize(0);
    weights.clear();
  };
  grid.visit(azimuths, symmetry, [&](const DirectionPair& pair, double weight) {
    pairs.push(pair.wi, pair.wo);
    weights.push_back(weight);
    if (pairs.size() >= kBlock) flush();
  });
  flush();
}

const SampleSet* samplesOf(const Brdf& a, const Brdf& b, ErrorAxes axes, ErrorDirections directions) {
  if (directions == ErrorDirections::Chosen) return nullptr;
  if (directions == ErrorDirections::Automatic && axes == ErrorAxes::Hemisphere) return nullptr;
  return b.samples() ? b.samples() : a.samples();
}

void require(bool condition, const char* what, const std::string& found, const char* allowed) {
  if (!condition) throw Error(Error::Kind::Value, {"out of range", what, found, allowed});
}

void checkChannels(const Channels& a, const Channels& b) {
  const bool same = a.count() == b.count() && (a.count() == 1 || a == b);
  if (!same)
    throw Error(Error::Kind::Value, {"the two BRDFs have different channels", "error map",
                                     std::to_string(a.count()) + " and " + std::to_string(b.count()),
                                     "the same (choose luminance or rgb)"});
}

}  // namespace

ErrorDirections parseErrorDirections(std::string_view name) {
  for (const auto& [known, directions] : kDirections)
    if (known == name) return directions;
  throw Error(Error::Kind::Value,
              {"unknown directions", "error map", std::string(name), joined(errorDirectionsNames())});
}

std::vector<std::string> errorDirectionsNames() {
  std::vector<std::string> names;
  for (const auto& [name, directions] : kDirections) names.emplace_back(name);
  return names;
}

std::size_t automaticIntervals(const Brdf& a, const Brdf& b, ErrorAxes axes, ErrorDirections directions) {
  const SampleSet* samples = samplesOf(a, b, axes, directions);
  const std::size_t quarter = !samples ? 90 : samples->count() <= kFewSamples ? 9 : 45;
  return axes == ErrorAxes::Hemisphere ? 2 * quarter : quarter;
}

ErrorMap makeErrorMap(const Brdf& a, const Brdf& b, const ErrorMapOptions& options) {
  checkChannels(a.channels(), b.channels());
  ErrorGrid grid = options.grid;
  require(grid.intervals <= 1000, "error map intervals", std::to_string(grid.intervals), "1 to 1000, 0: automatic");
  require(options.azimuths >= 1 && options.azimuths <= 10'000, "error map azimuths", std::to_string(options.azimuths),
          "1 to 10000");
  require(options.worst <= 10'000, "worst pairs of an error map", std::to_string(options.worst), "0 to 10000");
  require(grid.thetaI >= 0 && grid.thetaI < kPi / 2, "theta_i", formatNumber(degrees(grid.thetaI)), "[0, 90) degrees");
  require(std::isfinite(grid.phiI), "phi_i", formatNumber(degrees(grid.phiI)), "a finite number of degrees");
  require(grid.within >= 0 && grid.within <= kPi, "angle around the incident direction",
          formatNumber(degrees(grid.within)), "0 to 180 degrees");
  const SampleSet* samples = samplesOf(a, b, grid.axes, options.directions);
  if (options.directions == ErrorDirections::Samples && !samples)
    throw Error(Error::Kind::Value, {"neither BRDF has samples", "error map", "samples", "automatic, chosen"});
  if (grid.intervals == 0) grid.intervals = automaticIntervals(a, b, grid.axes, options.directions);
  const bool ofB = samples && samples == b.samples();

  ErrorMeasure measure = options.measure;
  if (measure.metric->needsScale()) {
    const TargetSamples taken =
        samples ? TargetSamples{} : takeSamples(BrdfPointer(BrdfPointer(), &b), {Sampling::Hemisphere}, 90);
    measure.metric = measure.metric->scaledTo(samples ? typicalValue(*samples, ofB ? nullptr : &b, 90)
                                                      : typicalValue(*taken.set, nullptr, 90));
  }
  Accumulator accumulator(a, b, measure, grid);
  if (samples) {
    addSamples(accumulator, *samples, ofB, measure.metric->bySolidAngle());
    return accumulator.finish(options.worst, std::string("at the samples of ") + (ofB ? "B" : "A"));
  }
  const std::size_t each = grid.axes == ErrorAxes::Hemisphere ? 1 : options.azimuths;
  const std::size_t pairs = grid.nodes() * grid.nodes() * each;
  require(pairs <= kMostPairs, "pairs of directions of an error map", std::to_string(pairs), "at most 20000000");
  addChosen(accumulator, grid, options.azimuths, std::max(a.symmetry(), b.symmetry()));
  return accumulator.finish(options.worst, grid.axes == ErrorAxes::Hemisphere
                                               ? "one view direction a point"
                                               : "over " + std::to_string(each) + " azimuths");
}

}  // namespace brdf
