#include <brdf/simulate/Fresnel.h>
#include <brdf/simulate/cpu/CpuTransport.h>
#include <brdf/simulate/cpu/PathGroup.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace brdf {
namespace {

constexpr double kSplitLeast = 1e-3;  ///< a part of a split carries no less, of what the ray brought

}  // namespace

void CpuTransport::meetDielectric(PathGroup& group, std::size_t p, bool front, double cosine) const {
  LightPath& path = group.paths[p];
  const int medium = scene_.medium(path.meeting.facet);
  const Media behind = front ? path.media.entering(medium) : path.media.leaving(medium);
  const int from = path.media.current(), to = behind.current();
  if (from == to) {  // within another one that rules here
    path.media = behind;
    return;
  }
  double* weight = group.weight(p);
  const auto only = static_cast<std::size_t>(std::max(path.channel, 0));
  const double ratio = index(to, only) / index(from, only);
  double cosT = 0, reflected = 0, refracted = 0;
  const double reflectance = dielectricReflectance(cosine, ratio, cosT);
  bool parts = false;  // the channels refract into different directions
  for (std::size_t c = 0; c < channels_; ++c) {
    group.fresnel[c] = reflectance;
    if (const double own = dispersive_ ? index(to, c) / index(from, c) : ratio; own != ratio) {
      group.fresnel[c] = dielectricReflectance(cosine, own, cosT);
      parts = parts || weight[c] > 0;
    }
    reflected += weight[c] * group.fresnel[c];
    group.refracted[c] = weight[c] * (1 - group.fresnel[c]);
    refracted += group.refracted[c];
  }
  // What goes on as the refracted part, and what as the reflected one.
  const double least = kSplitLeast * static_cast<double>(channels_);
  const bool splits = group.parts[path.owner] < PathGroup::kParts && std::min(reflected, refracted) > least;
  bool refracts = refracted > 0;
  double share = 1;  // by which the drawn part's weight is divided
  if (!splits && refracts && reflected > 0) {
    const double chance = refracted / (reflected + refracted);
    refracts = path.random.next() < chance;
    share = refracts ? chance : 1 - chance;
  }
  const double towards = dot(path.ray.direction, path.meeting.normal);
  if (refracts) {
    std::size_t q = p;
    if (splits) {
      q = group.paths.size();
      group.paths.push_back(path);
      group.paths[q].random = PathRandom(static_cast<std::uint64_t>(path.random.next() * 0x1p53));
      ++group.parts[path.owner];
      group.waiting.push_back(static_cast<std::uint32_t>(q));
    }
    LightPath& inner = group.paths[q];
    double* carried = group.weight(q);
    std::size_t channel = only;
    if (parts) {
      double at = inner.random.next() * refracted;
      for (channel = 0; channel + 1 < channels_ && at >= group.refracted[channel]; ++channel)
        at -= group.refracted[channel];
      inner.channel = static_cast<std::int32_t>(channel);
    }
    for (std::size_t c = 0; c < channels_; ++c)
      carried[c] = (!parts ? group.refracted[c] : c == channel ? refracted : 0.0) / share;
    const double eta = index(to, channel) / index(from, channel);
    dielectricReflectance(cosine, eta, cosT);
    // d / eta + (cosI / eta - cosT) n, with the normal against the light.
    const double turned = (cosine / eta - cosT) * (towards < 0 ? 1 : -1);
    for (std::size_t k = 0; k < 3; ++k)
      inner.ray.direction[k] = inner.ray.direction[k] / eta + turned * inner.meeting.normal[k];
    inner.ray.direction = normalized(inner.ray.direction);
    inner.media = behind;
    if (!splits) return;
    TileScene::leave(inner.ray, inner.meeting);
  }
  for (std::size_t c = 0; c < channels_; ++c) weight[c] *= group.fresnel[c] / share;
  for (std::size_t k = 0; k < 3; ++k) path.ray.direction[k] -= 2 * towards * path.meeting.normal[k];
}

void CpuTransport::scatter(PathGroup& group, std::size_t facet) const {
  const std::size_t first = static_cast<std::size_t>(
      std::ranges::find_if(group.atFacet, [&](std::uint32_t p) { return group.paths[p].meeting.facet == facet; }) -
      group.atFacet.begin());
  const std::size_t count = group.atFacet.size() - first;  // sorted by facet: those at the end
  const Brdf& brdf = *facets_[facet].brdf;
  const std::size_t given = brdf.channels().count();
  group.pairs.resize(count);
  for (auto& numbers : group.numbers) numbers.resize(count);
  group.values.resize(given * count);
  group.density.resize(count);
  const auto pathOf = [&](std::size_t k) -> LightPath& { return group.paths[group.atFacet[first + k]]; };
  for (std::size_t k = 0; k < count; ++k) {
    LightPath& path = pathOf(k);
    const Direction& d = path.ray.direction;
    const Direction light = FacetFrame(path.meeting.normal).local({-d[0], -d[1], -d[2]});
    group.pairs.set(k, light, {});
    for (auto& numbers : group.numbers) numbers[k] = path.random.next();
  }
  // Samplers draw a light for a viewer: here the known direction is the light, and stands in the viewer's place.
  auto& light = group.pairs.wi;
  auto& drawn = group.pairs.wo;
  const auto read = [](const std::array<std::vector<double>, 3>& a) {
    return std::array<const double*, 3>{a[0].data(), a[1].data(), a[2].data()};
  };
  brdf.sample(read(light), {group.numbers[0].data(), group.numbers[1].data()},
              {drawn[0].data(), drawn[1].data(), drawn[2].data()}, count);
  const DirectionPairs<double> pairs{read(light), read(drawn), count}, swapped{read(drawn), read(light), count};
  brdf.evaluate(pairs, group.values.data(), nullptr);
  brdf.pdf(swapped, group.density.data());
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t p = group.atFacet[first + k];
    LightPath& path = pathOf(k);
    double* weight = group.weight(p);
    double* absorbed = group.absorbed.data() + path.owner * channels_;
    const Direction local{drawn[0][k], drawn[1][k], drawn[2][k]};
    const bool failed = !(local[2] > 0 && group.density[k] > 0);
    for (std::size_t c = 0; c < channels_; ++c) {
      const double value = group.values[(given == 1 ? 0 : c) * count + k];
      const double kept = failed ? 0 : weight[c] * value * local[2] / group.density[k];
      absorbed[c] += weight[c] - kept;
      weight[c] = kept;
    }
    path.state = LightPath::State::Travelling;
    if (failed) {
      path.state = LightPath::State::Ended;
      path.outcome = Outcome::Absorbed;
      continue;
    }
    path.ray.direction = FacetFrame(path.meeting.normal).world(local);
    TileScene::leave(path.ray, path.meeting);
    if (survives(group, p)) group.waiting.push_back(static_cast<std::uint32_t>(p));
  }
  group.atFacet.resize(first);
}

void CpuTransport::connect(PathGroup& group, std::size_t p) const {
  LightPath& path = group.paths[p];
  const OutgoingBins& bins = *group.bins;
  const std::size_t count = bins.count();
  const double* weight = group.weight(p);
  double* light = group.light.data() + path.owner * channels_ * count;
  double* excess = group.excess.data() + path.owner * channels_;
  const double c = group.turns[2 * path.owner], s = group.turns[2 * path.owner + 1];
  const double u = path.random.next(), v = path.random.next(), image = path.random.next();
  Meeting meeting;
  double distance;
  for (std::size_t b = 0; b < count; ++b) {
    const Direction wo = bins.direction(b, u, v, image);
    DoubleRay ray;
    ray.direction = {c * wo[0] - s * wo[1], s * wo[0] + c * wo[1], wo[2]};  // about the turned surface
    const double cosine = dot(ray.direction, path.meeting.normal);
    if (!(wo[2] > 0 && cosine > 0)) continue;
    TileScene::leave(ray, path.meeting);
    if (scene_.follow(ray, path.media, meeting, distance, group.queries) != TileScene::End::Above) continue;
    const double share = cosine / kPi * bins.solidAngle(b);
    for (std::size_t channel = 0; channel < channels_; ++channel) {
      light[channel * count + b] += weight[channel] * share;
      excess[channel] -= weight[channel] * share;
    }
  }
}

void CpuTransport::tallyGroup(PathGroup& group, std::size_t rays, const OutgoingBins& bins, Tally& tally) const {
  constexpr auto none = std::numeric_limits<std::uint32_t>::max();
  const auto entry = [&](Outcome outcome) {
    return group.totals.data() + static_cast<std::size_t>(outcome) * channels_;
  };
  group.lastPart.resize(rays);
  group.partBefore.assign(group.paths.size(), none);
  for (std::size_t k = 0; k < rays; ++k) group.lastPart[k] = static_cast<std::uint32_t>(k);
  for (std::size_t p = rays; p < group.paths.size(); ++p) {
    group.partBefore[p] = group.lastPart[group.paths[p].owner];
    group.lastPart[group.paths[p].owner] = static_cast<std::uint32_t>(p);
  }
  for (std::size_t k = 0; k < rays; ++k) {
    std::ranges::fill(group.totals, 0.0);
    std::copy_n(group.absorbed.data() + k * channels_, channels_, entry(Outcome::Absorbed));
    struct Arrival {
      std::size_t bin;
      bool above;
      std::size_t path;
    };
    std::array<Arrival, PathGroup::kParts> arrivals;
    std::size_t arrived = 0;
    for (std::uint32_t p = group.lastPart[k]; p != none; p = group.partBefore[p]) {
      const LightPath& path = group.paths[p];
      double* weight = group.weight(p);
      for (std::size_t c = 0; c < channels_; ++c) entry(path.outcome)[c] += weight[c];
      const bool above = path.outcome == Outcome::Reflected;
      if (!above && path.outcome != Outcome::Transmitted) continue;
      if (path.specular) {
        double* specular = entry(above ? Outcome::SpecularReflected : Outcome::SpecularTransmitted);
        for (std::size_t c = 0; c < channels_; ++c) specular[c] += weight[c];
        continue;
      }
      const std::size_t bin = bins.find(path.ray.direction);
      if (bin == bins.count()) continue;
      if (tally.listsDepartures)
        tally.departures.push_back({path.ray.direction,
                                    std::accumulate(weight, weight + channels_, 0.0) / static_cast<double>(channels_),
                                    !above});
      if (above && path.connected) {
        for (std::size_t c = 0; c < channels_; ++c) group.excess[k * channels_ + c] += weight[c];
        continue;
      }
      const auto same = std::find_if(arrivals.begin(), arrivals.begin() + arrived,
                                     [&](const Arrival& a) { return a.bin == bin && a.above == above; });
      if (same == arrivals.begin() + arrived) {
        arrivals[arrived++] = {bin, above, p};
      } else {
        double* together = group.weight(same->path);
        for (std::size_t c = 0; c < channels_; ++c) together[c] += weight[c];
      }
    }
    for (std::size_t a = 0; a < arrived; ++a) {
      RaySums& sums = arrivals[a].above ? tally.reflected : tally.transmitted;
      const double* weight = group.weight(arrivals[a].path);
      for (std::size_t c = 0; c < channels_; ++c) {
        if (connects_ && arrivals[a].above)
          group.light[(k * channels_ + c) * tally.bins + arrivals[a].bin] += weight[c];
        else
          sums.add(c * tally.bins + arrivals[a].bin, weight[c]);
      }
    }
    for (std::size_t c = 0; connects_ && c < channels_; ++c) {
      const double excess = group.excess[k * channels_ + c];
      const double* light = group.light.data() + (k * channels_ + c) * tally.bins;
      tally.excess.add(c, excess);
      for (std::size_t b = 0; b < tally.bins; ++b) {
        if (light[b] == 0) continue;
        tally.reflected.add(c * tally.bins + b, light[b]);
        tally.excessTimesReflected[c * tally.bins + b] += light[b] * excess;
      }
    }
    for (const Outcome part : {Outcome::Reflected, Outcome::Transmitted, Outcome::Absorbed, Outcome::Lost})
      for (std::size_t c = 0; c < channels_; ++c) entry(Outcome::Sum)[c] += entry(part)[c];
    for (std::size_t e = 0; e < group.totals.size(); ++e) tally.outcomes.add(e, group.totals[e]);
  }
  tally.rays += rays;
  tally.segments += group.queries;
}

}  // namespace brdf
