#pragma once
#include <brdf/brdf_export.h>
#include <brdf/simulate/Transport.h>

#include <cstdint>
#include <string>
#include <vector>

namespace brdf {

/// What a table of a simulated BRDF is to be like.
struct LayoutRequest {
  std::vector<double> thetaI;  ///< of the light, radians, ascending
  std::vector<double> phiI{};  ///< likewise; empty: an isotropic table, the mean over azimuths, mirrored in the plane
                               ///< of incidence
  double step = 0.087266462599716477;  ///< width of the outgoing bins, radians (5 degrees); at most 45 degrees
  enum class Bins {
    Automatic,  ///< Specular where a pilot run finds the reflection narrow
    Spherical,  ///< theta_o by phi_o, or phi_difference in an isotropic table, each as wide as `step`
    Specular    ///< about the mirror direction: specular_theta as fine as the pilot run says, but no wider than `step`
  } bins = Bins::Automatic;
  std::uint64_t pilotRays = 1 << 15;  ///< for each of at most three incident directions
  std::uint64_t seed = 1;
};

struct LayoutChoice {
  GridLayout layout;
  /// Angle about the mirror direction that holds half of the light that is reflected into bins, radians, of the
  /// narrowest of the pilot's directions; not a number without a pilot, or where nothing is reflected into bins.
  double halfWidth = 0;
  std::string reason;  ///< one line
};

/// Lays out a table. The pilot looks at the first, middle and last of the polar angles at the first azimuth. A lobe
/// that is narrow about another direction than the mirror's is not noticed: its bins are as wide as `step`. Throws
/// Error::Kind::Value for angles that are not ascending or out of range, or a step that is.
BRDF_EXPORT LayoutChoice chooseLayout(Transport& transport, std::size_t channels, const LayoutRequest& request);

}  // namespace brdf
