#include <brdf/base/Parallel.h>
#include <brdf/simulate/Transport.h>
#include <brdf/simulate/gpu/TracedRays.h>

#include <cmath>

namespace brdf {
namespace {

/// Interfaces keep what of a direction lies along the surface; floats keep it to this (eight units in the last place).
/// The angle at which light leaves a slab at grazing incidence they do not keep as well.
constexpr double kRounding = 1e-6;

/// Where light of a part arrives: no bin, or none because it is specular.
struct Arrival {
  std::uint32_t bin;
  bool specular;
};

Direction flatDirection(const Direction& wi, bool above, double index) {
  const double eta = above ? 1 : index;
  Direction flat{-wi[0] / eta, -wi[1] / eta, 0};
  const double z2 = 1 - flat[0] * flat[0] - flat[1] * flat[1];
  flat[2] = z2 > 0 ? std::copysign(std::sqrt(z2), above ? 1.0 : -1.0) : 0;
  return flat;
}

}  // namespace

void TracedRays::addTo(Tally& tally, const OutgoingBins& bins, std::size_t rays) const {
  std::vector<Arrival> arrivals(rays * parts);
  const Direction wi = bins.wi();
  parallelFor(arrivals.size(), 4096, [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) {
      const std::uint32_t state = states[k][0], end = state & kEnded;
      arrivals[k] = {static_cast<std::uint32_t>(bins.count()), false};
      if (end != kLeftAbove && end != kLeftBelow) continue;
      const Direction left{double(directions[k][0]), double(directions[k][1]), double(directions[k][2])};
      if ((state & kScattered) == 0) {
        const Direction flat = flatDirection(wi, end == kLeftAbove, index[state >> kMediumShift & 15]);
        const Direction off{left[0] - flat[0], left[1] - flat[1], left[2] - flat[2]};
        const double along2 = off[0] * off[0] + off[1] * off[1];
        arrivals[k].specular =
            along2 + off[2] * off[2] <= kSpecularWithin * kSpecularWithin || along2 <= kRounding * kRounding;
      }
      if (!arrivals[k].specular)
        arrivals[k].bin = static_cast<std::uint32_t>(bins.find({left[0], left[1], std::abs(left[2])}));
    }
  });

  const auto outcomeOf = [](std::uint32_t state) {
    switch (state & kEnded) {
      case kLeftAbove:
        return Outcome::Reflected;
      case kLeftBelow:
        return Outcome::Transmitted;
      case kAbsorbed:
        return Outcome::Absorbed;
      default:
        return Outcome::Lost;
    }
  };
  for (std::size_t ray = 0; ray < rays; ++ray) {
    const std::size_t first = ray * parts;
    // What was never split has one part.
    const std::size_t count = parts == 2 && (states[first][0] & kSplit) != 0 ? 2 : 1;
    const bool together = count == 2 && arrivals[first].bin == arrivals[first + 1].bin &&
                          ((states[first][0] ^ states[first + 1][0]) & kEnded) == 0;
    for (std::size_t k = first; k < first + count; ++k) {
      tally.segments += states[k][2];
      if (!tally.listsDepartures || arrivals[k].bin == bins.count()) continue;
      const Floats& left = directions[k];
      double light = 0;
      for (std::size_t c = 0; c < channels; ++c) light += double(weights[k][c]);
      tally.departures.push_back({{double(left[0]), double(left[1]), double(std::abs(left[2]))},
                                  light / static_cast<double>(tally.channels),
                                  outcomeOf(states[k][0]) == Outcome::Transmitted});
    }
    for (std::size_t c = 0; c < channels; ++c) {
      const std::size_t channel = firstChannel + c;
      std::array<double, kOutcomes> totals{};
      double absorbedHere = 0, goesOn = 0;
      bool chance = false;
      for (std::size_t k = first; k < first + count; ++k) {
        const std::uint32_t state = states[k][0];
        const Outcome outcome = outcomeOf(state);
        const double weight = double(weights[k][c]);
        totals[static_cast<std::size_t>(outcome)] += weight;
        absorbedHere += double(absorbed[k][c]);
        goesOn += weight;
        chance = chance || (state & kChance) != 0;
        if (outcome != Outcome::Reflected && outcome != Outcome::Transmitted) continue;
        const bool above = outcome == Outcome::Reflected;
        if (arrivals[k].specular)
          totals[static_cast<std::size_t>(above ? Outcome::SpecularReflected : Outcome::SpecularTransmitted)] += weight;
        if (arrivals[k].bin == bins.count()) continue;
        if (together && k > first) continue;
        RaySums& sums = above ? tally.reflected : tally.transmitted;
        sums.add(channel * tally.bins + arrivals[k].bin, together ? weight + double(weights[first + 1][c]) : weight);
      }
      // Where nothing was left to chance, what does not go on was absorbed: without the rounding of floats.
      totals[static_cast<std::size_t>(Outcome::Absorbed)] +=
          chance || absorbedHere == 0 ? absorbedHere : std::max(1 - goesOn, 0.0);
      for (const Outcome part : {Outcome::Reflected, Outcome::Transmitted, Outcome::Absorbed, Outcome::Lost})
        totals[static_cast<std::size_t>(Outcome::Sum)] += totals[static_cast<std::size_t>(part)];
      for (std::size_t o = 0; o < kOutcomes; ++o) tally.outcomes.add(o * tally.channels + channel, totals[o]);
    }
  }
}

}  // namespace brdf
