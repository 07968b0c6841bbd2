#pragma once
#include <brdf/brdf_export.h>
#include <brdf/io/Image.h>

#include <cstddef>
#include <span>
#include <vector>

namespace brdf {

/// Mean and standard error of every number of a picture whose points are not independent: each pixel is estimated by
/// several replicates, the same low-discrepancy points randomised independently. The points of a replicate spread
/// better than random ones, so that their scatter says nothing about the error; the replicates are independent and
/// unbiased, so that theirs does: the variance of the mean of R replicates m_r is sum_r (m_r - mean)^2 / (R (R - 1))
/// (L'Ecuyer and Lemieux 2002, "Recent Advances in Randomized Quasi-Monte Carlo Methods",
/// doi 10.1007/0-306-48102-2_20).
///
/// Sums are in double: 32 bytes a pixel and replicate.
class BRDF_EXPORT ReplicateFilm {
 public:
  /// With 8 replicates the standard error of one number is itself known to 1 / sqrt(2 * 7) = 27 %, that of a picture of
  /// many pixels much better; more replicates are less well spread for the same number of points.
  static constexpr std::size_t kReplicates = 8;

  /// Throws Error::Kind::Value above 4096 x 4096 pixels (4.3 GB).
  ReplicateFilm(std::size_t width, std::size_t height);

  /// Adds to one replicate the mean of `points` further points: R, G, B, A by pixel, rows from the top down or all from
  /// the bottom up. A number that is not finite counts as 0 and its pixel is counted in `notFinite`.
  void add(std::size_t replicate, std::span<const float> rgba, std::size_t points);

  /// Points a pixel of all replicates together.
  std::size_t points() const;
  /// Standard error of the luminance (Rec. 709), root mean square over the picture, over the picture's mean luminance:
  /// as ReferenceOptions::tolerance. Infinite for a black picture with scatter. All replicates must have as many
  /// points.
  double relativeError() const;
  /// Three channels, rows in the order that they were given in.
  Image mean() const;
  Image standardError() const;
  /// Numbers that were not finite, of all that were added.
  std::size_t notFinite() const { return notFinite_; }

 private:
  const double* sums(std::size_t replicate) const { return sums_.data() + replicate * 4 * width_ * height_; }

  std::size_t width_, height_;
  std::vector<double> sums_;         ///< by replicate, pixel, channel: value times points, R G B A
  std::vector<std::size_t> points_;  ///< by replicate
  std::size_t notFinite_ = 0;
};

}  // namespace brdf
