#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

namespace brdf {

/// Random numbers that make a surface: the same for the same seed on every machine (SplitMix64: Steele, Lea, Flood
/// 2014, "Fast Splittable Pseudorandom Number Generators", doi:10.1145/2660193.2660195).
class SurfaceRandom {
 public:
  explicit SurfaceRandom(std::uint64_t seed) : state_(mixed(seed + 0x9e3779b97f4a7c15u)) {}

  double uniform() {  ///< in [0, 1)
    return static_cast<double>(mixed(state_ += 0x9e3779b97f4a7c15u) >> 11) * 0x1p-53;
  }
  /// Of mean 0 and variance 1 (Box and Muller 1958, doi:10.1214/aoms/1177706645).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform())), angle = 2 * std::numbers::pi * uniform();
    return radius * std::cos(angle);
  }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace brdf
