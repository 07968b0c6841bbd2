#pragma once
#include <brdf/fit/Fit.h>
#include <brdf/fit/Metric.h>
#include <brdf/fit/Samples.h>

namespace brdf {

/// compare() for BRDFs that have the same channels, on given samples. `b` null: the samples' own values are b's.
/// `metric`: one to judge by besides allMetrics(), or null. Metrics that take their scale from the data and are not
/// given it (`metric` may be such a one, scaled) take it from b's values.
Comparison compareOn(const SampleSet& samples, const Brdf& a, const Brdf* b, const SampleRule& rule,
                     const MetricPointer& metric = nullptr);

}  // namespace brdf
