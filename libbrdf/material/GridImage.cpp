#include <brdf/geometry/Directions.h>
#include <brdf/material/GridImage.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

/// First node and step of `axis` as counted by `unit`; false where the steps differ by more than a millionth.
template <class Unit>
bool equalSteps(const GridAxis& axis, const Unit& unit, double& origin, double& spacing) {
  const std::size_t last = axis.size() - 1;
  if (last == 0) return false;
  const double first = unit(axis.nodes[0]), step = (unit(axis.nodes[last]) - first) / static_cast<double>(last);
  for (std::size_t i = 0; i <= last; ++i)
    if (std::abs(unit(axis.nodes[i]) - first - step * static_cast<double>(i)) > 1e-6 * step) return false;
  origin = first;
  spacing = step;
  return true;
}

}  // namespace

GridImage imageOf(const GridLayout& layout) {
  GridImage image;
  const std::size_t axes = layout.axes.size();
  for (std::size_t a = 0; a < axes; ++a) {
    const std::size_t along = std::min<std::size_t>(a, 2);
    image.size[along] *= layout.axes[a].size();
    image.name[along] += (image.name[along].empty() ? "" : ", ") + std::string(axisName(layout.axes[a].quantity));
  }
  for (std::size_t a = 0; a < std::min<std::size_t>(axes, 3); ++a) {
    if (a == 2 && axes > 3) break;
    const GridAxis& axis = layout.axes[a];
    if (equalSteps(
            axis, [](double angle) { return degrees(angle); }, image.origin[a], image.spacing[a]))
      image.unit[a] = "deg";
    else if (axis.scale == AxisScale::SquareRoot &&
             equalSteps(
                 axis, [](double angle) { return std::sqrt(angle / (kPi / 2)); }, image.origin[a], image.spacing[a]))
      image.unit[a] = "sqrt(theta / 90 deg)";
  }
  return image;
}

}  // namespace brdf
