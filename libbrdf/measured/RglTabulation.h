#pragma once
#include <brdf/brdf_export.h>
#include <brdf/measured/RglBrdf.h>

namespace brdf {

/// How finely tabulateRgl samples.
struct RglResolution {
  std::size_t theta = 32;  ///< polar angles of viewers, 0 to 89 degrees, even in the square root of the rest to 90
  std::size_t phi = 25;    ///< azimuths of viewers over a full turn, the first twice; 1 for an isotropic BRDF
  std::size_t microfacets = 128;  ///< polar angles of half vectors
  std::size_t azimuths = 64;      ///< and azimuths
  std::size_t lights = 64;        ///< along either side of the square of lights
};

/// Any BRDF as an RGL file holds it. The distribution of half vectors is made of its luminance at retro-reflection and
/// about the normal's mirror pairs, over a diffuse ground: it decides how finely directions are sampled, not what the
/// values are: at the nodes the values come back. `brdf` has RGB or spectral channels.
BRDF_EXPORT RglData tabulateRgl(const Brdf& brdf, const RglResolution& resolution = {});

}  // namespace brdf
