#pragma once
#include <brdf/render/RayCaster.h>
#include <brdf/render/SceneLighting.h>
#include <brdf/sampling/PathRandom.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace brdf {

/// Estimates the radiance that comes back along camera rays: path tracing with next-event estimation, environment and
/// BRDF sampling combined by the balance heuristic (Veach and Guibas 1995, "Optimally Combining Sampling Techniques for
/// Monte Carlo Rendering", eq. 14), many paths in step so that a material is evaluated in batches. One path a ray; the
/// mean over rays is unbiased.
class PathIntegrator {
 public:
  /// `bounces`: surfaces that light may meet on its way to the camera, at least 1; 1 is direct light only.
  PathIntegrator(const Scene& scene, std::size_t bounces);

  /// radiance[k] for rays[k], with the random numbers randoms[k]; covered[k] is 1 where the ray meets an object, else
  /// 0. Adds to `invalid` the evaluations where a material has no value (taken for 0), to `evaluations` all. Safe to
  /// call on several threads.
  void trace(std::span<const Ray> rays, std::span<PathRandom> randoms, Rgb* radiance, std::uint8_t* covered,
             std::uint64_t& evaluations, std::uint64_t& invalid) const;

 private:
  struct Path;
  struct Batch;
  void shade(std::span<Path> paths, bool last, Batch& batch, Rgb* radiance) const;
  void addLight(const SceneLight& light, std::span<Path> paths, Batch& batch, Rgb* radiance) const;
  void addEnvironment(std::span<Path> paths, Batch& batch, Rgb* radiance) const;
  void scatter(std::span<Path> paths, Batch& batch) const;

  RayCaster caster_;
  std::vector<BrdfPointer> materials_;  ///< RGB, with samplers
  std::vector<SceneLight> lights_;
  std::optional<SceneLighting> lighting_;
  bool environmentVisible_;  ///< behind the objects
  std::size_t bounces_;
};

}  // namespace brdf
