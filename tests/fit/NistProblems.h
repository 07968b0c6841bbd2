#pragma once
#include <brdf/fit/Optimizer.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace brdf {

/// Residuals of a curve through points, with derivatives by hand.
class Curve : public CostFunction {
 public:
  /// Value at the predictors t, and its derivatives with respect to b.
  using Function = std::function<double(const double* t, std::span<const double> b, double* derivatives)>;

  /// `t` holds the predictors of one point after those of another, as many a point as t.size() / y.size().
  Curve(std::vector<double> t, std::vector<double> y, std::size_t parameters, Function function);

  const std::vector<double>& lower() const override { return lower_; }
  const std::vector<double>& upper() const override { return upper_; }
  double squaredError(std::span<const double> b) override;
  NormalEquations normalEquations(std::span<const double> b) override;
  void setBounds(std::vector<double> lower, std::vector<double> upper);

  std::size_t points() const { return y_.size(); }
  std::size_t parameters() const { return lower_.size(); }
  /// model - data at one point; `row` receives the derivatives.
  double residual(std::size_t point, std::span<const double> b, double* row) const;

 private:
  std::vector<double> t_, y_;
  Function function_;
  std::vector<double> lower_, upper_;
};

/// A problem of the NIST Statistical Reference Datasets, nonlinear regression (tests/data/nist).
struct NistProblem {
  std::string name, difficulty;  ///< "Lower", "Average", "Higher"
  Curve curve;
  std::vector<std::vector<double>> starts;  ///< start 1 (far), start 2 (near)
  std::vector<double> certified;
  double residualSum;
};

/// All 27, from `folder`; throws std::runtime_error for a file that is not as published.
std::vector<NistProblem> nistProblems(const std::filesystem::path& folder);
/// One of them.
NistProblem nistProblem(const std::filesystem::path& folder, const std::string& name);

/// Correct digits of the worst parameter: -log10 of its relative error (NIST's log relative error), at most 11, the
/// digits that are certified.
double correctDigits(std::span<const double> found, std::span<const double> certified);

}  // namespace brdf
