#include <brdf/base/Parallel.h>
#include <brdf/fit/Samples.h>
#include <brdf/fit/SpherePicture.h>
#include <brdf/geometry/Frame.h>
#include <brdf/io/EnvironmentSampler.h>
#include <brdf/sampling/SampledBrdf.h>
#include <brdf/sampling/Sequence.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brdf {
namespace {

constexpr std::size_t kAcross = 24;       // pixels
constexpr std::size_t kDirections = 256;  // a pixel
static_assert(FitData::kBlockLength % kDirections == 0 && FitData::kChunkLength % FitData::kBlockLength == 0);

// CIE 1976 lightness: a cube root above (6/29)^3, the tangent of it below.
constexpr double kKnee = 6.0 / 29;

double lightness(double y) {
  const double root = y > kKnee * kKnee * kKnee ? std::cbrt(y) : y / (3 * kKnee * kKnee) + 4.0 / 29;
  return 116 * root - 16;
}
double lightnessSlope(double y) {
  const double root = std::cbrt(std::max(y, kKnee * kKnee * kKnee));
  return 116 / (3 * root * root);
}
double radianceOf(double l) {
  const double root = (l + 16) / 116;
  return root > kKnee ? root * root * root : 3 * kKnee * kKnee * (root - 4.0 / 29);
}

double luminance(const EnvironmentMap::Rgb& rgb) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

/// The frames of the places of the sphere that the pixels show.
std::vector<Frame> pixelsOfSphere(std::size_t across) {
  std::vector<Frame> pixels;
  for (std::size_t row = 0; row < across; ++row)
    for (std::size_t column = 0; column < across; ++column) {
      const auto middle = [&](std::size_t k) {
        return (2 * static_cast<double>(k) + 1) / static_cast<double>(across) - 1;
      };
      const double x = middle(column), y = -middle(row), squared = x * x + y * y;
      if (squared >= 1) continue;
      Frame pixel;
      pixel.normal = {x, y, std::sqrt(1 - squared)};
      pixel.tangent = normalized(Direction{pixel.normal[2], 0, -pixel.normal[0]});
      pixel.bitangent = cross(pixel.normal, pixel.tangent);
      pixels.push_back(pixel);
    }
  return pixels;
}

/// The radiance of a white diffuser where the sphere is brightest, by channel (one: luminance). It changes slowly: a
/// coarse picture finds it.
std::vector<double> whiteOf(const EnvironmentMap& map, std::size_t channels) {
  EnvironmentMap::Rgb brightest{};
  for (const Frame& pixel : pixelsOfSphere(6))
    if (const auto light = map.irradiance(pixel.normal); luminance(light) > luminance(brightest)) brightest = light;
  std::vector<double> white(channels, luminance(brightest) / kPi);
  if (channels == 3)
    for (std::size_t c = 0; c < 3; ++c) white[c] = brightest[c] / kPi;
  for (double& w : white)
    if (!(w > 0)) w = 1;
  return white;
}

/// Draws the directions of one pixel, from `first` in the chunk's pairs on, and what each adds.
void lightPixel(const Frame& pixel, std::size_t index, const Brdf& brdf, const EnvironmentMap& map,
                const EnvironmentSampler& sampler, const std::vector<double>& white, FitChunk& chunk,
                std::size_t first) {
  constexpr std::size_t half = kDirections / 2;
  const Direction wo = pixel.local({0, 0, 1});
  std::array<std::vector<double>, 3> view, drawn;
  std::array<std::vector<double>, 2> random;
  for (std::size_t k = 0; k < 3; ++k) {
    view[k].assign(half, wo[k]);
    drawn[k].resize(half);
  }
  const auto shift = [&](std::size_t k) { return static_cast<double>(mixedBits(4 * index + k) >> 11) * 0x1p-53; };
  for (std::size_t j = 0; j < half; ++j) {
    const auto u = r2(j, shift(0), shift(1)), v = r2(j, shift(2), shift(3));
    chunk.pairs.set(first + j, pixel.local(sampler.sample(u[0], u[1])), wo);
    random[0].push_back(v[0]);
    random[1].push_back(v[1]);
  }
  brdf.sample({view[0].data(), view[1].data(), view[2].data()}, {random[0].data(), random[1].data()},
              {drawn[0].data(), drawn[1].data(), drawn[2].data()}, half);
  for (std::size_t j = 0; j < half; ++j) chunk.pairs.set(first + half + j, {drawn[0][j], drawn[1][j], drawn[2][j]}, wo);

  std::vector<double> density(kDirections);
  brdf.pdf(chunk.pairs.view().slice(first, kDirections), density.data());
  const std::size_t pairs = chunk.pairs.size();
  for (std::size_t j = 0; j < kDirections; ++j) {
    const Direction wi{chunk.pairs.wi[0][first + j], chunk.pairs.wi[1][first + j], chunk.pairs.wi[2][first + j]};
    const Direction world = pixel.world(wi);
    const bool counts = wi[2] > 0;
    if (!counts) chunk.pairs.set(first + j, {0, 0, 1}, wo);  // where every lobe has a value; it adds nothing
    const double together = counts ? half * (sampler.pdf(world) + density[j]) : 1.0;
    const auto light = map.radiance(counts ? world : Direction{0, 0, 1});
    for (std::size_t c = 0; c < white.size(); ++c)
      chunk.light[c * pairs + first + j] =
          counts && together > 0 ? (white.size() == 3 ? light[c] : luminance(light)) * wi[2] / (together * white[c])
                                 : 0.0;
  }
}

}  // namespace

SphereMetric::SphereMetric(std::string name, std::shared_ptr<const EnvironmentMap> map)
    : map_(map ? std::move(map) : sphereLight()) {
  name_ = std::move(name);
  formula_ = "difference of lightness L* of the pixels of a sphere";
  source_ = "CIE 15:2004, Colorimetry, section 8.2.1.1";
}

void SphereMetric::prepare(const double* values, const DirectionPairs<double>& pairs, double* target) const {
  std::transform(values, values + pairs.count, target, lightness);
}
void SphereMetric::restore(const double* target, const DirectionPairs<double>& pairs, double* values) const {
  std::transform(target, target + pairs.count, values, radianceOf);
}
void SphereMetric::residual(const double* f, const double* target, const DirectionPairs<double>& pairs,
                            double* r) const {
  for (std::size_t i = 0; i < pairs.count; ++i) r[i] = lightness(f[i]) - target[i];
}
void SphereMetric::slope(const double* f, const double*, const DirectionPairs<double>& pairs, double* slope) const {
  std::transform(f, f + pairs.count, slope, lightnessSlope);
}

const std::shared_ptr<const EnvironmentMap>& sphereLight() {
  static const auto map = [] {
    const Direction lamp = normalized(Direction{0.5, std::sqrt(0.5), 0.5});
    const double edge = std::cos(radians(10)), radiance = 1 / (1 - edge * edge);  // pi L sin^2 is the irradiance
    Image picture(512, 256, 3);
    const EnvironmentMap grid(picture);
    for (std::size_t row = 0; row < picture.height; ++row)
      for (std::size_t column = 0; column < picture.width; ++column) {
        const Direction d = grid.direction(column, row);
        const double value = dot(d, lamp) > edge ? radiance : d[1] > 0 ? 0.3 : 0.1;
        std::fill_n(picture.pixel(column, row), 3, static_cast<float>(value));
      }
    return std::make_shared<const EnvironmentMap>(picture);
  }();
  return map;
}

FitData spherePicture(const Brdf& target, const std::shared_ptr<const SphereMetric>& metric) {
  SamplerOptions coarse;  // it only proposes directions, beside the map
  coarse.tolerance = 0.5;
  const BrdfPointer brdf = withSampler(BrdfPointer(BrdfPointer(), &target), coarse);
  const EnvironmentMap& map = metric->map();
  const EnvironmentSampler sampler(map);
  const std::vector<Frame> pixels = pixelsOfSphere(kAcross);
  FitData data;
  data.metric = metric;
  data.pairsAResidual = kDirections;
  data.channels = target.channels().count();
  data.samples = pixels.size();
  data.totalWeight = static_cast<double>(pixels.size());
  const bool rgb = target.channels().kind == Channels::Kind::Rgb;
  const std::vector<double> white = whiteOf(map, rgb ? 3 : 1);

  constexpr std::size_t inChunk = FitData::kChunkLength / kDirections;
  data.chunks.resize((pixels.size() + inChunk - 1) / inChunk);
  parallelFor(pixels.size(), inChunk, [&](std::size_t begin, std::size_t end) {
    FitChunk& chunk = data.chunks[begin / inChunk];
    const std::size_t count = end - begin, pairs = count * kDirections;
    chunk.pairs.resize(pairs);
    chunk.light.resize(data.channels * pairs);
    for (std::size_t k = 0; k < count; ++k)
      lightPixel(pixels[begin + k], begin + k, *brdf, map, sampler, white, chunk, k * kDirections);
    for (std::size_t c = white.size(); c < data.channels; ++c)
      std::copy_n(chunk.light.data(), pairs, chunk.light.data() + c * pairs);
    std::vector<double> values(data.channels * pairs), radiance(count);
    std::vector<std::uint8_t> valid(pairs);
    brdf->evaluate(chunk.pairs.view(), values.data(), valid.data());
    chunk.target.resize(data.channels * count);
    for (std::size_t c = 0; c < data.channels; ++c) {
      double *light = chunk.light.data() + c * pairs, *value = values.data() + c * pairs;
      for (std::size_t i = 0; i < pairs; ++i)
        if (!valid[i]) light[i] = 0;
      for (std::size_t k = 0; k < count; ++k)
        radiance[k] =
            std::inner_product(light + k * kDirections, light + (k + 1) * kDirections, value + k * kDirections, 0.0);
      metric->prepare(radiance.data(), chunk.pairs.view().slice(0, count), chunk.target.data() + c * count);
    }
  });
  return data;
}

SphereErrors sphereErrors(const FitData& picture, const Brdf& brdf) {
  SphereErrors errors;
  for (const FitChunk& chunk : picture.chunks) {
    const std::size_t pairs = chunk.pairs.size(), count = picture.residuals(chunk);
    std::vector<double> values(picture.channels * pairs), radiance(count), residual(count), black(count);
    brdf.evaluateParallel(chunk.pairs.view(), values.data(), nullptr);
    for (std::size_t c = 0; c < picture.channels; ++c) {
      const double *light = chunk.light.data() + c * pairs, *value = values.data() + c * pairs;
      for (std::size_t k = 0; k < count; ++k)
        radiance[k] =
            std::inner_product(light + k * kDirections, light + (k + 1) * kDirections, value + k * kDirections, 0.0);
      const auto squared = [&](const std::vector<double>& f) {
        picture.block(chunk, c).residual(f.data(), residual.data());
        return std::inner_product(residual.begin(), residual.end(), residual.begin(), 0.0);
      };
      errors.error += squared(radiance);
      errors.zeroModel += squared(black);
    }
  }
  const double residuals = picture.totalWeight * static_cast<double>(picture.channels);
  return {std::sqrt(errors.error / residuals), std::sqrt(errors.zeroModel / residuals)};
}

}  // namespace brdf
