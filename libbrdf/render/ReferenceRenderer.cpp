#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/render/Lens.h>
#include <brdf/render/PathIntegrator.h>
#include <brdf/render/ReferenceRenderer.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>

namespace brdf {
namespace {

// Paths traced in step: enough for batches of a material, few enough to stay in the second-level cache.
constexpr std::size_t kPaths = 2048;

/// Mean and scatter of what each pixel's paths brought, updated sample by sample (Welford 1962, "Note on a Method for
/// Calculating Corrected Sums of Squares and Products").
struct Film {
  std::vector<Rgb> mean, squares;  ///< `squares`: sum of squared distances from the mean
  std::vector<double> luminanceSquares;
  std::vector<double> luminance;
  std::vector<double> coverage;  ///< part of the rays that met an object
  std::size_t samples = 0;

  explicit Film(std::size_t pixels)
      : mean(pixels), squares(pixels), luminanceSquares(pixels), luminance(pixels), coverage(pixels) {}

  static void update(double& mean, double& squares, double value, double count) {
    const double before = value - mean;
    mean += before / count;
    squares += before * (value - mean);
  }
  void add(std::size_t pixel, const Rgb& rgb, bool covered, std::size_t count) {
    const auto n = static_cast<double>(count);
    coverage[pixel] += (double(covered) - coverage[pixel]) / n;
    for (std::size_t c = 0; c < 3; ++c) update(mean[pixel][c], squares[pixel][c], rgb[c], n);
    update(luminance[pixel], luminanceSquares[pixel], 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2], n);
  }
  double variance(double squaresSum) const {  ///< of the mean
    const auto n = static_cast<double>(samples);
    return squaresSum / (n * (n - 1));
  }
  double relativeError() const {
    double sum = 0, total = 0;
    for (std::size_t k = 0; k < mean.size(); ++k) {
      sum += variance(luminanceSquares[k]);
      total += luminance[k];
    }
    if (sum == 0) return 0;
    const auto pixels = static_cast<double>(mean.size());
    return total > 0 ? std::sqrt(sum / pixels) / (total / pixels) : INFINITY;
  }
};

void checkOptions(const ReferenceOptions& options) {
  constexpr std::size_t kMaximumSamples = std::size_t{1} << 24;
  if (options.samples < 2 || options.samples > kMaximumSamples)
    throw Error(Error::Kind::Value, {"samples out of range", "reference renderer", std::to_string(options.samples),
                                     "2 to " + std::to_string(kMaximumSamples)});
  if (!(options.tolerance >= 0))
    throw Error(Error::Kind::Value,
                {"tolerance out of range", "reference renderer", std::to_string(options.tolerance), "0 or more"});
  if (options.bounces < 1 || options.bounces > 1000)
    throw Error(Error::Kind::Value,
                {"bounces out of range", "reference renderer", std::to_string(options.bounces), "1 to 1000"});
}

}  // namespace

ReferencePicture renderReference(const Scene& scene, const ReferenceOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  checkScene(scene);
  checkOptions(options);
  const PathIntegrator integrator(scene, options.bounces);
  const Lens lens(scene);
  const std::size_t pixels = scene.width * scene.height;
  const auto width = static_cast<double>(scene.width), height = static_cast<double>(scene.height);
  Film film(pixels);
  std::atomic<std::uint64_t> evaluations = 0, invalid = 0;
  ReferencePicture picture;

  const auto drawPass = [&](std::size_t from, std::size_t to) {
    const std::size_t grain = std::max<std::size_t>(1, kPaths / (to - from));
    parallelFor(pixels, grain, [&](std::size_t first, std::size_t last) {
      std::vector<Ray> rays;
      std::vector<PathRandom> randoms;
      std::uint64_t evaluated = 0, without = 0;
      const std::size_t step = std::min(to - from, kPaths);
      for (std::size_t begin = from; begin < to; begin += step) {
        const std::size_t end = std::min(to, begin + step);
        rays.clear();
        randoms.clear();
        for (std::size_t pixel = first; pixel < last; ++pixel)
          for (std::size_t sample = begin; sample < end; ++sample) {
            PathRandom random((options.seed * 0x9e3779b97f4a7c15u) ^ (std::uint64_t{pixel} << 24 | sample));
            const double x = options.pixelCentres ? 0.5 : random.next(), y = options.pixelCentres ? 0.5 : random.next();
            rays.push_back(lens.through(double(pixel % scene.width) + x, double(pixel / scene.width) + y));
            randoms.push_back(random);
          }
        std::vector<Rgb> radiance(rays.size());
        std::vector<std::uint8_t> covered(rays.size());
        integrator.trace(rays, randoms, radiance.data(), covered.data(), evaluated, without);
        std::size_t k = 0;
        for (std::size_t pixel = first; pixel < last; ++pixel) {
          const Rgb behind = backgroundRadiance(scene.background, (double(pixel % scene.width) + 0.5) / width,
                                                (double(pixel / scene.width) + 0.5) / height, width / height);
          for (std::size_t sample = begin; sample < end; ++sample, ++k) {
            for (std::size_t c = 0; c < 3 && !covered[k]; ++c) radiance[k][c] += behind[c];
            film.add(pixel, radiance[k], covered[k], sample + 1);
          }
        }
      }
      evaluations += evaluated;
      invalid += without;
    });
    film.samples = to;
  };

  for (std::size_t done = 0; done < options.samples && !picture.converged && !picture.stopped;) {
    const std::size_t next = std::min(options.samples, std::max<std::size_t>(16, 2 * done));
    drawPass(done, next);
    done = next;
    picture.relativeError = film.relativeError();
    picture.converged = options.tolerance > 0 && picture.relativeError <= options.tolerance;
    if (options.progress) picture.stopped = !options.progress(done, options.samples, picture.relativeError);
  }

  picture.samples = film.samples;
  const std::size_t channels = scene.background.kind == SceneBackground::Kind::Transparent ? 4 : 3;
  picture.radiance = Image(scene.width, scene.height, channels);
  picture.standardError = Image(scene.width, scene.height, 3);
  for (std::size_t k = 0; k < pixels; ++k) {
    if (channels == 4) picture.radiance.values[4 * k + 3] = static_cast<float>(film.coverage[k]);
    for (std::size_t c = 0; c < 3; ++c) {
      picture.radiance.values[channels * k + c] = static_cast<float>(film.mean[k][c]);
      picture.standardError.values[3 * k + c] = static_cast<float>(std::sqrt(film.variance(film.squares[k][c])));
    }
  }
  if (evaluations > 0) picture.invalidShare = double(invalid) / double(evaluations);
  picture.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return picture;
}

}  // namespace brdf
