#include <brdf/base/Text.h>
#include <brdf/color/Colorimetry.h>
#include <brdf/geometry/Directions.h>
#include <brdf/measured/GridReading.h>
#include <brdf/measured/GridWriting.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

using Q = AxisQuantity;

std::vector<double> range(double first, double last, double step) {
  std::vector<double> values;
  for (int i = 0; first + i * step <= last + 1e-9; ++i) values.push_back(first + i * step);
  return values;
}

}  // namespace

void reportCells(const GridData& data, WriteReport& report) {
  std::vector<std::uint8_t> above(data.states.size());
  data.layout.aboveHorizon(0, above.size(), above.data());
  std::size_t invalid = 0, extrapolated = 0;
  for (std::size_t i = 0; i < above.size(); ++i) {
    invalid += above[i] && data.states[i] == stateByte(CellState::Invalid);
    extrapolated += data.states[i] == stateByte(CellState::Extrapolated);
  }
  if (invalid > 0)
    report.losses.push_back("validity: " + std::to_string(invalid) +
                            " cells above the horizon without a value are written as 0");
  if (extrapolated > 0)
    report.losses.push_back("validity: " + std::to_string(extrapolated) + " extrapolated cells look measured");
  if (!data.standardError.empty()) report.losses.push_back("standard errors");
}

std::shared_ptr<const GridBrdf> gridFor(const Brdf& brdf, bool (*fitting)(const GridLayout&),
                                        const GridLayout& fallback, WriteReport& report) {
  const auto* own = dynamic_cast<const GridBrdf*>(&brdf);
  std::shared_ptr<const GridBrdf> grid;
  if (own && fitting(own->layout())) {
    grid = own->with(own->lookup());
    for (const GridAxis& axis : own->layout().axes)
      if (axis.scale != AxisScale::Linear || !axis.edges.empty()) {
        report.losses.push_back("axes: the format has nodes only, interpolated linearly in the angle");
        break;
      }
  } else {
    grid = GridBrdf::tabulate(brdf, fallback);
    report.losses.push_back("resampled on a grid: " + fallback.text());
  }
  reportCells(grid->data(), report);
  return grid;
}

bool seamsShow(const GridLayout& layout) {
  if (layout.symmetry.mirror) return true;  // half a turn, no seam
  for (const GridAxis& axis : layout.axes) {
    std::vector<double> listed;
    for (const double node : axis.nodes) listed.push_back(degrees(node));
    if (axis.period > 2 * kPi - 1e-6 && listed.size() > 1 && !fullTurn(listed)) return false;
  }
  return true;
}

bool hasOnly(const GridLayout& layout, const std::vector<Q>& quantities) {
  for (const GridAxis& axis : layout.axes)
    if (std::find(quantities.begin(), quantities.end(), axis.quantity) == quantities.end()) return false;
  const bool turns = layout.find(Q::PhiI) < layout.axes.size() || layout.find(Q::PhiH) < layout.axes.size();
  return seamsShow(layout) && !layout.symmetry.reciprocal && !(layout.symmetry.mirror && turns);
}

FileAxis::FileAxis(const GridLayout& layout, Q quantity) {
  const std::size_t which = layout.find(quantity);
  if (which == layout.axes.size()) {
    nodes = {0};
    return;
  }
  nodes = layout.axes[which].nodes;
  stride = 1;
  for (std::size_t a = 0; a < which; ++a) stride *= layout.axes[a].size();
}

std::string FileAxis::text() const {
  std::string text;
  for (const double node : nodes) text += (text.empty() ? "" : " ") + degreesText(node);
  return text;
}

std::string degreesText(double angle, double shift) {
  const double exact = degrees(angle) + shift;
  for (int digits = 1; digits <= 17; ++digits) {
    const std::string text = formatNumber(exact, digits);
    if (radians(*parseNumber(text) - shift) == angle) return text;
  }
  return formatNumber(exact);
}

std::vector<double> xyzOf(const GridData& data) {
  const std::size_t cells = data.layout.cells();
  if (data.channels.kind == Channels::Kind::Monochrome) return data.values;
  const Matrix3 matrix = linearSrgbToXyz();
  std::vector<double> xyz(3 * cells, 0.0);
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < cells; ++i) xyz[row * cells + i] += matrix[row][c] * data.values[c * cells + i];
  return xyz;
}

GridLayout specularFallback(const Brdf& brdf, bool turns) {
  std::vector<double> polar{0, 0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4, 5, 6, 8, 10, 12.5, 15, 17.5};
  const std::vector<double> wide = range(20, 180, 5);
  polar.insert(polar.end(), wide.begin(), wide.end());
  GridLayout layout{Parametrisation::Specular, {GridAxis::listedDegrees(Q::SpecularTheta, polar)}};
  const bool mirror = brdf.symmetry() == Symmetry::Isotropic;
  turns = turns && brdf.symmetry() == Symmetry::Anisotropic;
  layout.symmetry.mirror = mirror;
  if (mirror)
    layout.axes.push_back(GridAxis::listedDegrees(Q::SpecularPhi, range(0, 180, 5)));
  else
    layout.axes.push_back(GridAxis::listedDegrees(Q::SpecularPhi, range(0, 360, turns ? 10 : 5)).periodic());
  layout.axes.push_back(GridAxis::listedDegrees(Q::ThetaI, range(0, 85, 5)));
  if (turns) layout.axes.push_back(GridAxis::listedDegrees(Q::PhiI, range(0, 360, 30)).periodic());
  return layout;
}

void reportUnkept(const Components& components, const std::vector<ComponentKind>& kept, bool specular, bool totals,
                  std::string_view format, WriteReport& report) {
  const auto lost = [&](ComponentKind kind, std::string_view prefix) {
    report.losses.push_back(std::string(prefix) + std::string(componentName(kind)) + ": " + std::string(format) +
                            " has no place for it");
  };
  for (const ScatterComponent& part : components.scatter)
    if (std::find(kept.begin(), kept.end(), part.kind) == kept.end()) lost(part.kind, "");
  if (!specular)
    for (const SpecularComponent& part : components.specular) lost(part.kind, "specular ");
  if (!totals)
    for (const TotalScatter& part : components.totals) lost(part.kind, "stated total of the ");
}

}  // namespace brdf
