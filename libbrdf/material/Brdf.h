#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/material/Channels.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace brdf {

class SampleSet;

/// How a BRDF behaves when the surface is turned about its normal.
enum class Symmetry {
  Isotropic,   ///< depends on phi_i - phi_o only, and not on its sign
  Bilateral,   ///< depends on phi_i - phi_o, sign included (or mirror-symmetric anisotropic)
  Anisotropic  ///< no symmetry
};

/// A bidirectional reflectance distribution function: any kind, immutable, safe to share among threads.
///
/// Conventions, pinned by tests/material/ConventionsTest.cpp (a Lambertian of albedo a has the value a/pi everywhere):
/// - Local frame: normal +z, tangent +x; `wi` points to the light, `wo` to the viewer, both unit.
/// - A value is f_r in 1/sr WITHOUT the cosine.
/// - Where either cosine is <= 0 the value is 0 (and valid): there is no reflection from below the horizon.
/// - Values are planar: channel c of pair i is `values[c * pairs.count + i]`.
/// - Invalid is not zero: where a BRDF has no value (an unmeasured cell, say) `valid[i]` is 0 and the values are 0.
///   `valid` may be null when the caller takes invalid for zero.
class BRDF_EXPORT Brdf {
 public:
  virtual ~Brdf();

  virtual const Channels& channels() const = 0;
  virtual Symmetry symmetry() const = 0;

  /// Whether f(wi, wo) = f(wo, wi) holds by construction.
  virtual bool reciprocal() const = 0;

  /// What it is, in one line: a material expression that reads back, or kind and source of measured data.
  virtual std::string description() const = 0;

  /// Values for a batch, on the calling thread. `values` holds channels().count() * pairs.count numbers, `valid` (or
  /// null) pairs.count flags.
  virtual void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const = 0;

  /// The same in float; by default by way of double.
  virtual void evaluate(const DirectionPairs<float>& pairs, float* values, std::uint8_t* valid) const;

  /// Draws a light direction for each viewer direction from two random numbers in [0, 1). `wo`, `u` and `wi` are
  /// component arrays of `count` numbers; a draw that fails (below the horizon) is (0, 0, 0) and carries no light.
  /// By default cosine-weighted.
  virtual void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
                      const std::array<double*, 3>& wi, std::size_t count) const;

  /// Density of `sample` drawing wi given wo, per solid angle (1/sr).
  virtual void pdf(const DirectionPairs<double>& pairs, double* density) const;

  /// The measured samples behind this BRDF, or null when it has none (an analytic one).
  virtual const SampleSet* samples() const { return nullptr; }

  // ----- conveniences over the batch interface -----------------------------------------------------------------

  /// Values for one pair, one number a channel.
  std::vector<double> evaluate(const std::array<double, 3>& wi, const std::array<double, 3>& wo) const;

  /// Evaluates a large batch on all threads.
  void evaluateParallel(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const;
};

using BrdfPointer = std::shared_ptr<const Brdf>;

}  // namespace brdf
