#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/wave/Grating.h>
#include <brdf/simulate/wave/Roughness.h>

#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>

namespace brdf::wave {
namespace {

constexpr double kPi = std::numbers::pi;
double square(double x) { return x * x; }

class GratingModel : public ScatterModel {
 public:
  GratingModel(const GratingShape& shape, FilmStack stack, double wavelength, double width)
      : shape_(shape),
        stack_(std::move(stack)),
        waveNumber_(2 * kPi / wavelength),
        step_(wavelength / shape.period),
        width_(width),
        along_{std::cos(shape.angle), std::sin(shape.angle)} {}

  void jones(const Geometry* geometry, std::size_t count, Jones* values) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const double scale = density(geometry[k]);
      values[k] = scale > 0 ? std::sqrt(scale) * facetAmplitudes(geometry[k], stack_) : Jones{};
    }
  }
  Symmetry symmetry() const override { return Symmetry::Anisotropic; }

 private:
  static constexpr double kReach = 9;  ///< widths: exp(-40)

  /// Sum over the orders of share times response.
  double density(const Geometry& g) const {
    const double u = g.qx * along_[0] + g.qy * along_[1], v = g.qy * along_[0] - g.qx * along_[1];
    if (std::abs(v) > kReach * width_) return 0;
    const double phase = waveNumber_ * shape_.depth * (g.cosI + g.cosS);
    const auto first = static_cast<int>(std::ceil((u - kReach * width_) / step_));
    const auto last = static_cast<int>(std::floor((u + kReach * width_) / step_));
    double sum = 0;
    for (int m = first; m <= last; ++m)
      sum += orderShare(shape_, m, phase) * std::exp(-(square(u - m * step_) + v * v) / (2 * width_ * width_));
    return sum / (2 * kPi * width_ * width_);
  }

  GratingShape shape_;
  FilmStack stack_;
  double waveNumber_, step_, width_;
  std::array<double, 2> along_;
};

class MirrorModel : public ScatterModel {
 public:
  MirrorModel(FilmStack stack, double width) : stack_(std::move(stack)), width_(width) {}
  void jones(const Geometry* geometry, std::size_t count, Jones* values) const override {
    for (std::size_t k = 0; k < count; ++k) {
      const Geometry& g = geometry[k];
      const double x = (g.qx * g.qx + g.qy * g.qy) / (2 * width_ * width_);
      values[k] = x > 700 ? Jones{} : std::exp(-x / 2) / (width_ * std::sqrt(2 * kPi)) * facetAmplitudes(g, stack_);
    }
  }

 private:
  FilmStack stack_;
  double width_;
};

}  // namespace

double orderShare(const GratingShape& shape, int order, double phase) {
  const int m = std::abs(order);
  if (shape.profile == GratingShape::Profile::Sinusoidal) {
    const double x = phase / 2;
    // Far beyond the argument the series' first term, (x/2)^m / m!, is below the least number.
    if (m > 2 * x + 400) return 0;
    return square(boost::math::cyl_bessel_j(m, x));
  }
  const double contrast = 4 * square(std::sin(phase / 2));
  if (m == 0) return std::max(0.0, 1 - contrast * shape.duty * (1 - shape.duty));
  return contrast * square(std::sin(kPi * m * shape.duty) / (kPi * m));
}

std::vector<GratingOrder> gratingOrders(const GratingShape& shape, const FilmStack& stack, double wavelength,
                                        const Vector& wi) {
  const double step = wavelength / shape.period, cx = std::cos(shape.angle), sx = std::sin(shape.angle);
  const auto reach = static_cast<int>(std::min(2 / step, 1e6)) + 1;
  std::vector<GratingOrder> orders;
  for (int m = -reach; m <= reach; ++m) {
    const double x = m * step * cx - wi[0], y = m * step * sx - wi[1], z2 = 1 - x * x - y * y;
    if (!(z2 > 0)) continue;
    const Vector wo{x, y, std::sqrt(z2)}, h{wi[0] + x, wi[1] + y, wi[2] + wo[2]}, across = cross(wi, wo);
    const double length = std::sqrt(dot(h, h));
    Complex rs, rp;
    stack.reflection(std::sqrt(dot(across, across)) / length, length / 2, rs, rp);
    const double share = orderShare(shape, m, 2 * kPi / wavelength * shape.depth * (wi[2] + wo[2]));
    orders.push_back(
        {m, std::atan2(std::hypot(x, y), wo[2]), std::atan2(y, x), share, share * (std::norm(rs) + std::norm(rp)) / 2});
  }
  return orders;
}

ScatterModelPointer grating(const GratingShape& shape, FilmStack stack, double wavelength, double width) {
  if (18 * width * shape.period / wavelength > 200)
    throw Error(Error::Kind::Value,
                {"more than 200 orders of the grating lie within the response of the instrument", "wave model Grating",
                 formatNumber(18 * width * shape.period / wavelength), "a smaller width or period"});
  return std::make_shared<GratingModel>(shape, std::move(stack), wavelength, width);
}

ScatterModelPointer mirror(FilmStack stack, double width) {
  return std::make_shared<MirrorModel>(std::move(stack), width);
}

}  // namespace brdf::wave
