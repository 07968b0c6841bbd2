#include <brdf/fit/BoxQuadratic.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace brdf {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(BoxQuadratic, IsTheLinearSolutionInsideTheBox) {
  // 4x + y = 1, x + 3y = 2: x = 1/11, y = 7/11.
  const std::vector<double> matrix{4, 1, 1, 3}, b{1, 2}, low{-1, -1}, high{1, 1};
  const auto x = minimizeInBox(matrix, b, low, high);
  EXPECT_NEAR(x[0], 1.0 / 11, 1e-15);
  EXPECT_NEAR(x[1], 7.0 / 11, 1e-15);
}

TEST(BoxQuadratic, NonNegativeLeastSquaresDropsTheNegativeColumn) {
  // Columns (1, 0) and (1, 1), right side (1, -1): unconstrained (2, -1); with x >= 0 it is (1, 0).
  const std::vector<double> matrix{1, 1, 1, 2}, b{1, 0}, low{0, 0}, high{kInfinity, kInfinity};
  const auto x = minimizeInBox(matrix, b, low, high);
  EXPECT_NEAR(x[0], 1, 1e-15);
  EXPECT_EQ(x[1], 0);
}

TEST(BoxQuadratic, SharesEquallyBetweenEqualColumns) {
  const std::vector<double> matrix{2, 2, 2, 2}, b{2, 2}, low{0, 0}, high{kInfinity, kInfinity};
  const auto x = minimizeInBox(matrix, b, low, high);
  EXPECT_NEAR(x[0], 0.5, 1e-12);
  EXPECT_NEAR(x[1], 0.5, 1e-12);
}

TEST(BoxQuadratic, AColumnOfZerosKeepsItsVariableAtZero) {
  const std::vector<double> matrix{1, 0, 0, 0}, b{3, 0}, low{-9, -9}, high{9, 9};
  EXPECT_EQ(minimizeInBox(matrix, b, low, high), (std::vector<double>{3, 0}));
}

TEST(BoxQuadratic, MeetsTheOptimalityConditionsOnRandomProblems) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  for (int trial = 0; trial < 500; ++trial) {
    const std::size_t n = 1 + random() % 8, rows = n + random() % 4;
    std::vector<double> columns(n * rows), matrix(n * n), b(n), low(n), high(n);
    for (double& value : columns) value = uniform(-1, 1);
    for (std::size_t i = 0; i < n; ++i) {
      const double size =
          std::pow(10, uniform(-4, 4));  // columns of very different size, as narrow and broad lobes have
      for (std::size_t k = 0; k < rows; ++k) columns[i * rows + k] *= size;
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t k = 0; k < rows; ++k) matrix[i * n + j] += columns[i * rows + k] * columns[j * rows + k];
      b[i] = uniform(-1, 1) * std::sqrt(matrix[i * n + i]);
      low[i] = -uniform(0, 1) / std::sqrt(matrix[i * n + i]);
      high[i] = trial % 2 ? kInfinity : uniform(0, 1) / std::sqrt(matrix[i * n + i]);
    }
    const auto x = minimizeInBox(matrix, b, low, high);
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_GE(x[i], low[i]);
      ASSERT_LE(x[i], high[i]);
      double gradient = -b[i];
      for (std::size_t j = 0; j < n; ++j) gradient += matrix[i * n + j] * x[j];
      gradient /= std::sqrt(matrix[i * n + i]);
      if (x[i] > low[i]) {
        EXPECT_LE(gradient, 1e-7) << "trial " << trial << " variable " << i;
      }
      if (x[i] < high[i]) {
        EXPECT_GE(gradient, -1e-7) << "trial " << trial << " variable " << i;
      }
    }
  }
}

TEST(BoxQuadratic, PseudoInverseNamesTheDirectionThatIsNotDetermined) {
  // The first two variables appear only as their sum.
  const std::vector<double> matrix{1, 1, 0, 1, 1, 0, 0, 0, 4};
  std::vector<std::vector<double>> directions;
  const auto inverse = pseudoInverse(matrix, 3, 1e-12, &directions);
  ASSERT_EQ(directions.size(), 1u);
  EXPECT_NEAR(std::abs(directions[0][0]), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(directions[0][0], -directions[0][1], 1e-12);
  EXPECT_NEAR(directions[0][2], 0, 1e-12);
  EXPECT_NEAR(inverse[8], 0.25, 1e-15);
}

}  // namespace
}  // namespace brdf
