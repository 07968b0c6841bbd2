#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/DirectionPairs.h>
#include <brdf/material/Brdf.h>
#include <brdf/material/SampleSet.h>

#include <memory>
#include <string>
#include <vector>

namespace brdf {

/// Measurements at directions of no particular order.
struct ScatteredSamples {
  Channels channels;
  DirectionPairBuffer<double> pairs;
  std::vector<double> values;  ///< 1/sr without the cosine, planar: channel c of sample i at [c * pairs.size() + i]
  std::vector<std::uint8_t> valid;  ///< 1 where the sample is a measurement; empty: all are
  bool isotropic = true;            ///< the surface may be turned about its normal, and mirrored
  /// Uncertainty of each value, as `values` is (1/sr, planar); what kind, the reader's report says. Empty: not known.
  std::vector<double> uncertainty;
};

/// A BRDF known at scattered direction pairs. `samples()` gives them in their own order; `evaluate` interpolates.
///
/// Method: moving least squares. The 16 nearest samples (20 when anisotropic) are blended by a local linear fit with
/// the weights ((R - d) / (R d))^2 of Franke and Little (R the distance of the next), which are infinite at a sample's
/// own directions and smooth elsewhere, so a sample's own value comes back. Values are interpolated as asinh(f / f0),
/// f0 a tenth of the median magnitude: like a logarithm over the decades of a specular peak, yet exact for zero and
/// negative values. Between samples that are not negative the result is not either. Distances are taken between
/// - isotropic: (sqrt(sin theta_h + 0.1), |d|, s.d / 4), where s and d are the sum and the difference of the
/// projections
///   of wi and wo on the surface: the same for turned and mirrored pairs, finer towards the mirror direction. The sign
///   of s.d keeps a pair apart from its swap, so reciprocity is not imposed on the data;
/// - anisotropic: (s stretched likewise, d), four coordinates.
/// Error, the Cornell files' samples (eight incidence angles, 10 degrees apart) predicted from others, median of
/// |difference| / value of the luminance: each from all others 1.5 % for garnet_red and 3.5 % for acryl_blue; each from
/// the other incidence angles 3.1 % and 8.9 %. Peaks that only one sample shows are lost when it is left out.
/// Valid at every pair above the horizon, far from any sample too, as long as one sample is valid.
class BRDF_EXPORT ScatteredBrdf : public Brdf {
 public:
  /// Invalid, non-finite and below-horizon samples become invalid samples of value 0. Throws Error::Kind::Value when
  /// the arrays disagree in length.
  ScatteredBrdf(ScatteredSamples samples, std::string description);
  ~ScatteredBrdf() override;

  const Channels& channels() const override { return data_.channels; }
  Symmetry symmetry() const override { return data_.isotropic ? Symmetry::Isotropic : Symmetry::Anisotropic; }
  bool reciprocal() const override { return false; }
  std::string description() const override { return description_; }
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override;
  using Brdf::evaluate;
  const SampleSet* samples() const override { return samples_.get(); }

  const ScatteredSamples& data() const { return data_; }

  /// For ValueOrigins: makes the flags of evaluate() CellStates. Measured within the convex hull of the nearest samples
  /// that interpolation uses, Extrapolated outside.
  void classify(const DirectionPairs<double>& pairs, std::uint8_t* states) const;

 private:
  class Samples;
  class Interpolator;
  template <int Dimensions>
  class TreeInterpolator;

  ScatteredSamples data_;
  std::string description_;
  std::unique_ptr<const SampleSet> samples_;
  std::unique_ptr<const Interpolator> interpolator_;  ///< null when no sample is valid
};

}  // namespace brdf
