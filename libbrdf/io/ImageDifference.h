#pragma once
#include <brdf/brdf_export.h>
#include <brdf/io/Image.h>

#include <cstddef>

namespace brdf {

/// How far a picture of radiance may be from another one, by channel: |a - b| <= absolute + relative |b|.
struct ImageTolerance {
  double absolute = 1e-4;  ///< in the pictures' unit, 0 or more
  double relative = 0.01;  ///< 0 or more
  double outliers = 0;     ///< share of the pixels, 0 to 1, that may be farther
};

struct ImageDifference {
  std::size_t outliers = 0;  ///< pixels with a channel farther than allowed, or not finite in one picture alone
  double worst = 0;          ///< largest |a - b| / (absolute + relative |b|); infinite where one is not finite
  std::size_t worstX = 0, worstY = 0;  ///< its pixel, y from the top
  double rms = 0;                      ///< of a - b over pixels and channels that are finite in both
  bool within = false;                 ///< outliers / pixels <= tolerance.outliers
};

/// Compares picture `a` with the picture `b` that it should be. Throws Error::Kind::Value when their sizes or channels
/// differ, they are empty, or the tolerance is out of its range.
BRDF_EXPORT ImageDifference imageDifference(const Image& a, const Image& b, const ImageTolerance& tolerance);

}  // namespace brdf
