#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/sampling/SampledBrdf.h>
#include <brdf/sampling/Sequence.h>
#include <brdf/simulate/Fresnel.h>
#include <brdf/simulate/cpu/CpuTransport.h>
#include <brdf/simulate/cpu/PathGroup.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// Sums are kept by strands whose number does not depend on the threads; each takes every so many groups of rays.
constexpr std::size_t kStrands = 32;
constexpr std::size_t kStrandBytes = std::size_t{128} << 20;  ///< of all strands' tallies, where one is not more

/// Below this share a path goes on by chance only. Small: a roulette that ends what matters makes noise, and paths that
/// carry less are few.
constexpr double kRoulette = 0.01;

std::vector<double> perChannel(const std::vector<double>& numbers, std::size_t channels, double otherwise = 0) {
  if (numbers.size() == channels) return numbers;
  return std::vector<double>(channels, numbers.empty() ? otherwise : numbers[0]);
}

Direction mirrored(const Direction& d, const Direction& n, double along) {
  return {d[0] - 2 * along * n[0], d[1] - 2 * along * n[1], d[2] - 2 * along * n[2]};
}

std::uint64_t mixed(std::uint64_t z) {  // SplitMix64's finaliser, as in PathRandom
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

CpuTransport::CpuTransport(const Microsurface& surface, const TransportOptions& options)
    : scene_(surface), channels_(surface.channels.count()), bounces_(options.bounces) {
  for (const Facet& facet : surface.facets) {
    PreparedFacet& prepared = facets_.emplace_back();
    prepared.kind = facet.kind;
    switch (facet.kind) {
      case Facet::Kind::Mirror:
        break;
      case Facet::Kind::Conductor:
        prepared.first = perChannel(facet.eta, channels_);
        prepared.second = perChannel(facet.k, channels_);
        break;
      case Facet::Kind::Dielectric:
        prepared.first = perChannel(facet.eta, channels_);
        prepared.second = perChannel(facet.absorption, channels_);
        prepared.dispersive = std::ranges::count(prepared.first, prepared.first[0]) != std::ssize(prepared.first);
        prepared.absorbs = std::ranges::any_of(prepared.second, [](double a) { return a > 0; });
        break;
      case Facet::Kind::Lambertian:
        prepared.first = perChannel(facet.albedo, channels_);
        break;
      case Facet::Kind::Scattering:
        prepared.brdf = withSampler(facet.brdf);
    }
    dispersive_ = dispersive_ || prepared.dispersive;
  }
  const auto count = [&](Facet::Kind kind) { return std::ranges::count(surface.facets, kind, &Facet::kind); };
  if (options.nextEvent == NextEvent::On && count(Facet::Kind::Dielectric) > 0)
    throw Error(Error::Kind::Value, {"light inside a dielectric cannot be connected with directions outside",
                                     "next-event estimation", "on", "off or automatic, or facets that are opaque"});
  connects_ = options.nextEvent == NextEvent::On || (options.nextEvent == NextEvent::Automatic &&
                                                     count(Facet::Kind::Lambertian) == std::ssize(surface.facets));
}

CpuTransport::~CpuTransport() = default;

double CpuTransport::index(int medium, std::size_t channel) const {
  return medium == Media::kNone ? 1.0 : facets_[scene_.facetOf(medium)].first[channel];
}

void CpuTransport::trace(const RayBatch& batch, const OutgoingBins& bins, Tally& tally) {
  const std::size_t bytes = (tally.reflected.sum.size() * 4 + tally.outcomes.sum.size() * 2) * sizeof(double);
  const std::size_t groupRays =
      !connects_ ? PathGroup::kRays
                 : std::clamp<std::size_t>((std::size_t{1} << 18) / (bins.count() * channels_), 1, PathGroup::kRays);
  const std::size_t groups = (batch.count + groupRays - 1) / groupRays;
  const std::size_t strands = std::clamp<std::size_t>(kStrandBytes / std::max<std::size_t>(bytes, 1), 1,
                                                      std::min(kStrands, std::max<std::size_t>(groups, 1)));
  Tally empty(tally.bins, tally.channels);
  empty.listsDepartures = tally.listsDepartures;
  std::vector<Tally> parts(strands, empty);
  parallelFor(strands, 1, [&](std::size_t from, std::size_t to) {
    PathGroup group(channels_);
    for (std::size_t strand = from; strand < to; ++strand)
      for (std::size_t g = strand; g < groups; g += strands) {
        const std::uint64_t start = g * groupRays;
        traceGroup(batch, bins, batch.first + start, std::min<std::uint64_t>(groupRays, batch.count - start), group,
                   parts[strand]);
      }
  });
  for (const Tally& part : parts) tally.add(part);
}

void CpuTransport::traceGroup(const RayBatch& batch, const OutgoingBins& bins, std::uint64_t first, std::size_t count,
                              PathGroup& group, Tally& tally) const {
  const Direction wi = bins.wi();
  group.incident = {-wi[0], -wi[1], -wi[2]};
  group.paths.resize(count);
  group.parts.assign(count, 1);
  group.turns.resize(2 * count);
  group.queries = 0;
  group.waiting.clear();
  std::fill_n(group.weights.begin(), count * channels_, 1.0);
  std::fill_n(group.absorbed.begin(), count * channels_, 0.0);
  group.bins = &bins;
  if (connects_) {
    group.light.assign(count * channels_ * bins.count(), 0.0);
    group.excess.assign(count * channels_, 0.0);
    tally.prepareExcess();
  }
  for (std::size_t k = 0; k < count; ++k) {
    LightPath& path = group.paths[k] = LightPath();
    path.random = PathRandom(mixed(batch.seed * 0x9e3779b97f4a7c15u) + (first + k) * 0xd1342543de82ef95u);
    path.owner = static_cast<std::uint32_t>(k);
    const double u = path.random.next(), v = path.random.next();
    path.ray.origin = scene_.above(u, v);
    double c = 1, s = 0;
    if (batch.turning) {
      const double turn = 2 * kPi * path.random.next();
      c = std::cos(turn);
      s = std::sin(turn);
    }
    group.turns[2 * k] = c;
    group.turns[2 * k + 1] = s;
    path.ray.direction = {c * group.incident[0] - s * group.incident[1], s * group.incident[0] + c * group.incident[1],
                          group.incident[2]};
    group.waiting.push_back(static_cast<std::uint32_t>(k));
  }
  while (!group.waiting.empty()) {
    group.atFacet.clear();
    // Paths that split append their other part.
    for (std::size_t k = 0; k < group.waiting.size(); ++k) {
      advance(group, group.waiting[k]);
      if (group.paths[group.waiting[k]].state == LightPath::State::Scattering)
        group.atFacet.push_back(group.waiting[k]);
    }
    group.waiting.clear();
    std::ranges::sort(group.atFacet, {}, [&](std::uint32_t p) { return group.paths[p].meeting.facet; });
    while (!group.atFacet.empty()) scatter(group, group.paths[group.atFacet.back()].meeting.facet);
  }
  tallyGroup(group, count, bins, tally);
}

void CpuTransport::advance(PathGroup& group, std::size_t p) const {
  for (;;) {
    LightPath& path = group.paths[p];
    double distance;
    const TileScene::End end = scene_.follow(path.ray, path.media, path.meeting, distance, group.queries);
    if (end == TileScene::End::Nowhere) {
      path.state = LightPath::State::Ended;
      path.outcome = Outcome::Lost;
      return;
    }
    absorbAlong(group, p, distance);
    if (end != TileScene::End::Facet) return leave(group, p, end == TileScene::End::Above);
    if (!interact(group, p)) return;
  }
}

void CpuTransport::leave(PathGroup& group, std::size_t p, bool above) const {
  LightPath& path = group.paths[p];
  path.state = LightPath::State::Ended;
  const int medium = path.media.current();
  const bool consistent = above ? medium == Media::kNone : scene_.transmitsBelow(path.media);
  path.outcome = !consistent ? Outcome::Lost : above ? Outcome::Reflected : Outcome::Transmitted;
  const Direction& d = path.ray.direction;
  const double c = group.turns[2 * path.owner], s = group.turns[2 * path.owner + 1];
  const Direction left{c * d[0] + s * d[1], c * d[1] - s * d[0], d[2]};  // the surface turned back
  path.specular = false;
  if (path.mirrorLike) {
    // Where a flat surface sends the light, or it goes without one.
    const double eta = above ? 1 : index(medium, path.channel < 0 ? 0 : static_cast<std::size_t>(path.channel));
    Direction flat{group.incident[0] / eta, group.incident[1] / eta, 0};
    const double z2 = 1 - flat[0] * flat[0] - flat[1] * flat[1];
    flat[2] = z2 > 0 ? std::copysign(std::sqrt(z2), above ? 1.0 : -1.0) : 0;
    const Direction off{left[0] - flat[0], left[1] - flat[1], left[2] - flat[2]};
    path.specular = dot(off, off) <= kSpecularWithin * kSpecularWithin;
  }
  path.ray.direction = {left[0], left[1], std::abs(left[2])};
}

void CpuTransport::absorbAlong(PathGroup& group, std::size_t p, double distance) const {
  const LightPath& path = group.paths[p];
  const int medium = path.media.current();
  if (medium == Media::kNone) return;
  const PreparedFacet& facet = facets_[scene_.facetOf(medium)];
  if (!facet.absorbs) return;
  double* weight = group.weight(p);
  double* absorbed = group.absorbed.data() + path.owner * channels_;
  for (std::size_t c = 0; c < channels_; ++c) {
    const double share = -std::expm1(-facet.second[c] * distance);
    absorbed[c] += weight[c] * share;
    weight[c] -= weight[c] * share;
  }
}

bool CpuTransport::survives(PathGroup& group, std::size_t p) const {
  LightPath& path = group.paths[p];
  double* weight = group.weight(p);
  const double most = *std::max_element(weight, weight + channels_);
  if (most >= kRoulette) return true;
  if (most > 0 && path.random.next() * kRoulette < most) {
    for (std::size_t c = 0; c < channels_; ++c) weight[c] *= kRoulette / most;
    return true;
  }
  std::fill_n(weight, channels_, 0.0);
  path.state = LightPath::State::Ended;
  path.outcome = Outcome::Absorbed;  // of nothing
  return false;
}

bool CpuTransport::interact(PathGroup& group, std::size_t p) const {
  LightPath& path = group.paths[p];
  const Meeting& meeting = path.meeting;
  const PreparedFacet& facet = facets_[meeting.facet];
  const double along = dot(path.ray.direction, meeting.normal);
  const bool front = along < 0;
  const bool dielectric = facet.kind == Facet::Kind::Dielectric;
  // The back of what is opaque, or of a dielectric that was never entered: rounding let it through.
  const bool inconsistent = !front && (!dielectric || !path.media.within(scene_.medium(meeting.facet)));
  if (inconsistent || ++path.meetings > bounces_) {
    path.state = LightPath::State::Ended;
    path.outcome = Outcome::Lost;
    return false;
  }
  double* weight = group.weight(p);
  double* absorbed = group.absorbed.data() + path.owner * channels_;
  const double cosine = std::min(std::abs(along), 1.0);
  switch (facet.kind) {
    case Facet::Kind::Mirror:
      path.connected = false;
      path.ray.direction = mirrored(path.ray.direction, meeting.normal, along);
      break;
    case Facet::Kind::Conductor: {
      path.connected = false;
      const int medium = path.media.current();
      for (std::size_t c = 0; c < channels_; ++c) {
        const double outside = index(medium, c);
        const double kept =
            weight[c] * conductorReflectance(cosine, facet.first[c] / outside, facet.second[c] / outside);
        absorbed[c] += weight[c] - kept;
        weight[c] = kept;
      }
      path.ray.direction = mirrored(path.ray.direction, meeting.normal, along);
      break;
    }
    case Facet::Kind::Lambertian: {
      path.mirrorLike = false;
      for (std::size_t c = 0; c < channels_; ++c) {
        absorbed[c] += weight[c] * (1 - facet.first[c]);
        weight[c] *= facet.first[c];
      }
      if (connects_) connect(group, p);
      path.connected = connects_;
      const double u = path.random.next(), v = path.random.next();
      path.ray.direction = FacetFrame(meeting.normal).world(cosineDirection(u, v));
      break;
    }
    case Facet::Kind::Dielectric:
      meetDielectric(group, p, front, cosine);
      break;
    case Facet::Kind::Scattering:
      path.mirrorLike = false;
      path.state = LightPath::State::Scattering;
      return false;
  }
  TileScene::leave(path.ray, path.meeting);
  return survives(group, p);
}

}  // namespace brdf
