#include <brdf/material/CellCounts.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/PatchBrdf.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/material/TreeBrdf.h>

#include <algorithm>

namespace brdf {
namespace {

void countStates(const std::vector<std::uint8_t>& states, CellCounts& counts) {
  for (const std::uint8_t state : states) {
    counts.measured += state == stateByte(CellState::Measured);
    counts.extrapolated += state == stateByte(CellState::Extrapolated);
    counts.invalid += state == stateByte(CellState::Invalid);
  }
}

template <class Directions>
void countBelow(const Directions& directions, std::size_t cells, CellCounts& counts) {
  constexpr std::size_t block = 16384;
  std::vector<std::uint8_t> above(std::min(cells, block));
  for (std::size_t first = 0; first < cells; first += block) {
    const std::size_t length = std::min(block, cells - first);
    directions.aboveHorizon(first, length, above.data());
    counts.belowHorizon += static_cast<std::uint64_t>(std::count(above.data(), above.data() + length, 0));
  }
}

}  // namespace

std::optional<CellCounts> countCells(const Brdf& brdf) {
  CellCounts counts;
  if (const auto* grid = dynamic_cast<const GridBrdf*>(&brdf)) {
    countStates(grid->data().states, counts);
    countBelow(grid->layout(), grid->data().states.size(), counts);
    counts.layout = grid->layout().text();
  } else if (const auto* table = dynamic_cast<const TableBrdf*>(&brdf)) {
    const TableLayout& layout = table->data().layout;
    countStates(table->data().valid, counts);
    countBelow(TableDirections(layout), layout.cells(), counts);
    counts.layout = "phi_d " + std::to_string(layout.phiD) + " x theta_d " + std::to_string(layout.thetaD) +
                    " x theta_h " + std::to_string(layout.thetaH) + ", half_difference";
  } else if (const auto* patches = dynamic_cast<const PatchBrdf*>(&brdf)) {
    const PatchData& data = patches->data();
    counts.measured = data.incident.count() * data.outgoing.count();
    counts.layout = std::to_string(data.incident.count()) + " incident x " + std::to_string(data.outgoing.count()) +
                    " outgoing patches";
  } else if (const auto* tree = dynamic_cast<const TreeBrdf*>(&brdf)) {
    counts.measured = tree->tree().cells();
    counts.layout = "tensor tree of rank " + std::to_string(tree->tree().rank());
  } else if (const auto* scattered = dynamic_cast<const ScatteredBrdf*>(&brdf)) {
    const ScatteredSamples& data = scattered->data();
    countStates(data.valid, counts);
    for (std::size_t i = 0; i < data.pairs.size(); ++i)
      counts.belowHorizon += !(data.pairs.wi[2][i] > 0 && data.pairs.wo[2][i] > 0);
  } else {
    return std::nullopt;
  }
  return counts;
}

}  // namespace brdf
