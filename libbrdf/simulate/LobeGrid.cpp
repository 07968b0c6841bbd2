#include <brdf/simulate/LobeGrid.h>

#include <limits>

namespace brdf {

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
    const double typical = sum > 0 ? square / sum / static_cast<double>(rays) : 0;
    for (std::size_t b = 0; b < bins.count(); ++b) {
      const std::size_t cell = cells_[b];
      if (!above_[cell]) continue;
      Estimate value = lobeValue(sums, bins, rays, c, b);
      if (value.value == 0) value.error = typical / bins.projectedSolidAngles()[b];
      data.values[c * cells + cell] = value.value;
      data.standardError[c * cells + cell] = value.error;
      data.states[cell] = stateByte(CellState::Measured);
    }
  }
}

}  // namespace brdf
