#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>
#include <brdf/view/ErrorAxes.h>
#include <brdf/view/ErrorMeasure.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// Where two BRDFs are compared.
enum class ErrorDirections {
  Automatic,  ///< Samples where a BRDF has some, but Chosen on the hemisphere
  Samples,    ///< at b's own samples where it has any, else a's
  Chosen      ///< at directions that the map chooses
};
/// "automatic", "samples" or "chosen"; throws Error::Kind::Value for another name.
BRDF_EXPORT ErrorDirections parseErrorDirections(std::string_view name);
BRDF_EXPORT std::vector<std::string> errorDirectionsNames();

struct ErrorMapOptions {
  ErrorMeasure measure;
  ErrorGrid grid{.intervals = 0};  ///< intervals 1 to 1000; 0: automaticIntervals()
  ErrorDirections directions = ErrorDirections::Automatic;
  /// Pairs of directions a node, 1 to 10000, where the map chooses the directions; at most 2e7 pairs in all.
  std::size_t azimuths = 36;
  std::size_t worst = 10;  ///< how many of the worst pairs are listed, at most 10000
};

/// A pair of directions where two BRDFs differ much.
struct WorstPair {
  DirectionPair pair;
  double error = 0;          ///< of all channels: see ErrorMap::errors
  std::vector<double> a, b;  ///< by channel, 1/sr
  std::size_t node = 0;      ///< of the map
};

/// Differences of two BRDFs over the nodes of a grid, and pair by pair. Every pair counts alike at samples (by the
/// solid angle of its cell where the metric asks for that), and by the solid angles that it stands for where the map
/// chooses directions.
struct ErrorMap {
  ErrorGrid grid;
  std::vector<double> mean;            ///< by node, as the measure averages; 0 where nothing was counted
  std::vector<double> channelMean;     ///< channel c of a node at c * nodes^2 + node; empty for one channel
  std::vector<std::uint64_t> count;    ///< pairs of directions at the node, times channels
  double overallMean = 0;              ///< over all that was counted
  std::vector<double> channelOverall;  ///< the same, one a channel
  double largest = 0;                  ///< the largest absolute value of a node
  /// One a pair: the residual of its channels, by root mean square, or their mean where the average is signed.
  std::vector<double> errors;
  std::vector<double> weights;   ///< of the pairs; empty: all alike
  std::size_t leftOut = 0;       ///< pairs where a BRDF has no value, or none that is finite
  std::vector<WorstPair> worst;  ///< the largest |error| first, none of error 0; see below
  std::string sampling;          ///< where the directions come from, in words
};

/// 90 where the map chooses the directions (180 on the hemisphere). On samples 45, wider than the degree by which
/// tables usually step (nodes of their own step would show a chequerboard), and 9 for at most 100,000 of them: enough
/// then meet in a node; on the hemisphere twice as many.
BRDF_EXPORT std::size_t automaticIntervals(const Brdf& a, const Brdf& b, ErrorAxes axes, ErrorDirections directions);

/// The worst pairs lie at least an eighteenth of the map's side apart along one of its axes (5 degrees of 90), and at
/// most one at a node: the neighbours of the worst are as bad, and would be all that a plain list has.
///
/// Compares `a` with `b`, which must have the same channels (see chooseChannels). A metric that takes a scale from the
/// data takes it from b, as compare() does. Throws Error::Kind::Value for options out of range, samples that are not
/// there or have no cells where the metric needs them, and a user's metric without a finite value.
BRDF_EXPORT ErrorMap makeErrorMap(const Brdf& a, const Brdf& b, const ErrorMapOptions& options);

}  // namespace brdf
