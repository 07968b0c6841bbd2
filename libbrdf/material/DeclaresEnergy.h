#pragma once
#include <string>

namespace brdf {

/// A BRDF that by its theory may reflect more than it receives (a first order without bound, facets without shadowing)
/// says so by deriving from this class too; the audit (check/Check.h) then measures the albedo and demands nothing.
class DeclaresEnergy {
 public:
  virtual ~DeclaresEnergy() = default;
  /// Why, in one sentence without a full stop; empty where it keeps energy.
  virtual std::string energyNote() const = 0;
};

}  // namespace brdf
