#pragma once
#include <brdf/material/Brdf.h>

#include <cstdint>
#include <functional>
#include <string>

namespace brdf::app {

/// Values of one block of direction pairs: planar like Brdf::evaluate, and the sampling density when `density` is not
/// null. Called from several threads.
using BlockEvaluator =
    std::function<void(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid, double* density)>;

struct TableResult {
  std::size_t rows = 0;
  std::size_t invalid = 0;  ///< rows where the BRDF has no value: written as nan
};

/// Reads direction pairs from the CSV file `in` (columns wi_x,wi_y,wi_z,wo_x,wo_y,wo_z in any order, others kept),
/// and writes `out`: the same rows extended by value_0.. (one a channel; 17 significant digits) and, with
/// `withDensity`, `pdf`. Directions must be of unit length to 1e-3 and are normalised when they are not to 1e-14.
/// Throws Error with the line. `progress(rows done, rows)` may return false to stop (then nothing is written).
TableResult evaluateTable(const std::string& in, const std::string& out, std::size_t channels, bool withDensity,
                          const BlockEvaluator& evaluate,
                          const std::function<bool(std::size_t, std::size_t)>& progress);

}  // namespace brdf::app
