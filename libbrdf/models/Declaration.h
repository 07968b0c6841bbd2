#pragma once
#include <limits>
#include <string>

namespace brdf {

/// A law that a model does not keep as others must, by its authors' choice or by its formula's nature:
///
///   <declares check="NAME" [allowed="number"]>reason</declares>
///
/// in its record. The audit (check/Check.h) measures the law all the same. The names:
/// - energy: its albedo may exceed 1 (`allowed`: up to that);
/// - normalisation: the integral of D cos(theta_h) is not 1 (`allowed`: differs by up to that);
/// - double_accuracy, float_accuracy: the relative error against the exact value that `allowed` states;
/// - zero_crossing: a term passes through zero, where it is clamped: beside it, errors are measured in units of the
/// last
///   place of the lobe's peak.
struct Declaration {
  std::string check;
  double allowed = std::numeric_limits<double>::infinity();
  std::string reason;
};

}  // namespace brdf
