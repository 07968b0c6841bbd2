#pragma once
#include <brdf/material/GridBrdf.h>
#include <brdf/measured/Format.h>

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

namespace brdf {

// What the formats of gridded samples share.

/// Makes the BRDF of a grid just read. Cells that `rule` or a value that is not finite calls invalid become Invalid;
/// they, negative values and cells below the horizon are counted. Values are still what the file has; `quantity` says
/// what that is.
ReadResult finishGrid(GridData data, const std::filesystem::path& path, ReadReport report, Quantity quantity,
                      InvalidRule rule);

/// Linear sRGB from the three planes of `values` in another colour space, in place. The transfer function of sRGB goes
/// on as a power above 1 and as its straight line below 0.
void toLinearSrgb(std::vector<double>& values, ColourSpace space);
/// And back.
void fromLinearSrgb(std::vector<double>& values, ColourSpace space);

}  // namespace brdf
