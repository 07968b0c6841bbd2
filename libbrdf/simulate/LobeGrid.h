#pragma once
// Tables made of tallies. Internal to libbrdf/simulate.
#include <brdf/material/GridBrdf.h>
#include <brdf/simulate/OutgoingBins.h>
#include <brdf/simulate/Tally.h>

#include <vector>

namespace brdf {

/// f_r of one bin and channel, 1/sr: the light in it over its projected solid angle.
Estimate lobeValue(const RaySums& sums, const OutgoingBins& bins, std::uint64_t rays, std::size_t channel,
                   std::size_t bin);

/// A grid that is filled one incident direction at a time; the others are Invalid, and so are cells whose node is below
/// the horizon.
class LobeGrid {
 public:
  LobeGrid(const GridLayout& layout, const Channels& channels);

  /// The light in each bin over its projected solid angle, for the light at these nodes of theta_i and phi_i. A bin
  /// that no ray reached has the value 0 and the standard error that a single ray of the weight typical of this lobe
  /// would have made.
  void set(const RaySums& sums, const OutgoingBins& bins, std::uint64_t rays, std::size_t thetaI, std::size_t phiI);

  GridData data;

 private:
  std::vector<std::uint8_t> above_;
  std::vector<std::size_t> cells_;  ///< scratch
};

}  // namespace brdf
