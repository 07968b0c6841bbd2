#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>
#include <brdf/material/Quantity.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

struct ReadReport;

enum class AngleUnit { Degrees, Radians };
/// Which of a file's two directions is the light's.
enum class Incident {
  AsStated,  ///< the one that the format calls incident
  Swapped    ///< the other one
};
enum class ColourSpace {
  LinearSrgb,   ///< linear sRGB primaries
  EncodedSrgb,  ///< sRGB with its transfer function (IEC 61966-2-1), undone at reading
  Xyz           ///< CIE 1931 XYZ, Y = 1 the white of D65
};
/// Which values of a file mean "not measured"; those that are not finite always do.
enum class InvalidRule {
  NotFinite,   ///< no others: negative values are noise about zero
  Negative,    ///< values below 0
  NotPositive  ///< values of 0 and below
};
/// Which side of a sheet a file calls its front.
enum class Sides { AsStated, Swapped };

/// What the user says of a measured file, against what its format or content says. Each may be left unsaid. On the
/// command line: `--assume quantity=brdf_cos`, once for each (parseReadOptions).
struct ReadOptions {
  std::optional<Quantity> quantity;    ///< "quantity": brdf, brdf_cos, reflectance_factor
  std::optional<AngleUnit> angles;     ///< "angles": degrees, radians
  std::optional<Incident> incident;    ///< "incident": as_stated, swapped
  std::optional<Symmetry> symmetry;    ///< "symmetry": isotropic, bilateral, anisotropic
  std::optional<ColourSpace> colour;   ///< "colour": linear_srgb, srgb, xyz
  std::optional<InvalidRule> invalid;  ///< "invalid": not_finite, negative, not_positive
  std::optional<Sides> sides;          ///< "sides": as_stated, swapped

  bool empty() const { return keys().empty(); }
  /// The keys of what is said, in the order above.
  BRDF_EXPORT std::vector<std::string> keys() const;
};

/// A key that --assume takes.
struct ReadOptionKey {
  std::string key;
  std::vector<std::string> values;
  std::string meaning;  ///< one line
};
BRDF_EXPORT std::span<const ReadOptionKey> readOptionKeys();

/// Reads "key=value" items. Throws Error::Kind::Usage with the known keys or values.
BRDF_EXPORT ReadOptions parseReadOptions(std::span<const std::string> items);

// What a reader takes: the option where it is given, else what the format says. Either goes to report.assumptions as
// one sentence with its evidence, e.g. "quantity: brdf (the format's definition)" or "quantity: brdf_cos (given; the
// format's definition says brdf)". `evidence` says why the reader takes `byFormat`.
BRDF_EXPORT Quantity choose(const ReadOptions&, Quantity byFormat, std::string_view evidence, ReadReport& report);
BRDF_EXPORT AngleUnit choose(const ReadOptions&, AngleUnit byFormat, std::string_view evidence, ReadReport& report);
BRDF_EXPORT Incident choose(const ReadOptions&, Incident byFormat, std::string_view evidence, ReadReport& report);
BRDF_EXPORT Symmetry choose(const ReadOptions&, Symmetry byFormat, std::string_view evidence, ReadReport& report);
BRDF_EXPORT ColourSpace choose(const ReadOptions&, ColourSpace byFormat, std::string_view evidence, ReadReport& report);
BRDF_EXPORT InvalidRule choose(const ReadOptions&, InvalidRule byFormat, std::string_view evidence, ReadReport& report);
BRDF_EXPORT Sides choose(const ReadOptions&, Sides byFormat, std::string_view evidence, ReadReport& report);

}  // namespace brdf
