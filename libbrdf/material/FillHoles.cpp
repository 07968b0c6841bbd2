#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/base/Text.h>
#include <brdf/material/FillHoles.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/material/ValueOrigins.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

constexpr std::array<std::string_view, 5> kNames = {"none", "reciprocity", "symmetry", "nearest", "model"};

/// The cells to fill: a copy of those of a table or grid.
struct Cells {
  GridLayout layout;
  std::size_t channels;
  std::vector<double>& values;
  std::vector<std::uint8_t>& states;
};

/// Fills from what `source` says of the pairs that `place` makes of the cells' own, where that rests on measured
/// cells of `origins` (null: wherever it is valid). A pair that falls on its own hole, as an exchanged one in a
/// reciprocal table does, would otherwise get what rounding leaves of a neighbour.
template <class Place>
void fillFrom(const Cells& cells, const Brdf& source, const ValueOrigins* origins, const Place& place) {
  const std::size_t count = cells.states.size();
  parallelFor(count, 8192, [&](std::size_t first, std::size_t last) {
    DirectionPairBuffer<double> own, wanted;
    cells.layout.directions(first, last - first, own);
    std::vector<std::uint8_t> above(last - first);
    cells.layout.aboveHorizon(first, last - first, above.data());
    std::vector<std::size_t> holes;
    for (std::size_t i = first; i < last; ++i)
      if (cells.states[i] == stateByte(CellState::Invalid) && above[i - first]) holes.push_back(i);
    if (holes.empty()) return;
    wanted.resize(holes.size());
    for (std::size_t k = 0; k < holes.size(); ++k) {
      std::array<double, 3> wi, wo;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        wi[axis] = own.wi[axis][holes[k] - first];
        wo[axis] = own.wo[axis][holes[k] - first];
      }
      place(wi, wo);
      wanted.set(k, wi, wo);
    }
    std::vector<double> found(holes.size() * cells.channels);
    std::vector<std::uint8_t> valid(holes.size());
    source.evaluate(wanted.view(), found.data(), valid.data());
    if (origins) origins->classify(wanted.view(), valid.data());
    for (std::size_t k = 0; k < holes.size(); ++k) {
      bool usable = valid[k] == stateByte(CellState::Measured);
      for (std::size_t c = 0; c < cells.channels; ++c) usable = usable && std::isfinite(found[c * holes.size() + k]);
      if (!usable) continue;
      cells.states[holes[k]] = stateByte(CellState::Extrapolated);
      for (std::size_t c = 0; c < cells.channels; ++c) cells.values[c * count + holes[k]] = found[c * holes.size() + k];
    }
  });
}

/// Breadth first from all measured cells at once, one step along one axis at a time.
void fillNearest(const Cells& cells) {
  const std::size_t count = cells.states.size();
  constexpr std::uint32_t none = ~std::uint32_t{0};
  std::vector<std::uint32_t> source(count, none), front, next;
  for (std::size_t i = 0; i < count; ++i)
    if (cells.states[i] == stateByte(CellState::Measured)) {
      source[i] = static_cast<std::uint32_t>(i);
      front.push_back(static_cast<std::uint32_t>(i));
    }
  while (!front.empty()) {
    next.clear();
    for (const std::uint32_t cell : front) {
      std::size_t stride = 1;
      for (const GridAxis& axis : cells.layout.axes) {
        const std::size_t size = axis.size(), at = cell / stride % size, start = cell - at * stride;
        const bool round = axis.period > 0;
        const auto reach = [&](std::size_t index) {
          const std::size_t other = start + index * stride;
          if (source[other] != none) return;
          source[other] = source[cell];
          next.push_back(static_cast<std::uint32_t>(other));
        };
        if (at > 0 || round) reach(at > 0 ? at - 1 : size - 1);
        if (at + 1 < size || round) reach(at + 1 < size ? at + 1 : 0);
        stride *= size;
      }
    }
    front.swap(next);
  }
  std::vector<std::uint8_t> above(count);
  cells.layout.aboveHorizon(0, count, above.data());
  for (std::size_t i = 0; i < count; ++i) {
    if (cells.states[i] != stateByte(CellState::Invalid) || !above[i] || source[i] == none) continue;
    cells.states[i] = stateByte(CellState::Extrapolated);
    for (std::size_t c = 0; c < cells.channels; ++c) cells.values[c * count + i] = cells.values[c * count + source[i]];
  }
}

/// `measured` is the BRDF of the measured cells alone.
void fill(const Cells& cells, FillMethod method, const Brdf& measured, const Brdf* model) {
  const ValueOrigins origins(measured);
  switch (method) {
    case FillMethod::Reciprocity:
      return fillFrom(cells, measured, &origins, [](auto& wi, auto& wo) { std::swap(wi, wo); });
    case FillMethod::Symmetry:
      return fillFrom(cells, measured, &origins, [](auto& wi, auto& wo) { wi[1] = -wi[1], wo[1] = -wo[1]; });
    case FillMethod::Nearest:
      return fillNearest(cells);
    case FillMethod::Model:
      if (!model || model->channels().count() != cells.channels)
        throw Error(Error::Kind::Value, {"no model that fits the data", "fill",
                                         model ? std::to_string(model->channels().count()) + " channels" : "none",
                                         std::to_string(cells.channels) + " channels"});
      return fillFrom(cells, *model, nullptr, [](auto&, auto&) {});
    case FillMethod::None:
      return;
  }
}

/// The data with filled cells made invalid.
template <class Data>
Data measuredOnly(Data data, std::vector<std::uint8_t> Data::*states) {
  for (std::uint8_t& state : data.*states)
    if (state == stateByte(CellState::Extrapolated)) state = stateByte(CellState::Invalid);
  return data;
}

FilledBrdf counted(BrdfPointer brdf, const GridLayout& layout, const std::vector<std::uint8_t>& before,
                   const std::vector<std::uint8_t>& after) {
  FilledBrdf result{std::move(brdf)};
  std::vector<std::uint8_t> above(after.size());
  layout.aboveHorizon(0, after.size(), above.data());
  for (std::size_t i = 0; i < after.size(); ++i) {
    result.filled += before[i] == stateByte(CellState::Invalid) && after[i] == stateByte(CellState::Extrapolated);
    result.remaining += after[i] == stateByte(CellState::Invalid) && above[i];
  }
  return result;
}

}  // namespace

FillMethod fillMethod(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end())
    throw Error(Error::Kind::Value, {"unknown method", "fill", std::string(name), joined(kNames)});
  return static_cast<FillMethod>(found - kNames.begin());
}

FilledBrdf fillHoles(const BrdfPointer& brdf, FillMethod method, const Brdf* model) {
  if (const auto* grid = dynamic_cast<const GridBrdf*>(brdf.get())) {
    GridData data = grid->data();
    const GridBrdf measured(measuredOnly(data, &GridData::states), grid->description());
    fill({data.layout, data.channels.count(), data.values, data.states}, method, measured, model);
    const auto result = std::make_shared<const GridBrdf>(std::move(data), grid->description(), grid->lookup());
    return counted(result, grid->layout(), grid->data().states, result->data().states);
  }
  if (const auto* table = dynamic_cast<const TableBrdf*>(brdf.get())) {
    TableData data = table->data();
    const GridLayout layout = GridLayout::fromTable(data.layout);
    const TableBrdf measured(measuredOnly(data, &TableData::valid), table->description());
    fill({layout, data.channels.count(), data.values, data.valid}, method, measured, model);
    const auto result =
        std::make_shared<const TableBrdf>(std::move(data), table->description(), table->lookup(), table->position());
    return counted(result, layout, table->data().valid, result->data().valid);
  }
  throw Error(Error::Kind::Value,
              {"only tables and grids have holes to fill", "fill", brdf->description(), "a BRDF with cells"});
}

}  // namespace brdf
