#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Channels.h>

#include <cstdint>
#include <span>
#include <vector>

namespace brdf {

/// A figure with its standard error (one standard deviation of the estimate).
struct Estimate {
  double value = 0, error = 0;
};

/// Sums over rays of something a ray carries, for several channels or bins.
struct RaySums {
  std::vector<double> sum, square;  ///< of the values, and of their squares, a ray's contributions to one entry added
                                    ///< up before they are squared

  explicit RaySums(std::size_t entries = 0) : sum(entries), square(entries) {}
  void add(std::size_t entry, double value) {
    sum[entry] += value;
    square[entry] += value * value;
  }
  BRDF_EXPORT void add(const RaySums& other);
  /// Mean a ray of `rays` independent ones, and its standard error; infinite for fewer than 2 rays.
  BRDF_EXPORT Estimate mean(std::size_t entry, std::uint64_t rays) const;
};

/// What became of light.
enum class Outcome {
  Reflected,            ///< left above, towards one of the bins or where no bin is
  Transmitted,          ///< left below
  Absorbed,             ///< by a facet or inside a dielectric
  Lost,                 ///< met no end: cut by the bounces, or by rounding fell through an opaque surface
  SpecularReflected,    ///< the part of Reflected that left in the mirror direction by mirror-like facets only
  SpecularTransmitted,  ///< the part of Transmitted that went straight through, or as a flat interface refracts
  Sum                   ///< Reflected + Transmitted + Absorbed + Lost
};
constexpr std::size_t kOutcomes = 7;

/// A direction in which light left, before it was put into a bin.
struct Departure {
  Direction direction{};     ///< as OutgoingBins::find() takes it
  double light = 0;          ///< of what the ray brought, mean over the channels
  bool transmitted = false;  ///< left below
};

/// Where the light of many rays from one incident direction went. Every ray brings 1 in each channel; nothing else is
/// normalised. What left specularly is in no bin.
struct Tally {
  std::size_t bins = 0, channels = 0;
  std::uint64_t rays = 0;
  std::uint64_t segments = 0;      ///< ray-geometry queries that were made: the cost
  RaySums reflected, transmitted;  ///< by bin, planar: channel c of bin b at [c * bins + b]
  RaySums outcomes;                ///< Outcome o of channel c at [o * channels + c]
  /// Next-event estimation (Transport::connects()): of each channel what its paths carried away from facets that were
  /// connected less what the connections put into bins, whose mean is 0; and the sums over rays of this times what the
  /// ray brought into each bin, as `reflected`. Else empty.
  RaySums excess;
  std::vector<double> excessTimesReflected;
  bool listsDepartures = false;  ///< whether every piece of light that is put into a bin is listed as well
  std::vector<Departure> departures;

  Tally() = default;
  Tally(std::size_t binCount, std::size_t channelCount)
      : bins(binCount),
        channels(channelCount),
        reflected(binCount * channelCount),
        transmitted(binCount * channelCount),
        outcomes(kOutcomes * channelCount) {}

  /// Adds other rays of the same direction.
  BRDF_EXPORT void add(const Tally& other);
  void prepareExcess();
  /// The light in bins: `reflected`, with the excess, where there is one, or a part of it shared out among the bins of
  /// its channel by what they hold. A control variate: the sum of bins that err together is then known as well as what
  /// paths carried.
  BRDF_EXPORT RaySums balanced() const;
  Estimate outcome(Outcome outcome, std::size_t channel) const {
    return outcomes.mean(static_cast<std::size_t>(outcome) * channels + channel, rays);
  }
};

}  // namespace brdf
