#include <brdf/base/Error.h>
#include <brdf/base/Parallel.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/CellSolidAngles.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/GridCells.h>
#include <brdf/material/SampleSet.h>
#include <brdf/material/ValueOrigins.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

constexpr std::size_t kGrain = 65536;

void check(GridData& data) {
  data.layout.check("BRDF grid");
  const std::size_t cells = data.layout.cells(), count = cells * data.channels.count();
  if (data.states.empty()) data.states.assign(cells, stateByte(CellState::Measured));
  const auto fail = [](const char* what, std::size_t found, std::size_t allowed) {
    throw Error(Error::Kind::Value, {what, "BRDF grid", std::to_string(found), std::to_string(allowed)});
  };
  if (data.values.size() != count) fail("values and layout disagree", data.values.size(), count);
  if (data.states.size() != cells) fail("cell states and layout disagree", data.states.size(), cells);
  if (!data.standardError.empty() && data.standardError.size() != count)
    fail("standard errors and layout disagree", data.standardError.size(), count);
  if (*std::max_element(data.states.begin(), data.states.end()) > stateByte(CellState::Extrapolated))
    fail("unknown cell state", *std::max_element(data.states.begin(), data.states.end()), 2);
}

/// Cells that are not finite in any channel become Invalid; Invalid cells become 0.
void clean(GridData& data) {
  const std::size_t cells = data.layout.cells(), channelCount = data.channels.count();
  parallelFor(cells, kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
      const double* values = data.values.data() + channel * cells;
      for (std::size_t i = first; i < last; ++i)
        if (!std::isfinite(values[i])) data.states[i] = stateByte(CellState::Invalid);
    }
    for (std::size_t channel = 0; channel < channelCount; ++channel) {
      double* values = data.values.data() + channel * cells;
      for (std::size_t i = first; i < last; ++i) values[i] = data.states[i] ? values[i] : 0.0;
    }
  });
}

}  // namespace

/// The cells as samples, and for look-ups: what grids that share them share.
class GridBrdf::Cells : public SampleSet {
 public:
  explicit Cells(std::shared_ptr<const GridData> data)
      : data_(std::move(data)),
        measures_(data_->layout),
        lookup(data_->values.data(), data_->states.data(), data_->states.size(), data_->channels.count()) {}

  std::size_t count() const override { return data_->states.size(); }
  const Channels& channels() const override { return data_->channels; }
  void read(std::size_t first, std::size_t length, DirectionPairBuffer<double>* pairs, double* values,
            std::uint8_t* valid) const override {
    if (pairs) data_->layout.directions(first, length, *pairs);
    if (!values && !valid) return;
    std::vector<std::uint8_t> above(length);
    data_->layout.aboveHorizon(first, length, above.data());
    const std::uint8_t* states = data_->states.data() + first;
    for (std::size_t i = 0; i < length; ++i) above[i] &= states[i] == stateByte(CellState::Measured);
    if (valid) std::copy(above.begin(), above.end(), valid);
    if (!values) return;
    for (std::size_t channel = 0; channel < data_->channels.count(); ++channel) {
      const double* from = data_->values.data() + channel * count() + first;
      for (std::size_t i = 0; i < length; ++i) values[channel * length + i] = above[i] ? from[i] : 0.0;
    }
  }
  bool solidAngles(std::size_t first, std::size_t length, double* measures) const override {
    measures_.read(first, length, measures);
    return true;
  }
  bool standardErrors(std::size_t first, std::size_t length, double* errors) const override {
    if (data_->standardError.empty()) return false;
    for (std::size_t channel = 0; channel < data_->channels.count(); ++channel)
      std::copy_n(data_->standardError.data() + channel * count() + first, length, errors + channel * length);
    return true;
  }

 private:
  std::shared_ptr<const GridData> data_;
  CellSolidAngles measures_;

 public:
  const GridCells lookup;
};

GridBrdf::GridBrdf(GridData data, std::string description, Lookup lookup)
    : description_(std::move(description)), lookup_(lookup) {
  check(data);
  clean(data);
  data_ = std::make_shared<const GridData>(std::move(data));
  cells_ = std::make_shared<const Cells>(data_);
  locator_ = std::make_unique<const GridLocator>(data_->layout, lookup == Lookup::Nearest);
}

GridBrdf::GridBrdf(std::shared_ptr<const GridData> data, std::shared_ptr<const Cells> cells, std::string description,
                   Lookup lookup)
    : data_(std::move(data)),
      cells_(std::move(cells)),
      locator_(std::make_unique<const GridLocator>(data_->layout, lookup == Lookup::Nearest)),
      description_(std::move(description)),
      lookup_(lookup) {}

GridBrdf::~GridBrdf() = default;

std::shared_ptr<const GridBrdf> GridBrdf::with(Lookup lookup) const {
  return std::shared_ptr<const GridBrdf>(new GridBrdf(data_, cells_, description_, lookup));
}

const SampleSet* GridBrdf::samples() const { return cells_.get(); }

void GridBrdf::evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const {
  if (lookup_ == Lookup::Nearest)
    cells_->lookup.nearest(*locator_, pairs, values, valid);
  else
    cells_->lookup.interpolate(*locator_, pairs, values, valid);
}

void GridBrdf::evaluate(const DirectionPairs<float>& pairs, float* values, std::uint8_t* valid) const {
  if (lookup_ == Lookup::Nearest)
    cells_->lookup.nearest(*locator_, pairs, values, valid);
  else
    cells_->lookup.interpolate(*locator_, pairs, values, valid);
}

std::shared_ptr<const GridBrdf> GridBrdf::tabulate(const Brdf& brdf, const GridLayout& layout) {
  layout.check("BRDF grid");
  GridData data{layout, brdf.channels(), {}, {}};
  const ValueOrigins origins(brdf);
  const std::size_t cells = layout.cells(), channelCount = data.channels.count();
  data.values.resize(cells * channelCount);
  data.states.resize(cells);
  if (origins.hasStandardErrors()) data.standardError.resize(cells * channelCount);
  parallelFor(cells, 4096, [&](std::size_t first, std::size_t last) {
    const std::size_t length = last - first;
    DirectionPairBuffer<double> pairs;
    layout.directions(first, length, pairs);
    std::vector<double> values(channelCount * length);
    std::vector<std::uint8_t> above(length);
    const auto keep = [&](std::vector<double>& planes) {
      for (std::size_t channel = 0; channel < channelCount; ++channel)
        std::copy_n(values.data() + channel * length, length, planes.data() + channel * cells + first);
    };
    std::uint8_t* states = data.states.data() + first;
    brdf.evaluate(pairs.view(), values.data(), states);
    layout.aboveHorizon(first, length, above.data());
    for (std::size_t i = 0; i < length; ++i) states[i] = states[i] && above[i];
    origins.classify(pairs.view(), states);
    keep(data.values);
    if (!origins.hasStandardErrors()) return;
    origins.standardErrors(pairs.view(), values.data());
    keep(data.standardError);
  });
  return std::make_shared<const GridBrdf>(std::move(data), "grid of (" + brdf.description() + ")");
}

void convertQuantity(GridData& data, Quantity quantity) {
  data.original = quantity;
  if (quantity == Quantity::Brdf) return;
  const std::size_t cells = data.layout.cells();
  if (data.states.empty()) data.states.assign(cells, stateByte(CellState::Measured));
  parallelFor(cells, kGrain, [&](std::size_t first, std::size_t last) {
    DirectionPairBuffer<double> pairs;
    data.layout.directions(first, last - first, pairs);
    for (std::size_t i = first; i < last; ++i) {
      const double cosine = pairs.wo[2][i - first];
      if (quantity == Quantity::BrdfCosine && !(cosine > 1e-15)) {
        data.states[i] = stateByte(CellState::Invalid);
        continue;
      }
      const double factor = toBrdfFactor(quantity, cosine);
      for (auto* array : {&data.values, &data.standardError})
        for (std::size_t at = i; at < array->size(); at += cells) (*array)[at] *= factor;
    }
  });
}

std::size_t invalidateBelowHorizon(GridData& data) {
  const std::size_t cells = data.layout.cells();
  if (data.states.empty()) data.states.assign(cells, stateByte(CellState::Measured));
  std::vector<std::uint8_t> above(cells);
  data.layout.aboveHorizon(0, cells, above.data());
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    if (above[i]) continue;
    data.states[i] = stateByte(CellState::Invalid);
    ++count;
  }
  return count;
}

}  // namespace brdf
