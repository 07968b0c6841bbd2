#pragma once
#include <brdf/material/GridBrdf.h>
#include <brdf/measured/Format.h>

#include <string>
#include <vector>

namespace brdf {

// What the writers of grids share: layouts, angles, losses.

/// What a format without a place for it loses of a grid: invalid and extrapolated cells, standard errors.
void reportCells(const GridData& data, WriteReport& report);

/// `brdf` as a grid: itself where its layout is `fitting`, else tabulated on `fallback`. What is lost goes to `report`:
/// resampling, scales and edges of the axes, cells above the horizon without a value (the caller writes them as 0).
std::shared_ptr<const GridBrdf> gridFor(const Brdf& brdf, bool (*fitting)(const GridLayout&),
                                        const GridLayout& fallback, WriteReport& report);

/// Whether azimuths that go all around look so in a list: no gap at the seam wider than the steps elsewhere
/// (fullTurn()).
bool seamsShow(const GridLayout& layout);
/// Whether every axis of the layout is one of these, its seams show, and it has no symmetry but the mirror of isotropic
/// data.
bool hasOnly(const GridLayout& layout, const std::vector<AxisQuantity>& quantities);

/// One axis of a grid as the writers see it; where the grid does not have it, one node at 0.
struct FileAxis {
  std::vector<double> nodes;  ///< radians
  std::size_t stride = 0;

  FileAxis(const GridLayout& layout, AxisQuantity quantity);
  std::size_t size() const { return nodes.size(); }
  /// The nodes in degrees, separated by blanks.
  std::string text() const;
};

/// The shortest number d for which radians(d - shift) is `angle`, or, where none is, the nearest.
std::string degreesText(double angle, double shift = 0);

/// Planar colours of a grid as XYZ; one channel as it is. For formats of coloursOnly.
std::vector<double> xyzOf(const GridData& data);

/// The layout on which BRDFs of other kinds are tabulated for formats of the specular parametrisation: incidences to 85
/// degrees, fine about the mirror direction. `turns`: with azimuths of the light for anisotropic ones.
GridLayout specularFallback(const Brdf& brdf, bool turns);

/// Reports as lost every component but those of the kinds `kept`; `specular` and `totals` say whether the format takes
/// those.
void reportUnkept(const Components& components, const std::vector<ComponentKind>& kept, bool specular, bool totals,
                  std::string_view format, WriteReport& report);

}  // namespace brdf
