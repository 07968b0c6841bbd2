#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// How two values a and b (1/sr) at one pair of directions differ.
enum class ErrorMeasure {
  Difference,  ///< a - b, signed, 1/sr
  Absolute,    ///< |a - b|, 1/sr
  Relative,    ///< |a - b| / b, no unit; pairs with b <= 0 are left out
  Log,         ///< |ln(1 + a cos theta_i) - ln(1 + b cos theta_i)|
  CubeRoot     ///< |cbrt(a cos theta_i) - cbrt(b cos theta_i)|, sr^-1/3
};

BRDF_EXPORT double errorMeasure(ErrorMeasure measure, double a, double b, double cosThetaI);
/// "difference", "absolute", "relative", "log" or "cuberoot"; throws Error::Kind::Value for another name.
BRDF_EXPORT ErrorMeasure parseErrorMeasure(std::string_view name);
/// What is shown, with its unit, e.g. "mean |f_A - f_B| (1/sr)".
BRDF_EXPORT std::string errorMeasureLabel(ErrorMeasure measure);

/// The two angles that a map spans, both from 0 to 90 degrees.
enum class ErrorAxes {
  IncidentOutgoing,  ///< x = theta_i, y = theta_o; means over both azimuths
  HalfDifference     ///< x = theta_h, y = theta_d; means over phi_h and phi_d
};
/// "theta_i,theta_o" or "theta_h,theta_d"; throws Error::Kind::Value for another name.
BRDF_EXPORT ErrorAxes parseErrorAxes(std::string_view name);

struct ErrorMapOptions {
  ErrorMeasure measure = ErrorMeasure::Absolute;
  ErrorAxes axes = ErrorAxes::IncidentOutgoing;
  std::size_t intervals = 0;  ///< from 0 to 90 degrees along each axis, 1 to 1000; 0: automaticIntervals()
  std::size_t azimuths = 36;  ///< pairs of directions a node, where the map chooses the directions itself
  bool onSamples = true;      ///< on b's own samples where it has any (else a's), binned; false: at chosen directions
};

/// Mean differences over a square of nodes, row after row: node (x, y) stands for the angles within half an interval of
/// x and y times 90 / intervals degrees. (Measurements lie at round angles: as nodes they fall in the middle.)
struct ErrorMap {
  std::size_t intervals = 0;
  std::vector<double> mean;          ///< 0 where nothing was counted
  std::vector<std::uint64_t> count;  ///< pairs of directions at the node, times channels
  double overallMean = 0;            ///< over all that was counted, unweighted
  double largest = 0;                ///< the largest absolute value of a node
  std::string sampling;              ///< where the directions come from, in words

  std::size_t nodes() const { return intervals + 1; }  ///< along each axis
};

/// 90 where the map chooses the directions. On samples 45, wider than the degree by which tables usually step (nodes of
/// their own step would show a chequerboard), and 9 for at most 100,000 of them: enough then meet in a node.
BRDF_EXPORT std::size_t automaticIntervals(const Brdf& a, const Brdf& b, bool onSamples);

/// Compares `a` with `b`, which must have the same number of channels (see chooseChannels). Throws Error::Kind::Value.
BRDF_EXPORT ErrorMap makeErrorMap(const Brdf& a, const Brdf& b, const ErrorMapOptions& options);

}  // namespace brdf
