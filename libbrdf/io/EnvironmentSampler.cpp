#include <brdf/io/EnvironmentSampler.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// Turns `count + 1` running sums that start at 0 into shares; without any weight, even shares.
double normalise(double* sums, std::size_t count) {
  const double total = sums[count];
  for (std::size_t i = 1; i <= count; ++i)
    sums[i] = total > 0 ? sums[i] / total : static_cast<double>(i) / static_cast<double>(count);
  sums[count] = 1;
  return total;
}

/// Index of the interval that holds u, and the position inside it in [0, 1).
std::pair<std::size_t, double> find(const double* sums, std::size_t count, double u) {
  const double* above = std::upper_bound(sums + 1, sums + count, u);
  const auto index = static_cast<std::size_t>(above - sums - 1);
  const double width = sums[index + 1] - sums[index];
  return {index, width > 0 ? std::clamp((u - sums[index]) / width, 0.0, 1.0) : 0.5};
}

/// Mean over each column's texel, across the row only, of the luminance interpolated between the centres of texels:
/// three quarters of its own and an eighth of each neighbour's.
void smoothedRow(const Image& picture, std::size_t row, double* means) {
  const auto luminance = [&](std::size_t column) {
    const float* rgb = picture.pixel(column, row);
    return 0.2126 * double(rgb[0]) + 0.7152 * double(rgb[1]) + 0.0722 * double(rgb[2]);
  };
  const std::size_t width = picture.width;
  double before = luminance(width - 1), here = luminance(0);
  for (std::size_t column = 0; column < width; ++column) {
    const double after = luminance(column + 1 < width ? column + 1 : 0);
    means[column] = 0.75 * here + 0.125 * (before + after);
    before = here;
    here = after;
  }
}

}  // namespace

EnvironmentSampler::EnvironmentSampler(const EnvironmentMap& map)
    : width_(map.width()), height_(map.height()), rows_(height_ + 1), columns_(height_ * (width_ + 1)) {
  std::vector<double> angles(height_ + 1), means(height_ * width_);
  for (std::size_t row = 0; row < height_; ++row) smoothedRow(map.picture(), row, means.data() + row * width_);
  for (std::size_t row = 0; row < height_; ++row) {
    // Across a pole the opposite meridian continues.
    const double *here = means.data() + row * width_, *above = row > 0 ? here - width_ : here,
                 *below = row + 1 < height_ ? here + width_ : here;
    const std::size_t turnAbove = row > 0 ? 0 : width_ / 2, turnBelow = row + 1 < height_ ? 0 : width_ / 2;
    double* sums = columns_.data() + row * (width_ + 1);
    for (std::size_t column = 0; column < width_; ++column)
      sums[column + 1] = sums[column] + 0.75 * here[column] +
                         0.125 * (above[(column + turnAbove) % width_] + below[(column + turnBelow) % width_]);
    rows_[row + 1] = rows_[row] + normalise(sums, width_) * map.solidAngle(row);
    angles[row + 1] = angles[row] + map.solidAngle(row);
  }
  if (!(rows_[height_] > 0)) rows_ = std::move(angles);
  normalise(rows_.data(), height_);
}

Direction EnvironmentSampler::sample(double u, double v) const {
  const auto [row, down] = find(rows_.data(), height_, v);
  const auto [column, across] = find(columns_.data() + row * (width_ + 1), width_, u);
  const double phi = ((static_cast<double>(column) + across) / static_cast<double>(width_) - 0.5) * 2 * kPi;
  // Even in solid angle: linear in the cosine between the row's edges.
  const double step = kPi / static_cast<double>(height_), top = step * static_cast<double>(row);
  const double cosine = std::cos(top) * (1 - down) + std::cos(top + step) * down;
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return {sine * std::sin(phi), cosine, -sine * std::cos(phi)};
}

double EnvironmentSampler::pdf(const Direction& d) const {
  const double u = 0.5 + std::atan2(d[0], -d[2]) / (2 * kPi), v = std::acos(std::clamp(d[1], -1.0, 1.0)) / kPi;
  const auto cell = [](double at, std::size_t count) {
    return std::min(static_cast<std::size_t>(at * static_cast<double>(count)), count - 1);
  };
  const std::size_t row = cell(v, height_), column = cell(u, width_);
  const double* sums = columns_.data() + row * (width_ + 1);
  const double step = kPi / static_cast<double>(height_), top = step * static_cast<double>(row);
  const double angle = 2 * std::sin(top + step / 2) * std::sin(step / 2) * 2 * kPi / static_cast<double>(width_);
  return (rows_[row + 1] - rows_[row]) * (sums[column + 1] - sums[column]) / angle;
}

std::vector<float> EnvironmentSampler::rowShares() const { return {rows_.begin() + 1, rows_.end()}; }

std::vector<float> EnvironmentSampler::columnShares() const {
  std::vector<float> shares(width_ * height_);
  for (std::size_t row = 0; row < height_; ++row)
    std::copy_n(columns_.begin() + static_cast<std::ptrdiff_t>(row * (width_ + 1) + 1), width_,
                shares.begin() + static_cast<std::ptrdiff_t>(row * width_));
  return shares;
}

}  // namespace brdf
