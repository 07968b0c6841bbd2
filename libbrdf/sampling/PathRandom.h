#pragma once
#include <cstdint>

namespace brdf {

/// Independent random numbers of one path: a counter mixed by SplitMix64 (Steele, Lea, Flood 2014, "Fast Splittable
/// Pseudorandom Number Generators"). The same stream for the same key everywhere.
class PathRandom {
 public:
  explicit PathRandom(std::uint64_t key = 0) : state_(mixed(key)) {}
  double next() {  ///< in [0, 1)
    state_ += 0x9e3779b97f4a7c15u;
    return static_cast<double>(mixed(state_) >> 11) * 0x1p-53;
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
