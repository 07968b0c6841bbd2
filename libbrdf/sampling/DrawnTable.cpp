#include <brdf/base/Error.h>
#include <brdf/material/GridShader.h>
#include <brdf/material/RegionErrors.h>
#include <brdf/material/Resample.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/sampling/DrawnTable.h>
#include <brdf/sampling/SampledBrdf.h>
#include <brdf/sampling/Sequence.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// The same look-ups as a grid.
std::shared_ptr<const GridBrdf> asGrid(const TableBrdf& table) {
  const TableData& data = table.data();
  GridLayout layout = GridLayout::fromTable(data.layout);
  const bool nearest = table.lookup() == TableBrdf::Lookup::Nearest;
  if (!nearest && table.position() == TableBrdf::Position::Node)
    for (GridAxis& axis : layout.axes) {
      axis.nodes.assign(axis.edges.begin(), axis.edges.end() - 1);
      axis.edges.clear();
    }
  return std::make_shared<const GridBrdf>(GridData{layout, data.channels, data.values, data.valid}, table.description(),
                                          nearest ? GridBrdf::Lookup::Nearest : GridBrdf::Lookup::Interpolated);
}

/// Of one trial.
void judge(DrawnTable& trial, const Brdf& brdf) {
  trial.error = -1;
  for (const RegionError& region : regionErrors(*trial.grid, brdf, 2048)) {
    if (!(region.relativeMean > trial.error)) continue;
    trial.error = region.relativeMean;
    trial.region = region.region;
  }
}

/// DrawnTable::base.
std::vector<double> floors(const GridBrdf& grid) {
  constexpr std::size_t count = 4096;
  DirectionPairBuffer<double> pairs(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b] = r2(i, 0.5, 0.5);
    const auto [c, d] = r2(i, 0.1, 0.7);
    // The second pair of numbers in another order, so that the two directions are independent.
    pairs.set(i, cosineDirection(a, b), cosineDirection(std::fmod(c + a * 7, 1.0), std::fmod(d + b * 5, 1.0)));
  }
  const std::size_t channels = grid.channels().count();
  std::vector<double> values(channels * count), base;
  grid.evaluate(pairs.view(), values.data(), nullptr);
  for (std::size_t c = 0; c < channels; ++c) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(c * count), rank = first + count / 50;
    std::nth_element(first, rank, first + count);
    base.push_back(std::max(0.0, *rank));
  }
  return base;
}

DrawnTable tableOf(const BrdfPointer& brdf, const DrawnTableOptions& options) {
  if (brdf->channels().kind == Channels::Kind::Spectral)
    throw Error(Error::Kind::Value, {"a shader has no spectra", brdf->description(),
                                     std::to_string(brdf->channels().count()) + " wavelengths", "monochrome, RGB"});
  if (!(options.tolerance > 0))
    throw Error(Error::Kind::Value, {"tolerance of resampling", {}, std::to_string(options.tolerance), "more than 0"});
  if (const auto* sampled = dynamic_cast<const SampledBrdf*>(brdf.get())) return tableOf(sampled->source(), options);
  std::shared_ptr<const GridBrdf> grid;
  if (const auto* table = dynamic_cast<const TableBrdf*>(brdf.get())) grid = asGrid(*table);
  if (const auto found = std::dynamic_pointer_cast<const GridBrdf>(brdf)) grid = found;
  if (grid && gridShaderTexels(grid->layout()) <= options.maximumTexels) return {grid, false, 0, {}, {}};

  const auto attempt = [&](Parametrisation parametrisation, double step) {
    const GridLayout layout = gridFor(*brdf, parametrisation, step);
    DrawnTable trial;
    if (layout.cells() > options.maximumCells || gridShaderTexels(layout) > options.maximumTexels) return trial;
    trial = {GridBrdf::tabulate(*brdf, layout), true, 0, {}, {}};
    judge(trial, *brdf);
    return trial;
  };
  DrawnTable best;
  Parametrisation chosen = Parametrisation::HalfDifference;
  for (const double step : {6.0, 12.0, 24.0}) {  // coarser ones where even these are too many cells
    for (const Parametrisation parametrisation :
         {Parametrisation::HalfDifference, Parametrisation::Spherical, Parametrisation::Specular}) {
      DrawnTable trial = attempt(parametrisation, step);
      if (!trial.grid || (best.grid && !(trial.error < best.error))) continue;
      best = std::move(trial);
      chosen = parametrisation;
    }
    if (best.grid) break;
  }
  if (!best.grid)
    throw Error(Error::Kind::Value, {"the device holds no table of this BRDF",
                                     brdf->description(),
                                     "at most " + std::to_string(options.maximumTexels) + " texels",
                                     {}});
  for (const double step : {4.5, 3.0, 2.0, 1.5, 1.0, 0.75, 0.5}) {
    if (best.error <= options.tolerance) break;
    DrawnTable trial = attempt(chosen, step);
    if (!trial.grid) break;
    if (trial.error < best.error) best = std::move(trial);
  }
  return best;
}

/// A grid less a constant by channel.
class AboveConstant : public Brdf {
 public:
  AboveConstant(std::shared_ptr<const GridBrdf> grid, std::vector<double> base)
      : grid_(std::move(grid)), base_(std::move(base)) {}
  const Channels& channels() const override { return grid_->channels(); }
  Symmetry symmetry() const override { return grid_->symmetry(); }
  bool reciprocal() const override { return grid_->reciprocal(); }
  std::string description() const override { return grid_->description(); }
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override {
    grid_->evaluate(pairs, values, valid);
    for (std::size_t c = 0; c < base_.size(); ++c)
      for (std::size_t i = 0; i < pairs.count; ++i)
        if (pairs.wi[2][i] > 0 && pairs.wo[2][i] > 0) values[c * pairs.count + i] -= base_[c];
  }
  using Brdf::evaluate;

 private:
  std::shared_ptr<const GridBrdf> grid_;
  std::vector<double> base_;
};

}  // namespace

BrdfPointer aboveBase(const DrawnTable& table) {
  const auto above = std::make_shared<const AboveConstant>(table.grid, table.base);
  SamplerOptions options;
  options.tolerance = 0.01;  // made once for a table, and every sample has its noise
  options.cosineShare = 0.02;
  return std::make_shared<const SampledBrdf>(above, TabulatedSampler(*above, options));
}

DrawnTable drawnTable(const BrdfPointer& brdf, const DrawnTableOptions& options) {
  DrawnTable table = tableOf(brdf, options);
  table.base = floors(*table.grid);
  return table;
}

}  // namespace brdf
