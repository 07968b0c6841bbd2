#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/material/CellSolidAngles.h>
#include <brdf/material/GridCells.h>
#include <brdf/material/SampleSet.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/material/ValueOrigins.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

/// The table's axes; with nodes at the lower ends of the cells instead of their middles when the position says so.
std::unique_ptr<const GridLocator> locatorOf(const TableLayout& layout, TableBrdf::Lookup lookup,
                                             TableBrdf::Position position) {
  GridLayout grid = GridLayout::fromTable(layout);
  const bool cells = lookup == TableBrdf::Lookup::Nearest;
  if (!cells && position == TableBrdf::Position::Node)
    for (GridAxis& axis : grid.axes) {
      axis.nodes.assign(axis.edges.begin(), axis.edges.end() - 1);
      axis.edges.clear();
    }
  return std::make_unique<const GridLocator>(grid, cells);
}

void check(const TableData& data) {
  const TableLayout& layout = data.layout;
  const std::size_t cells = layout.cells();
  const auto fail = [](const char* what, std::string found, std::string allowed) {
    throw Error(Error::Kind::Value, {what, "BRDF table", std::move(found), std::move(allowed)});
  };
  if (cells == 0)
    fail("an axis has no cell",
         std::to_string(layout.thetaH) + " x " + std::to_string(layout.thetaD) + " x " + std::to_string(layout.phiD),
         "1 or more each");
  if (data.values.size() != cells * data.channels.count() || data.valid.size() != cells)
    fail("arrays and layout disagree",
         std::to_string(data.values.size()) + " values and " + std::to_string(data.valid.size()) + " flags",
         std::to_string(cells * data.channels.count()) + " and " + std::to_string(cells));
  if (const std::uint8_t most = *std::max_element(data.valid.begin(), data.valid.end());
      most > stateByte(CellState::Extrapolated))
    fail("unknown cell state", std::to_string(most), "0 to 2");
}

}  // namespace

class TableBrdf::Cells : public SampleSet {
 public:
  explicit Cells(std::shared_ptr<const TableData> data)
      : data_(std::move(data)),
        directions_(data_->layout),
        measures_(GridLayout::fromTable(data_->layout)),
        lookup(data_->values.data(), data_->valid.data(), data_->valid.size(), data_->channels.count()) {}

  std::size_t count() const override { return data_->layout.cells(); }
  const Channels& channels() const override { return data_->channels; }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    if (pairs) directions_.directions(first, length, *pairs);
    if (!values && !valid) return;
    std::vector<std::uint8_t> ownFlags;
    if (!valid) {
      ownFlags.resize(length);
      valid = ownFlags.data();
    }
    directions_.aboveHorizon(first, length, valid);
    const std::uint8_t* given = data_->valid.data() + first;
    for (std::size_t i = 0; i < length; ++i) valid[i] &= given[i] == stateByte(CellState::Measured);
    if (!values) return;
    for (std::size_t channel = 0; channel < data_->channels.count(); ++channel) {
      const double* __restrict from = data_->values.data() + channel * count() + first;
      double* __restrict to = values + channel * length;
      for (std::size_t i = 0; i < length; ++i) to[i] = valid[i] ? from[i] : 0.0;
    }
  }
  bool solidAngles(std::size_t first, std::size_t length, double* measures) const override {
    measures_.read(first, length, measures);
    return true;
  }

 private:
  std::shared_ptr<const TableData> data_;
  TableDirections directions_;
  CellSolidAngles measures_;

 public:
  const GridCells lookup;
};

TableBrdf::TableBrdf(TableData data, std::string description, Lookup lookup, Position position)
    : description_(std::move(description)), lookup_(lookup), position_(position) {
  check(data);
  const std::size_t cells = data.layout.cells(), channelCount = data.channels.count();
  parallelFor(cells, 65536, [&](std::size_t first, std::size_t last) {
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
      const double* values = data.values.data() + channel * cells;
      for (std::size_t i = first; i < last; ++i)
        data.valid[i] = std::isfinite(values[i]) ? data.valid[i] : stateByte(CellState::Invalid);
    }
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
      double* values = data.values.data() + channel * cells;
      for (std::size_t i = first; i < last; ++i) values[i] = data.valid[i] ? values[i] : 0.0;
    }
  });
  data_ = std::make_shared<const TableData>(std::move(data));
  cells_ = std::make_shared<const Cells>(data_);
  locator_ = locatorOf(data_->layout, lookup, position);
}

TableBrdf::TableBrdf(std::shared_ptr<const TableData> data, std::shared_ptr<const Cells> cells, std::string description,
                     Lookup lookup, Position position)
    : data_(std::move(data)),
      cells_(std::move(cells)),
      locator_(locatorOf(data_->layout, lookup, position)),
      description_(std::move(description)),
      lookup_(lookup),
      position_(position) {}

TableBrdf::~TableBrdf() = default;

std::shared_ptr<const TableBrdf> TableBrdf::with(Lookup lookup, Position position) const {
  return std::shared_ptr<const TableBrdf>(new TableBrdf(data_, cells_, description_, lookup, position));
}

const SampleSet* TableBrdf::samples() const { return cells_.get(); }

void TableBrdf::evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  if (lookup_ == Lookup::Nearest)
    cells_->lookup.nearest(*locator_, pairs, values, valid);
  else
    cells_->lookup.interpolate(*locator_, pairs, values, valid);
}

void TableBrdf::evaluate(const DirectionPairs<float>& pairs, float* values, std::uint8_t* valid) const {
  if (lookup_ == Lookup::Nearest)
    cells_->lookup.nearest(*locator_, pairs, values, valid);
  else
    cells_->lookup.interpolate(*locator_, pairs, values, valid);
}

std::shared_ptr<const TableBrdf> TableBrdf::tabulate(const Brdf& brdf, const TableLayout& layout) {
  TableData data{layout, brdf.channels(), {}, {}};
  const std::size_t cells = layout.cells(), channelCount = data.channels.count();
  data.values.resize(cells * channelCount);
  data.valid.resize(cells);
  const TableDirections directions(layout);
  const ValueOrigins origins(brdf);
  parallelFor(cells, 4096, [&](std::size_t first, std::size_t last) {
    const std::size_t length = last - first;
    DirectionPairBuffer<double> pairs;
    directions.directions(first, length, pairs);
    std::vector<double> values(channelCount * length);
    std::vector<std::uint8_t> above(length);
    brdf.evaluate(pairs.view(), values.data(), data.valid.data() + first);
    directions.aboveHorizon(first, length, above.data());
    for (std::size_t i = 0; i < length; ++i) data.valid[first + i] = data.valid[first + i] && above[i];
    origins.classify(pairs.view(), data.valid.data() + first);
    for (std::size_t channel = 0; channel < channelCount; ++channel)
      std::copy_n(values.data() + channel * length, length, data.values.data() + channel * cells + first);
  });
  return std::make_shared<const TableBrdf>(std::move(data), "table of (" + brdf.description() + ")");
}

}  // namespace brdf
