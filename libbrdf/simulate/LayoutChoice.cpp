#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/Gonioreflectometer.h>
#include <brdf/simulate/LayoutChoice.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

using Q = AxisQuantity;

constexpr double kNarrow = 2;     ///< a lobe is narrow where half of it is within so many steps of the mirror direction
constexpr double kFinest = 1e-4;  ///< radians: the narrowest ring about the mirror direction
constexpr int kPilotRings = 200;  ///< of equal ratio, from kFinest to 180 degrees
constexpr double kShareOfRing = 0.08;  ///< of the light in bins, at most in one ring

struct Pilot {
  std::vector<double> edges;   ///< of rings about the mirror direction, radians
  std::vector<double> shares;  ///< of the light in bins: mean over the directions
  double halfWidth = std::numeric_limits<double>::quiet_NaN();
};

std::vector<double> pilotEdges() {
  std::vector<double> edges{0};
  for (int k = 0; k <= kPilotRings; ++k) edges.push_back(kFinest * std::pow(kPi / kFinest, k / double(kPilotRings)));
  edges.back() = kPi;
  return edges;
}

GridAxis axisOf(Q quantity, std::vector<double> edges) {
  GridAxis axis{quantity, {}, AxisScale::Linear, std::move(edges)};
  for (std::size_t k = 0; k + 1 < axis.edges.size(); ++k) axis.nodes.push_back((axis.edges[k] + axis.edges[k + 1]) / 2);
  return axis;
}

Pilot pilotRun(Transport& transport, std::size_t channels, const LayoutRequest& request) {
  Pilot pilot{pilotEdges(), {}, std::numeric_limits<double>::quiet_NaN()};
  GridLayout layout{Parametrisation::Specular, {axisOf(Q::SpecularTheta, pilot.edges), {Q::ThetaI, request.thetaI}}};
  if (!request.phiI.empty()) layout.axes.push_back({Q::PhiI, request.phiI});
  pilot.shares.assign(pilot.edges.size() - 1, 0.0);
  std::vector<std::size_t> chosen{0, request.thetaI.size() / 2, request.thetaI.size() - 1};
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  for (const std::size_t k : chosen) {
    const OutgoingBins bins(layout, request.thetaI[k], request.phiI.empty() ? 0 : request.phiI[0]);
    Tally tally(bins.count(), channels);
    transport.trace({request.phiI.empty(), request.seed ^ (0x70696c6f74u + k), 0, request.pilotRays}, bins, tally);
    std::vector<double> rings(bins.count());
    double all = 0;
    for (std::size_t e = 0; e < tally.reflected.sum.size(); ++e) {
      rings[e % bins.count()] += tally.reflected.sum[e];
      all += tally.reflected.sum[e];
    }
    if (!(all > 0)) continue;
    double within = 0, width = kPi;
    for (std::size_t r = 0; r < rings.size(); ++r) {
      pilot.shares[r] += rings[r] / all / static_cast<double>(chosen.size());
      if (within < all / 2 && within + rings[r] >= all / 2) width = pilot.edges[r + 1];
      within += rings[r];
    }
    if (!(pilot.halfWidth <= width)) pilot.halfWidth = width;
  }
  return pilot;
}

/// Rings that hold little of the light each, grow by half at most from one to the next where the light is, and are no
/// wider than the step.
std::vector<double> ringEdges(const Pilot& pilot, double step) {
  std::vector<double> edges{0};
  double share = 0;
  for (std::size_t r = 0; r < pilot.shares.size(); ++r) {
    share += pilot.shares[r];
    const double width = pilot.edges[r + 1] - edges.back();
    const bool nextTooMuch = r + 1 < pilot.shares.size() && share + pilot.shares[r + 1] > kShareOfRing;
    const bool nextTooWide = r + 1 < pilot.shares.size() && pilot.edges[r + 2] - edges.back() > step;
    if ((nextTooMuch && width >= kFinest) || nextTooWide) {
      edges.push_back(pilot.edges[r + 1]);
      share = 0;
    }
    if (edges.back() > 2 * step && edges.back() > 0.5 * kPi / 9) break;
  }
  // From here on nothing is narrow.
  const double from = edges.back();
  const int count = std::max(1, static_cast<int>(std::ceil((kPi - from) / step)));
  for (int k = 1; k <= count; ++k) edges.push_back(from + (kPi - from) * k / count);
  return edges;
}

void checkAngles(const std::vector<double>& angles, const char* where, double most) {
  for (std::size_t k = 0; k < angles.size(); ++k)
    if (!(std::abs(angles[k]) <= most) || (k > 0 && !(angles[k] > angles[k - 1])))
      throw Error(Error::Kind::Value,
                  {"not ascending, or out of range", where, formatNumber(degrees(angles[k]), 6) + " degrees",
                   "ascending, at most " + formatNumber(degrees(most), 6) + " degrees"});
}

}  // namespace

LayoutChoice chooseLayout(Transport& transport, std::size_t channels, const LayoutRequest& request) {
  if (request.thetaI.empty())
    throw Error(Error::Kind::Value, {"no incident directions", "theta_i", "none", "one or more"});
  checkAngles(request.thetaI, "theta_i", radians(kMostThetaI) + 1e-12);
  checkAngles(request.phiI, "phi_i", 2 * kPi);
  if (request.thetaI[0] < 0 || !(request.step >= radians(0.05) && request.step <= kPi / 4))
    throw Error(Error::Kind::Value, {"out of range", "step", formatNumber(degrees(request.step), 6) + " degrees",
                                     "0.05 to 45 degrees, and theta_i from 0"});
  LayoutChoice choice;
  choice.halfWidth = std::numeric_limits<double>::quiet_NaN();
  const bool isotropic = request.phiI.empty();
  bool specular = request.bins == LayoutRequest::Bins::Specular;
  Pilot pilot;
  if (request.bins != LayoutRequest::Bins::Spherical) {
    pilot = pilotRun(transport, channels, request);
    choice.halfWidth = pilot.halfWidth;
    specular = specular || pilot.halfWidth < kNarrow * request.step;
    choice.reason = std::isnan(pilot.halfWidth)
                        ? "the pilot run reflected nothing into bins"
                        : "half of the reflected light is within " + formatNumber(degrees(pilot.halfWidth), 3) +
                              " degrees of the mirror direction where it is narrowest";
  } else {
    choice.reason = "as asked for";
  }
  const auto cells = [&](double range) {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(range / request.step - 1e-9)));
  };
  std::vector<GridAxis>& axes = choice.layout.axes;
  if (specular) {
    choice.layout.parametrisation = Parametrisation::Specular;
    axes.push_back(axisOf(Q::SpecularTheta, ringEdges(pilot, request.step)));
    axes.push_back(isotropic ? GridAxis::uniformCells(Q::SpecularPhi, 0, kPi, cells(kPi))
                             : GridAxis::uniformCells(Q::SpecularPhi, 0, 2 * kPi, cells(2 * kPi)).periodic());
  } else {
    axes.push_back(GridAxis::uniformCells(Q::ThetaO, 0, kPi / 2, cells(kPi / 2)));
    // An anisotropic table has a cell about phi_o = 0: grooves and their like send light there.
    const std::size_t turn = cells(2 * kPi);
    const double half = kPi / static_cast<double>(turn);
    axes.push_back(isotropic ? GridAxis::uniformCells(Q::PhiDifference, 0, kPi, cells(kPi))
                             : GridAxis::uniformCells(Q::PhiO, -half, 2 * kPi - half, turn).periodic());
  }
  axes.push_back({Q::ThetaI, request.thetaI});
  if (!isotropic) {
    axes.push_back({Q::PhiI, request.phiI});
    axes.back().period = 2 * kPi;
  }
  choice.layout.symmetry.mirror = isotropic;
  return choice;
}

}  // namespace brdf
