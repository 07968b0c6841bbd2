#pragma once
// Paths that are traced together, so that facets with a BRDF are evaluated in batches. Internal to libbrdf/simulate.
#include <brdf/material/Brdf.h>
#include <brdf/sampling/PathRandom.h>
#include <brdf/simulate/OutgoingBins.h>
#include <brdf/simulate/Tally.h>
#include <brdf/simulate/cpu/TileScene.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace brdf {

/// The frame of a facet: its tangent is +x as seen along the facet (+y where that is its normal).
struct FacetFrame {
  Direction t, b, n;
  explicit FacetFrame(const Direction& normal) : n(normal) {
    t = {1 - n[0] * n[0], -n[0] * n[1], -n[0] * n[2]};
    if (dot(t, t) < 1e-20) t = {-n[2] * n[1], 1 - n[1] * n[1], -n[1] * n[2]};
    t = normalized(t);
    b = cross(n, t);
  }
  Direction local(const Direction& d) const { return {dot(d, t), dot(d, b), dot(d, n)}; }
  Direction world(const Direction& d) const {
    Direction w;
    for (std::size_t k = 0; k < 3; ++k) w[k] = d[0] * t[k] + d[1] * b[k] + d[2] * n[k];
    return normalized(w);
  }
};

/// A ray's way from the light, or a part of it from where it split on.
struct LightPath {
  enum class State { Travelling, Scattering, Ended };

  DoubleRay ray;
  Meeting meeting;  ///< Scattering: where
  Media media;
  PathRandom random{};
  std::uint32_t owner = 0;    ///< the ray, of the group
  std::int32_t channel = -1;  ///< the only one that it still carries, or -1: all
  std::uint32_t meetings = 0;
  State state = State::Travelling;
  bool mirrorLike = true;           ///< met mirrors, conductors and dielectrics only
  Outcome outcome = Outcome::Lost;  ///< Ended
  bool connected = false;           ///< what leaves from the last facet met is in the bins already
  bool specular = false;            ///< Ended: left as a flat surface would send it
};

/// At most kRays rays, each in at most kParts parts.
struct PathGroup {
  static constexpr std::size_t kRays = 128, kParts = 4;

  explicit PathGroup(std::size_t channelCount)
      : channels(channelCount),
        weights(kRays * kParts * channels),
        absorbed(kRays * channels),
        totals(kOutcomes * channels),
        fresnel(channels),
        refracted(channels) {
    paths.reserve(kRays * kParts);
    waiting.reserve(kRays * kParts);
    atFacet.reserve(kRays * kParts);
  }

  double* weight(std::size_t path) { return weights.data() + path * channels; }

  std::size_t channels;
  std::vector<LightPath> paths;
  std::vector<std::uint32_t> parts;  ///< paths of a ray so far
  std::vector<double> weights;       ///< of a path, one a channel
  std::vector<double> absorbed;      ///< of a ray, one a channel
  std::vector<double> turns;         ///< cosine and sine of the angle by which a ray's surface is turned
  std::vector<std::uint32_t> waiting, atFacet;
  std::vector<std::uint32_t> lastPart, partBefore;  ///< of a ray, of a path: to tally the parts of a ray together
  std::vector<double> totals, fresnel, refracted;   ///< scratch: of one ray, of one meeting
  Direction incident{};                             ///< the way light travels, before the surface is turned
  std::uint64_t queries = 0;

  // Of facets that are connected with the bins.
  const OutgoingBins* bins = nullptr;
  std::vector<double> excess;  ///< Tally::excess, by ray, then channel
  std::vector<double> light;   ///< in the bins, by ray, then channel, then bin: to be squared when the ray is complete

  // Of a batch of scatterings, one entry a path.
  DirectionPairBuffer<double> pairs;
  std::array<std::vector<double>, 2> numbers;
  std::vector<double> values, density;
};

}  // namespace brdf
