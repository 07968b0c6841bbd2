#include <brdf/measured/Warp2D.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// Index of the interval of ascending values that holds x, and how far into it, held at the ends.
std::pair<std::size_t, double> interval(const std::vector<float>& values, double x) {
  if (values.size() < 2) return {0, 0};
  const auto above = std::upper_bound(values.begin() + 1, values.end() - 1, x);
  const auto k = static_cast<std::size_t>(above - values.begin()) - 1;
  const double low = values[k], high = values[k + 1];
  return {k, std::clamp((x - low) / (high - low), 0.0, 1.0)};
}

/// t in [0, 1] where the integral of a + (b - a) t' from 0 to t is `area`.
double solveLinear(double a, double b, double area) {
  // 2 area / (a + sqrt(a^2 + 2 (b - a) area)): no cancellation where a and b are close.
  const double root = std::sqrt(std::max(0.0, a * a + 2 * (b - a) * area));
  return a + root > 0 ? std::clamp(2 * area / (a + root), 0.0, 1.0) : 0;
}
double integralLinear(double a, double b, double t) { return t * (a + 0.5 * (b - a) * t); }

/// Cell of a coordinate among `nodes` nodes, and how far into it.
std::pair<std::size_t, double> cell(double x, std::size_t nodes) {
  const double scaled = std::clamp(x, 0.0, 1.0) * static_cast<double>(nodes - 1);
  const auto k = std::min(static_cast<std::size_t>(scaled), nodes - 2);
  return {k, scaled - static_cast<double>(k)};
}

}  // namespace

Warp2D::Warp2D(std::size_t width, std::size_t height, std::vector<float> first, std::vector<float> second,
               std::vector<float> values, bool normalise)
    : width_(width), height_(height), first_(std::move(first)), second_(std::move(second)), values_(std::move(values)) {
  if (!normalise) return;
  const std::size_t area = width_ * height_, slices = values_.size() / area;
  rowSums_.resize(values_.size());
  sums_.resize(slices * height_);
  const double dx = 1 / static_cast<double>(width_ - 1), dy = 1 / static_cast<double>(height_ - 1);
  for (std::size_t s = 0; s < slices; ++s) {
    float* const density = values_.data() + s * area;
    const auto integrate = [&] {
      for (std::size_t y = 0; y < height_; ++y) {
        double sum = 0;
        rowSums_[s * area + y * width_] = 0;
        for (std::size_t x = 1; x < width_; ++x) {
          sum += 0.5 * dx * (static_cast<double>(density[y * width_ + x - 1]) + density[y * width_ + x]);
          rowSums_[s * area + y * width_ + x] = sum;
        }
      }
      double sum = 0;
      sums_[s * height_] = 0;
      for (std::size_t y = 1; y < height_; ++y) {
        sum += 0.5 * dy * (rowSums_[s * area + y * width_ - 1] + rowSums_[s * area + (y + 1) * width_ - 1]);
        sums_[s * height_ + y] = sum;
      }
      return sum;
    };
    double total = integrate();
    if (!(total > 0)) {
      std::fill_n(density, area, 1.0f);
      total = integrate();
    }
    for (std::size_t i = 0; i < area; ++i) density[i] = static_cast<float>(density[i] / total);
    integrate();  // of the rounded numbers; drawing divides by the sums, not by 1
  }
}

Warp2D::Condition Warp2D::locate(double first, double second) const {
  const auto [a, ta] = interval(first_, first);
  const auto [b, tb] = interval(second_, second);
  const std::size_t columns = std::max<std::size_t>(second_.size(), 1);
  Condition condition;
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = (k & 2 ? ta : 1 - ta) * (k & 1 ? tb : 1 - tb);
    if (weight <= 0) continue;
    condition.slice[condition.count] = (a + (k >> 1)) * columns + b + (k & 1);
    condition.weight[condition.count++] = weight;
  }
  return condition;
}

double Warp2D::value(std::size_t index, const Condition& condition) const {
  double sum = 0;
  for (std::size_t k = 0; k < condition.count; ++k)
    sum += condition.weight[k] * values_[condition.slice[k] * width_ * height_ + index];
  return sum;
}

/// Integral of row y's density from 0 to node x.
double Warp2D::row(std::size_t y, std::size_t x, const Condition& condition) const {
  double sum = 0;
  for (std::size_t k = 0; k < condition.count; ++k)
    sum += condition.weight[k] * rowSums_[(condition.slice[k] * height_ + y) * width_ + x];
  return sum;
}

/// Integral of the marginal from 0 to row y.
double Warp2D::rows(std::size_t y, const Condition& condition) const {
  double sum = 0;
  for (std::size_t k = 0; k < condition.count; ++k)
    sum += condition.weight[k] * sums_[condition.slice[k] * height_ + y];
  return sum;
}

double Warp2D::evaluate(const Point& at, const Condition& condition) const {
  const auto [x, tx] = cell(at.x, width_);
  const auto [y, ty] = cell(at.y, height_);
  const std::size_t i = y * width_ + x;
  return (1 - ty) * ((1 - tx) * value(i, condition) + tx * value(i + 1, condition)) +
         ty * ((1 - tx) * value(i + width_, condition) + tx * value(i + width_ + 1, condition));
}

Warp2D::Drawn Warp2D::draw(const Point& numbers, const Condition& condition) const {
  // Where `sum(k)`, ascending in k from 0, passes `target`: the last k below it.
  const auto below = [](std::size_t count, double target, const auto& sum) {
    std::size_t low = 0, high = count - 1;
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      (sum(middle) <= target ? low : high) = middle;
    }
    return low;
  };
  const double stepsX = static_cast<double>(width_ - 1), stepsY = static_cast<double>(height_ - 1);
  const double wantedY = numbers.y * rows(height_ - 1, condition);
  const std::size_t y = below(height_, wantedY, [&](std::size_t k) { return rows(k, condition); });
  const double r0 = row(y, width_ - 1, condition), r1 = row(y + 1, width_ - 1, condition);
  const double ty = solveLinear(r0, r1, (wantedY - rows(y, condition)) * stepsY);
  const auto along = [&](std::size_t k) { return (1 - ty) * row(y, k, condition) + ty * row(y + 1, k, condition); };
  const double wantedX = numbers.x * along(width_ - 1);
  const std::size_t x = below(width_, wantedX, along);
  const std::size_t i = y * width_ + x;
  const double c0 = (1 - ty) * value(i, condition) + ty * value(i + width_, condition);
  const double c1 = (1 - ty) * value(i + 1, condition) + ty * value(i + width_ + 1, condition);
  const double tx = solveLinear(c0, c1, (wantedX - along(x)) * stepsX);
  return {{(static_cast<double>(x) + tx) / stepsX, (static_cast<double>(y) + ty) / stepsY}, (1 - tx) * c0 + tx * c1};
}

Warp2D::Drawn Warp2D::invert(const Point& at, const Condition& condition) const {
  const auto [x, tx] = cell(at.x, width_);
  const auto [y, ty] = cell(at.y, height_);
  const double stepsX = static_cast<double>(width_ - 1), stepsY = static_cast<double>(height_ - 1);
  const double r0 = row(y, width_ - 1, condition), r1 = row(y + 1, width_ - 1, condition);
  const std::size_t i = y * width_ + x;
  const double c0 = (1 - ty) * value(i, condition) + ty * value(i + width_, condition);
  const double c1 = (1 - ty) * value(i + 1, condition) + ty * value(i + width_ + 1, condition);
  const double start = (1 - ty) * row(y, x, condition) + ty * row(y + 1, x, condition);
  const double whole = (1 - ty) * r0 + ty * r1, all = rows(height_ - 1, condition);
  return {{whole > 0 ? std::min((start + integralLinear(c0, c1, tx) / stepsX) / whole, 1.0) : tx,
           all > 0 ? std::min((rows(y, condition) + integralLinear(r0, r1, ty) / stepsY) / all, 1.0) : ty},
          (1 - tx) * c0 + tx * c1};
}

}  // namespace brdf
