#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/LobeSum.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace brdf {

/// One fitted number.
struct FittedParameter {
  std::string name;  ///< "alpha", or "scale" for a lobe's factor
  std::string lobe;  ///< model name
  std::size_t lobeIndex = 0;
  std::optional<std::size_t> channel;  ///< empty: shared by all channels
  double value = 0;
  std::optional<double> standardError;  ///< empty where it is not determined (on a bound, or rank deficient)
  double minimum = 0, maximum = 0;
  bool fixed = false;
  bool atBound = false;
};

/// Covariance of the fitted numbers that the data determine, for residuals that are independent and of equal spread.
struct FitCovariance {
  std::vector<std::size_t> parameters;  ///< indices into FitReport::parameters
  std::vector<double> matrix;           ///< n x n; 0 between channels fitted apart

  /// The same as correlations: 1 on the diagonal.
  BRDF_EXPORT std::vector<double> correlations() const;
};

/// The optimizer lowered the error.
struct FitStep {
  std::size_t run = 0;        ///< which start, from 0; the last ones are on all samples
  std::size_t iteration = 0;  ///< counted over all runs
  double error = 0;           ///< in the metric asked for, on the samples of that run
};

/// Residuals in a region of directions (material/RegionErrors.h).
struct RegionResidual {
  std::string region;
  std::size_t samples = 0;
  double error = 0;           ///< in the metric asked for, over the region
  double share = 0;           ///< of the squared error of all
  double meanDifference = 0;  ///< of f - t over samples and channels, 1/sr: the bias
  double relativeMean = 0;    ///< sum of |f - t| / sum of |t|
};

/// A sample that adds much to the error.
struct WorstSample {
  std::array<double, 3> wi{}, wo{};
  std::size_t channel = 0;
  double target = 0, fitted = 0;  ///< 1/sr
  double share = 0;               ///< of the squared error of all
};

/// Error on samples that the fit did not see: the directions are cut into blocks (nine steps of
/// the square root of theta_h, 15 degrees of theta_d, 30 of phi_d, for anisotropic targets 45 of phi_h), each left out
/// once with the others of its part.
struct CrossValidation {
  double error = 0;                ///< in the metric asked for
  double standardError = 0;        ///< of it, from the scatter of the parts
  std::vector<double> partErrors;  ///< of each part
};

/// Another fit made on the way: a stage of a progressive one, or lobes to choose among (fit/ModelChoice.h).
struct FitCandidate {
  std::string lobes;        ///< as they were asked for
  double error = 0;         ///< in the metric asked for
  std::size_t degrees = 0;  ///< as FitReport::degrees, aic, bic
  double aic = 0, bic = 0;
  std::optional<double> crossValidation;  ///< its error
  bool converged = false;
};

struct FitReport {
  std::shared_ptr<const LobeSum> material;  ///< the fit
  std::string metric;
  std::string metricFormula;  ///< the residual whose mean square is minimised, f the fit's and t the target's value
  std::string optimizer;
  std::string strategy;
  double error = 0;                         ///< in the metric asked for
  std::map<std::string, double> metrics;    ///< by every metric
  std::map<std::string, double> zeroModel;  ///< the same for the model that answers 0
  /// The constant BRDF (one value of at least 0 a channel, 1/sr) with the least error in the metric asked for.
  std::vector<double> constantModel;
  double constantError = 0;  ///< its error
  std::string sampling;      ///< which samples of the target were used, in words
  std::string weights;       ///< "none", "solid-angle" or "importance"
  double maximumTheta = 90;  ///< degrees
  std::string channelNames;  ///< what the channels are: "luminance", "rgb", "spectral", or the target's numbers "0,3"
  double seconds = 0;
  /// Evaluations of the error by the optimizer, all starts; on large data the first runs see a subset only.
  std::size_t evaluations = 0;
  std::size_t iterations = 0;
  std::size_t samples = 0;  ///< samples used
  std::size_t offered = 0;  ///< samples there were, with those invalid or beyond the theta limit
  std::size_t channels = 0;
  bool converged = false;
  std::string termination;  ///< the reason, in words
  std::vector<FittedParameter> parameters;
  FitCovariance covariance;
  std::vector<FitStep> history;
  std::vector<RegionResidual> regions;  ///< empty for metrics on pictures, as `worst`
  std::vector<WorstSample> worst;       ///< at most ten, the worst first
  /// K: free numbers and the variance of the residuals; n = samples x channels.
  std::size_t degrees = 0;
  /// n ln(error^2) + 2 K (Akaike 1974, doi:10.1109/TAC.1974.1100705) and n ln(error^2) + K ln n (Schwarz 1978,
  /// doi:10.1214/aos/1176344136), for normal, independent residuals; only differences mean anything, between fits of
  /// one target by one metric. Minus infinity for an exact fit.
  double aic = 0, bic = 0;
  std::optional<CrossValidation> crossValidation;
  std::vector<FitCandidate> candidates;  ///< empty for one fit alone; this one is among them
  std::vector<std::string> notes;        ///< what a user should know: rank deficiency, parameters at bounds, weak lobes
};

}  // namespace brdf
