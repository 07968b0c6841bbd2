#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/simulate/FacetExpression.h>
#include <brdf/simulate/Gonioreflectometer.h>
#include <brdf/simulate/LobeGrid.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace brdf {
namespace {

using Q = AxisQuantity;

[[noreturn]] void fail(std::string what, std::string where, std::string found, std::string allowed) {
  throw Error(Error::Kind::Value, {std::move(what), std::move(where), std::move(found), std::move(allowed)});
}

void checkOptions(const GonioreflectometerOptions& options) {
  options.layout.check("layout");
  const std::size_t theta = options.layout.find(Q::ThetaI);
  if (theta == options.layout.axes.size()) fail("no incident directions", "layout", "no axis theta_i", "theta_i");
  for (const double angle : options.layout.axes[theta].nodes)
    if (angle < 0 || degrees(angle) > kMostThetaI + 1e-9)
      fail("incident polar angle", "theta_i", formatNumber(degrees(angle), 8) + " degrees",
           "0 to " + formatNumber(kMostThetaI) + " degrees");
  if (!(options.tolerance > 0)) fail("out of range", "tolerance", formatNumber(options.tolerance), "more than 0");
  if (options.minimumRays < 2 || options.maximumRays < options.minimumRays)
    fail("out of range", "rays", std::to_string(options.minimumRays) + " to " + std::to_string(options.maximumRays),
         "at least 2, and at most the maximum");
}

/// What the tolerance is of.
double errorOf(const LobeSimulation& lobe, const GonioreflectometerOptions& options) {
  if (options.toleranceOf == ToleranceOf::Bins) return lobe.noise();
  double worst = 0;
  for (std::size_t c = 0; c < lobe.tally().channels; ++c)
    for (const Outcome outcome : {Outcome::Reflected, Outcome::Transmitted})
      worst = std::max(worst, lobe.tally().outcome(outcome, c).error);
  return worst;
}

constexpr std::uint64_t kConnectedRays = 1 << 10;  ///< enough for their errors, which all bins share

/// Rays to add next: as many as the error asks for, but no more than make progress visible.
std::uint64_t nextRays(const LobeSimulation& lobe, double error, const GonioreflectometerOptions& options) {
  // Rays that are connected with every bin are costly, and few are enough.
  const bool connects = lobe.connects();
  const std::uint64_t least = connects ? 256 : 4096, most = connects ? 1 << 13 : 1 << 18;
  const std::uint64_t rays = lobe.tally().rays, left = options.maximumRays - rays;
  if (rays == 0) return std::min(connects ? std::min(options.minimumRays, kConnectedRays) : options.minimumRays, left);
  const double ratio = error / options.tolerance;
  const double wanted = std::clamp(static_cast<double>(rays) * (ratio * ratio * 1.05 - 1), double(least), double(most));
  return std::min(static_cast<std::uint64_t>(wanted), left);
}

std::string descriptionOf(const Microsurface& surface) {
  std::vector<std::string> facets;
  for (const Facet& facet : surface.facets) facets.push_back(facetText(facet));
  return "simulated: " + (surface.description.empty() ? "microsurface" : surface.description) + " of " + joined(facets);
}

/// Specular shares by polar angle: the mean over the azimuths of those angles that are done.
void addSpecular(Components& components, ComponentKind kind, const Channels& channels,
                 const std::vector<EnergyBalance>& balance, const GridAxis& thetas, std::size_t azimuths,
                 std::vector<Estimate> EnergyBalance::*part) {
  SpecularComponent specular{kind, channels, {}, {}};
  std::vector<std::vector<double>> shares;  // by angle, then channel
  bool any = false;
  for (std::size_t t = 0; (t + 1) * azimuths <= balance.size(); ++t) {
    std::vector<double> share(channels.count());
    for (std::size_t a = 0; a < azimuths; ++a)
      for (std::size_t c = 0; c < share.size(); ++c)
        share[c] += (balance[t * azimuths + a].*part)[c].value / static_cast<double>(azimuths);
    any = any || std::ranges::any_of(share, [](double s) { return s > 0; });
    specular.thetaI.push_back(thetas.nodes[t]);
    shares.push_back(std::move(share));
  }
  if (!any) return;
  for (std::size_t c = 0; c < channels.count(); ++c)
    for (const auto& share : shares) specular.values.push_back(share[c]);
  components.specular.push_back(std::move(specular));
}

}  // namespace

bool reachesTolerance(const LobeSimulation& lobe, const GonioreflectometerOptions& options) {
  for (std::size_t c = 0; c < lobe.tally().channels; ++c)
    if (lobe.tally().outcome(Outcome::Lost, c).value > options.tolerance) return false;
  return errorOf(lobe, options) <= options.tolerance;
}

GonioreflectometerResult simulateBrdf(const Microsurface& surface, const GonioreflectometerOptions& options) {
  checkOptions(options);
  const auto start = std::chrono::steady_clock::now();
  TransportOptions transportOptions = options.transport;
  // It does nothing for the shares that leave.
  if (options.toleranceOf == ToleranceOf::Albedo && transportOptions.nextEvent == NextEvent::Automatic)
    transportOptions.nextEvent = NextEvent::Off;
  const std::shared_ptr<Transport> transport = makeTransport(options.backend, surface, transportOptions);
  const GridLayout& layout = options.layout;
  const GridAxis& thetas = layout.axes[layout.find(Q::ThetaI)];
  const std::size_t phiAxis = layout.find(Q::PhiI);
  const std::vector<double> azimuths =
      phiAxis == layout.axes.size() ? std::vector<double>{0} : layout.axes[phiAxis].nodes;
  const bool absoluteAzimuth = layout.find(Q::PhiO) < layout.axes.size();

  GonioreflectometerResult result;
  LobeGrid reflected(layout, surface.channels), transmitted(layout, surface.channels);
  bool anyTransmitted = false, stopped = false;
  GonioreflectometerProgress progress;
  progress.directions = thetas.size() * azimuths.size();
  for (std::size_t t = 0; t < thetas.size() && !stopped; ++t) {
    std::unique_ptr<LobeSimulation> lobe;
    for (std::size_t a = 0; a < azimuths.size(); ++a) {
      // At normal incidence every azimuth of the light is the same direction.
      const bool same = lobe && thetas.nodes[t] == 0 && absoluteAzimuth;
      if (!same) {
        lobe = std::make_unique<LobeSimulation>(transport, surface.channels, layout, thetas.nodes[t], azimuths[a],
                                                (options.seed << 20) + t * azimuths.size() + a);
        double error = 0;
        do {
          lobe->add(nextRays(*lobe, error, options));
          error = errorOf(*lobe, options);
          progress.rays = lobe->tally().rays;
          progress.noise = error;
          stopped = options.progress && !options.progress(progress);
        } while (!stopped && error > options.tolerance && lobe->tally().rays < options.maximumRays);
        result.rays += lobe->tally().rays;
        result.segments += lobe->tally().segments;
        if (stopped) break;
      }
      EnergyBalance balance = lobe->balance();
      balance.phiI = azimuths[a];
      balance.converged = reachesTolerance(*lobe, options);
      result.balance.push_back(std::move(balance));
      reflected.set(lobe->reflected(), lobe->bins(), lobe->tally().rays, t, a);
      transmitted.set(lobe->tally().transmitted, lobe->bins(), lobe->tally().rays, t, a);
      anyTransmitted =
          anyTransmitted || std::ranges::any_of(lobe->tally().transmitted.sum, [](double sum) { return sum > 0; });
      ++progress.done;
    }
  }
  const std::string description = descriptionOf(surface);
  result.brdf = std::make_shared<GridBrdf>(std::move(reflected.data), description);
  if (anyTransmitted)
    result.components.scatter.push_back(
        {ComponentKind::FrontTransmission,
         std::make_shared<GridBrdf>(std::move(transmitted.data), description + ", transmission")});
  addSpecular(result.components, ComponentKind::FrontReflection, surface.channels, result.balance, thetas,
              azimuths.size(), &EnergyBalance::specularReflected);
  addSpecular(result.components, ComponentKind::FrontTransmission, surface.channels, result.balance, thetas,
              azimuths.size(), &EnergyBalance::specularTransmitted);
  result.connects = transport->connects();
  result.complete = progress.done == progress.directions;
  result.converged = result.complete && std::ranges::all_of(result.balance, &EnergyBalance::converged);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace brdf
