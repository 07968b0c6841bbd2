#pragma once
#include <brdf/brdf_export.h>
#include <brdf/fit/Fit.h>
#include <brdf/io/Container.h>

namespace brdf {

/// Keeps a fit's report with its container entry, whose BRDF is the report's material:
///
///   writer.add("fit", *report.material, provenance) -> group; storeFit(group, report)
///
/// Group Fit of the entry: attributes Metric, Error, Optimizer, Strategy, Seconds, Evaluations, Iterations, Samples,
/// Channels, Converged, Termination, Notes, MetricFormula, Sampling, Weights, ChannelNames, MaximumTheta (degrees),
/// SamplesOffered, ConstantError; list ConstantModel (1/sr, one number a channel); groups Metrics and ZeroModel with
/// one number a metric; group Parameters with one list a column (Channel -1: shared by all channels; StandardError NaN:
/// not determined).
BRDF_EXPORT void storeFit(const h5::Group& entry, const FitReport& report);

/// The report stored with entry `index`. Throws Error::Kind::Value when the entry is no fit, and Error::Kind::Format
/// when the report is damaged.
BRDF_EXPORT FitReport loadFit(const Container& container, std::size_t index);

}  // namespace brdf
