#include <brdf/geometry/Directions.h>
#include <brdf/io/Container.h>
#include <brdf/io/StoredGrid.h>
#include <brdf/io/StoredValues.h>
#include <brdf/material/GridImage.h>

#include <array>
#include <cmath>

namespace brdf {
namespace {

using stored::broken;
using stored::restoreChoice;
using stored::Sizes;

/// The names of the first n values of an enumeration.
template <std::size_t n, class Enum>
std::array<std::string_view, n> namesOf(std::string_view (*name)(Enum)) {
  std::array<std::string_view, n> names;
  for (std::size_t i = 0; i < n; ++i) names[i] = name(static_cast<Enum>(i));
  return names;
}

const auto kParametrisations = namesOf<3>(parametrisationName);
const auto kQuantities = namesOf<11>(axisName);
const auto kScales = namesOf<4>(scaleName);
constexpr std::array<std::string_view, 2> kOutside = {"clamp", "invalid"};
constexpr std::array<std::string_view, 2> kLookups = {"interpolated", "nearest"};
constexpr std::array<std::string_view, 3> kOriginals = {"brdf", "brdf_cos", "reflectance_factor"};

template <class Enum, std::size_t n>
std::string_view nameOf(const std::array<std::string_view, n>& names, Enum value) {
  return names[static_cast<std::size_t>(value)];
}

Sizes shapeOf(const GridLayout& layout) {
  const auto size = imageOf(layout).size;
  return {size[2], size[1], size[0]};
}

void storeImage(const h5::Group& group, const GridLayout& layout) {
  const GridImage image = imageOf(layout);
  std::array<std::int64_t, 6> extent{};
  for (std::size_t a = 0; a < 3; ++a) extent[2 * a + 1] = static_cast<std::int64_t>(image.size[a]) - 1;
  group.setIntegers("Version", std::array<std::int64_t, 2>{1, 0});
  group.setText("Type", "ImageData");
  group.setIntegers("WholeExtent", extent);
  group.setNumbers("Origin", image.origin);
  group.setNumbers("Spacing", image.spacing);
  group.setNumbers("Direction", std::array<double, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1});
  group.setTexts("AxisUnits", image.unit);
}

}  // namespace

void storeGrid(const h5::Group& group, const GridBrdf& grid) {
  const GridData& data = grid.data();
  const GridLayout& layout = data.layout;
  storeImage(group, layout);
  group.setText("Parametrisation", parametrisationName(layout.parametrisation));
  group.setText("Quantity", "BRDF without the cosine, 1/sr");
  group.setText("OriginalQuantity", nameOf(kOriginals, data.original));
  group.setInteger("Mirror", layout.symmetry.mirror);
  group.setInteger("Reciprocal", layout.symmetry.reciprocal);
  group.setText("Lookup", nameOf(kLookups, grid.lookup()));
  group.setInteger("StandardErrors", !data.standardError.empty());
  stored::storeChannels(group, data.channels);
  const h5::Group axes = group.createGroup("Axes");
  for (std::size_t a = 0; a < layout.axes.size(); ++a) {
    const GridAxis& axis = layout.axes[a];
    const h5::Group part = axes.createGroup(std::to_string(a));
    part.setText("Quantity", axisName(axis.quantity));
    part.setText("Scale", scaleName(axis.scale));
    part.setNumber("Period", axis.period);
    part.setText("Outside", nameOf(kOutside, axis.outside));
    part.writeArray("nodes", axis.nodes.data(), Sizes{axis.nodes.size()});
    if (!axis.edges.empty()) part.writeArray("edges", axis.edges.data(), Sizes{axis.edges.size()});
  }
  if (!layout.specularOffsets.empty())
    group.writeArray("SpecularOffsets", layout.specularOffsets.data(), Sizes{layout.specularOffsets.size()});
  const h5::Group cells = group.createGroup("PointData");
  const Sizes shape = shapeOf(layout);
  stored::storeValues(cells, data.values.data(), data.states.data(), data.channels.count(), shape);
  if (data.standardError.empty()) return;
  for (std::size_t c = 0; c < data.channels.count(); ++c)
    cells.writeArray(stored::errorName(c), data.standardError.data() + c * data.states.size(), shape);
}

GridLayout restoreGridLayout(const h5::Group& group) {
  GridLayout layout;
  layout.parametrisation = restoreChoice<Parametrisation>(group, "Parametrisation", kParametrisations);
  layout.symmetry = {group.integer("Mirror") != 0, group.integer("Reciprocal") != 0};
  const auto list = [](const h5::Group& from, const char* name) {
    const Sizes shape = from.dimensions(name);
    if (shape.size() != 1)
      broken(from, std::string("not a list: ") + name, std::to_string(shape.size()) + " axes", "1");
    std::vector<double> values(shape[0]);
    from.readArray(name, values.data(), shape);
    return values;
  };
  const h5::Group axes = group.group("Axes");
  for (std::size_t a = 0; a < 5 && axes.hasObject(std::to_string(a)); ++a) {
    const h5::Group part = axes.group(std::to_string(a));
    GridAxis axis;
    axis.quantity = restoreChoice<AxisQuantity>(part, "Quantity", kQuantities);
    axis.scale = restoreChoice<AxisScale>(part, "Scale", kScales);
    axis.outside = restoreChoice<Outside>(part, "Outside", kOutside);
    axis.period = part.number("Period");
    axis.nodes = list(part, "nodes");
    if (part.hasObject("edges")) axis.edges = list(part, "edges");
    layout.axes.push_back(std::move(axis));
  }
  if (group.hasObject("SpecularOffsets")) layout.specularOffsets = list(group, "SpecularOffsets");
  layout.check(group.where());
  return layout;
}

BrdfPointer restoreGrid(const h5::Group& group, const std::string& description) {
  GridData data;
  data.layout = restoreGridLayout(group);
  data.channels = stored::restoreChannels(group);
  data.original = restoreChoice<Quantity>(group, "OriginalQuantity", kOriginals);
  const h5::Group cells = group.group("PointData");
  const Sizes shape = shapeOf(data.layout);
  if (cells.dimensions("valid") != shape)
    broken(cells, "cells and axes disagree", std::to_string(cells.dimensions("valid")[0]) + " slices",
           data.layout.text());
  stored::restoreValues(cells, data.channels.count(), shape, data.values, data.states);
  if (group.integer("StandardErrors") != 0)
    data.standardError = stored::restoreChannelArrays(cells, stored::errorName, data.channels.count(), shape);
  return std::make_shared<const GridBrdf>(std::move(data), description,
                                          restoreChoice<GridBrdf::Lookup>(group, "Lookup", kLookups));
}

StoredTable::StoredTable(const Container& container, std::size_t index)
    : cells_(container.group(index).hasObject("PointData") ? container.group(index).group("PointData")
                                                           : container.group(index)) {
  const h5::Group& group = container.group(index);
  const std::string& kind = container.entries().at(index).kind;
  if (kind == "grid") {
    layout_ = restoreGridLayout(group);
    shape_ = shapeOf(layout_);
  } else if (kind == "table") {
    shape_ = cells_.dimensions("valid");
    if (shape_.size() != 3) broken(cells_, "table of the wrong shape", std::to_string(shape_.size()) + " axes", "3");
    layout_ = GridLayout::fromTable({shape_[2], shape_[1], shape_[0], group.integer("Reciprocal") != 0});
  } else {
    throw Error(Error::Kind::Value, {"only tables and grids are read in parts", group.where(), kind, "table, grid"});
  }
  channels_ = stored::restoreChannels(group);
}

std::vector<double> StoredTable::values(std::size_t channel, std::size_t first, std::size_t count) const {
  if (first > slices() || count > slices() - first) count = slices() + 1;  // readSlices says what is wrong
  std::vector<double> result(count <= slices() ? count * cellsPerSlice() : 0);
  cells_.readSlices(stored::valueName(channel), result.data(), shape_, first, count);
  return result;
}

std::vector<std::uint8_t> StoredTable::states(std::size_t first, std::size_t count) const {
  if (first > slices() || count > slices() - first) count = slices() + 1;
  std::vector<std::uint8_t> result(count <= slices() ? count * cellsPerSlice() : 0);
  cells_.readSlices("valid", result.data(), shape_, first, count);
  return result;
}

}  // namespace brdf
