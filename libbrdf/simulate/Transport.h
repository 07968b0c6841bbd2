#pragma once
#include <brdf/brdf_export.h>
#include <brdf/simulate/Microsurface.h>
#include <brdf/simulate/OutgoingBins.h>
#include <brdf/simulate/Tally.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace brdf {

/// Light that leaves within this angle (radians) of the mirror direction, by mirror-like facets only, is specular: it
/// counts as leaving in that direction exactly. Far below any bin, far above the rounding of a backend that keeps
/// directions in float.
constexpr double kSpecularWithin = 1e-5;

/// Rays that a backend is to trace.
struct RayBatch {
  /// Whether each ray turns the surface by a random angle about its normal first, so that the outcome is the mean over
  /// azimuths (of an isotropic table); the bins' azimuth of the light is then the turned one.
  bool turning = false;
  std::uint64_t seed = 1;   ///< rays of one seed and number are the same ray, whatever the batches
  std::uint64_t first = 0;  ///< number of the first ray
  std::uint64_t count = 0;
};

/// Traces light through a microsurface: the backend of the virtual gonioreflectometer.
///
/// Geometrical optics, unpolarised at every meeting; see docs/simulation.md. A ray starts at a point that is uniform
/// over the tile, above everything, and carries 1 in each channel, so that every point of the mean plane is lit alike.
/// What a ray carries when it leaves is added to its bin (a ray may split at dielectrics: its parts in one bin add up).
/// Means must be unbiased: whatever ends paths early by chance divides by the chance.
class BRDF_EXPORT Transport {
 public:
  virtual ~Transport();
  /// Adds the batch's rays, from bins.wi(), to a tally of bins.count() bins and as many channels as the surface has,
  /// and lists departures where the tally does. One call at a time. Throws Error::Kind::Device where a device fails.
  virtual void trace(const RayBatch& batch, const OutgoingBins& bins, Tally& tally) = 0;
  /// Whether facets are connected with the bins (NextEvent).
  virtual bool connects() const { return false; }
};

/// Next-event estimation: where light meets a facet that is `lambertian`, one direction of every bin, at random within
/// it, gets what the facet sends there if nothing is in the way; what the path itself carries away from there is then
/// in no bin (of reflected light), as it would count twice. Means are the same. A ray costs about as many queries as
/// there are bins above each facet that it meets, and its bins err together: errors of bins are those of many rays
/// fewer.
enum class NextEvent {
  Off,
  On,        ///< throws Error::Kind::Value where a facet is a dielectric, or the backend cannot
  Automatic  ///< where every facet is `lambertian`, and the backend can
};

struct TransportOptions {
  /// Meetings with facets after which what a ray still carries counts as lost, 1 to 1'000'000.
  std::size_t bounces = 1000;
  NextEvent nextEvent = NextEvent::Off;
};

/// A backend by its name ("cpu"; "gpu" where the program has registered it).
struct TransportBackend {
  std::string name;
  std::string title;  ///< one line
  /// Throws Error::Kind::Value for a surface that it cannot trace, Error::Kind::Device where a device is missing.
  std::function<std::unique_ptr<Transport>(const Microsurface& surface, const TransportOptions& options)> make;
};
/// Adds a backend; replaces one of the same name. Not to be called while others look.
BRDF_EXPORT void registerTransport(TransportBackend backend);
BRDF_EXPORT const std::vector<TransportBackend>& transportBackends();
/// Checks the surface and makes the backend ready. Throws Error::Kind::Value for an unknown name.
BRDF_EXPORT std::unique_ptr<Transport> makeTransport(const std::string& backend, const Microsurface& surface,
                                                     const TransportOptions& options = {});

}  // namespace brdf
