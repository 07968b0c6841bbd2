#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/ChannelView.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/material/TableBrdf.h>
#include <brdf/view/HoleMap.h>

#include <algorithm>

namespace brdf {
namespace {

constexpr std::size_t kBlock = 65'536;

HoleMapAxis axisOf(const GridAxis& axis) {
  HoleMapAxis result;
  result.name = axisName(axis.quantity);
  for (const double node : axis.nodes) result.nodes.push_back(degrees(node));
  for (const double edge : axis.edges) result.edges.push_back(degrees(edge));
  if (!result.edges.empty()) return result;
  const std::vector<double>& nodes = result.nodes;
  const std::size_t n = nodes.size();
  if (n == 1) {
    result.edges = {nodes[0] - 0.5, nodes[0] + 0.5};
    return result;
  }
  result.edges.push_back(nodes[0] - (nodes[1] - nodes[0]) / 2);
  for (std::size_t k = 1; k < n; ++k) result.edges.push_back((nodes[k - 1] + nodes[k]) / 2);
  result.edges.push_back(nodes[n - 1] + (nodes[n - 1] - nodes[n - 2]) / 2);
  if (!isAzimuth(axis.quantity))  // a polar angle ends at the normal and at the horizon
    for (double& edge : result.edges)
      edge = std::clamp(edge, std::min(0.0, nodes.front()), std::max(90.0, nodes.back()));
  return result;
}

std::size_t chosenAxis(const GridLayout& layout, std::string_view name, const char* field) {
  std::vector<std::string> known;
  for (std::size_t k = 0; k < layout.axes.size(); ++k) {
    if (axisName(layout.axes[k].quantity) == name) return k;
    known.emplace_back(axisName(layout.axes[k].quantity));
  }
  throw Error(Error::Kind::Value, {"no such axis in the data", field, std::string(name), joined(known)});
}

std::array<std::size_t, 2> usualAxes(const GridLayout& layout) {
  using Q = AxisQuantity;
  for (const auto& [x, y] : {std::pair{Q::ThetaH, Q::ThetaD}, {Q::ThetaO, Q::ThetaI}, {Q::SpecularTheta, Q::ThetaI}}) {
    const std::size_t a = layout.find(x), b = layout.find(y);
    if (a < layout.axes.size() && b < layout.axes.size()) return {a, b};
  }
  return {0, 1};
}

}  // namespace

HoleMap makeHoleMap(const Brdf& brdf, std::string_view xAxis, std::string_view yAxis) {
  const Brdf* source = &brdf;
  while (const auto* view = dynamic_cast<const ChannelView*>(source)) source = view->source().get();
  const auto* table = dynamic_cast<const TableBrdf*>(source);
  const auto* grid = dynamic_cast<const GridBrdf*>(source);
  if (!table && !grid)
    throw Error(Error::Kind::Value, {"a hole map is of the cells of a table or grid", "material", source->description(),
                                     "measured data on a grid of angles"});
  const GridLayout layout = table ? GridLayout::fromTable(table->data().layout) : grid->layout();
  const std::vector<std::uint8_t>& states = table ? table->data().valid : grid->data().states;
  if (layout.axes.size() < 2)
    throw Error(Error::Kind::Value, {"a hole map needs two axes", "material", layout.text(), "2 to 4 axes"});
  auto [a, b] = usualAxes(layout);
  if (!xAxis.empty()) a = chosenAxis(layout, xAxis, "x axis");
  if (!yAxis.empty()) b = chosenAxis(layout, yAxis, "y axis");
  if (a == b) {
    if (!xAxis.empty() && !yAxis.empty())
      throw Error(Error::Kind::Value, {"one axis twice", "hole map", std::string(xAxis), "two different axes"});
    (xAxis.empty() ? a : b) = a == 0 ? 1 : 0;
  }
  HoleMap map;
  map.x = axisOf(layout.axes[a]);
  map.y = axisOf(layout.axes[b]);
  map.layout = layout.text();
  map.counts.assign(map.x.nodes.size() * map.y.nodes.size(), {});
  std::array<std::size_t, 2> stride{1, 1};
  for (std::size_t k = 0; k < a; ++k) stride[0] *= layout.axes[k].size();
  for (std::size_t k = 0; k < b; ++k) stride[1] *= layout.axes[k].size();
  std::vector<std::uint8_t> above(std::min(kBlock, states.size()));
  for (std::size_t first = 0; first < states.size(); first += kBlock) {
    const std::size_t length = std::min(kBlock, states.size() - first);
    layout.aboveHorizon(first, length, above.data());
    for (std::size_t i = 0; i < length; ++i) {
      const std::size_t cell = first + i;
      const std::size_t x = cell / stride[0] % map.x.nodes.size(), y = cell / stride[1] % map.y.nodes.size();
      const auto state = static_cast<CellState>(states[cell]);
      const HoleMap::Class kind = !above[i]                          ? HoleMap::BelowHorizon
                                  : state == CellState::Measured     ? HoleMap::Measured
                                  : state == CellState::Extrapolated ? HoleMap::Filled
                                                                     : HoleMap::Invalid;
      ++map.counts[y * map.x.nodes.size() + x][kind];
      ++map.total[kind];
    }
  }
  return map;
}

}  // namespace brdf
