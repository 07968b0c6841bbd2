#include <brdf/material/CellState.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/ScatteredBrdf.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/material/ValueOrigins.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

constexpr double kNegligible =
    1e-6;  ///< of the weight: what a node of the grid itself gets from its neighbours by rounding

/// 1 for the cells that belong, 0 for others.
std::vector<double> indicator(const std::vector<std::uint8_t>& states, bool (*belongs)(std::uint8_t state)) {
  std::vector<double> values(states.size());
  std::transform(states.begin(), states.end(), values.begin(), belongs);
  return values;
}

bool isMeasured(std::uint8_t state) { return state == stateByte(CellState::Measured); }
bool isValid(std::uint8_t state) { return state != stateByte(CellState::Invalid); }

}  // namespace

ValueOrigins::ValueOrigins(const Brdf& brdf) {
  const Brdf* source = &brdf;
  while (const auto* view = dynamic_cast<const ChannelView*>(source)) source = view->source().get();
  if (dynamic_cast<const ScatteredBrdf*>(source)) {
    samples_ = source;
  } else if (const auto* table = dynamic_cast<const TableBrdf*>(source)) {
    const TableData& data = table->data();
    const auto share = [&](bool (*belongs)(std::uint8_t)) {
      TableData values{data.layout, Channels::monochrome(), indicator(data.valid, belongs),
                       std::vector<std::uint8_t>(data.valid.size(), 1)};
      return std::make_shared<TableBrdf>(std::move(values), "", table->lookup(), table->position());
    };
    measured_ = share(isMeasured);
    valid_ = share(isValid);
  } else if (const auto* grid = dynamic_cast<const GridBrdf*>(source)) {
    const GridData& data = grid->data();
    const auto share = [&](bool (*belongs)(std::uint8_t)) {
      GridData values{data.layout, Channels::monochrome(), indicator(data.states, belongs), {}};
      for (GridAxis& axis : values.layout.axes) axis.outside = Outside::Invalid;
      return std::make_shared<GridBrdf>(std::move(values), "", grid->lookup());
    };
    measured_ = share(isMeasured);
    valid_ = share(isValid);
    if (data.standardError.empty() || source != &brdf) return;
    GridData errors{data.layout, data.channels, data.standardError, data.states}, unknown = errors;
    bool anyUnknown = false;
    for (std::size_t i = 0; i < errors.values.size(); ++i) {
      unknown.values[i] = std::isfinite(errors.values[i]) ? 0 : 1;
      anyUnknown = anyUnknown || unknown.values[i] > 0;
      if (unknown.values[i] > 0) errors.values[i] = 0;
    }
    errors_ = std::make_shared<GridBrdf>(std::move(errors), "", grid->lookup());
    if (anyUnknown) unknown_ = std::make_shared<GridBrdf>(std::move(unknown), "", grid->lookup());
  }
}

void ValueOrigins::classify(const DirectionPairs<double>& pairs, std::uint8_t* states) const {
  if (samples_) {
    static_cast<const ScatteredBrdf*>(samples_)->classify(pairs, states);
  } else if (measured_) {
    std::vector<double> measured(pairs.count), valid(pairs.count);
    std::vector<std::uint8_t> inside(pairs.count);
    measured_->evaluate(pairs, measured.data(), inside.data());
    valid_->evaluate(pairs, valid.data(), nullptr);
    for (std::size_t i = 0; i < pairs.count; ++i) {
      if (states[i] == 0) continue;
      CellState state = CellState::Extrapolated;
      if (inside[i] && measured[i] >= 1 - kNegligible) state = CellState::Measured;
      if (inside[i] && valid[i] <= kNegligible) state = CellState::Invalid;
      states[i] = stateByte(state);
    }
  }
}

void ValueOrigins::standardErrors(const DirectionPairs<double>& pairs, double* errors) const {
  errors_->evaluate(pairs, errors, nullptr);
  if (!unknown_) return;
  std::vector<double> share(pairs.count * unknown_->channels().count());
  unknown_->evaluate(pairs, share.data(), nullptr);
  for (std::size_t i = 0; i < share.size(); ++i)
    if (share[i] > kNegligible) errors[i] = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace brdf
