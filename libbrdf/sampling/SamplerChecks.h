#pragma once
#include <brdf/brdf_export.h>
#include <brdf/geometry/Directions.h>
#include <brdf/sampling/SamplerEfficiency.h>

#include <cstdint>
#include <span>

namespace brdf {

/// Pearson's chi-square of observed counts against expected ones.
struct ChiSquare {
  double statistic = 0;
  std::size_t cells = 0;   ///< after pooling; the degrees of freedom are one less
  double probability = 1;  ///< of a statistic as large by chance, were the counts drawn as expected
  std::size_t worst = 0;   ///< cell of the largest term, before pooling
};

/// Cells that expect fewer than `pooling` counts are pooled, smallest first, until the pool expects that many (Cochran
/// 1954) or no such cell is left. The expected counts must sum to about the observed ones. Throws Error::Kind::Value
/// when the lengths differ.
BRDF_EXPORT ChiSquare chiSquare(std::span<const double> observed, std::span<const double> expected,
                                double pooling = 10);

/// The significance for each of `tests` independent tests that makes `level` the chance of any false alarm among them:
/// 1 - (1 - level)^(1/tests) (Sidak 1967).
BRDF_EXPORT double sidakSignificance(double level, std::size_t tests);

struct SamplerTestOptions {
  std::size_t draws = 100'000;
  std::size_t cells = 512;    ///< of the hemisphere, about
  double pooling = 10;        ///< counts that a cell must expect
  double quadrature = 0.001;  ///< HemispherePartition::integrate's tolerance
  std::uint64_t seed = 1;
};

/// What drawing from a sampler for one viewer showed.
struct SamplerTest {
  ChiSquare chiSquare;   ///< of the draws that do not fail
  double integral = 0;   ///< of the density over the hemisphere; should be 1 less the share of failed draws
  double failed = 0;     ///< share of draws that are (0, 0, 0)
  double deviation = 0;  ///< integral + failed - 1 in units of its error: that of counting, at least 1e-3 (quadrature)
  std::size_t bad = 0;   ///< draws that are neither a unit vector above the horizon nor (0, 0, 0)
  std::size_t uncovered = 0;  ///< draws where the density is not positive and finite
  Direction
      worst{};  ///< light at the centre of the cell of the largest term; (0, 0, 0) where that is below the horizon
  double worstObserved = 0, worstExpected = 0;  ///< counts of that cell
};

/// Whether a sampler draws what its density says: draws are counted in cells that draws of another seed laid out
/// (together with points about the mirror and the retro direction), and compared with the density integrated over each
/// cell.
BRDF_EXPORT SamplerTest testSampler(const DirectionSampler& sampler, const Direction& wo,
                                    const SamplerTestOptions& options = {});

/// The integral of the sampler's density over the hemisphere, by the same cells.
BRDF_EXPORT double pdfIntegral(const DirectionSampler& sampler, const Direction& wo,
                               const SamplerTestOptions& options = {});

}  // namespace brdf
