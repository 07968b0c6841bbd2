#include <brdf/simulate/Gonioreflectometer.h>
#include <brdf/simulate/LobeGrid.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

double noiseOf(const RaySums& sums, const OutgoingBins& bins, std::uint64_t rays, std::size_t channels) {
  double worst = 0;
  for (std::size_t c = 0; c < channels; ++c) {
    double errors = 0, values = 0;
    for (std::size_t b = 0; b < bins.count(); ++b) {
      const Estimate value = lobeValue(sums, bins, rays, c, b);
      if (value.value == 0) continue;
      const double measure = bins.projectedSolidAngles()[b];
      errors += measure * value.error * value.error;
      values += measure * value.value * value.value;
    }
    if (values > 0) worst = std::max(worst, std::sqrt(errors / values));
  }
  return worst;
}

bool holdsAny(const RaySums& sums) {
  return std::ranges::any_of(sums.sum, [](double sum) { return sum > 0; });
}

}  // namespace

LobeSimulation::LobeSimulation(std::shared_ptr<Transport> transport, const Channels& channels, const GridLayout& layout,
                               double thetaI, double phiI, std::uint64_t seed)
    : transport_(std::move(transport)),
      channels_(channels),
      layout_(layout),
      bins_(layout, thetaI, phiI),
      seed_(seed),
      tally_(bins_.count(), channels.count()),
      balanced_(tally_.reflected) {}

void LobeSimulation::add(std::uint64_t rays) {
  const bool turning = layout_.find(AxisQuantity::PhiI) == layout_.axes.size();
  transport_->trace({turning, seed_, tally_.rays, rays}, bins_, tally_);
  if (transport_->connects()) balanced_ = tally_.balanced();
}

Estimate LobeSimulation::value(std::size_t channel, std::size_t bin) const {
  return lobeValue(reflected(), bins_, tally_.rays, channel, bin);
}

Estimate LobeSimulation::transmission(std::size_t channel, std::size_t bin) const {
  return lobeValue(tally_.transmitted, bins_, tally_.rays, channel, bin);
}

double LobeSimulation::noise() const {
  if (tally_.rays == 0) return std::numeric_limits<double>::infinity();
  const RaySums& sums = holdsAny(reflected()) ? reflected() : tally_.transmitted;
  return noiseOf(sums, bins_, tally_.rays, channels_.count());
}

EnergyBalance LobeSimulation::balance() const {
  EnergyBalance balance;
  balance.thetaI = bins_.thetaI();
  balance.phiI = bins_.phiI();
  balance.rays = tally_.rays;
  balance.noise = noise();
  const auto fill = [&](std::vector<Estimate>& list, Outcome outcome) {
    for (std::size_t c = 0; c < channels_.count(); ++c) list.push_back(tally_.outcome(outcome, c));
  };
  fill(balance.reflected, Outcome::Reflected);
  fill(balance.transmitted, Outcome::Transmitted);
  fill(balance.absorbed, Outcome::Absorbed);
  fill(balance.lost, Outcome::Lost);
  fill(balance.sum, Outcome::Sum);
  fill(balance.specularReflected, Outcome::SpecularReflected);
  fill(balance.specularTransmitted, Outcome::SpecularTransmitted);
  return balance;
}

std::shared_ptr<const GridBrdf> LobeSimulation::lobe() const {
  GridLayout layout = layout_;
  for (GridAxis& axis : layout.axes) {
    const bool polar = axis.quantity == AxisQuantity::ThetaI;
    if (!polar && axis.quantity != AxisQuantity::PhiI) continue;
    axis.nodes.assign(1, polar ? bins_.thetaI() : bins_.phiI());
    axis.edges.clear();
    if (polar && !layout.specularOffsets.empty()) layout.specularOffsets.assign(1, bins_.specularOffset());
  }
  LobeGrid grid(layout, channels_);
  grid.set(reflected(), bins_, tally_.rays, 0, 0);
  return std::make_shared<GridBrdf>(std::move(grid.data), "simulated lobe");
}

}  // namespace brdf
