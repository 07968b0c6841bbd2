#pragma once
#include <brdf/brdf_export.h>
#include <brdf/fit/FitReport.h>
#include <brdf/material/LobeSum.h>

#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// A lobe to be fitted: which model, which parameters are held.
struct LobeRequest {
  ModelPointer model;
  std::map<std::string, double> fixed;  ///< parameter name -> value that the fit does not move; "scale" is a name too
  std::map<std::string, double> start;  ///< parameter name -> starting value; defaults otherwise
  std::map<std::string, std::string> tied;  ///< parameter name -> parameter of the same lobe that it stays equal to
  /// A parameter of a lobe that comes before in the list of requests.
  struct Elsewhere {
    std::size_t lobe = 0;  ///< index in the list
    std::string parameter;
  };
  std::map<std::string, Elsewhere> tiedElsewhere{};  ///< parameter name -> what it stays equal to
};

enum class Strategy {
  Automatic,  ///< Separable where the metric allows it, else Joint
  Separable,  ///< scale factors by non-negative linear least squares inside the loop over shape parameters
  Joint       ///< scale factors are parameters like the others
};

enum class Combination {
  Shared,     ///< one shape for all channels, one scale factor a channel
  PerChannel  ///< every channel has its own shape and scale
};

/// Which channels of the target are fitted.
struct FitChannels {
  enum class Kind { Native, Luminance, Rgb, List } kind = Kind::Native;
  std::vector<std::size_t> list;  ///< indices of the target's channels, for List
};

/// Where the values of a target are looked at.
enum class Sampling {
  Automatic,   ///< its own samples where it has any, else Hemisphere
  All,         ///< its own samples: measured points, cells of a table
  Hemisphere,  ///< pairs of directions in equal solid angles
  Importance   ///< random pairs, more where the target is bright, weighted so that the mean is that of Hemisphere
};

struct SampleChoice {
  Sampling sampling = Sampling::Automatic;
  /// Hemisphere and Importance: how many, at most 1e7; 0: 221184 and 100000.
  std::size_t count = 0;
  std::uint64_t seed = 1;    ///< Importance
  bool solidAngles = false;  ///< All: each sample counts by the solid angle of its cell, else all alike
  bool noise = false;        ///< All, fits only: each value counts by 1 / variance (fit/NoiseWeights.h)
};

struct FitOptions {
  /// A name in metricNames(), or one with an argument: "relative:FLOOR", "huber:DELTA", "sphere[:MAP]", "formula:TEXT"
  /// (findMetric).
  std::string metric = "rms";
  std::string optimizer = "lm";  ///< name in optimizerNames()
  Strategy strategy = Strategy::Automatic;
  Combination combination = Combination::Shared;
  FitChannels channels;
  SampleChoice samples;
  double maximumTheta = 90;  ///< degrees; samples with theta_i or theta_o above are left out
  /// Relative: stop when a step lowers the squared error by less than this part and moves no parameter (in its
  /// logarithm where its scale is one) by more than a hundredth of the square root of this.
  double tolerance = 1e-8;
  /// Of each run of the optimizer; methods of NLopt get 5 (those with gradients) or 20 evaluations for each.
  std::size_t maximumIterations = 200;
  std::size_t starts = 0;  ///< extra random starts (Latin hypercube over the soft bounds)
  std::uint64_t seed = 1;  ///< of the random starts, and of optimizers that draw random numbers
  /// Cross-validation in so many parts of whole blocks of directions, 2 to 100; 0: none. Each costs another fit.
  std::size_t crossValidation = 0;
  bool scan = true;        ///< scan each lobe's shape on a coarse grid for the starting values (deterministic)
  bool dataStart = false;  ///< start from shapes read off the data too (fit/DataStart.h); with scan off only they and
                           ///< the request's own are starts
  /// Called after each iteration with the error so far; return false to stop with the best so far.
  std::function<bool(std::size_t iteration, double error)> progress;
};

/// Fits a sum of lobes to a target of any kind. Throws Error::Kind::Value for an unknown metric or optimizer, a
/// combination that cannot be, or a target without valid samples.
BRDF_EXPORT FitReport fit(const Brdf& target, const std::vector<LobeRequest>& lobes, const FitOptions& options);

BRDF_EXPORT std::vector<std::string> metricNames();
BRDF_EXPORT std::vector<std::string> optimizerNames();

/// Differences between two BRDFs by every metric (means over samples and channels, unweighted unless asked, or the
/// metric says so), on the samples of b that `samples` chooses; Automatic: on b's own when it has any, else on a's,
/// else on pairs of directions in equal solid angles. `zeroModel` is b against 0. Metrics by solid angle are left out
/// where the samples have no cells.
struct Comparison {
  std::map<std::string, double> metrics;
  std::map<std::string, double> zeroModel;
  std::map<std::string, std::string> formulas;  ///< of the residual, f being a and t b, with the numbers in use
  std::size_t samples = 0;
  std::size_t channels = 0;
  std::string sampling;  ///< where the samples come from, in words
};
/// `metric`: one to judge by besides metricNames(), as FitOptions::metric, or empty.
BRDF_EXPORT Comparison compare(const Brdf& a, const Brdf& b, double maximumTheta = 90, std::string_view metric = {},
                               const SampleChoice& samples = {});

/// The target seen through other channels: luminance (one channel), rgb, or a list of the target's own.
/// Luminance of spectral data is sum(f ybar) / sum(ybar) over its wavelengths (equal energy, CIE 1931 2-degree);
/// of RGB data 0.2126 R + 0.7152 G + 0.0722 B. Keeps the target's samples.
BRDF_EXPORT BrdfPointer selectChannels(BrdfPointer target, const FitChannels& channels);

}  // namespace brdf
