#pragma once
#include <brdf/fit/Cost.h>

#include <optional>

namespace brdf {

/// Appends the fitted numbers of one group of channels to the report, with standard errors from the covariance
/// sigma^2 (J'J)^-1, sigma^2 = RSS / (n - p), J the derivative of the metric's residuals with respect to all free
/// parameters that are not on a bound (shape and scale factors together). This holds for residuals that are independent
/// and of equal spread; a model that does not describe the data leaves residuals that are neither. Notes name
/// parameters on bounds, combinations that the data do not determine, and lobes without a share. `channel`: the channel
/// that shape parameters belong to when every channel has its own.
void describeParameters(const FitProblem& problem, const FitData& data, ChannelRange channels,
                        std::optional<std::size_t> channel, std::span<const double> shape, const Scales& scales,
                        FitReport& report);

}  // namespace brdf
