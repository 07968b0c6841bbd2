#include <brdf/base/Parallel.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/measured/GridFile.h>

#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace brdf {
namespace {

// IEC 61966-2-1, without the clamping of Colorimetry.h: measured values exceed 1 and noise goes below 0.
double decoded(double v) { return v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92; }
double encoded(double v) { return v > 0.0031308 ? 1.055 * std::pow(v, 1 / 2.4) - 0.055 : 12.92 * v; }

void eachPixel(std::vector<double>& values, const Matrix3& matrix) {
  const std::size_t cells = values.size() / 3;
  for (std::size_t i = 0; i < cells; ++i) {
    const std::array<double, 3> from{values[i], values[cells + i], values[2 * cells + i]};
    for (std::size_t row = 0; row < 3; ++row)
      values[row * cells + i] = matrix[row][0] * from[0] + matrix[row][1] * from[1] + matrix[row][2] * from[2];
  }
}

}  // namespace

void inspectCells(const std::vector<double>& values, std::vector<std::uint8_t>& states, InvalidRule rule,
                  const std::function<void(std::size_t, std::size_t, std::uint8_t*)>& aboveHorizon,
                  ReadReport& report) {
  constexpr std::size_t grain = 65536;
  const std::size_t cells = states.size();
  if (cells == 0) return;
  const std::size_t channels = values.size() / cells;
  std::atomic<std::uint64_t> allNegative = 0, allNotFinite = 0, allBelow = 0, allInvalid = 0;
  parallelFor(cells, grain, [&](std::size_t first, std::size_t last) {
    const std::size_t count = last - first;
    std::vector<std::uint8_t> negative(count, 0), zero(count, 0), notFinite(count, 0), above(count);
    for (std::size_t channel = 0; channel < channels; ++channel) {
      const double* from = values.data() + channel * cells + first;
      for (std::size_t i = 0; i < count; ++i) {
        negative[i] |= from[i] < 0;
        zero[i] |= from[i] == 0;
        notFinite[i] |= !(std::abs(from[i]) <= std::numeric_limits<double>::max());
      }
    }
    aboveHorizon(first, count, above.data());
    const bool negativeToo = rule != InvalidRule::NotFinite, zeroToo = rule == InvalidRule::NotPositive;
    std::uint64_t negatives = 0, notFinites = 0, below = 0, invalid = 0;
    for (std::size_t i = 0; i < count; ++i) {
      std::uint8_t& state = states[first + i];
      if (notFinite[i] || (negative[i] && negativeToo) || (zero[i] && zeroToo)) state = stateByte(CellState::Invalid);
      negatives += negative[i];
      notFinites += notFinite[i];
      below += !above[i];
      invalid += !above[i] || state == stateByte(CellState::Invalid);
    }
    allNegative += negatives;
    allNotFinite += notFinites;
    allBelow += below;
    allInvalid += invalid;
  });
  report.samples += cells;
  report.negative += allNegative;
  report.notFinite += allNotFinite;
  report.belowHorizon += allBelow;
  report.invalid += allInvalid;
}

void warnOfCells(ReadReport& report) {
  if (report.notFinite > 0) report.warnings.push_back(std::to_string(report.notFinite) + " cells are not finite");
  if (report.invalid == report.samples) report.warnings.push_back("no cell is valid");
}

ReadResult finishGrid(GridData data, const std::filesystem::path& path, ReadReport report, Quantity quantity,
                      InvalidRule rule) {
  data.states.resize(data.layout.cells(), stateByte(CellState::Measured));
  inspectCells(data.values, data.states, rule, std::bind_front(&GridLayout::aboveHorizon, &data.layout), report);
  warnOfCells(report);
  convertQuantity(data, quantity);
  report.metadata["grid"] = data.layout.text();
  return {std::make_shared<GridBrdf>(std::move(data), path.filename().string()), std::move(report)};
}

void toLinearSrgb(std::vector<double>& values, ColourSpace space) {
  if (space == ColourSpace::EncodedSrgb)
    for (double& value : values) value = decoded(value);
  else if (space == ColourSpace::Xyz)
    eachPixel(values, xyzToLinearSrgb());
}

void fromLinearSrgb(std::vector<double>& values, ColourSpace space) {
  if (space == ColourSpace::EncodedSrgb)
    for (double& value : values) value = encoded(value);
  else if (space == ColourSpace::Xyz)
    eachPixel(values, linearSrgbToXyz());
}

}  // namespace brdf
