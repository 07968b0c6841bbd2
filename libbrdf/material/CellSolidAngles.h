#pragma once
// The measures of the cells of a grid or table. Internal to libbrdf/material.
#include <brdf/material/GridLayout.h>

#include <vector>

namespace brdf {

/// d omega_i d omega_o over each cell of a grid, up to a common factor: a product of one factor an axis. Polar angles
/// give differences of cosines, azimuths of themselves; in half/difference coordinates
/// d omega_i d omega_o = 4 cos theta_d d omega_h d omega_d (Walter et al. 2007, doi:10.2312/EGWR/EGSR07/195-206,
/// eq. 14, with the light fixed), so that theta_d gives differences of 2 sin^2 theta_d. A node's cell reaches halfway,
/// in the scale of the axis, to its neighbours; the axis ends at its end nodes. What lies below the horizon of a cell
/// whose centre is above counts.
class CellSolidAngles {
 public:
  explicit CellSolidAngles(const GridLayout& layout);
  void read(std::size_t first, std::size_t length, double* measures) const;

 private:
  std::vector<std::vector<double>> factors_;  ///< one list an axis, the first fastest
};

}  // namespace brdf
