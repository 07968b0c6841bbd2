#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "NistProblems.h"

namespace brdf {
namespace {

std::vector<NistProblem> all() { return nistProblems(std::filesystem::path(BRDF_SOURCE_DIR) / "tests/data/nist"); }

TEST(Nist, TheFilesAreReadAndTheModelsAreRight) {
  const std::vector<NistProblem> problems = all();
  EXPECT_EQ(problems.size(), 27u);
  for (NistProblem nist : problems) {
    // The certified answer, in 11 digits, has the certified residual. Lanczos1 is exact to rounding.
    const double allowed = nist.name == "Lanczos1" ? 1e-20 : 1e-8 * nist.residualSum;
    EXPECT_NEAR(nist.curve.squaredError(nist.certified), nist.residualSum, allowed) << nist.name;
    EXPECT_EQ(nist.starts[1].size(), nist.certified.size());
    const std::size_t n = nist.certified.size(), points = nist.curve.points();
    std::vector<double> row(n), unused(n);
    for (const std::vector<double>& at : {nist.starts[1], nist.certified})
      for (std::size_t i = 0; i < n; ++i) {
        std::vector<double> less = at, more = at;
        const double h = 1e-5 * std::abs(at[i]);
        less[i] -= h;
        more[i] += h;
        double largest = 0, worst = 0;
        for (std::size_t point = 0; point < points; ++point) {
          nist.curve.residual(point, at, row.data());
          const double difference =
              (nist.curve.residual(point, more, unused.data()) - nist.curve.residual(point, less, unused.data())) /
              (2 * h);
          largest = std::max(largest, std::abs(row[i]));
          worst = std::max(worst, std::abs(row[i] - difference));
        }
        EXPECT_LE(worst, 1e-5 * largest) << nist.name << " b" << i + 1;
      }
  }
}

TEST(Nist, LevenbergMarquardtFindsTheCertifiedValuesToSixDigitsFromBothStarts) {
  for (NistProblem nist : all())
    for (const std::vector<double>& start : nist.starts) {
      OptimizerOptions options;
      options.tolerance = 1e-13;
      options.maximumIterations = 5000;
      const OptimizerResult result = levenbergMarquardt(nist.curve, start, options);
      EXPECT_GE(correctDigits(result.x, nist.certified), 6)
          << nist.name << " from " << start[0] << ": " << result.termination << ", " << result.iterations;
      EXPECT_TRUE(result.converged) << nist.name << ": " << result.termination;
    }
}

}  // namespace
}  // namespace brdf
