#pragma once
#include <brdf/fit/Fit.h>

namespace brdf {

/// compare() for BRDFs that have the same channels, on given samples. `b` null: the samples' own values are b's.
Comparison compareOn(const SampleSet& samples, const Brdf& a, const Brdf* b, double maximumTheta);

}  // namespace brdf
