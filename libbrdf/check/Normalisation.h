#pragma once
#include <brdf/brdf_export.h>
#include <brdf/models/FormulaModel.h>

#include <span>

namespace brdf {

/// The integral of D(h) cos(theta_h) over the hemisphere of the model's distribution `which` (FormulaModel's
/// distributions()), 1 where it is normalised (Walter et al. 2007, "Microfacet models for refraction through rough
/// surfaces", (4)): midpoints of even steps in log tan theta_h and log tan phi_h, in which a peak of any width at the
/// normal and any stretch along x or y is as wide as any other; the rule converges exponentially for smooth D. An
/// isotropic model's is taken at one azimuth.
BRDF_EXPORT double distributionIntegral(const FormulaModel& model, std::size_t which,
                                        std::span<const double> parameters);

}  // namespace brdf
