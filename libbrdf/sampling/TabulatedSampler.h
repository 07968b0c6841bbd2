#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace brdf {

struct SamplerOptions {
  /// Relative variance of f cos / pdf (variance over albedo squared) that the tables may add: more cells and more
  /// viewers until measured to be below it, or until more of them or more memory do not help. The report says what was
  /// reached. Cells at 0.5, 0.05, 0.01 (cosineShare 0.01): GGX(alpha=0.05) 168, 2224, 10459 in 0.1 s each;
  /// GGX(alpha=0.05, alpha_y=0.3) 1656, 53981, 2013531 in 0.1, 0.3 and 1.6 s on two cores.
  double tolerance = 0.05;
  /// Share of cosine-weighted draws at least mixed in, 0 to 1: bounds what a table misses, and costs a sharp lobe a
  /// relative variance of share / (1 - share).
  double cosineShare = 0.05;
  /// Of all tables together; they get coarser to stay below it.
  std::size_t maximumBytes = std::size_t{64} << 20;
};

/// Draws light directions in proportion to f cos of any BRDF, from tables of its own values.
///
/// For a set of viewers (polar angles close together toward grazing; azimuths too where the surface may not be turned)
/// the value averaged over the channels, times the cosine, is tabulated in one or two polar charts (SamplingChart.h)
/// with cells where it changes. Per viewer a constant floor (the value that a tenth of the hemisphere stays below) is
/// drawn exactly, by the cosine, and the tables hold what lies above it. Between viewers the neighbours' tables are
/// mixed, and the density is that of the mixture: `pdf` is exactly the density of `sample`, whatever the tables miss.
/// Draws that fall below the horizon fail (0, 0, 0); the density integrates to 1 less their share.
/// What a BRDF shows only at viewers between the tabulated and the measured ones (a peak that interpolation of
/// scattered data makes within a degree, say) stays with the cosine and is not in the report. Immutable; safe to share
/// among threads.
class BRDF_EXPORT TabulatedSampler {
 public:
  enum class Kind {
    Half,          ///< half vectors about the normal: mirror-like lobes
    HalfAndRetro,  ///< half vectors, and lights about the viewer for retro-reflection, where each is the nearer peak
    Light          ///< light directions about the normal: broad or irregular ones
  };

  /// What building it found.
  struct Report {
    Kind kind = Kind::Half;
    std::size_t viewers = 0;      ///< tabulated
    std::size_t cells = 0;        ///< of all tables
    std::size_t bytes = 0;        ///< of all tables
    double relativeVariance = 0;  ///< of f cos / pdf, measured between the viewers: mean over five polar angles
    double worstVariance = 0;     ///< the largest of the five
    double seconds = 0;           ///< wall-clock time to choose and build
  };

  /// Builds coarse tables of each kind, measures their variance, and refines the best. All threads. Throws
  /// Error::Kind::Value when an option is out of its range.
  explicit TabulatedSampler(const Brdf& brdf, const SamplerOptions& options = {});
  /// The same with the kind given.
  TabulatedSampler(const Brdf& brdf, Kind kind, const SamplerOptions& options = {});

  /// As Brdf::sample. A viewer at or below the horizon gets failed draws.
  void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
              const std::array<double*, 3>& wi, std::size_t count) const;
  /// As Brdf::pdf.
  void pdf(const DirectionPairs<double>& pairs, double* density) const;

  const Report& report() const { return report_; }

  /// The tables as a shader reads them (shaders/brdf_sampler.glsl): texels of four floats.
  struct Texels {
    Kind kind = Kind::Half;
    bool turning = true;  ///< the surface may be turned: no azimuths of viewers
    int thetas = 0, phis = 0;
    int search = 1;  ///< a power of two, at least half the cells of the longest row or column
    /// For each viewer three texels, theta by theta, then azimuth by azimuth: (share of the cosine, of the first chart,
    /// of the second, 0), then for both charts (rows, columns, texel of its first row, 0); after these the tables
    /// (PolarTable::appendTexels).
    std::vector<float> numbers;
  };
  Texels texels() const;

  /// Another mixture of draws, without searches, for shaders whose every sample has to be cheap: in proportion to
  /// (f - base) cos, as PolarWarp has it, `base` being a constant that needs no draws (1/sr). Charts overlap; where
  /// there are two, each draws its part of f, a smooth function of the directions, so that a draw needs no density but
  /// its own.
  struct Warps {
    /// For each viewer, in the order of Texels, a texel (share of the first chart in the draws, 0, 0, 0).
    std::vector<float> shares;
    /// For each viewer, and for each of its charts, PolarWarp::texels.
    std::vector<float> texels;
  };
  Warps warps(double base = 0) const;

 private:
  class Tables;
  void choose(const Brdf& brdf, std::span<const Kind> kinds, const SamplerOptions& options);

  std::shared_ptr<const Tables> tables_;
  Report report_;
};

/// "half vector", "half vector and retro", "light".
BRDF_EXPORT const char* name(TabulatedSampler::Kind kind);

}  // namespace brdf
