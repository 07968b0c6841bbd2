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
    Automatic,  ///< Spherical where a pilot run finds no peak that such bins flatten; else that of the three, narrowed
                ///< where the peaks are, that flattens them least
    Spherical,  ///< theta_o by phi_o, or phi_difference in an isotropic table, each as wide as `step`
    Specular,   ///< specular_theta by specular_phi about the mirror direction, narrowed where peaks are
    Retro       ///< the same about the direction back to the light: a specular layout of offsets -2 theta_i
  } bins = Bins::Automatic;
  std::uint64_t pilotRays = 1 << 18;  ///< of all incident directions together; 1024 to 32768 of each
  std::uint64_t seed = 1;
};

struct LayoutChoice {
  GridLayout layout;
  std::string reason;  ///< one line
};

/// Lays out a table. Peaks are looked for by a pilot run from every incident direction: a bin that holds a hundredth of
/// some direction's light or more, and in which a twentieth of the square of the light's density would be lost to the
/// mean over the bin, is cut in three along the axis, and its neighbours with it; so again, until no bin does, or is
/// narrower than 0.02 degrees, or there are 65536 outgoing bins, or four million in the table (or what `step` alone
/// makes, if more). All bins of a ring, or a sector, are cut together. Throws Error::Kind::Value for angles that are
/// not ascending or out of range, or a step that is.
BRDF_EXPORT LayoutChoice chooseLayout(Transport& transport, std::size_t channels, const LayoutRequest& request);

}  // namespace brdf
