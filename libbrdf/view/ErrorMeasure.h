#pragma once
#include <brdf/brdf_export.h>
#include <brdf/fit/Metric.h>

#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// How the residuals r of many pairs of directions become one number.
enum class ErrorAverage {
  RootMeanSquare,  ///< sqrt(mean r^2), as the metric itself
  Absolute,        ///< mean |r|
  Signed           ///< mean r: negative where A is below B
};

/// How two BRDFs differ at one pair of directions: the residual r(f, t) of a metric of `compare` and `fit`, f being A's
/// value and t B's (1/sr).
struct ErrorMeasure {
  MetricPointer metric = findMetric("rms");
  ErrorAverage average = ErrorAverage::Absolute;
};

/// `measure` is a metric (findMetric), or "difference" or "absolute" for the signed and the absolute mean of rms.
/// `average` is "rms", "absolute", "signed", or "automatic": rms for a metric named. Throws Error::Kind::Value for
/// other names, and for a metric whose terms do not belong to pairs of directions (sphere).
BRDF_EXPORT ErrorMeasure parseErrorMeasure(std::string_view measure, std::string_view average = "automatic");
BRDF_EXPORT std::vector<std::string> errorAverageNames();
/// What is shown, with its unit, e.g. "mean of |f_A - f_B| (1/sr)".
BRDF_EXPORT std::string errorMeasureLabel(const ErrorMeasure& measure);
/// The error of one pair, e.g. "|f_A - f_B| (1/sr)".
BRDF_EXPORT std::string errorTermLabel(const ErrorMeasure& measure);

}  // namespace brdf
