#pragma once
#include <brdf/brdf_export.h>
#include <brdf/render/Ray.h>
#include <brdf/render/Scene.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace brdf {

/// What light reaches the surface seen through each pixel of a film, by rays: for shaders, which cast none.
///
/// The first layer of `words` holds the lights besides the environment: bit i of a pixel's first word is 1 where light
/// i is seen. The other layers hold the environment as cells x cells cells of the octahedral square of its map's
/// directions (OctahedralMap): bit k % 32 of word (k / 32) % 4 of layer 1 + k / 128 is 1 where it is seen in cell k =
/// cells * row + column, looked at in one direction of the cell, drawn by the map's luminance from the part that faces
/// the surface. So each bit is right on average (the share of the cell's light that is seen) and coarse by itself; new
/// seeds draw new directions.
struct ShadowMask {
  std::size_t width = 0, height = 0;  ///< rows from the bottom, as OpenGL has them
  std::size_t cells = 0;              ///< a side; 0: lights only
  std::size_t layers = 0;
  std::vector<std::uint32_t> words;  ///< four a pixel, layer by layer
};

struct ShadowOptions {
  std::size_t width = 0, height = 0;  ///< of the film, pixels
  std::uint64_t seed = 0;
  /// The ray through a place of the film in pixels from its lower left corner, y upwards.
  std::function<Ray(double x, double y)> through;
  /// Where given, one number a pixel: those with 0 are left out.
  const std::vector<float>* wanted = nullptr;
};

class BRDF_EXPORT ShadowCaster {
 public:
  /// Takes the scene's objects, lights (at most 32) and environment; materials and camera are not looked at.
  /// `cells`: of the environment, a side: a power of two up to 64; 0 for none.
  ShadowCaster(const Scene& scene, std::size_t cells);
  ~ShadowCaster();
  ShadowCaster(const ShadowCaster&) = delete;
  ShadowCaster& operator=(const ShadowCaster&) = delete;

  /// Fills `mask`, keeping what was cast before where a pixel is not wanted again. Pixels that see no object count as
  /// lit. On all threads.
  void cast(const ShadowOptions& options, ShadowMask& mask) const;

 private:
  struct Pixel;
  void castLights(Pixel& pixel) const;
  void castEnvironment(Pixel& pixel, std::size_t stride) const;

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace brdf
