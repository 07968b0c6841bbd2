#pragma once
#include <brdf/fit/Fit.h>
#include <brdf/fit/FitData.h>

#include <cstdint>
#include <vector>

namespace brdf {

/// Fills in regions and worst of the report: the residuals of its material on the data. Not for pictures.
void describeResiduals(const FitData& data, FitReport& report);

/// Part of each sample, 0 to parts - 1, for cross-validation: blocks of directions as CrossValidation describes them,
/// dealt out from the largest to the part with the fewest samples. Throws Error::Kind::Value when there are fewer
/// blocks than parts.
BRDF_EXPORT std::vector<std::uint8_t> directionParts(const FitData& data, Symmetry symmetry, std::size_t parts);

}  // namespace brdf
