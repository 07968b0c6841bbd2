#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>
#include <brdf/material/TensorTree.h>

#include <memory>
#include <mutex>
#include <span>
#include <string>

namespace brdf {

/// Coordinates of a direction pair in a tensor tree, as Radiance defines them (geometry/DiskSquare.h; the light enters
/// by its direction of travel seen from above, (-wi.x, -wi.y)):
/// - rank 4: x0, x1 = diskToSquare(-wi.x, -wi.y); x2, x3 = diskToSquare(wo.x, wo.y);
/// - rank 3, surfaces that may be turned: x0 = (1 - sin theta_i)/2, so that only x0 < 1/2 is used; x1, x2 =
///   diskToSquare of wo turned by minus the azimuth of (-wi.x, -wi.y): the mirror direction lies on x2 = 1/2, x1 > 1/2.
BRDF_EXPORT TensorTree::Point treePoint(int rank, const std::array<double, 3>& wi, const std::array<double, 3>& wo);

/// A BRDF that is constant on the cells of a tensor tree: of high resolution where it changes fast, coarse elsewhere;
/// no interpolation. f_r in 1/sr without the cosine, the channels of a cell together.
///
/// Sampling descends the tree for the viewer given, along the means over the light's coordinates, and ends with a
/// direction uniform in projected solid angle within a cell. Rank 4: exactly by the mean magnitude of the channels.
/// Rank 3 holds no distribution of lights for a viewer: there the roles are exchanged, which is exact for reciprocal
/// data, and a tenth of the draws is cosine-weighted, so that nothing is missed in others. Cosine-weighted where all is
/// 0. Tables for it (about the size of the tree) are made at the first draw.
class BRDF_EXPORT TreeBrdf : public Brdf {
 public:
  /// Values that are not finite become 0. Throws Error::Kind::Value for a tree of another rank than 3 and 4, or of
  /// another number of channels.
  TreeBrdf(TensorTree tree, Channels channels, std::string description);
  ~TreeBrdf() override;

  const TensorTree& tree() const { return tree_; }
  /// The largest share of light that leaves, over all incident directions, of the channels' sum with these weights: pi
  /// times the mean over the outgoing coordinates. 1 is all of it.
  double largestAlbedo(std::span<const double> channelWeights) const;

  const Channels& channels() const override { return channels_; }
  /// Rank 3: isotropic where the values are the same on both sides of the plane of incidence (to 1e-9), else bilateral.
  Symmetry symmetry() const override { return symmetry_; }
  bool reciprocal() const override { return false; }
  std::string description() const override { return description_; }
  void evaluate(const DirectionPairs<double>& pairs, double* values, std::uint8_t* valid) const override;
  using Brdf::evaluate;
  void sample(const std::array<const double*, 3>& wo, const std::array<const double*, 2>& u,
              const std::array<double*, 3>& wi, std::size_t count) const override;
  void pdf(const DirectionPairs<double>& pairs, double* density) const override;

 private:
  const TreeMarginal& sampler() const;

  TensorTree tree_;
  Channels channels_;
  std::string description_;
  Symmetry symmetry_;
  std::vector<double> magnitude_;  ///< of each cell: mean over the channels
  mutable std::once_flag once_;
  mutable std::unique_ptr<const TreeMarginal> sampler_;
};

}  // namespace brdf
