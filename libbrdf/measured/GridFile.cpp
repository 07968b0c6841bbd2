#include <brdf/color/Colorimetry.h>
#include <brdf/measured/GridFile.h>

#include <cmath>

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

ReadResult finishGrid(GridData data, const std::filesystem::path& path, ReadReport report, Quantity quantity,
                      InvalidRule rule) {
  const std::size_t cells = data.layout.cells(), channels = data.channels.count();
  report.samples = cells;
  data.states.resize(cells, stateByte(CellState::Measured));
  std::vector<std::uint8_t> above(cells);
  data.layout.aboveHorizon(0, cells, above.data());
  for (std::size_t i = 0; i < cells; ++i) {
    bool negative = false, zero = false, notFinite = false;
    for (std::size_t channel = 0; channel < channels; ++channel) {
      const double value = data.values[channel * cells + i];
      negative |= value < 0;
      zero |= value == 0;
      notFinite |= !std::isfinite(value);
    }
    const bool missing =
        notFinite || (negative && rule != InvalidRule::NotFinite) || (zero && rule == InvalidRule::NotPositive);
    if (missing) data.states[i] = stateByte(CellState::Invalid);
    report.negative += negative;
    report.notFinite += notFinite;
    report.belowHorizon += !above[i];
    report.invalid += !above[i] || data.states[i] == stateByte(CellState::Invalid);
  }
  if (report.notFinite > 0) report.warnings.push_back(std::to_string(report.notFinite) + " cells are not finite");
  if (report.invalid == cells) report.warnings.push_back("no cell is valid");
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
