#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>
#include <brdf/material/PatchBasis.h>

#include <memory>
#include <string>
#include <vector>

namespace brdf {

/// A matrix of values between patches of directions. f_r in 1/sr without the cosine: the mean over a pair of patches,
/// weighted by projected solid angle.
struct PatchData {
  /// Patches of the light's direction of travel seen from above, (-wi.x, -wi.y, wi.z): the mirror direction of a light
  /// lies in the patch of its own number when both bases are the same. (So do WINDOW and Radiance number them.)
  PatchBasis incident = PatchBasis::klemsFull();
  PatchBasis outgoing = PatchBasis::klemsFull();  ///< patches of wo
  Channels channels;
  /// Planar: channel c between incident i and outgoing o at [(c * outgoing.count() + o) * incident.count() + i].
  std::vector<double> values;
};

/// A BRDF that is constant on each pair of patches: what Klems matrices say and how Radiance evaluates them, without
/// interpolation. Directions that no patch holds (bases that end below 90 degrees) are invalid.
///
/// Its samples are the pairs of patches at their centres, incident fastest; each stands for the product of the two
/// projected solid angles. Its sampler is exact: a light patch by mean magnitude of the channels times projected solid
/// angle, then a direction uniform in projected solid angle; cosine-weighted where all is 0.
class BRDF_EXPORT PatchBrdf : public Brdf {
 public:
  /// Values that are not finite become 0. Throws Error::Kind::Value when there are not as many as patch pairs.
  PatchBrdf(PatchData data, std::string description);
  ~PatchBrdf() override;

  const PatchData& data() const { return data_; }
  /// For each incident patch (a channel together) the share of its light that leaves: sum of value times projected
  /// solid angle over the outgoing patches. 1 is all of it.
  std::vector<double> directionalAlbedos() const;

  const Channels& channels() const override { return data_.channels; }
  Symmetry symmetry() const override { return Symmetry::Anisotropic; }
  bool reciprocal() const override { return false; }
  std::string description() const override { return description_; }
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override;
  using Brdf::evaluate;
  void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
              const std::array<double*, 3>& wi, std::size_t count) const override;
  void pdf(const DirectionPairs<double>& pairs, double* density) const override;
  const SampleSet* samples() const override;

 private:
  class Pairs;
  std::size_t incidentPatch(double x, double y, double z) const { return data_.incident.find(-x, -y, z); }

  PatchData data_;
  std::string description_;
  std::unique_ptr<const Pairs> pairs_;
  /// For each outgoing patch the sums of value x projected solid angle over the incident patches up to each, 0 first.
  std::vector<double> cumulative_;
};

}  // namespace brdf
