#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>

#include <string>
#include <vector>

namespace brdf {

/// Something about measured data that a wrong convention would explain.
struct LintFinding {
  std::string check;     ///< "energy", "grazing", "reciprocity", "angles", "negative", "zero", "highlight"
  std::string evidence;  ///< one sentence with the numbers
  std::string option;    ///< the read option that would change it ("quantity=brdf_cos"), or empty

  /// "check: evidence (option ...)".
  BRDF_EXPORT std::string sentence() const;
};

/// Looks at the samples of a measured BRDF (about 16000 of them, evenly drawn) for signs that it was read by the wrong
/// conventions. An unusual material may show the same signs: findings are to be judged, not obeyed.
/// - energy: a directional albedo above 1.05 (the error of the quadrature is below 0.02 for what is no spike);
/// - grazing: off the highlight, values that follow cos(theta_o)^p with p above 0.7 or below -0.7;
/// - reciprocity: a median asymmetry above 0.2 of samples whose directions are exchanged (within 3 degrees), and
/// whether
///   multiplying or dividing by cos(theta_o) mends it;
/// - angles: no polar angle above 1.6 degrees, as radians read as degrees would have;
/// - negative: one negative value that repeats, as a mark for "not measured" does;
/// - zero: zeros apart from the other values, as such marks are;
/// - highlight: a peak more than 30 degrees from the mirror direction.
/// Nothing for a BRDF without samples.
BRDF_EXPORT std::vector<LintFinding> lint(const Brdf& brdf);

}  // namespace brdf
