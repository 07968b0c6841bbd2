#include <brdf/simulate/LobeGrid.h>

#include <limits>

namespace brdf {

namespace {

/// The bins of a ring taken together.
struct RingSum {
  RaySums sums{1};
  double measure = 0;

  void add(const RaySums& bins, std::size_t entry, double solidAngle) {
    sums.sum[0] += bins.sum[entry];
    sums.square[0] += bins.square[entry];
    measure += solidAngle;
  }
  Estimate value(std::uint64_t rays) const {
    const Estimate mean = sums.mean(0, rays);
    return {mean.value / measure, mean.error / measure};
  }
};

}  // namespace

Estimate lobeValue(const RaySums& sums, const OutgoingBins& bins, std::uint64_t rays, std::size_t channel,
                   std::size_t bin) {
  const double measure = bins.projectedSolidAngles()[bin];
  if (!(measure > 0)) return {0, std::numeric_limits<double>::infinity()};
  const Estimate mean = sums.mean(channel * bins.count() + bin, rays);
  return {mean.value / measure, mean.error / measure};
}

LobeGrid::LobeGrid(const GridLayout& layout, const Channels& channels) : data{layout, channels, {}, {}} {
  const std::size_t cells = layout.cells();
  data.values.assign(channels.count() * cells, 0.0);
  data.standardError.assign(channels.count() * cells, std::numeric_limits<double>::quiet_NaN());
  data.states.assign(cells, stateByte(CellState::Invalid));
  above_.resize(cells);
  layout.aboveHorizon(0, cells, above_.data());
}

void LobeGrid::set(const RaySums& sums, const OutgoingBins& bins, std::uint64_t rays, std::size_t thetaI,
                   std::size_t phiI) {
  const GridLayout& layout = data.layout;
  const std::size_t cells = layout.cells();
  const bool isotropic = layout.find(AxisQuantity::PhiI) == layout.axes.size();
  // Of each bin the cell: the outgoing axes keep their order, and the axes of the light stand still.
  cells_.resize(bins.count());
  for (std::size_t b = 0; b < bins.count(); ++b) {
    std::size_t rest = b, stride = 1, cell = 0;
    for (const GridAxis& axis : layout.axes) {
      std::size_t index;
      if (axis.quantity == AxisQuantity::ThetaI) {
        index = thetaI;
      } else if (axis.quantity == AxisQuantity::PhiI) {
        index = phiI;
      } else {
        index = rest % axis.size();
        rest /= axis.size();
      }
      cell += index * stride;
      stride *= axis.size();
    }
    cells_[b] = cell;
  }
  for (std::size_t c = 0; c < data.channels.count(); ++c) {
    double sum = 0, square = 0;
    for (std::size_t b = 0; b < bins.count(); ++b) {
      sum += sums.sum[c * bins.count() + b];
      square += sums.square[c * bins.count() + b];
    }
    // Normal incidence on a surface that is turned at random: azimuths differ by chance only, and look-ups of a grid
    // take one of them there.
    std::vector<RingSum> rings(isotropic && bins.thetaI() == 0 ? bins.rings() : 0);
    for (std::size_t b = 0; b < bins.count() && !rings.empty(); ++b)
      rings[bins.ring(b)].add(sums, c * bins.count() + b, bins.projectedSolidAngles()[b]);
    const double typical = sum > 0 ? square / sum / static_cast<double>(rays) : 0;
    for (std::size_t b = 0; b < bins.count(); ++b) {
      const std::size_t cell = cells_[b];
      if (!above_[cell]) continue;
      Estimate value = rings.empty() ? lobeValue(sums, bins, rays, c, b) : rings[bins.ring(b)].value(rays);
      if (value.value == 0)
        value.error = typical / (rings.empty() ? bins.projectedSolidAngles()[b] : rings[bins.ring(b)].measure);
      data.values[c * cells + cell] = value.value;
      data.standardError[c * cells + cell] = value.error;
      data.states[cell] = stateByte(CellState::Measured);
    }
  }
}

}  // namespace brdf
