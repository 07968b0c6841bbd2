#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/GridLayout.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf {
namespace {

using Q = AxisQuantity;

constexpr std::array<std::string_view, 3> kNames = {"spherical", "half_difference", "specular"};
constexpr std::size_t kMostCells = std::size_t{1} << 31;
constexpr double kSlack = 1e-6;  // radians: rounding of listed angles
constexpr double kHorizon = 1e-15;

std::vector<Q> quantitiesOf(Parametrisation parametrisation) {
  switch (parametrisation) {
    case Parametrisation::HalfDifference:
      return {Q::ThetaH, Q::PhiH, Q::ThetaD, Q::PhiD};
    case Parametrisation::Specular:
      return {Q::ThetaI, Q::PhiI, Q::SpecularTheta, Q::SpecularPhi};
    default:
      return {Q::ThetaI, Q::PhiI, Q::ThetaO, Q::PhiO, Q::PhiDifference};
  }
}

double largest(Q quantity) {
  if (isAzimuth(quantity)) return 4 * kPi;
  return quantity == Q::SpecularTheta ? kPi : kPi / 2;
}

bool ascending(const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]) || (i > 0 && !(values[i] > values[i - 1]))) return false;
  return true;
}

/// Directions of a cell from its coordinates in the order of AxisQuantity; those without an axis at their defaults.
DirectionPair pairAt(Parametrisation parametrisation, const std::array<double, 11>& at, bool difference,
                     double specularOffset) {
  const auto value = [&](Q quantity) { return at[static_cast<std::size_t>(quantity)]; };
  if (parametrisation == Parametrisation::HalfDifference)
    return fromHalfDifference({value(Q::ThetaH), value(Q::PhiH), value(Q::ThetaD), value(Q::PhiD)});
  const double phiI = value(Q::PhiI);
  const Direction wi = fromSpherical(value(Q::ThetaI), phiI);
  if (parametrisation == Parametrisation::Spherical)
    return {wi, fromSpherical(value(Q::ThetaO), difference ? phiI + value(Q::PhiDifference) : value(Q::PhiO))};
  const double thetaS = value(Q::ThetaI) + specularOffset;
  const double ct = std::cos(thetaS), st = std::sin(thetaS), ci = std::cos(phiI), si = std::sin(phiI);
  const Direction local = fromSpherical(value(Q::SpecularTheta), value(Q::SpecularPhi));
  const double u = ct * local[0] - st * local[2];
  return {wi, {ci * u - si * local[1], si * u + ci * local[1], st * local[0] + ct * local[2]}};
}

}  // namespace

std::string_view parametrisationName(Parametrisation parametrisation) {
  return kNames[static_cast<std::size_t>(parametrisation)];
}

std::size_t GridLayout::cells() const {
  std::size_t product = 1;
  for (const GridAxis& axis : axes) product *= axis.size();
  return product;
}

std::size_t GridLayout::find(Q quantity) const {
  return static_cast<std::size_t>(
      std::find_if(axes.begin(), axes.end(), [&](const GridAxis& axis) { return axis.quantity == quantity; }) -
      axes.begin());
}

std::string GridLayout::text() const {
  std::vector<std::string> parts;
  for (const GridAxis& axis : axes)
    parts.push_back(std::string(axisName(axis.quantity)) + " " + std::to_string(axis.size()));
  return joined(parts, " x ") + ", " + std::string(parametrisationName(parametrisation));
}

Symmetry GridLayout::surfaceSymmetry() const {
  bool anisotropic = false, azimuth = false;
  for (const GridAxis& axis : axes) {
    if (axis.size() == 1 || !isAzimuth(axis.quantity)) continue;
    const bool absolute = axis.quantity == Q::PhiI || axis.quantity == Q::PhiO || axis.quantity == Q::PhiH;
    (absolute ? anisotropic : azimuth) = true;
  }
  if (anisotropic) return Symmetry::Anisotropic;
  return azimuth && !symmetry.mirror ? Symmetry::Bilateral : Symmetry::Isotropic;
}

bool GridLayout::reciprocal() const {
  return symmetry.reciprocal || (parametrisation == Parametrisation::HalfDifference && find(Q::PhiD) == axes.size());
}

void GridLayout::check(const std::string& where) const {
  const auto fail = [&](std::string what, std::string found, std::string allowed) {
    throw Error(Error::Kind::Value, {std::move(what), where, std::move(found), std::move(allowed)});
  };
  if (axes.empty() || axes.size() > 4) fail("wrong number of axes", std::to_string(axes.size()), "1 to 4");
  const std::vector<Q> known = quantitiesOf(parametrisation);
  std::size_t product = 1;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const GridAxis& axis = axes[a];
    const std::string name(axisName(axis.quantity));
    if (std::find(known.begin(), known.end(), axis.quantity) == known.end())
      fail("this axis does not belong to the parametrisation", name, std::string(parametrisationName(parametrisation)));
    if (find(axis.quantity) != a) fail("an axis stands twice", name, "each once");
    if (axis.size() == 0 || axis.size() > kMostCells / product)
      fail("wrong size of the axis " + name, std::to_string(axis.size()), "1 or more, at most 2^31 cells in all");
    product *= axis.size();
    if (!ascending(axis.nodes) || !ascending(axis.edges)) fail("not ascending", "axis " + name, "ascending angles");
    const double limit = largest(axis.quantity) + kSlack, least = isAzimuth(axis.quantity) ? -limit : -kSlack;
    for (const auto* list : {&axis.nodes, &axis.edges})
      if (!list->empty() && (list->front() < least || list->back() > limit))
        fail("angle out of range on the axis " + name,
             formatNumber(degrees(list->front()), 6) + " to " + formatNumber(degrees(list->back()), 6) + " degrees",
             formatNumber(degrees(least), 4) + " to " + formatNumber(degrees(limit), 4));
    if (!axis.edges.empty() && axis.edges.size() != axis.size() + 1)
      fail("wrong number of edges on the axis " + name, std::to_string(axis.edges.size()),
           std::to_string(axis.size() + 1));
    for (std::size_t i = 0; i < axis.edges.size(); ++i)
      if ((i < axis.size() && axis.edges[i] > axis.nodes[i]) || (i > 0 && axis.edges[i] < axis.nodes[i - 1]))
        fail("a node outside its cell", "axis " + name, "each node between its two edges");
    if (axis.scale != AxisScale::Linear && isAzimuth(axis.quantity))
      fail("an azimuth has a scale", name + " " + std::string(scaleName(axis.scale)), "linear");
    if (axis.scale == AxisScale::Sine && axis.quantity == Q::SpecularTheta && axis.nodes.back() > kPi / 2 + kSlack)
      fail("the sine of angles above 90 degrees", name, "another scale");
    if (axis.period != 0) {
      const auto& list = axis.edges.empty() ? axis.nodes : axis.edges;
      if (!isAzimuth(axis.quantity) || !(axis.period > 0 && axis.period <= 2 * kPi + kSlack) ||
          list.back() - list.front() > axis.period + kSlack)
        fail("wrong period on the axis " + name, formatNumber(degrees(axis.period), 6) + " degrees",
             "none for a polar angle; at most 360 degrees, and no less than the axis spans");
    }
  }
  const auto has = [&](Q quantity) { return find(quantity) < axes.size(); };
  if (has(Q::PhiO) && has(Q::PhiDifference)) fail("two axes say the same", "phi_o and phi_difference", "one of them");
  if (has(Q::PhiO) && !has(Q::PhiI)) fail("phi_o without phi_i", "isotropic data", "the axis phi_difference");
  const bool anisotropic = has(Q::PhiI) || has(Q::PhiH);
  const bool halfTurns = symmetry.reciprocal && parametrisation == Parametrisation::HalfDifference;
  for (const GridAxis& axis : axes) {
    if (symmetry.mirror && isAzimuth(axis.quantity) &&
        (axis.quantity == Q::PhiI || axis.quantity == Q::PhiH || !anisotropic)) {
      const double end = halfTurns && axis.quantity == Q::PhiD ? kPi / 2 : kPi;
      const auto& list = axis.edges.empty() ? axis.nodes : axis.edges;
      if (list.front() < -kSlack || list.back() > end + kSlack)
        fail("a mirrored axis goes too far", std::string(axisName(axis.quantity)),
             "0 to " + formatNumber(degrees(end), 4) + " degrees");
    } else if (halfTurns && axis.quantity == Q::PhiD && std::abs(axis.period - kPi) > kSlack) {
      fail("wrong period of phi_d in a reciprocal grid", formatNumber(degrees(axis.period), 6) + " degrees",
           "180 degrees");
    }
  }
  if (!specularOffsets.empty() && (parametrisation != Parametrisation::Specular || !has(Q::ThetaI) ||
                                   specularOffsets.size() != axes[find(Q::ThetaI)].size()))
    fail("specular offsets do not match", std::to_string(specularOffsets.size()),
         "one for each node of theta_i of a specular grid, or none");
}

void GridLayout::directions(std::size_t first, std::size_t length, DirectionPairBuffer<double>& pairs) const {
  pairs.resize(length);
  std::array<double, 11> at{};
  at[static_cast<std::size_t>(Q::PhiD)] = kPi / 2;
  const bool difference = find(Q::PhiO) == axes.size();
  const std::size_t thetaI = find(Q::ThetaI);
  std::vector<std::size_t> index(axes.size());
  for (std::size_t a = 0, rest = first; a < axes.size(); ++a) {
    index[a] = rest % axes[a].size();
    rest /= axes[a].size();
    at[static_cast<std::size_t>(axes[a].quantity)] = axes[a].nodes[index[a]];
  }
  for (std::size_t i = 0; i < length; ++i) {
    const double offset = specularOffsets.empty() ? 0 : specularOffsets[index[thetaI]];
    const DirectionPair pair = pairAt(parametrisation, at, difference, offset);
    pairs.set(i, pair.wi, pair.wo);
    for (std::size_t a = 0; a < axes.size(); ++a) {  // on to the next cell
      index[a] = index[a] + 1 == axes[a].size() ? 0 : index[a] + 1;
      at[static_cast<std::size_t>(axes[a].quantity)] = axes[a].nodes[index[a]];
      if (index[a] != 0) break;
    }
  }
}

void GridLayout::aboveHorizon(std::size_t first, std::size_t length, std::uint8_t* above) const {
  DirectionPairBuffer<double> pairs;
  directions(first, length, pairs);
  for (std::size_t i = 0; i < length; ++i) above[i] = pairs.wi[2][i] > kHorizon && pairs.wo[2][i] > kHorizon;
}

GridLayout GridLayout::fromTable(const TableLayout& table) {
  const double period = table.reciprocal ? kPi : 2 * kPi;
  return {Parametrisation::HalfDifference,
          {GridAxis::uniformCells(Q::PhiD, 0, period, table.phiD).periodic(period),
           GridAxis::uniformCells(Q::ThetaD, 0, kPi / 2, table.thetaD),
           GridAxis::uniformCells(Q::ThetaH, 0, kPi / 2, table.thetaH, AxisScale::SquareRoot)},
          {.mirror = false, .reciprocal = table.reciprocal}};
}

}  // namespace brdf
