#include <brdf/geometry/Directions.h>
#include <brdf/material/GridAxis.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

constexpr std::array<std::string_view, 11> kNames = {"theta_i",        "phi_i",          "theta_o",     "phi_o",
                                                     "phi_difference", "theta_h",        "phi_h",       "theta_d",
                                                     "phi_d",          "specular_theta", "specular_phi"};
constexpr std::array<std::string_view, 4> kScales = {"linear", "cosine", "sine", "square_root"};

std::vector<double> steps(double first, double last, std::size_t count, AxisScale scale) {
  std::vector<double> points(count);
  const double from = toScale(scale, first), to = toScale(scale, last);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
    points[i] = fromScale(scale, from + (to - from) * t);
  }
  // The ends as given, whatever the scale rounds.
  if (count > 0) points.front() = first;
  if (count > 1) points.back() = last;
  return points;
}

std::vector<double> inRadians(std::vector<double> angles) {
  for (double& angle : angles) angle = radians(angle);
  return angles;
}

void setCells(GridAxis& axis, std::vector<double> edges) {
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    axis.nodes.push_back(
        fromScale(axis.scale, (toScale(axis.scale, edges[i]) + toScale(axis.scale, edges[i + 1])) / 2));
  axis.edges = std::move(edges);
}

}  // namespace

std::string_view axisName(AxisQuantity quantity) { return kNames[static_cast<std::size_t>(quantity)]; }
std::string_view scaleName(AxisScale scale) { return kScales[static_cast<std::size_t>(scale)]; }

bool isAzimuth(AxisQuantity quantity) {
  switch (quantity) {
    case AxisQuantity::PhiI:
    case AxisQuantity::PhiO:
    case AxisQuantity::PhiDifference:
    case AxisQuantity::PhiH:
    case AxisQuantity::PhiD:
    case AxisQuantity::SpecularPhi:
      return true;
    default:
      return false;
  }
}

double toScale(AxisScale scale, double angle) {
  switch (scale) {
    case AxisScale::Cosine:
      return -std::cos(angle);
    case AxisScale::Sine:
      return std::sin(angle);
    case AxisScale::SquareRoot:
      return std::sqrt(angle);
    default:
      return angle;
  }
}

double fromScale(AxisScale scale, double scaled) {
  switch (scale) {
    case AxisScale::Cosine:
      return std::acos(std::clamp(-scaled, -1.0, 1.0));
    case AxisScale::Sine:
      return std::asin(std::clamp(scaled, -1.0, 1.0));
    case AxisScale::SquareRoot:
      return scaled * scaled;
    default:
      return scaled;
  }
}

GridAxis GridAxis::uniformNodes(AxisQuantity quantity, double first, double last, std::size_t count, AxisScale scale) {
  return {quantity, steps(first, last, count, scale), scale};
}

GridAxis GridAxis::uniformCells(AxisQuantity quantity, double first, double last, std::size_t count, AxisScale scale) {
  GridAxis axis{quantity, {}, scale};
  setCells(axis, steps(first, last, count + 1, scale));
  return axis;
}

GridAxis GridAxis::listedDegrees(AxisQuantity quantity, const std::vector<double>& degrees) {
  return {quantity, inRadians(degrees)};
}

GridAxis GridAxis::cellsDegrees(AxisQuantity quantity, const std::vector<double>& edges, AxisScale scale) {
  GridAxis axis{quantity, {}, scale};
  setCells(axis, inRadians(edges));
  return axis;
}

}  // namespace brdf
