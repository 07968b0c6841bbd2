#pragma once
#include <brdf/material/Brdf.h>

#include <cstddef>

namespace brdf::app {

struct Violations {
  std::size_t tested = 0;
  std::size_t count = 0;
  double median = 0;  ///< reciprocity: the usual relative difference
  double worst = 0;   ///< reciprocity: largest relative difference; energy: largest albedo
};

/// Random direction pairs (cosine-distributed, fixed seed) whose value changes by more than `tolerance`, relative to
/// the larger one, when light and viewer are exchanged. Pairs without a value are left out.
Violations reciprocityViolations(const Brdf& brdf, std::size_t pairs, double tolerance);

/// Light directions 0, 5, ..., 85 degrees and channels at which the albedo exceeds 1 by more than three of its errors.
Violations energyViolations(const Brdf& brdf, std::size_t points);

}  // namespace brdf::app
