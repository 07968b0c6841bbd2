#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/geometry/Directions.h>
#include <brdf/models/Model.h>

#include <string>
#include <vector>

namespace brdf {

/// Direction pairs above the horizon.
struct BRDF_EXPORT CheckPairs {
  DirectionPairBuffer<double> pairs;

  std::size_t size() const { return pairs.size(); }
  Direction wi(std::size_t k) const { return {pairs.wi[0][k], pairs.wi[1][k], pairs.wi[2][k]}; }
  Direction wo(std::size_t k) const { return {pairs.wo[0][k], pairs.wo[1][k], pairs.wo[2][k]}; }
  DirectionPairBuffer<float> narrow() const;  ///< rounded to float
  CheckPairs rounded() const;                 ///< the same numbers in double
};

/// `perKind` pairs of each of twelve kinds: random, near and at the mirror direction, near and at the viewer, half
/// vectors at the scale of sharp lobes, normal viewers, and grazing up to 89.9999 degrees on either side, on both, and
/// there near the mirror and the retro direction. `horizon` adds cosines of 6e-17, 1e-20 and 1e-30.
BRDF_EXPORT CheckPairs adversarialPairs(std::size_t perKind, unsigned seed, bool horizon);

/// Parameters of a model, one number each, and where they lie.
struct BRDF_EXPORT ParameterCase {
  std::vector<double> values;
  std::string name;
  bool soft = true;  ///< inside the soft bounds
};

/// The defaults, the ends of the soft bounds, and `count` random places inside (in the logarithm where the scale is).
BRDF_EXPORT std::vector<ParameterCase> softCases(const Model& model, std::size_t count, unsigned seed);
/// The ends of the hard bounds, `count` random corners, and each parameter at either bound with the others at their
/// defaults.
BRDF_EXPORT std::vector<ParameterCase> hardCases(const Model& model, std::size_t count, unsigned seed);

/// "GGX(alpha=0.1, ior=1.5)".
BRDF_EXPORT std::string parameterText(const Model& model, const std::vector<double>& values);
/// "theta_i 45 phi_i 0 theta_o 60 phi_o 180 deg".
BRDF_EXPORT std::string directionText(const Direction& wi, const Direction& wo);

}  // namespace brdf
