#include <brdf/fit/BoxQuadratic.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace brdf {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ConstMap = Eigen::Map<const Matrix>;

/// 1 / sqrt of the diagonal, 0 where that is not positive.
Eigen::VectorXd diagonalScale(const Matrix& matrix) {
  return matrix.diagonal().unaryExpr([](double d) { return d > 0 && std::isfinite(d) ? 1 / std::sqrt(d) : 0.0; });
}

/// Solution of matrix * z = b: Cholesky where the scaled matrix is well enough conditioned, else the shortest one.
Eigen::VectorXd solve(const Matrix& matrix, const Eigen::VectorXd& b) {
  const Eigen::VectorXd scale = diagonalScale(matrix);
  Matrix scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
  const Eigen::VectorXd right = scale.cwiseProduct(b);
  const Eigen::LLT<Matrix> cholesky(scaled);
  if (cholesky.info() == Eigen::Success && cholesky.rcond() > 1e-13)
    return scale.cwiseProduct(cholesky.solve(right).eval());
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(scaled);
  const double smallest = 1e-13 * eigen.eigenvalues().maxCoeff();
  Eigen::VectorXd part = eigen.eigenvectors().transpose() * right;
  for (Eigen::Index i = 0; i < part.size(); ++i)
    part[i] = eigen.eigenvalues()[i] > smallest ? part[i] / eigen.eigenvalues()[i] : 0;
  return scale.cwiseProduct((eigen.eigenvectors() * part).eval());
}

}  // namespace

std::vector<double> minimizeInBox(std::span<const double> matrix, std::span<const double> b,
                                  std::span<const double> lower, std::span<const double> upper) {
  const std::size_t n = b.size();
  const ConstMap a(matrix.data(), static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  const Eigen::Map<const Eigen::VectorXd> right(b.data(), static_cast<Eigen::Index>(n));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n));
  enum class State { Free, AtLower, AtUpper, Excluded };
  std::vector<State> state(n);
  for (std::size_t i = 0; i < n; ++i) state[i] = matrix[i * n + i] > 0 ? State::Free : State::Excluded;

  std::vector<Eigen::Index> freeSet;
  // Each round binds or frees one variable; the bound is generous, and x is feasible at every moment.
  for (std::size_t round = 0; round < 10 * n + 10; ++round) {
    freeSet.clear();
    for (std::size_t i = 0; i < n; ++i)
      if (state[i] == State::Free) freeSet.push_back(static_cast<Eigen::Index>(i));
    if (!freeSet.empty()) {
      Eigen::VectorXd bound = x;
      for (const Eigen::Index i : freeSet) bound[i] = 0;
      const Eigen::VectorXd rest = right - a * bound;
      const Eigen::VectorXd z = solve(a(freeSet, freeSet), rest(freeSet));
      double step = 1;
      Eigen::Index blocking = -1;
      bool blockedBelow = false;
      for (std::size_t k = 0; k < freeSet.size(); ++k) {
        const Eigen::Index i = freeSet[k];
        const double target = z[static_cast<Eigen::Index>(k)];
        const double limit = target < lower[i] ? lower[i] : target > upper[i] ? upper[i] : target;
        if (limit == target) continue;
        const double fraction = std::clamp((limit - x[i]) / (target - x[i]), 0.0, 1.0);
        if (blocking < 0 || fraction < step) {
          step = fraction;
          blocking = i;
          blockedBelow = target < lower[i];
        }
      }
      for (std::size_t k = 0; k < freeSet.size(); ++k) {
        const Eigen::Index i = freeSet[k];
        x[i] = std::clamp(x[i] + step * (z[static_cast<Eigen::Index>(k)] - x[i]), lower[i], upper[i]);
      }
      if (blocking >= 0) {
        state[blocking] = blockedBelow ? State::AtLower : State::AtUpper;
        x[blocking] = blockedBelow ? lower[blocking] : upper[blocking];
        continue;
      }
    }
    // Every free variable is at its optimum: does the gradient hold the others on their bounds?
    const Eigen::VectorXd pull = right - a * x;
    std::size_t release = n;
    double strongest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (state[i] != State::AtLower && state[i] != State::AtUpper) continue;
      if (lower[i] == upper[i]) continue;
      const double inward = (state[i] == State::AtLower ? pull[i] : -pull[i]) / std::sqrt(matrix[i * n + i]);
      const double rounding = 1e-14 * std::abs(b[i]) / std::sqrt(matrix[i * n + i]);
      if (inward > rounding && inward > strongest) {
        strongest = inward;
        release = i;
      }
    }
    if (release == n) break;
    state[release] = State::Free;
  }
  return {x.data(), x.data() + n};
}

std::vector<double> pseudoInverse(std::span<const double> matrix, std::size_t n, double relative,
                                  std::vector<std::vector<double>>* nullVectors) {
  if (n == 0) return {};
  const Matrix a = ConstMap(matrix.data(), static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  const Eigen::VectorXd scale = diagonalScale(a);
  const Matrix scaled = scale.asDiagonal() * a * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(scaled);
  const double smallest = relative * eigen.eigenvalues().maxCoeff();
  Matrix inverse = Matrix::Zero(a.rows(), a.cols());
  for (Eigen::Index k = 0; k < a.rows(); ++k) {
    const Eigen::VectorXd vector = eigen.eigenvectors().col(k);
    if (eigen.eigenvalues()[k] > smallest)
      inverse += vector * vector.transpose() / eigen.eigenvalues()[k];
    else if (nullVectors)
      nullVectors->emplace_back(vector.data(), vector.data() + n);
  }
  inverse = scale.asDiagonal() * inverse * scale.asDiagonal();
  return {inverse.data(), inverse.data() + n * n};
}

}  // namespace brdf
