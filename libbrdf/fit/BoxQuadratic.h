#pragma once
#include <brdf/brdf_export.h>

#include <span>
#include <vector>

namespace brdf {

/// The x in the box [lower, upper] that minimises x'Ax/2 - b'x, for a symmetric positive semi-definite `matrix`
/// (row-major, n x n) and lower <= 0 <= upper (bounds may be infinite): non-negative least squares on normal equations,
/// and the bounded Levenberg-Marquardt step. Primal active set after Stark and Parker 1995, "Bounded-Variable
/// Least-Squares", started from 0 with every variable free. Directions that the matrix does not determine get the
/// shortest solution in units of the diagonal; a variable whose diagonal is 0 stays 0.
BRDF_EXPORT std::vector<double> minimizeInBox(std::span<const double> matrix, std::span<const double> b,
                                              std::span<const double> lower, std::span<const double> upper);

/// Inverse of a symmetric positive semi-definite matrix (row-major, n x n) on its range: eigenvalues of the matrix
/// scaled to unit diagonal below `relative` times the largest count as 0. `nullVectors`, when given, receives the
/// scaled eigenvectors of those (one after the other, n numbers each).
BRDF_EXPORT std::vector<double> pseudoInverse(std::span<const double> matrix, std::size_t n, double relative = 1e-13,
                                              std::vector<std::vector<double>>* nullVectors = nullptr);

}  // namespace brdf
