#pragma once
// What the benchmarks of look-ups and lobes share: the pairs they ask for, and the clock.
#include <brdf/geometry/Directions.h>

#include <array>
#include <cmath>
#include <ctime>
#include <random>

namespace brdf {

inline constexpr std::size_t kPairs = 1'000'000;

/// kPairs pairs above the horizon, uniform in projected solid angle, always the same.
template <class T>
const DirectionPairBuffer<T>& randomPairs() {
  static const DirectionPairBuffer<T> pairs = [] {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto direction = [&] {
      const Direction w = fromSpherical(std::acos(std::sqrt(uniform(random))), 2 * kPi * uniform(random));
      return std::array<T, 3>{T(w[0]), T(w[1]), T(w[2])};
    };
    DirectionPairBuffer<T> made(kPairs);
    for (std::size_t i = 0; i < kPairs; ++i) made.set(i, direction(), direction());
    return made;
  }();
  return pairs;
}

/// Processor time that this thread spends on the work, in seconds: other programs on the machine do not count.
inline double secondsOf(const auto& work) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

}  // namespace brdf
