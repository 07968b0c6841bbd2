#pragma once
#include <brdf/brdf_export.h>

#include <cstdint>
#include <span>
#include <vector>

namespace brdf {

/// How often numbers fall between edges.
struct Histogram {
  std::vector<double> edges;         ///< ascending, one more than bins
  std::vector<std::uint64_t> count;  ///< of bin i: from edges[i] to below edges[i + 1], the last edge included
  std::vector<double> share;         ///< of the weight, adds up to 1
  bool logarithmic = false;          ///< edges in equal ratios; the first bin holds everything smaller, too
};

/// Numbers that are finite, each with a weight >= 0 (`weights` empty: all alike). None negative and the largest more
/// than 20 times the median: logarithmic bins over at most eight decades; else `bins` (1 to 10000) equal ones. Numbers
/// that are all the same have one bin. No numbers: no bins. Throws Error::Kind::Value for another number of bins.
BRDF_EXPORT Histogram makeHistogram(std::span<const double> values, std::span<const double> weights, std::size_t bins);

/// Numbers in their order, with the weight of those before.
class BRDF_EXPORT Distribution {
 public:
  /// Weights >= 0; empty: all alike.
  Distribution(std::span<const double> values, std::span<const double> weights);

  /// The smallest number that no less than `share` (0 to 1) of the weight does not exceed; 0 without numbers.
  double quantile(double share) const;

 private:
  std::vector<double> values_, shares_;
};

}  // namespace brdf
