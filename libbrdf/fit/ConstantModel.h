#pragma once
#include <brdf/fit/FitData.h>

#include <vector>

namespace brdf {

/// The constant BRDF that a fit has to beat.
struct ConstantModel {
  std::vector<double> values;  ///< of each channel, at least 0, 1/sr
  double error = 0;            ///< root of the weighted mean of squared residuals over samples and channels
};

/// The constant of least error: by linear least squares where the metric is quadratic; else found on 8192 of the
/// samples and improved by two Gauss-Newton steps on all; by Levenberg-Marquardt for pictures
/// (FitData::pairsAResidual).
BRDF_EXPORT ConstantModel bestConstant(const FitData& data);

}  // namespace brdf
