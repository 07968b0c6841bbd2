#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/material/CellState.h>
#include <brdf/material/ValueOrigins.h>
#include <brdf/view/Slice.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

constexpr std::size_t kRowsAtOnce = 64;  ///< bounds the memory beside the result

void require(bool condition, const char* field, double found, const char* allowed) {
  if (!condition) throw Error(Error::Kind::Value, {"out of range", field, formatNumber(found), allowed});
}

void check(const SliceOptions& options) {
  require(std::isfinite(options.phiD), "phi_d", degrees(options.phiD), "a finite number of degrees");
  require(std::isfinite(options.phiH), "phi_h", degrees(options.phiH), "a finite number of degrees");
  require(std::isfinite(options.phiI), "phi_i", degrees(options.phiI), "a finite number of degrees");
  require(std::isfinite(options.phi), "phi", degrees(options.phi), "a finite number of degrees");
  require(options.warp >= 0.1 && options.warp <= 10, "warp", options.warp, "0.1 to 10");
  for (const std::size_t cells : {options.columns, options.rows})
    require(cells >= 1 && cells <= 8192, "cells of a slice", static_cast<double>(cells), "1 to 8192");
}

std::vector<double> middles(std::size_t cells, double warp) {
  std::vector<double> angles(cells);
  for (std::size_t k = 0; k < cells; ++k)
    angles[k] = kPi / 2 * std::pow((static_cast<double>(k) + 0.5) / static_cast<double>(cells), warp);
  return angles;
}

DirectionPair directionsOf(const SliceOptions& options, double x, double y) {
  if (options.axes == SliceAxes::HalfDifference) return fromHalfDifference({x, options.phiH, y, options.phiD});
  return {fromSpherical(x, options.phiI), fromSpherical(y, options.phiI + options.phi)};
}

}  // namespace

std::size_t Slice::countOf(std::uint8_t state) const {
  return static_cast<std::size_t>(std::count(states.begin(), states.end(), state));
}

SliceAxes parseSliceAxes(std::string_view name) {
  if (name == "theta_h,theta_d") return SliceAxes::HalfDifference;
  if (name == "theta_i,theta_o") return SliceAxes::IncidentOutgoing;
  throw Error(Error::Kind::Value, {"unknown axes", "slice", std::string(name), "theta_h,theta_d or theta_i,theta_o"});
}

std::string fixedAngles(const SliceOptions& options) {
  const auto one = [](const char* name, double angle) {
    return std::string(name) + " = " + formatNumber(degrees(angle), 6) + " deg";
  };
  return options.axes == SliceAxes::HalfDifference
             ? one("phi_d", options.phiD) + ", " + one("phi_h", options.phiH)
             : one("phi_i", options.phiI) + ", " + one("phi_o - phi_i", options.phi);
}

Slice makeSlice(const Brdf& brdf, const SliceOptions& options) {
  check(options);
  Slice slice;
  slice.columns = options.columns;
  slice.rows = options.rows;
  slice.x = middles(options.columns, options.warp);
  slice.y = middles(options.rows, 1);
  const std::size_t channels = brdf.channels().count(), count = slice.count();
  slice.values.resize(channels * count);
  slice.states.resize(count);
  const ValueOrigins origins(brdf);
  DirectionPairBuffer<double> pairs;
  std::vector<double> values;
  for (std::size_t first = 0; first < options.rows; first += kRowsAtOnce) {
    const std::size_t rows = std::min(kRowsAtOnce, options.rows - first), length = rows * options.columns;
    std::uint8_t* states = slice.states.data() + first * options.columns;
    pairs.resize(length);
    values.resize(channels * length);
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t column = 0; column < options.columns; ++column) {
        const DirectionPair pair = directionsOf(options, slice.x[column], slice.y[first + row]);
        pairs.set(row * options.columns + column, pair.wi, pair.wo);
      }
    brdf.evaluateParallel(pairs.view(), values.data(), states);
    for (std::size_t i = 0; i < length; ++i)
      states[i] = stateByte(states[i] ? CellState::Measured : CellState::Invalid);
    origins.classify(pairs.view(), states);
    for (std::size_t i = 0; i < length; ++i)
      if (!(pairs.wi[2][i] > 0 && pairs.wo[2][i] > 0)) states[i] = kBelowHorizon;
    for (std::size_t c = 0; c < channels; ++c)
      std::copy_n(values.data() + c * length, length, slice.values.data() + c * count + first * options.columns);
  }
  return slice;
}

}  // namespace brdf
