#pragma once
#include <brdf/simulate/FacetExpression.h>
#include <brdf/simulate/Gonioreflectometer.h>

#include <cmath>
#include <string>
#include <vector>

namespace brdf::testing {

inline Microsurface facetedSurface(decltype(Microsurface::shape) shape, const std::vector<std::string>& facets) {
  Microsurface surface{std::move(shape), {}, {}, "test surface"};
  for (const std::string& text : facets) surface.facets.push_back(parseFacet(text));
  surface.channels = facetChannels(surface.facets);
  return surface;
}

inline HeightField flatField(float height = 0, double spacing = 0.5) {
  return {2, 2, spacing, spacing, std::vector<float>(4, height)};
}

/// Grooves along y, of walls at 45 degrees, period 1 micrometre along x.
inline HeightField vGrooves() { return {2, 2, 0.5, 0.5, {0.5F, 0, 0.5F, 0}}; }

/// A smooth wavy field of slopes up to about `steepness`, with no symmetry.
inline HeightField wavyField(double steepness, std::size_t nodes = 32) {
  HeightField field{nodes, nodes, 1.0 / static_cast<double>(nodes), 1.0 / static_cast<double>(nodes), {}};
  for (std::size_t j = 0; j < nodes; ++j)
    for (std::size_t i = 0; i < nodes; ++i) {
      const double x = 2 * kPi * static_cast<double>(i) / static_cast<double>(nodes);
      const double y = 2 * kPi * static_cast<double>(j) / static_cast<double>(nodes);
      const double h = std::sin(x) + 0.5 * std::cos(2 * y + 0.3) + 0.4 * std::sin(x + 2 * y + 1);
      field.heights.push_back(static_cast<float>(steepness * h / (2 * kPi * 1.5)));
    }
  return field;
}

/// Cells of 5 degrees along theta_o and 10 along phi_o, the first about phi_o = 0.
inline GridLayout anisotropicLayout(const std::vector<double>& thetaI, const std::vector<double>& phiI) {
  using Q = AxisQuantity;
  return {Parametrisation::Spherical,
          {GridAxis::uniformCells(Q::ThetaO, 0, kPi / 2, 18),
           GridAxis::uniformCells(Q::PhiO, radians(-5.0), radians(355.0), 36).periodic(),
           GridAxis::listedDegrees(Q::ThetaI, thetaI), GridAxis::listedDegrees(Q::PhiI, phiI)}};
}

/// Cells of 10 degrees along theta_o, and 30 along phi_difference folded in the plane of incidence.
inline GridLayout isotropicLayout(const std::vector<double>& thetaI) {
  using Q = AxisQuantity;
  return {Parametrisation::Spherical,
          {GridAxis::uniformCells(Q::ThetaO, 0, kPi / 2, 9), GridAxis::uniformCells(Q::PhiDifference, 0, kPi, 6),
           GridAxis::listedDegrees(Q::ThetaI, thetaI)},
          {.mirror = true}};
}

/// One incident direction (degrees) after so many rays.
inline LobeSimulation simulated(const Microsurface& surface, const GridLayout& layout, double thetaI, double phiI,
                                std::uint64_t rays, std::uint64_t seed = 1, const TransportOptions& options = {}) {
  LobeSimulation lobe(makeTransport("cpu", surface, options), surface.channels, layout, radians(thetaI), radians(phiI),
                      seed);
  lobe.add(rays);
  return lobe;
}

}  // namespace brdf::testing
