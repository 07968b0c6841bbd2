#pragma once
// A monochrome BRDF given by a function, and the materials that samplers find hard.
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>

#include <functional>

namespace brdf::test {

class FunctionBrdf : public Brdf {
 public:
  using Function = std::function<double(const Direction& wi, const Direction& wo)>;
  explicit FunctionBrdf(Function function, Symmetry symmetry = Symmetry::Isotropic)
      : function_(std::move(function)), symmetry_(symmetry) {}

  const Channels& channels() const override { return channels_; }
  Symmetry symmetry() const override { return symmetry_; }
  bool reciprocal() const override { return true; }
  std::string description() const override { return "test function"; }
  using Brdf::evaluate;
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const Direction wi{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
      const Direction wo{pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
      values[i] = wi[2] > 0 && wo[2] > 0 ? function_(wi, wo) : 0;
      if (valid) valid[i] = 1;
    }
  }

 private:
  Function function_;
  Symmetry symmetry_;
  Channels channels_;
};

/// Light goes back to where it came from, within about 1.7 degrees, over a diffuse ground.
inline FunctionBrdf retroReflector() {
  return FunctionBrdf([](const Direction& wi, const Direction& wo) {
    double squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) squared += (wi[axis] - wo[axis]) * (wi[axis] - wo[axis]);
    return 0.05 + 40 * std::exp(-squared / (0.03 * 0.03));
  });
}

/// Brushed metal: thirteen times wider across the tangent than along it.
inline FunctionBrdf brushed() {
  return FunctionBrdf(
      [](const Direction& wi, const Direction& wo) {
        const double z = wi[2] + wo[2], x = (wi[0] + wo[0]) / z, y = (wi[1] + wo[1]) / z;
        return 0.02 + 5 * std::exp(-x * x / (0.03 * 0.03) - y * y / (0.4 * 0.4));
      },
      Symmetry::Anisotropic);
}

}  // namespace brdf::test
