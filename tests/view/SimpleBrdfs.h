#pragma once
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>

#include <functional>
#include <utility>

namespace brdf::test {

/// A BRDF from a function of one pair of directions above the horizon, the same in every channel; valid where `valid`
/// says so.
class FunctionBrdf : public Brdf {
 public:
  using Function = std::function<double(const Direction& wi, const Direction& wo)>;
  using Validity = std::function<bool(const Direction& wi, const Direction& wo)>;

  explicit FunctionBrdf(Function function, Channels channels = {}, Validity valid = nullptr)
      : function_(std::move(function)), valid_(std::move(valid)), channels_(std::move(channels)) {}

  const Channels& channels() const override { return channels_; }
  Symmetry symmetry() const override { return Symmetry::Isotropic; }
  bool reciprocal() const override { return true; }
  std::string description() const override { return "test function"; }
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override {
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const Direction wi{pairs.wi[0][i], pairs.wi[1][i], pairs.wi[2][i]};
      const Direction wo{pairs.wo[0][i], pairs.wo[1][i], pairs.wo[2][i]};
      const bool known = !valid_ || valid_(wi, wo);
      const double value = known && wi[2] > 0 && wo[2] > 0 ? function_(wi, wo) : 0;
      for (std::size_t c = 0; c < channels_.count(); ++c) values[c * pairs.count + i] = value;
      if (valid) valid[i] = known;
    }
  }
  using Brdf::evaluate;

 private:
  Function function_;
  Validity valid_;
  Channels channels_;
};

inline FunctionBrdf constantBrdf(double value, Channels channels = {}) {
  return FunctionBrdf([value](const Direction&, const Direction&) { return value; }, std::move(channels));
}

/// Angle between two unit vectors; exact for small ones.
inline double angleBetween(const Direction& a, const Direction& b) {
  const Direction c = cross(a, b);
  return std::atan2(std::sqrt(dot(c, c)), dot(a, b));
}

}  // namespace brdf::test
