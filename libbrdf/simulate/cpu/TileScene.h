#pragma once
// A microsurface, ready for rays. Internal to libbrdf/simulate.
#include <brdf/simulate/cpu/Media.h>
#include <brdf/simulate/cpu/TileShapes.h>

#include <memory>
#include <variant>
#include <vector>

namespace brdf {

/// The tile, repeated without end, between a plane above everything and one below. Immutable; safe to share among
/// threads. Spheres and the plane of a packing are met in double precision, triangles in float; points on them are
/// double again.
class TileScene {
 public:
  /// Throws Error::Kind::Value for more than 2^27 primitives, Error::Kind::Device where Embree fails.
  explicit TileScene(const Microsurface& surface);
  ~TileScene();
  TileScene(const TileScene&) = delete;
  TileScene& operator=(const TileScene&) = delete;

  enum class End {
    Facet,   ///< met one
    Above,   ///< left through the upper plane
    Below,   ///< left through the lower plane
    Nowhere  ///< crossed a million tiles without meeting anything
  };
  /// Moves the ray to where it meets a facet or leaves. `distance` becomes the way it went, `meeting` what it met.
  /// `media` tells facets that it comes from rather than meets: those rounding left it a little on the wrong side of.
  /// Adds to `queries` the Embree queries made.
  End follow(DoubleRay& ray, const Media& media, Meeting& meeting, double& distance, std::uint64_t& queries) const;

  /// A point of the upper plane by its place in the block, both in [0, 1).
  Direction above(double u, double v) const { return {u * block_.width, v * block_.depth, highest_}; }
  /// Puts the ray's origin beside the facet it met, on the side to which its direction points.
  static void leave(DoubleRay& ray, const Meeting& meeting);

  /// Slot of a facet's dielectric in Media; Media::kNone for other facets.
  int medium(std::size_t facet) const { return mediumOf_[facet]; }
  std::size_t facetOf(int medium) const { return facetOf_[static_cast<std::size_t>(medium)]; }
  /// Whether light that leaves below from `media` is transmitted; else it fell through a surface without holes.
  bool transmitsBelow(const Media& media) const { return open_ || media.within(below_); }

  const TileBlock& block() const { return block_; }
  RTCScene scene() const { return scene_; }
  double highest() const { return highest_; }
  double lowest() const { return lowest_; }

 private:
  bool query(const DoubleRay& ray, double least, double most, RTCRayHit& hit) const;
  bool meetFacet(const DoubleRay& ray, double most, const Media& media, Meeting& meeting, double& distance,
                 std::uint64_t& queries) const;
  void wrap(DoubleRay& ray) const;

  std::variant<FieldTiles, MeshTiles, SphereTiles> shape_;
  TileBlock block_;
  double lowest_ = 0, highest_ = 0;
  bool plane_ = false;  ///< the plane of a packing
  bool open_ = false;   ///< light may pass without meeting a dielectric
  int below_ = Media::kNone;
  std::vector<int> mediumOf_;
  std::vector<std::size_t> facetOf_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace brdf
