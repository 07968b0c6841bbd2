#pragma once
#include <brdf/brdf_export.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// A sum of squared residuals r at x, with what a Gauss-Newton step needs. J = dr/dx.
struct NormalEquations {
  double squaredError = 0;       ///< r'r
  std::vector<double> gradient;  ///< J'r, n numbers
  std::vector<double> matrix;    ///< J'J, n x n, row-major; approximations of it are welcome
};

/// Where a minimum is expected: the box that global methods search, and the unit of every coordinate for the others.
struct SearchBox {
  std::vector<double> lower, upper;  ///< inside the bounds; may be infinite
};

/// A sum of squares to minimise in a box.
class BRDF_EXPORT CostFunction {
 public:
  virtual ~CostFunction();
  virtual const std::vector<double>& lower() const = 0;  ///< n numbers; -infinity allowed
  virtual const std::vector<double>& upper() const = 0;
  /// r'r; may be non-finite where the function has no value.
  virtual double squaredError(std::span<const double> x) = 0;
  virtual NormalEquations normalEquations(std::span<const double> x) = 0;
  /// The squared error of the answer 0: below its 1e-28th part there is nothing but rounding. 0 when unknown.
  virtual double scale() const { return 0; }
  /// Contains `start`, which lies inside the bounds. The bounds themselves unless the function knows better.
  virtual SearchBox searchBox(std::span<const double> start) const;
};

struct OptimizerOptions {
  double tolerance = 1e-8;  ///< relative change of the squared error; steps are held to a hundredth of its square root
  /// Methods without derivatives and global ones get 20 evaluations for each, those with gradients 5.
  std::size_t maximumIterations = 200;
  std::uint64_t seed = 1;  ///< of the methods that draw random numbers
  /// Called after each iteration; return false to stop with the best so far.
  std::function<bool(double squaredError)> progress;
};

struct OptimizerResult {
  std::vector<double> x;
  double squaredError = 0;
  std::size_t iterations = 0;
  std::size_t evaluations = 0;
  bool converged = false;
  bool stopped = false;     ///< by the progress function
  std::string termination;  ///< the reason, in words
};

/// One way to minimise a cost function from a start inside the box. The best point seen is the result.
struct Optimizer {
  std::string_view name;   ///< as on the command line
  std::string_view title;  ///< with its source
  bool usesDerivatives;
  bool global;  ///< searches the whole search box (CostFunction::searchBox), which must be finite
  OptimizerResult (*minimize)(CostFunction& cost, std::vector<double> start, const OptimizerOptions& options);
};

/// All optimizers, Levenberg-Marquardt first.
BRDF_EXPORT std::span<const Optimizer> allOptimizers();
/// Adds an optimizer; replaces one of the same name. Its texts must live on. Not while others ask for optimizers.
BRDF_EXPORT void registerOptimizer(const Optimizer& optimizer);
/// The optimizer called `name`; throws Error::Kind::Value with the allowed names.
BRDF_EXPORT const Optimizer& findOptimizer(std::string_view name);

/// Levenberg-Marquardt as a trust region in a box (Moré 1978, "The Levenberg-Marquardt algorithm: implementation and
/// theory", doi:10.1007/BFb0067700): each step minimises the quadratic model inside the bounds exactly, damped to the
/// length that is trusted, in units of the largest slopes seen. Where residuals stay large the model learns their
/// curvature.
BRDF_EXPORT OptimizerResult levenbergMarquardt(CostFunction& cost, std::vector<double> start,
                                               const OptimizerOptions& options);

}  // namespace brdf
