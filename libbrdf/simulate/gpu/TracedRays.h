#pragma once
#include <brdf/brdf_export.h>
#include <brdf/simulate/OutgoingBins.h>
#include <brdf/simulate/Tally.h>

#include <array>
#include <cstdint>
#include <vector>

namespace brdf {

/// What became of rays that shaders/brdf_transport.glsl has traced, as it comes back from the device: of each ray its
/// parts one after the other, up to four channels side by side.
struct TracedRays {
  using Floats = std::array<float, 4>;
  using Words = std::array<std::uint32_t, 4>;
  /// Bits of the first word of a state; shaders/brdf_transport_path.glsl says what they mean.
  static constexpr std::uint32_t kEnded = 7, kLeftAbove = 1, kLeftBelow = 2, kAbsorbed = 3, kLost = 4, kScattered = 8,
                                 kChance = 16, kSplit = 32, kSecond = 64, kMediumShift = 12;

  std::size_t parts = 1;  ///< of a ray: 1 or 2
  std::vector<Floats> directions, weights, absorbed;
  std::vector<Words> states;  ///< state, meetings, searches, steps
  std::size_t firstChannel = 0, channels = 1;
  /// Index of refraction outside and in each medium, of the first channel.
  std::array<double, 9> index{1, 1, 1, 1, 1, 1, 1, 1, 1};

  /// Adds the first `rays` rays to the tally's channels, in their order; Tally::rays is left alone.
  BRDF_EXPORT void addTo(Tally& tally, const OutgoingBins& bins, std::size_t rays) const;
};

}  // namespace brdf
