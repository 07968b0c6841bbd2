#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/CellCounts.h>
#include <brdf/material/Resample.h>

#include <cmath>

namespace brdf {
namespace {

using Q = AxisQuantity;

constexpr std::size_t kMostValues = std::size_t{1} << 28;  // 2 GiB

/// Cells over a whole turn, or half of it where the symmetry completes it.
GridAxis azimuth(Q quantity, bool half, std::size_t turn, double period = 2 * kPi) {
  if (half) return GridAxis::uniformCells(quantity, 0, period / 2, turn / 2);
  return GridAxis::uniformCells(quantity, 0, period, turn).periodic(period);
}

}  // namespace

GridLayout gridFor(const Brdf& brdf, Parametrisation parametrisation, double step) {
  if (!(step >= 0.1 && step <= 45))
    throw Error(Error::Kind::Value, {"wrong step", "grid", formatNumber(step, 6) + " degrees", "0.1 to 45 degrees"});
  const bool isotropic = brdf.symmetry() == Symmetry::Isotropic, anisotropic = brdf.symmetry() == Symmetry::Anisotropic;
  const auto right = static_cast<std::size_t>(std::lround(90 / step));
  const std::size_t turn = 4 * right;
  const auto theta = [&](Q quantity) { return GridAxis::uniformCells(quantity, 0, kPi / 2, right); };
  GridLayout layout;
  layout.parametrisation = parametrisation;
  layout.symmetry.mirror = isotropic;
  switch (parametrisation) {
    case Parametrisation::Spherical:
      layout.axes = {azimuth(Q::PhiDifference, isotropic, turn), theta(Q::ThetaO), theta(Q::ThetaI)};
      if (anisotropic) layout.axes.push_back(azimuth(Q::PhiI, false, turn));
      break;
    case Parametrisation::Specular:
      layout.axes = {azimuth(Q::SpecularPhi, isotropic, turn),
                     GridAxis::uniformCells(Q::SpecularTheta, 0, kPi, 2 * right, AxisScale::SquareRoot),
                     theta(Q::ThetaI)};
      if (anisotropic) layout.axes.push_back(azimuth(Q::PhiI, false, turn));
      break;
    case Parametrisation::HalfDifference: {
      layout.symmetry.reciprocal = brdf.reciprocal();
      const double period = brdf.reciprocal() ? kPi : 2 * kPi;
      layout.axes = {azimuth(Q::PhiD, isotropic, brdf.reciprocal() ? turn / 2 : turn, period), theta(Q::ThetaD),
                     GridAxis::uniformCells(Q::ThetaH, 0, kPi / 2, right, AxisScale::SquareRoot)};
      if (anisotropic) layout.axes.push_back(azimuth(Q::PhiH, false, turn));
      break;
    }
  }
  return layout;
}

GridLayout parseGridLayout(std::string_view text, const Brdf& brdf) {
  if (text == "merl")
    return GridLayout::fromTable({.phiD = brdf.reciprocal() ? 180u : 360u, .reciprocal = brdf.reciprocal()});
  const std::size_t colon = text.find(':');
  if (colon != std::string_view::npos)
    for (const auto parametrisation :
         {Parametrisation::Spherical, Parametrisation::HalfDifference, Parametrisation::Specular})
      if (text.substr(0, colon) == parametrisationName(parametrisation))
        if (const auto step = parseNumber(text.substr(colon + 1))) return gridFor(brdf, parametrisation, *step);
  throw Error(Error::Kind::Value, {"unknown layout", "grid", std::string(text),
                                   "merl, or spherical, half_difference or specular with a step in degrees as in "
                                   "spherical:5"});
}

Resampled resample(const Brdf& brdf, const GridLayout& layout) {
  layout.check("resampling");
  if (layout.cells() > kMostValues / brdf.channels().count())
    throw Error(Error::Kind::Value, {"too many values", "resampling",
                                     std::to_string(brdf.channels().count()) + " channels of " + layout.text(),
                                     "at most " + std::to_string(kMostValues)});
  Resampled result{GridBrdf::tabulate(brdf, layout), {}};
  const GridBrdf& grid = *result.brdf;
  result.losses.push_back("resampled at " + layout.text());
  if (brdf.symmetry() == Symmetry::Anisotropic && grid.symmetry() != Symmetry::Anisotropic)
    result.losses.push_back("anisotropy: values are those of one azimuth of the surface");
  if (brdf.symmetry() != Symmetry::Isotropic && layout.symmetry.mirror)
    result.losses.push_back("values of mirrored pairs: the grid takes them for the same");
  if (!brdf.reciprocal() && grid.reciprocal())
    result.losses.push_back("values of exchanged pairs: the grid takes them for the same");
  if (const auto cells = countCells(grid); cells->extrapolated > 0)
    result.losses.push_back(std::to_string(cells->extrapolated) +
                            " cells rest on less than measured ones and are marked extrapolated");
  return result;
}

}  // namespace brdf
