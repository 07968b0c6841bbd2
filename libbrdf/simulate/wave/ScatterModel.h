#pragma once
#include <brdf/material/Brdf.h>
#include <brdf/material/Components.h>
#include <brdf/simulate/wave/Geometry.h>

#include <memory>

namespace brdf::wave {

/// What a surface scatters at one wavelength: Mueller matrices whose element m00 is the BRDF for unpolarised light in
/// 1/sr, without the cosine. Immutable; evaluated in batches on the calling thread.
class BRDF_EXPORT ScatterModel {
 public:
  virtual ~ScatterModel();

  /// Whether `jones` says it all. Others implement `mueller`.
  virtual bool deterministic() const { return true; }
  /// Amplitudes whose squares are BRDFs, up to a phase common to the four. Only where deterministic.
  virtual void jones(const Geometry* geometry, std::size_t count, Jones* values) const;
  /// By default from the Jones matrices.
  virtual void mueller(const Geometry* geometry, std::size_t count, Mueller* values) const;
  /// Element m00, by default from the Jones matrices.
  virtual void unpolarized(const Geometry* geometry, std::size_t count, double* values) const;

  virtual Symmetry symmetry() const { return Symmetry::Isotropic; }
  virtual bool reciprocal() const { return true; }
  /// Why the directional albedo may exceed 1, in one sentence; empty where it does not.
  virtual std::string energyNote() const { return {}; }

  /// The fraction of unpolarised light of polar angle theta (radians) that leaves undiffracted in the mirror direction;
  /// 0 where the model has no such part or says nothing about it.
  virtual double specular(double theta) const;
};
using ScatterModelPointer = std::shared_ptr<const ScatterModel>;

}  // namespace brdf::wave
