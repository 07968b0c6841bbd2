#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/material/Brdf.h>
#include <brdf/view/LobeTransform.h>

#include <vector>

namespace brdf {

struct LobeSampleOptions {
  double thetaI = radians(45);  ///< incident polar angle, [0, pi/2)
  double phiI = 0;              ///< incident azimuth
  double within = radians(2);   ///< samples whose incident direction lies within this angle, [0, pi]
  LobeScale scale;
  std::vector<double> weights;   ///< the value shown is the sum of weight * channel; empty: the mean of all channels
  std::size_t maximum = 20'000;  ///< of more samples every second, fourth... is kept; at least 1
};

/// The measured samples of a BRDF that belong to its lobe for one incident direction.
struct LobeSamples {
  std::vector<Direction> directions;  ///< of view
  std::vector<double> values;         ///< the value shown, 1/sr
  std::vector<double> lengths;        ///< transformed
  /// Transformed value of the model, at the sample's own directions, less that of the sample; 0 where the model has
  /// none. Empty without a model.
  std::vector<double> residuals;
  std::size_t found = 0;     ///< within the angle, kept or not
  double nearest = kPi;      ///< the smallest angle of a sample's incident direction from the one asked for
};

/// Of BRDFs that do not depend on turns about the normal each sample is turned to the incident azimuth first, so that
/// only the polar angle must agree; of reciprocal ones each counts with light and viewer exchanged, too. `model` has
/// the channels of `measured`, or is null. Throws Error::Kind::Value for a BRDF without samples and options out of
/// range.
BRDF_EXPORT LobeSamples lobeSamples(const Brdf& measured, const LobeSampleOptions& options,
                                    const Brdf* model = nullptr);

}  // namespace brdf
