#pragma once
#include <brdf/material/GridBrdf.h>
#include <brdf/measured/Format.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

// What the readers of grids share: axes, conventions, defects, components.

/// A polar angle as a file lists it (degrees, ascending). Look-ups beyond a list of incidences see the last one; beyond
/// other lists there is no value.
GridAxis polarAxis(AxisQuantity quantity, const std::vector<double>& degrees);

/// An azimuth as a file lists it (degrees, ascending). `mirrored`: half a turn that a mirror symmetry completes. Else
/// periodic where the list goes all around, first and last being the same or one step apart; where it does not, there
/// is no value beyond its ends, and a warning says so.
GridAxis azimuthAxis(AxisQuantity quantity, const std::vector<double>& degrees, bool mirrored, ReadReport& report);
/// Whether a list of azimuths goes all around.
bool fullTurn(const std::vector<double>& degrees);

/// The values along the azimuth axis `quantity` (0 to 180 degrees) continued to 360 degrees by their mirror images: for
/// grids that turn with the light (phi_i) and yet are mirrored in the plane of incidence.
void mirrorAzimuth(GridData& data, AxisQuantity quantity);

/// Whether the values are mirrored in the plane of incidence, `turns` being whether the light has several azimuths: as
/// the file states, or because the user says isotropic of a file with one azimuth of the light. Any other symmetry than
/// the file's is a contradiction: Error::Kind::Value, naming `path`.
bool chooseMirror(const ReadOptions& options, bool stated, bool turns, const std::filesystem::path& path,
                  ReadReport& report);

/// What the values of a file mean.
struct GridConventions {
  Quantity quantity = Quantity::Brdf;
  InvalidRule invalid = InvalidRule::NotFinite;
  Sides sides = Sides::AsStated;
  ColourSpace colour = ColourSpace::LinearSrgb;
};
/// The keys of the options that chooseConventions() and chooseMirror() honour.
const std::vector<std::string>& gridOptions();
/// Takes the options or else what the format says; all go to the report. `colour` is empty for a file without colours,
/// which an option about them contradicts: Error::Kind::Value.
GridConventions chooseConventions(const ReadOptions& options, Quantity quantity, std::string_view quantityEvidence,
                                  std::optional<ColourSpace> colour, std::string_view colourEvidence,
                                  ReadReport& report);

/// The BRDF of one grid of a file, its values as in the file: counts the defects, makes the values linear sRGB where
/// they are colours and f_r in 1/sr. Cells below the horizon are Invalid, and those on the horizon that hold 0: both
/// are fillers. Throws Error::Kind::Format with the path for a layout that is no good.
std::shared_ptr<const GridBrdf> finishPart(GridData data, const GridConventions& conventions,
                                           const std::filesystem::path& path, ReadReport& report);

/// The result of a file whose distributions are `parts` (front reflection included), with `others` beside them.
/// Sides::Swapped makes front back and back front. A file without a distribution gets a BRDF that is valid nowhere.
ReadResult assemble(std::vector<ScatterComponent> parts, Components others, Sides sides, ReadReport report);

/// Fraction of the light from `wi` that leaves, by channel: the integral of f cos(theta_o) over the hemisphere. Gauss's
/// rule of 4 points on stretches of at most 5 degrees between successive `polarNodes` (radians) about `pole`, midpoints
/// every 3 degrees around it.
std::vector<double> directionalReflectance(const Brdf& brdf, const std::array<double, 3>& wi,
                                           const std::array<double, 3>& pole, const std::vector<double>& polarNodes);

}  // namespace brdf
