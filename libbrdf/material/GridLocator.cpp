#include <brdf/base/Text.h>
#include <brdf/formula/Parser.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/GridLocator.h>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

using Q = AxisQuantity;

/// theta_i + offset(theta_i), piecewise linear, as a formula of `theta_i`.
std::string offsetFormula(const GridLayout& layout) {
  const std::vector<double>& offsets = layout.specularOffsets;
  const std::vector<double>& nodes = layout.axes[layout.find(Q::ThetaI)].nodes;
  const auto slope = [&](std::size_t i) { return (offsets[i + 1] - offsets[i]) / (nodes[i + 1] - nodes[i]); };
  std::string text = "theta_i + " + formatNumber(offsets[0]);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double change = (i + 1 < nodes.size() ? slope(i) : 0.0) - (i > 0 ? slope(i - 1) : 0.0);
    text += " + (" + formatNumber(change) + ")*max(theta_i - (" + formatNumber(nodes[i]) + "), 0)";
  }
  return text;
}

/// Assigns every quantity of the parametrisation under its name: the forward map. (ax, ay, az) is the light, (bx, by,
/// bz) the viewer.
std::string forwardMap(const GridLayout& layout) {
  if (layout.parametrisation == Parametrisation::HalfDifference)
    // The light about the half vector, as geometry/Directions.cpp has it, times the length of the half vector's
    // projection to save its trigonometry.
    return "phi_h = select(Hx*Hx + Hy*Hy > 0, atan2(Hy, Hx), 0);"
           "hx = select(Hx*Hx + Hy*Hy > 0, Hx, 1); hy = select(Hx*Hx + Hy*Hy > 0, Hy, 0);"
           "dx = ux - vx; dy = uy - vy; dz = uz - vz;"
           "cx = (Hz*(hx*dx + hy*dy) - (Hx*Hx + Hy*Hy)*dz)/H; cy = hx*dy - hy*dx;"
           "phi_d = select(cx*cx + cy*cy > 0, atan2(cy, cx), 0);";
  std::string text = layout.symmetry.reciprocal
                         ? "s = uz < vz; ax = select(s, vx, ux); ay = select(s, vy, uy); az = select(s, vz, uz);"
                           "bx = select(s, ux, vx); by = select(s, uy, vy); bz = select(s, uz, vz);"
                         : "ax = ux; ay = uy; az = uz; bx = vx; by = vy; bz = vz;";
  text += "sa2 = ax*ax + ay*ay; sa = sqrt(sa2); theta_i = atan2(sa, az); phi_i = select(sa2 > 0, atan2(ay, ax), 0);";
  if (layout.parametrisation == Parametrisation::Spherical) {
    text +=
        "sb2 = bx*bx + by*by; theta_o = atan2(sqrt(sb2), bz); phi_o = select(sb2 > 0, atan2(by, bx), 0);"
        "phi_difference = ";
    return text + (layout.find(Q::PhiI) < layout.axes.size()
                       ? "phi_o - phi_i;"
                       : "select(sa2*sb2 > 0, atan2(ax*by - ay*bx, ax*bx + ay*by), 0);");
  }
  text += layout.specularOffsets.empty() ? "ct = az; st = sa;"
                                         : "t = " + offsetFormula(layout) + "; ct = cos(t); st = sin(t);";
  // The viewer in the frame (towards the normal, right-handed, s) of the mirror direction s.
  return text +
         "ci = select(sa > 0, ax/sa, 1); si = select(sa > 0, ay/sa, 0); p = ci*bx + si*by; q = ci*by - si*bx;"
         "x = ct*p + st*bz; r2 = x*x + q*q; specular_theta = atan2(sqrt(r2), ct*bz - st*p);"
         "specular_phi = select(r2 > 0, atan2(q, x), 0);";
}

/// The coordinate of one axis in its scale: symmetry folded, azimuth wrapped into [low, low + period).
std::string coordinateFormula(const GridLayout& layout, const GridAxis& axis, double low) {
  const std::string name(axisName(axis.quantity));
  const bool phiI = layout.find(Q::PhiI) < layout.axes.size(), phiH = layout.find(Q::PhiH) < layout.axes.size();
  std::string text = name;
  bool folded = false;
  if (isAzimuth(axis.quantity) && layout.symmetry.mirror) {
    const bool primary = axis.quantity == Q::PhiI || axis.quantity == Q::PhiH || !(phiI || phiH);
    if (primary) {
      folded = true;
      text = "abs(" + name + ")";
      if (axis.quantity == Q::PhiD && layout.symmetry.reciprocal) text = "min(" + text + ", pi - " + text + ")";
    } else {
      text = std::string("select(") + (phiI ? "phi_i" : "phi_h") + " < 0, -(" + name + "), " + name + ")";
    }
  }
  if (isAzimuth(axis.quantity) && !folded) {
    const double period = axis.period > 0 ? axis.period : 2 * kPi;
    const std::string p = formatNumber(period), from = "(" + formatNumber(low) + ")";
    text = "(" + text + ") - " + p + "*floor(((" + text + ") - " + from + ")/" + p + ")";
  }
  switch (axis.scale) {
    case AxisScale::Cosine:
      return "-cos(" + text + ")";
    case AxisScale::Sine:
      return "sin(" + text + ")";
    case AxisScale::SquareRoot:
      return "sqrt(" + text + ")";
    default:
      return text;
  }
}

bool isFoldedPrimary(const GridLayout& layout, const GridAxis& axis) {
  const bool anisotropic = layout.find(Q::PhiI) < layout.axes.size() || layout.find(Q::PhiH) < layout.axes.size();
  return layout.symmetry.mirror && isAzimuth(axis.quantity) &&
         (axis.quantity == Q::PhiI || axis.quantity == Q::PhiH || !anisotropic);
}

}  // namespace

void GridLocator::Axis::prepare() {
  const std::size_t last = points.size() - 1;
  origin = points.front();
  const double span = points.back() - points.front();
  inverseStep = static_cast<double>(last) / span;
  uniform = true;
  for (std::size_t i = 0; i <= last; ++i)
    if (std::abs(points[i] - (origin + static_cast<double>(i) / inverseStep)) > 1e-12 * std::abs(span)) uniform = false;
  if (uniform) return;
  // Buckets as wide as the narrowest interval need one step of search each; their number is bounded.
  double narrowest = span;
  for (std::size_t i = 0; i < last; ++i) narrowest = std::min(narrowest, points[i + 1] - points[i]);
  const auto many = static_cast<std::size_t>(std::min(span / narrowest, 4095.0)) + 1;
  inverseStep = static_cast<double>(many) / span;
  buckets.resize(many);
  for (std::size_t b = 0, at = 0; b < many; ++b) {
    while (at + 2 < points.size() && (points[at + 1] - origin) * inverseStep <= static_cast<double>(b)) ++at;
    buckets[b] = static_cast<std::uint32_t>(at);
  }
}

inline double GridLocator::Axis::position(double coordinate) const {
  if (!(coordinate > points.front())) return 0;  // NaN is 0
  if (coordinate >= points.back()) return static_cast<double>(points.size() - 1);
  const double steps = (coordinate - origin) * inverseStep;
  std::size_t at = buckets[static_cast<std::size_t>(std::min(steps, static_cast<double>(buckets.size() - 1)))];
  while (at > 0 && coordinate < points[at]) --at;
  while (coordinate >= points[at + 1]) ++at;
  return static_cast<double>(at) + (coordinate - points[at]) / (points[at + 1] - points[at]);
}

GridLocator::GridLocator(const GridLayout& layout, bool cells) {
  std::string& text = coordinates_;
  text = forwardMap(layout);
  std::size_t stride = 1;
  for (const GridAxis& axis : layout.axes) {
    const std::size_t count = axis.size();
    if (count > 1) {
      Axis place;
      place.count = count;
      place.stride = stride;
      const bool wraps = axis.period > 0 && !isFoldedPrimary(layout, axis);
      const auto scaled = [&](double angle) { return toScale(axis.scale, angle); };
      std::vector<double> edges(axis.edges.size());
      std::transform(axis.edges.begin(), axis.edges.end(), edges.begin(), scaled);
      std::vector<double> nodes(count);
      std::transform(axis.nodes.begin(), axis.nodes.end(), nodes.begin(), scaled);
      const bool open = wraps && nodes.back() - nodes.front() < axis.period - 1e-9;
      if (edges.empty()) {
        edges.push_back(open ? nodes.front() - (nodes.front() + axis.period - nodes.back()) / 2 : nodes.front());
        for (std::size_t i = 0; i + 1 < count; ++i) edges.push_back((nodes[i] + nodes[i + 1]) / 2);
        edges.push_back(open ? edges.front() + axis.period : nodes.back());
      }
      place.bounded = axis.outside == Outside::Invalid && !wraps;
      const double slack = 1e-9 * (edges.back() - edges.front());
      place.low = edges.front() - slack;
      place.high = edges.back() + slack;
      double low = cells ? edges.front() : nodes.front();
      if (!wraps) low = (edges.front() + edges.back()) / 2 - kPi;  // what is outside is clamped to the nearer end
      place.points = cells ? edges : nodes;
      if (!cells && open) place.points.push_back(nodes.front() + axis.period);
      place.prepare();
      text += "coordinate_" + std::to_string(axes_.size()) + " = " + coordinateFormula(layout, axis, low) + ";";
      axes_.push_back(std::move(place));
    }
    stride *= count;
  }
  if (axes_.empty()) return;
  formula::Graph graph;
  formula::ParseOptions options;
  options.where = "coordinates of a grid";
  const formula::ParseResult parsed = formula::parse(graph, text, options);
  std::vector<formula::NodeId> outputs;
  for (std::size_t a = 0; a < axes_.size(); ++a)
    outputs.push_back(parsed.variables.at("coordinate_" + std::to_string(a)));
  program_.emplace(graph, outputs);
}

template <class T>
void GridLocator::locate(const DirectionPairs<T>& pairs, Block<T>& block) const {
  std::fill_n(block.base.begin(), pairs.count, 0);
  std::fill_n(block.outside.begin(), pairs.count, 0);
  block.anyOutside = false;
  if (axes_.empty()) return;
  std::array<std::array<T, kBlock>, 4> coordinates;
  const std::array<const T*, static_cast<std::size_t>(formula::Input::Count)> inputs = {
      pairs.wi[0], pairs.wi[1], pairs.wi[2], pairs.wo[0], pairs.wo[1], pairs.wo[2]};
  std::array<T*, 4> outputs{};
  for (std::size_t a = 0; a < axes_.size(); ++a) outputs[a] = coordinates[a].data();
  program_->run(inputs.data(), {}, outputs.data(), pairs.count);
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    const Axis& axis = axes_[a];
    T* __restrict position = coordinates[a].data();
    if (axis.bounded)
      for (std::size_t i = 0; i < pairs.count; ++i) {
        block.outside[i] |= !(position[i] >= axis.low && position[i] <= axis.high);
        block.anyOutside |= block.outside[i] != 0;
      }
    if (axis.uniform) {
      const T origin = static_cast<T>(axis.origin), perStep = static_cast<T>(axis.inverseStep);
      const T end = static_cast<T>(axis.points.size() - 1);
      for (std::size_t i = 0; i < pairs.count; ++i) {
        const T steps = (position[i] - origin) * perStep;
        const T above = steps > 0 ? steps : T(0);  // NaN is 0
        position[i] = above < end ? above : end;
      }
    } else {
      for (std::size_t i = 0; i < pairs.count; ++i) position[i] = static_cast<T>(axis.position(position[i]));
    }
    std::uint32_t* __restrict base = block.base.data();
    std::int32_t* __restrict step = block.step[a].data();
    T* __restrict weight = block.weight[a].data();
    const auto stride = static_cast<std::int32_t>(axis.stride), lastCell = static_cast<std::int32_t>(axis.count - 1);
    const auto lastInterval = static_cast<std::int32_t>(axis.points.size() - 2);
    // Past the last cell, where the axis is periodic, comes the first.
    const std::int32_t home = -lastCell * stride;
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const auto whole = static_cast<std::int32_t>(position[i]);
      const std::int32_t lower = whole < lastInterval ? whole : lastInterval;
      base[i] += static_cast<std::uint32_t>(lower * stride);
      step[i] = lower == lastCell ? home : stride;
      weight[i] = position[i] - static_cast<T>(lower);
    }
  }
}

template void GridLocator::locate(const DirectionPairs<float>&, Block<float>&) const;
template void GridLocator::locate(const DirectionPairs<double>&, Block<double>&) const;

}  // namespace brdf
