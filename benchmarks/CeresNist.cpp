// The NIST problems by Ceres Solver, for comparison with ours: a table row for each start. Options as in Ceres' own
// evaluation on these problems (examples/nist.cc): Levenberg-Marquardt, dense QR, tolerances at machine precision.
#include <ceres/ceres.h>

#include <algorithm>
#include <cstdio>

#include "../tests/fit/NistProblems.h"

namespace {

using namespace brdf;

class CurveResiduals : public ceres::CostFunction {
 public:
  explicit CurveResiduals(const Curve& curve) : curve_(curve), row_(curve.parameters()) {
    set_num_residuals(static_cast<int>(curve.points()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(curve.parameters()));
  }
  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    const std::size_t n = row_.size();
    for (std::size_t k = 0; k < curve_.points(); ++k) {
      residuals[k] = curve_.residual(k, {parameters[0], n}, row_.data());
      if (jacobians && jacobians[0]) std::copy(row_.begin(), row_.end(), jacobians[0] + k * n);
    }
    return true;
  }

 private:
  const Curve& curve_;
  mutable std::vector<double> row_;
};

}  // namespace

int main() {
  for (const NistProblem& nist : nistProblems(BRDF_SOURCE_DIR "/tests/data/nist"))
    for (std::size_t start = 0; start < 2; ++start) {
      std::vector<double> x = nist.starts[start];
      ceres::Problem problem;
      problem.AddResidualBlock(new CurveResiduals(nist.curve), nullptr, x.data());
      ceres::Solver::Options options;
      options.linear_solver_type = ceres::DENSE_QR;
      options.max_num_iterations = 10000;
      options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 2.2e-16;
      options.logging_type = ceres::SILENT;
      ceres::Solver::Summary summary;
      ceres::Solve(options, &problem, &summary);
      std::printf("%s,%zu,%.1f,%zu\n", nist.name.c_str(), start + 1, correctDigits(x, nist.certified),
                  summary.iterations.size());
    }
}
