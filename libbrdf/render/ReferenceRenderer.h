#pragma once
#include <brdf/brdf_export.h>
#include <brdf/io/Image.h>
#include <brdf/render/Scene.h>

#include <cstdint>
#include <functional>

namespace brdf {

struct ReferenceOptions {
  std::size_t samples = 256;  ///< paths a pixel, at most; 2 or more
  /// Stop when the standard error of the luminance, root mean square over the film, is below this part of the film's
  /// mean luminance; 0: draw all samples.
  double tolerance = 0;
  std::size_t bounces = 1;    ///< surfaces that light may meet on its way to the camera; 1: direct light only
  bool pixelCentres = false;  ///< all rays through the centres of pixels (what a rasteriser shades); else spread evenly
  std::uint64_t seed = 1;     ///< the same picture for the same seed, on any number of threads
  /// Called after each pass with samples done, samples at most and the error so far (of the tolerance's kind); return
  /// false to stop with what is there.
  std::function<bool(std::size_t done, std::size_t most, double error)> progress;
};

struct ReferencePicture {
  Image radiance;            ///< linear sRGB, W/(m^2 sr) in the units of the lights; R, G, B, A over no background
  Image standardError;       ///< of each number in `radiance`, from the scatter of its samples
  std::size_t samples = 0;   ///< drawn a pixel
  double relativeError = 0;  ///< as `tolerance` means it
  bool converged = false;    ///< relativeError <= tolerance
  bool stopped = false;      ///< by the progress function
  double invalidShare = 0;   ///< of the evaluations: where a material has no value it is taken for black
  double seconds = 0;
};

/// Draws a scene by path tracing on the CPU, in double precision: unbiased, with a standard error for every pixel (the
/// paths of a pixel are independent). The truth that other renderings are compared with. Throws as checkScene does, and
/// Error::Kind::Value for options out of range.
BRDF_EXPORT ReferencePicture renderReference(const Scene& scene, const ReferenceOptions& options = {});

}  // namespace brdf
