#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/render/ReplicateFilm.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <string>

namespace brdf {
namespace {

constexpr std::size_t kGrain = 16384;  // pixels a thread takes at a time

std::size_t checkedPixels(std::size_t width, std::size_t height) {
  constexpr std::size_t most = std::size_t{4096} * 4096;
  if (width == 0 || height == 0 || width > most || height > most || width * height > most)
    throw Error(Error::Kind::Value, {"size of a converging picture",
                                     {},
                                     std::to_string(width) + " x " + std::to_string(height),
                                     "at most " + std::to_string(most) + " pixels"});
  return width * height;
}

}  // namespace

ReplicateFilm::ReplicateFilm(std::size_t width, std::size_t height)
    : width_(width), height_(height), sums_(4 * checkedPixels(width, height) * kReplicates), points_(kReplicates) {}

void ReplicateFilm::add(std::size_t replicate, std::span<const float> rgba, std::size_t points) {
  const std::size_t pixels = width_ * height_;
  if (replicate >= kReplicates || rgba.size() != 4 * pixels)
    throw Error(Error::Kind::Value, {"a frame of another size than its film",
                                     {},
                                     std::to_string(rgba.size()),
                                     std::to_string(4 * pixels) + " numbers"});
  double* sums = sums_.data() + replicate * 4 * pixels;
  const auto weight = static_cast<double>(points);
  std::atomic<std::size_t> bad = 0;
  parallelFor(pixels, kGrain, [&](std::size_t first, std::size_t last) {
    std::size_t found = 0;
    for (std::size_t pixel = first; pixel < last; ++pixel)
      for (std::size_t c = 0; c < 4; ++c) {
        const float value = rgba[4 * pixel + c];
        if (std::isfinite(value))
          sums[4 * pixel + c] += weight * double(value);
        else
          ++found;
      }
    bad += found;
  });
  notFinite_ += bad;
  points_[replicate] += points;
}

std::size_t ReplicateFilm::points() const { return std::accumulate(points_.begin(), points_.end(), std::size_t{0}); }

double ReplicateFilm::relativeError() const {
  const std::size_t pixels = width_ * height_;
  std::vector<double> squares((pixels + kGrain - 1) / kGrain), totals(squares.size());
  parallelFor(pixels, kGrain, [&](std::size_t first, std::size_t last) {
    double square = 0, total = 0;
    for (std::size_t pixel = first; pixel < last; ++pixel) {
      double luminance[kReplicates], mean = 0;
      for (std::size_t r = 0; r < kReplicates; ++r) {
        const double* rgb = sums(r) + 4 * pixel;
        luminance[r] = (0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]) / static_cast<double>(points_[r]);
        mean += luminance[r] / kReplicates;
      }
      for (const double value : luminance) square += (value - mean) * (value - mean);
      total += mean;
    }
    squares[first / kGrain] = square / (kReplicates * (kReplicates - 1));
    totals[first / kGrain] = total;
  });
  const auto count = static_cast<double>(pixels);
  const double variance = std::accumulate(squares.begin(), squares.end(), 0.0) / count;
  const double mean = std::accumulate(totals.begin(), totals.end(), 0.0) / count;
  return variance == 0 ? 0 : mean > 0 ? std::sqrt(variance) / mean : INFINITY;
}

Image ReplicateFilm::mean() const {
  Image image(width_, height_, 4);
  parallelFor(image.values.size(), kGrain, [&](std::size_t first, std::size_t last) {
    const auto all = static_cast<double>(std::max<std::size_t>(points(), 1));
    for (std::size_t i = first; i < last; ++i) {
      double sum = 0;
      for (std::size_t r = 0; r < kReplicates; ++r) sum += sums(r)[i];
      image.values[i] = static_cast<float>(sum / all);
    }
  });
  return image;
}

Image ReplicateFilm::standardError() const {
  Image image(width_, height_, 3);
  parallelFor(image.values.size(), kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      double mean = 0, square = 0;
      const auto value = [&](std::size_t r) { return sums(r)[4 * (i / 3) + i % 3] / static_cast<double>(points_[r]); };
      for (std::size_t r = 0; r < kReplicates; ++r) mean += value(r) / kReplicates;
      for (std::size_t r = 0; r < kReplicates; ++r) square += (value(r) - mean) * (value(r) - mean);
      image.values[i] = static_cast<float>(std::sqrt(square / (kReplicates * (kReplicates - 1))));
    }
  });
  return image;
}

}  // namespace brdf
