#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Components.h>
#include <brdf/material/GridBrdf.h>
#include <brdf/simulate/Transport.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace brdf {

constexpr double kMostThetaI = 89.99;  ///< degrees: the most that a polar angle of the light may be

/// Where the light of one incident direction went, as shares of what arrived; lists hold one estimate a channel.
/// reflected + transmitted + absorbed + lost is `sum`, which is 1 within its standard error (exactly, where no path was
/// ended by chance): nothing of one is in another.
struct EnergyBalance {
  double thetaI = 0, phiI = 0;  ///< of the light, radians; phiI is 0 where the surface was turned at random
  std::uint64_t rays = 0;
  std::vector<Estimate> reflected, transmitted, absorbed, lost, sum;
  /// The parts of `reflected` and `transmitted` that are a specular component, in no bin.
  std::vector<Estimate> specularReflected, specularTransmitted;
  double noise = 0;        ///< of the bins: LobeSimulation::noise()
  bool converged = false;  ///< whether the tolerance was reached, and the lost light is below it
};

/// What a tolerance is of.
enum class ToleranceOf {
  Bins,   ///< "bins": LobeSimulation::noise(), in every channel
  Albedo  ///< "albedo": the standard error of `reflected` and of `transmitted`, in every channel, as shares of what
          ///< arrived
};

/// One incident direction of a virtual gonioreflectometer, refined as long as someone looks: rays are added a batch at
/// a time, and the lobe so far can be had after each.
class BRDF_EXPORT LobeSimulation {
 public:
  /// `layout` as Gonioreflectometer's; angles of the light in radians. `channels` are the surface's. The transport is
  /// shared: one call at a time for all that share it.
  LobeSimulation(std::shared_ptr<Transport> transport, const Channels& channels, const GridLayout& layout,
                 double thetaI, double phiI, std::uint64_t seed);

  void add(std::uint64_t rays);

  const OutgoingBins& bins() const { return bins_; }
  bool connects() const { return transport_->connects(); }
  const Tally& tally() const { return tally_; }
  const RaySums& reflected() const {
    return transport_->connects() ? balanced_ : tally_.reflected;
  }  ///< Tally::balanced()
  /// Of one bin and channel: f_r in 1/sr, the light that left into the bin over its projected solid angle.
  Estimate value(std::size_t channel, std::size_t bin) const;
  /// The same for transmitted light.
  Estimate transmission(std::size_t channel, std::size_t bin) const;
  /// Root mean square standard error over the root mean square value of the bins, both weighted by projected solid
  /// angle, of the worst channel: 0.1 for noise that is a tenth of the lobe. Of the reflected bins, or where nothing is
  /// reflected into bins of the transmitted ones; 0 where all the light so far is specular, absorbed or lost.
  double noise() const;
  EnergyBalance balance() const;
  /// The lobe so far: a grid whose axes of the light have one node. Standard errors as the tally has them.
  std::shared_ptr<const GridBrdf> lobe() const;

 private:
  std::shared_ptr<Transport> transport_;
  Channels channels_;
  GridLayout layout_;
  OutgoingBins bins_;
  std::uint64_t seed_;
  Tally tally_;
  RaySums balanced_;
};

struct GonioreflectometerProgress {
  std::size_t done = 0, directions = 0;  ///< incident directions
  std::uint64_t rays = 0;                ///< of the current direction
  double noise = 0;                      ///< of the current direction (what the tolerance is of)
};

struct GonioreflectometerOptions {
  /// The table to be made: axes of the light (theta_i, and phi_i for an anisotropic table) and cell-centred axes of the
  /// viewer (OutgoingBins). A layout without phi_i turns the surface at random about its normal: the mean over
  /// azimuths.
  GridLayout layout;
  ToleranceOf toleranceOf = ToleranceOf::Bins;
  /// Rays are added to an incident direction until its standard error is at most this, more than 0.
  double tolerance = 0.05;
  std::uint64_t minimumRays = 1 << 14;  ///< an incident direction; at most 1024 with next-event estimation
  std::uint64_t maximumRays = 1 << 24;  ///< an incident direction; reached before the tolerance: not converged
  TransportOptions transport{.nextEvent = NextEvent::Automatic};
  std::uint64_t seed = 1;  ///< the same seed gives the same table but for rounding, whatever the threads
  std::string backend = "cpu";
  /// Called from time to time; false stops, keeping the directions that are done.
  std::function<bool(const GonioreflectometerProgress&)> progress{};
};

/// Whether the lobe has reached the tolerance of these options, with the lost light below it in every channel.
BRDF_EXPORT bool reachesTolerance(const LobeSimulation& lobe, const GonioreflectometerOptions& options);

struct GonioreflectometerResult {
  std::shared_ptr<const GridBrdf> brdf;  ///< with standard errors; the cells of directions not done are Invalid
  /// Specular reflection and transmission by polar angle of the light (the mean over its azimuths; EnergyBalance has
  /// each direction's), and the distribution of transmitted light, where there is any.
  Components components;
  std::vector<EnergyBalance> balance;  ///< of the directions that are done
  std::uint64_t rays = 0, segments = 0;
  double seconds = 0;
  bool connects = false;   ///< next-event estimation was used
  bool complete = false;   ///< every direction was done
  bool converged = false;  ///< every one of them to the tolerance
};

/// Measures the BRDF of a microsurface like a gonioreflectometer that can count photons: light from each incident
/// direction is traced until it leaves, and counted in bins of directions. Throws Error::Kind::Value for options or a
/// surface that are no good, Error::Kind::Device where the backend's device fails.
BRDF_EXPORT GonioreflectometerResult simulateBrdf(const Microsurface& surface,
                                                  const GonioreflectometerOptions& options);

}  // namespace brdf
