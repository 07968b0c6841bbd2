#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/geometry/Directions.h>
#include <brdf/sampling/Sequence.h>
#include <brdf/sampling/ViewerDraws.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace brdf {
namespace {

/// Draws of one viewer before they are packed.
struct Drawn {
  std::vector<double> x, y, solid;  ///< slopes of the half vector; the solid angle with its factor and sign
  std::vector<double> weights;      ///< channel by channel
};

double polarAngle(std::size_t viewer) {
  const double left = 1 - static_cast<double>(viewer) / (ViewerDraws::kViewers - 1);
  return std::min(kPi / 2 * (1 - left * left), radians(89.94));
}

constexpr double kGolden = 0.6180339887498949;                                    // 1 / golden ratio
constexpr double kPlastic = 0.7548776662466927, kPlastic2 = kPlastic * kPlastic;  // of R2: see Sequence.h

double fraction(double x) { return x - std::floor(x); }

Drawn drawnBy(const Brdf& brdf, std::size_t viewer, std::size_t samples, std::size_t sets) {
  const Direction wo = fromSpherical(polarAngle(viewer), 0.0);
  const std::size_t count = samples * sets;
  DirectionPairBuffer<double> pairs(count);
  std::vector<double> u[2], density(count);
  for (auto& numbers : u) numbers.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto set = r2(i / samples, 0.5, 0.5);
    const auto k = static_cast<double>(i % samples);
    u[0][i] = std::min((k + set[0]) / static_cast<double>(samples), 1 - 0x1p-53);
    u[1][i] = fraction(k * kGolden + set[1]);
    for (std::size_t axis = 0; axis < 3; ++axis) pairs.wo[axis][i] = wo[axis];
  }
  const DirectionPairs<double> view = pairs.view();
  brdf.sample(view.wo, {u[0].data(), u[1].data()}, {pairs.wi[0].data(), pairs.wi[1].data(), pairs.wi[2].data()}, count);
  brdf.pdf(view, density.data());
  const std::size_t channels = brdf.channels().count();
  Drawn drawn;
  for (auto* numbers : {&drawn.x, &drawn.y, &drawn.solid}) numbers->resize(count);
  drawn.weights.resize(channels * count);
  brdf.evaluate(view, drawn.weights.data(), nullptr);
  for (std::size_t i = 0; i < count; ++i) {
    const Direction wi{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
    bool fine = wi[2] > 0 && density[i] > 0;
    for (std::size_t c = 0; c < channels; ++c) {
      double& weight = drawn.weights[c * count + i];
      weight = fine ? weight * wi[2] / density[i] : 0;
      fine = fine && std::isfinite(weight);
    }
    if (!fine) {
      for (std::size_t c = 0; c < channels; ++c) drawn.weights[c * count + i] = 0;
      drawn.solid[i] = 1;
      continue;
    }
    const Direction h = normalized({wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]});
    drawn.x[i] = h[0] / h[2];
    drawn.y[i] = h[1] / h[2];
    const double facing = dot(h, wo), half = 1 - h[2] * h[2], difference = 1 - facing * facing;
    const bool turns = fraction(kPlastic2 * static_cast<double>(i)) * (half + difference) < half;
    drawn.solid[i] = (turns ? -1 : 1) / (density[i] * std::pow(2 * h[2] * h[2], 3));
  }
  return drawn;
}

std::uint32_t bits(double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); }

/// Three weights at `part`, [0, 1), of a step above the rounded-down ones: see ViewerDraws::words.
std::uint32_t packed(const std::array<double, 3>& weights, double unit, double part) {
  double largest = 0;
  for (const double weight : weights) largest = std::max(largest, std::abs(weight) / unit);
  int exponent = 0;
  std::frexp(largest / 255, &exponent);
  exponent = std::clamp(exponent, -31, 0);
  std::uint32_t word = static_cast<std::uint32_t>(exponent + 31) << 27;
  for (std::size_t c = 0; c < 3; ++c) {
    const double steps = std::clamp(std::floor(std::ldexp(weights[c] / unit, -exponent) + part), -256.0, 255.0);
    word |= (static_cast<std::uint32_t>(static_cast<std::int32_t>(steps)) & 511u) << (9 * c);
  }
  return word;
}

}  // namespace

ViewerDraws viewerDraws(const Brdf& brdf, std::size_t samples, std::size_t sets) {
  const std::size_t channels = brdf.channels().count();
  if (brdf.channels().kind == Channels::Kind::Spectral)
    throw Error(Error::Kind::Value,
                {"channels of draws made in advance", brdf.description(), std::to_string(channels), "monochrome, RGB"});
  if (brdf.symmetry() == Symmetry::Anisotropic)
    throw Error(Error::Kind::Value,
                {"draws made in advance for a BRDF that may not be turned", brdf.description(), "anisotropic", {}});
  std::vector<Drawn> drawn(ViewerDraws::kViewers);
  parallelFor(drawn.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) drawn[t] = drawnBy(brdf, t, samples, sets);
  });
  ViewerDraws result;
  result.samples = samples;
  result.stride = (samples + 3) / 4 * 4;
  result.sets = sets;
  const std::size_t draws = samples * sets;
  double largest = 0;
  for (const Drawn& viewer : drawn)
    for (const double weight : viewer.weights) largest = std::max(largest, std::abs(weight));
  if (largest > 0) result.unit = static_cast<float>(std::exp2(std::ceil(std::log2(largest / 255))));
  result.words.resize(4 * result.stride * sets * drawn.size());
  parallelFor(drawn.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const Drawn& viewer = drawn[t];
      for (std::size_t i = 0; i < draws; ++i) {
        std::uint32_t* word = result.words.data() + 4 * ((t * sets + i / samples) * result.stride + i % samples);
        word[0] = bits(viewer.x[i]);
        word[1] = bits(viewer.y[i]);
        word[2] = channels == 1 ? bits(viewer.weights[i])
                                : packed({viewer.weights[i], viewer.weights[draws + i], viewer.weights[2 * draws + i]},
                                         double(result.unit), fraction(kPlastic * static_cast<double>(i)));
        word[3] = bits(viewer.solid[i]);
      }
    }
  });
  return result;
}

}  // namespace brdf
