#pragma once
#include <brdf/material/GridBrdf.h>
#include <brdf/measured/Format.h>

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace brdf {

// What the formats of gridded samples share.

/// Makes the cells Invalid that `rule` or a value that is not finite calls so, and counts cells, negative, not finite,
/// below the horizon and invalid in `report`. Values are planar, with one state a cell; `aboveHorizon(first, count,
/// flags)` is GridLayout's or TableDirections'.
void inspectCells(const std::vector<double>& values, std::vector<std::uint8_t>& states, InvalidRule rule,
                  const std::function<void(std::size_t, std::size_t, std::uint8_t*)>& aboveHorizon, ReadReport& report);
/// Warns of cells that are not finite, and where no cell is valid.
void warnOfCells(ReadReport& report);

/// Makes the BRDF of a grid just read: inspects its cells, warns, and converts its values, which are still what the
/// file has, from `quantity`.
ReadResult finishGrid(GridData data, const std::filesystem::path& path, ReadReport report, Quantity quantity,
                      InvalidRule rule);

/// Linear sRGB from the three planes of `values` in another colour space, in place. The transfer function of sRGB goes
/// on as a power above 1 and as its straight line below 0.
void toLinearSrgb(std::vector<double>& values, ColourSpace space);
/// And back.
void fromLinearSrgb(std::vector<double>& values, ColourSpace space);

}  // namespace brdf
