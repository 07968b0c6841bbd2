#pragma once
// The CPU backend of the virtual gonioreflectometer. Internal to libbrdf/simulate.
#include <brdf/simulate/Transport.h>
#include <brdf/simulate/cpu/TileScene.h>

#include <memory>
#include <vector>

namespace brdf {

struct PathGroup;

/// Paths on Embree, on all threads. Channels share a path: each has its own weight. Only refraction by an index that
/// differs among channels parts them; one is then drawn by what it carries. At its first meetings with a dielectric a
/// ray splits into what is reflected and what is refracted, later one of them is drawn; what carries little is ended by
/// chance (Russian roulette).
class CpuTransport : public Transport {
 public:
  CpuTransport(const Microsurface& surface, const TransportOptions& options);
  ~CpuTransport() override;

  void trace(const RayBatch& batch, const OutgoingBins& bins, Tally& tally) override;

  bool connects() const override { return connects_; }

  const TileScene& scene() const { return scene_; }

 private:
  struct PreparedFacet {
    Facet::Kind kind = Facet::Kind::Mirror;
    std::vector<double> first, second;  ///< one a channel: eta and k; eta and absorption; albedo
    BrdfPointer brdf;                   ///< with a sampler of its own
    bool dispersive = false;            ///< eta differs among channels
    bool absorbs = false;
  };

  void traceGroup(const RayBatch& batch, const OutgoingBins& bins, std::uint64_t first, std::size_t count,
                  PathGroup& group, Tally& tally) const;
  void advance(PathGroup& group, std::size_t path) const;
  /// False where the path ended or waits for scatter().
  bool interact(PathGroup& group, std::size_t path) const;
  void meetDielectric(PathGroup& group, std::size_t path, bool front, double cosine) const;
  void absorbAlong(PathGroup& group, std::size_t path, double distance) const;
  /// What a Lambertian facet, whose share of the path is in the weights already, sends to every bin.
  void connect(PathGroup& group, std::size_t path) const;
  void scatter(PathGroup& group, std::size_t facet) const;
  bool survives(PathGroup& group, std::size_t path) const;
  void tallyGroup(PathGroup& group, std::size_t rays, const OutgoingBins& bins, Tally& tally) const;
  void leave(PathGroup& group, std::size_t path, bool above) const;
  double index(int medium, std::size_t channel) const;

  TileScene scene_;
  std::vector<PreparedFacet> facets_;
  std::size_t channels_, bounces_;
  bool dispersive_ = false, connects_ = false;
};

}  // namespace brdf
