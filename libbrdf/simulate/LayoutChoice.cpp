#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/Gonioreflectometer.h>
#include <brdf/simulate/LayoutChoice.h>
#include <brdf/simulate/PeakCells.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace brdf {
namespace {

using Q = AxisQuantity;
using Bins = LayoutRequest::Bins;

constexpr double kNarrowest = 1e-4;  ///< radians: no bin is cut into narrower ones
constexpr std::size_t kMostOutgoing = std::size_t{1} << 16, kMostCells = std::size_t{1} << 22;
constexpr double kAsGood = 0.7;  ///< of the best one's square, with which a layout that is cut less is taken
constexpr std::size_t kLightsCompared = 24;
constexpr std::uint64_t kFewestPilotRays = 1 << 10, kMostPilotRays = 1 << 15;
constexpr double kSameDirection = 1e-6;  ///< differences of coordinates by rounding
constexpr double kExactShare = 0.01;     ///< of the light in one direction that makes it an exact one
constexpr double kNoLight = 1e-3;        ///< of what arrives: less is not looked at

/// The light of one incident direction that left on one side.
struct PilotLight {
  double thetaI, phiI;
  std::vector<Direction> directions;
  std::vector<double> shares;  ///< sum 1
};

/// A way to lay the outgoing bins, before the axes of the light are added.
struct Family {
  Bins bins;
  std::vector<double> polar, azimuth;  ///< edges
  std::size_t uniform = 0;             ///< how many bins there were before any was cut
  bool cut = false;

  double growth() const {
    return static_cast<double>((polar.size() - 1) * (azimuth.size() - 1)) / static_cast<double>(uniform);
  }
};

/// Drops directions that many rays leave in exactly: of flat mirrors that face one way. They have no width that bins
/// could show; in bins as narrow as rounding allows, nothing that looks the table up or integrates it would find them.
void dropExact(PilotLight& light) {
  const auto key = [](const Direction& direction) {
    std::array<std::int64_t, 3> cell{};
    for (std::size_t k = 0; k < 3; ++k) cell[k] = std::llround(direction[k] / kSameDirection);
    return cell;
  };
  std::map<std::array<std::int64_t, 3>, double> shares;
  for (std::size_t k = 0; k < light.directions.size(); ++k) shares[key(light.directions[k])] += light.shares[k];
  std::size_t kept = 0;
  for (std::size_t k = 0; k < light.directions.size(); ++k)
    if (shares[key(light.directions[k])] < kExactShare) {
      light.directions[kept] = light.directions[k];
      light.shares[kept++] = light.shares[k];
    }
  light.directions.resize(kept);
  light.shares.resize(kept);
}

std::vector<PilotLight> pilotRun(Transport& transport, std::size_t channels, const LayoutRequest& request) {
  GridLayout whole{Parametrisation::Spherical, {{Q::ThetaI, request.thetaI}}};
  const bool turning = request.phiI.empty();
  if (!turning) whole.axes.push_back({Q::PhiI, request.phiI});
  const std::vector<double> azimuths = turning ? std::vector<double>{0} : request.phiI;
  const std::uint64_t directions = request.thetaI.size() * azimuths.size();
  const std::uint64_t rays = std::clamp(request.pilotRays / directions, kFewestPilotRays, kMostPilotRays);
  std::vector<PilotLight> lights;
  std::uint64_t number = 0;
  for (const double thetaI : request.thetaI)
    for (const double phiI : azimuths) {
      Tally tally(1, channels);
      tally.listsDepartures = true;
      transport.trace({turning, request.seed ^ (0x70696c6f74u + number++), 0, rays}, OutgoingBins(whole, thetaI, phiI),
                      tally);
      for (const bool transmitted : {false, true}) {
        PilotLight light{thetaI, phiI, {}, {}};
        double all = 0;
        for (const Departure& departure : tally.departures) {
          if (departure.transmitted != transmitted || !(departure.light > 0)) continue;
          light.directions.push_back(departure.direction);
          light.shares.push_back(departure.light);
          all += departure.light;
        }
        if (!(all > kNoLight * static_cast<double>(rays))) continue;
        for (double& share : light.shares) share /= all;
        dropExact(light);
        if (light.directions.empty()) continue;
        lights.push_back(std::move(light));
      }
    }
  return lights;
}

GridAxis axisOf(Q quantity, std::vector<double> edges) {
  GridAxis axis{quantity, {}, AxisScale::Linear, std::move(edges)};
  for (std::size_t k = 0; k + 1 < axis.edges.size(); ++k) axis.nodes.push_back((axis.edges[k] + axis.edges[k + 1]) / 2);
  return axis;
}

Family familyOf(Bins bins, const LayoutRequest& request) {
  const auto cells = [&](double range) {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(range / request.step - 1e-9)));
  };
  const bool spherical = bins == Bins::Spherical, isotropic = request.phiI.empty();
  const double polar = spherical ? kPi / 2 : kPi, turn = isotropic ? kPi : 2 * kPi;
  // An anisotropic table has a cell about the azimuth 0: grooves and their like send light there.
  const std::size_t sectors = cells(turn);
  const double first = isotropic ? 0 : -kPi / static_cast<double>(sectors);
  Family family{bins, GridAxis::uniformCells(Q::ThetaO, 0, polar, cells(polar)).edges,
                GridAxis::uniformCells(Q::PhiO, first, first + turn, sectors).edges};
  family.uniform = sectors * (family.polar.size() - 1);
  return family;
}

GridLayout layoutOf(const Family& family, const LayoutRequest& request) {
  const bool spherical = family.bins == Bins::Spherical, isotropic = request.phiI.empty();
  GridLayout layout{spherical ? Parametrisation::Spherical : Parametrisation::Specular,
                    {axisOf(spherical ? Q::ThetaO : Q::SpecularTheta, family.polar),
                     axisOf(!spherical  ? Q::SpecularPhi
                            : isotropic ? Q::PhiDifference
                                        : Q::PhiO,
                            family.azimuth),
                     {Q::ThetaI, request.thetaI}}};
  if (!isotropic) {
    layout.axes[1].period = 2 * kPi;
    layout.axes.push_back({Q::PhiI, request.phiI});
    layout.axes.back().period = 2 * kPi;
  }
  layout.symmetry.mirror = isotropic;
  if (family.bins == Bins::Retro)
    for (const double thetaI : request.thetaI) layout.specularOffsets.push_back(-2 * thetaI);
  return layout;
}

void cutPeaks(Family& family, const std::vector<PilotLight>& lights, const LayoutRequest& request) {
  std::vector<AxisLight> polar, azimuth;
  // One bin: coordinates are all that is asked of it.
  const GridLayout layout = layoutOf(
      {family.bins, {family.polar.front(), family.polar.back()}, {family.azimuth.front(), family.azimuth.back()}},
      request);
  for (const PilotLight& light : lights) {
    const OutgoingBins bins(layout, light.thetaI, light.phiI);
    std::array<std::vector<double>, 2> positions;
    for (const Direction& direction : light.directions) {
      const auto place = bins.coordinates(direction);
      for (std::size_t k = 0; k < 2; ++k) positions[k].push_back(place[k]);
    }
    polar.emplace_back(positions[0], light.shares);
    azimuth.emplace_back(positions[1], light.shares);
  }
  const bool spherical = family.bins == Bins::Spherical;
  // Of light that is spread evenly: per projected solid angle about the normal, per solid angle elsewhere.
  const auto ofPolar = [&](double angle) {
    const double root = std::sin(spherical ? angle : angle / 2);
    return root * root;
  };
  const auto ofAzimuth = [](double angle) { return angle; };
  const std::size_t incident = request.thetaI.size() * std::max<std::size_t>(request.phiI.size(), 1);
  const std::size_t most = std::max(family.uniform, std::min(kMostOutgoing, kMostCells / incident));
  for (;;) {
    std::vector<double> rings = cutWherePeaked(family.polar, polar, ofPolar, kNarrowest, false);
    std::vector<double> sectors = cutWherePeaked(family.azimuth, azimuth, ofAzimuth, kNarrowest, !request.phiI.empty());
    if (rings.size() == family.polar.size() && sectors.size() == family.azimuth.size()) return;
    if ((rings.size() - 1) * (sectors.size() - 1) > most) return;
    family.polar = std::move(rings);
    family.azimuth = std::move(sectors);
    family.cut = true;
  }
}

/// Of each light the integral of its density's square (a mean over each bin) times the cosine: means lose of it what
/// they flatten. Over pairs of different rays, so that more bins do not seem better by chance.
std::vector<double> squares(const Family& family, const std::vector<PilotLight>& lights, const LayoutRequest& request) {
  const GridLayout layout = layoutOf(family, request);
  std::vector<double> list;
  for (const PilotLight& light : lights) {
    const OutgoingBins bins(layout, light.thetaI, light.phiI);
    std::vector<double> sums(bins.count()), ofSquares(bins.count());
    for (std::size_t k = 0; k < light.directions.size(); ++k) {
      const std::size_t bin = bins.find(light.directions[k]);
      if (bin == bins.count()) continue;
      sums[bin] += light.shares[k];
      ofSquares[bin] += light.shares[k] * light.shares[k];
    }
    double square = 0;
    for (std::size_t b = 0; b < sums.size(); ++b)
      if (sums[b] > 0 && bins.projectedSolidAngles()[b] > 0)
        square += (sums[b] * sums[b] - ofSquares[b]) / bins.projectedSolidAngles()[b];
    list.push_back(std::max(square, 0.0));
  }
  return list;
}

/// Of those that keep nearly as much as the best (the mean over some lights) the one that had to be cut least: it
/// follows the peaks as the light moves, between the angles of the light as well.
std::size_t leastFlattening(const std::vector<Family>& families, const std::vector<PilotLight>& all,
                            const LayoutRequest& request) {
  std::vector<PilotLight> lights;
  const std::size_t count = std::min(all.size(), kLightsCompared);
  for (std::size_t k = 0; k < count; ++k) lights.push_back(all[k * all.size() / count]);
  std::vector<double> scores(families.size());
  std::vector<std::vector<double>> kept;
  for (const Family& family : families) kept.push_back(squares(family, lights, request));
  for (std::size_t l = 0; l < lights.size(); ++l) {
    double best = 0;
    for (const auto& list : kept) best = std::max(best, list[l]);
    for (std::size_t f = 0; f < families.size() && best > 0; ++f) scores[f] += kept[f][l] / best;
  }
  const double enough = kAsGood * std::ranges::max(scores);
  std::size_t chosen = families.size();
  for (std::size_t f = 0; f < families.size(); ++f)
    if (scores[f] >= enough && (chosen == families.size() || families[f].growth() < families[chosen].growth()))
      chosen = f;
  return chosen;
}

double narrowest(const Family& family) {
  double least = kPi;
  for (const auto* edges : {&family.polar, &family.azimuth})
    for (std::size_t k = 0; k + 1 < edges->size(); ++k) least = std::min(least, (*edges)[k + 1] - (*edges)[k]);
  return least;
}

void checkAngles(const std::vector<double>& angles, const char* where, double most) {
  for (std::size_t k = 0; k < angles.size(); ++k)
    if (!(std::abs(angles[k]) <= most) || (k > 0 && !(angles[k] > angles[k - 1])))
      throw Error(Error::Kind::Value,
                  {"not ascending, or out of range", where, formatNumber(degrees(angles[k]), 6) + " degrees",
                   "ascending, at most " + formatNumber(degrees(most), 6) + " degrees"});
}

void checkRequest(const LayoutRequest& request) {
  if (request.thetaI.empty())
    throw Error(Error::Kind::Value, {"no incident directions", "theta_i", "none", "one or more"});
  checkAngles(request.thetaI, "theta_i", radians(kMostThetaI) + 1e-12);
  checkAngles(request.phiI, "phi_i", 2 * kPi);
  if (request.thetaI[0] < 0 || !(request.step >= radians(0.05) && request.step <= kPi / 4))
    throw Error(Error::Kind::Value, {"out of range", "step", formatNumber(degrees(request.step), 6) + " degrees",
                                     "0.05 to 45 degrees, and theta_i from 0"});
}

}  // namespace

LayoutChoice chooseLayout(Transport& transport, std::size_t channels, const LayoutRequest& request) {
  checkRequest(request);
  if (request.bins == Bins::Spherical) return {layoutOf(familyOf(Bins::Spherical, request), request), "as asked for"};
  const std::vector<PilotLight> lights = pilotRun(transport, channels, request);
  if (request.bins != Bins::Automatic) {
    Family family = familyOf(request.bins, request);
    cutPeaks(family, lights, request);
    return {layoutOf(family, request),
            "as asked for, bins down to " + formatNumber(degrees(narrowest(family)), 2) + " degrees"};
  }
  Family spherical = familyOf(Bins::Spherical, request);
  cutPeaks(spherical, lights, request);
  if (!spherical.cut)
    return {layoutOf(spherical, request), lights.empty()
                                              ? "the pilot run found no light, or light in single directions only"
                                              : "no peak is narrower than such bins show"};
  std::vector<Family> families{familyOf(Bins::Specular, request), familyOf(Bins::Retro, request)};
  for (Family& family : families) cutPeaks(family, lights, request);
  families.push_back(std::move(spherical));
  const Family& chosen = families[leastFlattening(families, lights, request)];
  const char* const about = chosen.bins == Bins::Specular ? "about the mirror direction"
                            : chosen.bins == Bins::Retro  ? "about the direction back to the light"
                                                          : "of theta_o and azimuth";
  return {layoutOf(chosen, request), "peaks narrower than " + formatNumber(degrees(request.step), 3) +
                                         " degrees: bins " + about + ", down to " +
                                         formatNumber(degrees(narrowest(chosen)), 2) + " degrees"};
}

}  // namespace brdf
