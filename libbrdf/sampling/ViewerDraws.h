#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace brdf {

/// Draws of light directions made in advance for a set of viewers, of a BRDF that may be turned about the normal: a
/// shader that sums light by importance sampling reads them and needs neither sampler nor density nor value.
///
/// Viewer t of kViewers stands at the polar angle 90 (1 - (1 - t / (kViewers - 1))^2) degrees, the last at 89.94, in
/// the x-z plane. Draw i of a set is made, for all viewers, from point i of the lattice (i / samples, i / golden
/// ratio), shifted in each set by other numbers. A viewer in between takes draw i of one or the other neighbour, in
/// proportion to their nearness, and of the draw the half vector: as it is, which keeps mirror-like peaks where they
/// belong, or turned with the viewer, which keeps retro-reflective ones. Which of the two is drawn too, by the squared
/// sines of theta_d and theta_h, so that both are parts of the BRDF that change little between viewers. What is off in
/// the mean is the linear interpolation of these parts: see tests/sampling/ViewerDrawsTest.cpp.
struct ViewerDraws {
  static constexpr std::size_t kViewers = 128;
  std::size_t samples = 0;  ///< draws of a set that count
  std::size_t stride = 0;   ///< the next multiple of 4: draws of a set with those of weight 0 that fill it up
  std::size_t sets = 0;
  /// For every viewer, every set and every draw four words. Three are floats: x / z and y / z of the half vector h; the
  /// solid angle that the draw stands for, 1 / density (sr), times q^3 with q = 1 / (2 h.z^2), negative where h is to
  /// be turned with the viewer. Between them the weight value * cos / density: of a monochrome BRDF a float; of an RGB
  /// one R, G, B in 9 bits each, two's complement, from the lowest on and an exponent e above, each worth its 9 bits
  /// times 2^(e - 31) times `unit`. A draw that fails has the weight 0.
  std::vector<std::uint32_t> words;
  float unit = 1;
};

/// Sets of draws by `brdf`'s own sampler, on all threads. Throws Error::Kind::Value for channels other than monochrome
/// and RGB, and for a BRDF that may not be turned.
BRDF_EXPORT ViewerDraws viewerDraws(const Brdf& brdf, std::size_t samples, std::size_t sets);

}  // namespace brdf
