#pragma once
#include <brdf/fit/FitData.h>
#include <brdf/fit/FitProblem.h>

#include <optional>
#include <vector>

namespace brdf {

/// Measures of a lobe's shape taken from its values at given pairs of directions. The values are read as those of a
/// microfacet model: times cos theta_i cos theta_o they follow the distribution of normals D(theta_h), whose share of
/// projected area cos theta_h D within a slope tan theta_h is known in closed form for the usual distributions: half of
/// it lies within alpha sqrt(ln 2) for Beckmann's, within alpha for GGX (Walter et al. 2007, "Microfacet Models for
/// Refraction through Rough Surfaces", doi:10.2312/EGWR/EGSR07/195-206, the sampling equations 28 and 35). Shadowing
/// and Fresnel's factor blur this; who compares values at the same pairs compares like with like.
struct LobeMeasures {
  double median = 0;     ///< ln of the slope within which half of the projected area lies
  double wide = 0;       ///< the same for nine tenths
  double grazing = 0;    ///< ln of how much higher D-corrected values are at theta_d > 50 degrees than below 30
  double stretched = 0;  ///< ln of the ratio of mean |slope| along x and y
};

/// Of values (1/sr) at the pairs, averaged over pairs of like theta_h, where noise below 0 cancels that above; empty
/// where they say nothing (nowhere above 0, or for one theta_h only).
BRDF_EXPORT std::optional<LobeMeasures> measureLobe(const DirectionPairs<double>& pairs, const double* values);

/// A starting shape read off the data: for one lobe after the other the shape, of a low-discrepancy set over its soft
/// bounds, whose measures are nearest to those of what the lobes before it leave of the data. A moment estimate: it
/// looks at no error, solves no scale factor while it searches, and sees at most 2048 samples. `data` has one channel
/// and one chunk. Lobes on which the data say nothing keep the request's start.
BRDF_EXPORT std::vector<double> shapeFromData(const FitProblem& problem, const FitData& data);

}  // namespace brdf
