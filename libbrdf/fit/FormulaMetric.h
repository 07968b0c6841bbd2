#pragma once
#include <brdf/fit/Metric.h>

namespace brdf {

/// A metric whose residual is a formula, as findMetric() describes it. Where the slope has no finite value that at f =
/// 1e-6/sr stands for it, or 0.
MetricPointer makeFormulaMetric(std::string_view text);

}  // namespace brdf
