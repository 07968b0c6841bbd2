#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/SampleSet.h>
#include <brdf/view/ErrorMap.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

constexpr std::size_t kBlock = 65'536;
constexpr std::size_t kFewSamples = 100'000;

struct NamedMeasure {
  std::string_view name;
  ErrorMeasure measure;
  std::string_view label;
};
constexpr std::array<NamedMeasure, 5> kMeasures{{
    {"difference", ErrorMeasure::Difference, "mean of f_A - f_B (1/sr)"},
    {"absolute", ErrorMeasure::Absolute, "mean of |f_A - f_B| (1/sr)"},
    {"relative", ErrorMeasure::Relative, "mean of |f_A - f_B| / f_B"},
    {"log", ErrorMeasure::Log, "mean of |difference of ln(1 + f cos theta_i)|, f in 1/sr"},
    {"cuberoot", ErrorMeasure::CubeRoot, "mean of |difference of cbrt(f cos theta_i)| (sr^-1/3)"},
}};

/// Collects differences into the nodes of a map.
class Accumulator {
 public:
  Accumulator(const Brdf& a, const Brdf& b, const ErrorMapOptions& options, std::size_t intervals)
      : a_(a), b_(b), options_(options), channels_(a.channels().count()) {
    map_.intervals = intervals;
    map_.mean.assign(map_.nodes() * map_.nodes(), 0);
    map_.count.assign(map_.nodes() * map_.nodes(), 0);
  }

  /// `known` holds the values of the BRDF whose samples these are (`bKnown`: b's), planar; null: both are evaluated.
  void add(const DirectionPairs<double>& pairs, const double* known, const std::uint8_t* knownValid, bool bKnown) {
    valuesA_.resize(pairs.count * channels_);
    valuesB_.resize(pairs.count * channels_);
    validA_.resize(pairs.count);
    validB_.resize(pairs.count);
    fill(a_, pairs, bKnown ? nullptr : known, knownValid, valuesA_, validA_);
    fill(b_, pairs, bKnown ? known : nullptr, knownValid, valuesB_, validB_);
    for (std::size_t i = 0; i < pairs.count; ++i) {
      if (!validA_[i] || !validB_[i]) continue;
      const Direction wi{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
      const Direction wo{pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
      const std::size_t node = nodeOf(wi, wo);
      for (std::size_t c = 0; c < channels_; ++c) {
        const double b = valuesB_[c * pairs.count + i];
        if (options_.measure == ErrorMeasure::Relative && !(b > 0)) continue;
        map_.mean[node] += errorMeasure(options_.measure, valuesA_[c * pairs.count + i], b, wi[2]);
        ++map_.count[node];
      }
    }
  }

  ErrorMap finish(std::string sampling) {
    double sum = 0;
    std::uint64_t count = 0;
    for (std::size_t node = 0; node < map_.mean.size(); ++node) {
      sum += map_.mean[node];
      count += map_.count[node];
      if (map_.count[node] > 0) map_.mean[node] /= static_cast<double>(map_.count[node]);
      map_.largest = std::max(map_.largest, std::abs(map_.mean[node]));
    }
    map_.overallMean = count > 0 ? sum / static_cast<double>(count) : 0;
    map_.sampling = std::move(sampling);
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
  }

  std::size_t nodeOf(const Direction& wi, const Direction& wo) const {
    double x, y;
    if (options_.axes == ErrorAxes::IncidentOutgoing) {
      x = toSpherical(wi).theta;
      y = toSpherical(wo).theta;
    } else {
      const HalfDifference angles = toHalfDifference(wi, wo);
      x = angles.thetaH;
      y = angles.thetaD;
    }
    const auto index = [&](double angle) {
      const double scaled = angle / (kPi / 2) * static_cast<double>(map_.intervals) + 0.5;
      return std::min(static_cast<std::size_t>(std::max(scaled, 0.0)), map_.intervals);
    };
    return index(y) * map_.nodes() + index(x);
  }

  const Brdf& a_;
  const Brdf& b_;
  const ErrorMapOptions& options_;
  std::size_t channels_;
  ErrorMap map_;
  std::vector<double> valuesA_, valuesB_;
  std::vector<std::uint8_t> validA_, validB_;
};

void addSamples(Accumulator& accumulator, const SampleSet& samples, bool ofB) {
  DirectionPairBuffer<double> pairs;
  std::vector<double> values(kBlock * samples.channels().count());
  std::vector<std::uint8_t> valid(kBlock);
  for (std::size_t first = 0; first < samples.count(); first += kBlock) {
    const std::size_t length = std::min(kBlock, samples.count() - first);
    samples.read(first, length, &pairs, values.data(), valid.data());
    accumulator.add(pairs.view(), values.data(), valid.data(), ofB);
  }
}

/// The angle that stands for a node; the first and last nodes have half an interval only, and stand in its middle.
double nodeAngle(std::size_t node, std::size_t intervals) {
  const double step = kPi / 2 / static_cast<double>(intervals);
  if (node == 0) return step / 4;
  if (node == intervals) return kPi / 2 - step / 4;
  return static_cast<double>(node) * step;
}

/// Directions at each node. Isotropic BRDFs need one azimuth, from 0 to pi, bilateral ones from 0 to 2 pi;
/// anisotropic ones both azimuths, whose numbers multiply to about `azimuths`.
void addDirections(Accumulator& accumulator, const ErrorMapOptions& options, std::size_t intervals, Symmetry symmetry) {
  const std::size_t turns = symmetry != Symmetry::Anisotropic
                                ? 1
                                : static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(options.azimuths))));
  const std::size_t differences = turns == 1 ? options.azimuths : (options.azimuths + turns - 1) / turns;
  const double differenceRange = symmetry == Symmetry::Isotropic ? kPi : 2 * kPi;
  DirectionPairBuffer<double> pairs;
  const auto flush = [&] {
    if (pairs.size() > 0) accumulator.add(pairs.view(), nullptr, nullptr, false);
    pairs.resize(0);
  };
  const std::size_t nodes = intervals + 1;
  for (std::size_t node = 0; node < nodes * nodes; ++node) {
    const double x = nodeAngle(node % nodes, intervals), y = nodeAngle(node / nodes, intervals);
    for (std::size_t turn = 0; turn < turns; ++turn) {
      const double turned = 2 * kPi * static_cast<double>(turn) / static_cast<double>(turns);
      for (std::size_t k = 0; k < differences; ++k) {
        const double azimuth = (static_cast<double>(k) + 0.5) * differenceRange / static_cast<double>(differences);
        const DirectionPair pair = options.axes == ErrorAxes::IncidentOutgoing
                                       ? DirectionPair{fromSpherical(x, turned), fromSpherical(y, turned + azimuth)}
                                       : fromHalfDifference({x, turned, y, azimuth});
        if (pair.wi[2] > 0 && pair.wo[2] > 0) pairs.push(pair.wi, pair.wo);
      }
    }
    if (pairs.size() >= kBlock) flush();
  }
  flush();
}

const SampleSet* samplesOf(const Brdf& a, const Brdf& b, bool wanted) {
  if (!wanted) return nullptr;
  return b.samples() ? b.samples() : a.samples();
}

}  // namespace

double errorMeasure(ErrorMeasure measure, double a, double b, double cosThetaI) {
  switch (measure) {
    case ErrorMeasure::Absolute:
      return std::abs(a - b);
    case ErrorMeasure::Relative:
      return std::abs(a - b) / b;
    case ErrorMeasure::Log:
      return std::abs(std::log1p(std::max(a, 0.0) * cosThetaI) - std::log1p(std::max(b, 0.0) * cosThetaI));
    case ErrorMeasure::CubeRoot:
      return std::abs(std::cbrt(a * cosThetaI) - std::cbrt(b * cosThetaI));
    default:
      return a - b;
  }
}

ErrorMeasure parseErrorMeasure(std::string_view name) {
  std::vector<std::string_view> names;
  for (const NamedMeasure& known : kMeasures) {
    if (known.name == name) return known.measure;
    names.push_back(known.name);
  }
  throw Error(Error::Kind::Value, {"unknown measure", "error map", std::string(name), joined(names)});
}

std::string errorMeasureLabel(ErrorMeasure measure) {
  for (const NamedMeasure& known : kMeasures)
    if (known.measure == measure) return std::string(known.label);
  return {};
}

ErrorAxes parseErrorAxes(std::string_view name) {
  if (name == "theta_i,theta_o") return ErrorAxes::IncidentOutgoing;
  if (name == "theta_h,theta_d") return ErrorAxes::HalfDifference;
  throw Error(Error::Kind::Value,
              {"unknown axes", "error map", std::string(name), "\"theta_i,theta_o\", \"theta_h,theta_d\""});
}

std::size_t automaticIntervals(const Brdf& a, const Brdf& b, bool onSamples) {
  const SampleSet* samples = samplesOf(a, b, onSamples);
  if (!samples) return 90;
  return samples->count() <= kFewSamples ? 9 : 45;
}

ErrorMap makeErrorMap(const Brdf& a, const Brdf& b, const ErrorMapOptions& options) {
  if (a.channels().count() != b.channels().count())
    throw Error(Error::Kind::Value,
                {"the two BRDFs have different channels", "error map",
                 std::to_string(a.channels().count()) + " and " + std::to_string(b.channels().count()),
                 "the same number (choose luminance or rgb)"});
  if (options.intervals > 1000)
    throw Error(Error::Kind::Value,
                {"out of range", "error map intervals", std::to_string(options.intervals), "1 to 1000, 0: automatic"});
  if (options.azimuths < 1 || options.azimuths > 10'000)
    throw Error(Error::Kind::Value,
                {"out of range", "error map azimuths", std::to_string(options.azimuths), "1 to 10000"});
  const std::size_t intervals = options.intervals > 0 ? options.intervals : automaticIntervals(a, b, options.onSamples);
  Accumulator accumulator(a, b, options, intervals);
  if (const SampleSet* samples = samplesOf(a, b, options.onSamples)) {
    const bool ofB = samples == b.samples();
    addSamples(accumulator, *samples, ofB);
    return accumulator.finish(std::string("at the samples of ") + (ofB ? "B" : "A"));
  }
  addDirections(accumulator, options, intervals, std::max(a.symmetry(), b.symmetry()));
  return accumulator.finish("over " + std::to_string(options.azimuths) + " azimuths");
}

}  // namespace brdf
