// What this plugin brings; plugin.cpp registers it.
#pragma once
#include <brdf/fit/Metric.h>
#include <brdf/fit/Optimizer.h>
#include <brdf/material/Brdf.h>
#include <brdf/measured/Format.h>
#include <brdf/simulate/SurfaceKinds.h>

#include <string_view>

namespace workshop {

/// Residual: the difference of fourth roots of f cos(theta_i).
brdf::MetricPointer fourthRootMetric();

/// Compass search: tries a step along each axis both ways, takes the first that is better, halves the step when none
/// is (T. G. Kolda, R. M. Lewis, V. Torczon, "Optimization by Direct Search", SIAM Review 45(3), 2003, section 2,
/// doi:10.1137/S003614450242889).
brdf::OptimizerResult compassSearch(brdf::CostFunction& cost, std::vector<double> start,
                                    const brdf::OptimizerOptions& options);

/// Text files of our goniometer: a first line "workshop goniometer", then theta_i theta_o phi (degrees) and f (1/sr).
brdf::Format goniometerFormat();

/// Ridges along y, for simulations of light on them: roofs(slope=15, period=2).
brdf::SurfaceKind roofsSurface();

/// "DEGREES,MATERIAL": the material on a surface turned about its normal, counter-clockwise seen from above.
brdf::BrdfPointer turnedBrdf(std::string_view arguments);

}  // namespace workshop
