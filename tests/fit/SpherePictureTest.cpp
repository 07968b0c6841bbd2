// The metric "sphere": its picture against the reference renderer, its derivatives, what a fit by it finds.
#include <brdf/base/Error.h>
#include <brdf/fit/Cost.h>
#include <brdf/fit/SpherePicture.h>
#include <brdf/render/ReferenceRenderer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "SyntheticTarget.h"

namespace brdf {
namespace {

std::shared_ptr<const SphereMetric> standard() {
  return std::dynamic_pointer_cast<const SphereMetric>(findMetric("sphere"));
}

TEST(SphereMetric, LightnessIsThatOfTheCie) {
  const auto metric = standard();
  // CIE 15:2004: L* of 1, 0.18, the knee (6/29)^3 and 0; 50 is at 0.18418651851...
  const std::vector<double> y{1, 0.18, std::pow(6.0 / 29, 3), 0, 0.184186518512444};
  const std::vector<double> expected{100, 49.496107610364, 8, 0, 50};
  std::vector<double> target(5), zero(5), slope(5), back(5), above(5), below(5);
  DirectionPairBuffer<double> pairs(5);
  metric->residual(y.data(), zero.data(), pairs.view(), target.data());
  metric->restore(target.data(), pairs.view(), back.data());
  metric->slope(y.data(), zero.data(), pairs.view(), slope.data());
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(target[i], expected[i], 1e-9);
    EXPECT_NEAR(back[i], y[i], 1e-14);
    const std::vector<double> more{y[i] + 1e-6}, less{y[i] - 1e-6};
    metric->residual(more.data(), zero.data(), pairs.view().slice(0, 1), above.data());
    metric->residual(less.data(), zero.data(), pairs.view().slice(0, 1), below.data());
    EXPECT_NEAR(slope[i], (above[0] - below[0]) / 2e-6, 1e-3 * slope[i]);
  }
}

/// Radiance of the picture's pixels over white, in the order of the pixels.
std::vector<double> radiances(const FitData& picture, std::size_t channel) {
  std::vector<double> all;
  for (const FitChunk& chunk : picture.chunks) {
    std::vector<double> part(picture.residuals(chunk));
    picture.block(chunk, channel).values(part.data());
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

TEST(SpherePicture, IsThatOfTheReferenceRenderer) {
  const auto map = sphereLight();
  std::vector<std::size_t> places;  // pixels on the sphere
  double white = 0;                 // of the brightest of 6 x 6 places
  for (std::size_t pixel = 0; pixel < 24 * 24; ++pixel) {
    const double x = (2 * double(pixel % 24) + 1) / 24 - 1, y = 1 - (2 * double(pixel / 24) + 1) / 24;
    if (x * x + y * y >= 1) continue;
    places.push_back(pixel);
  }
  for (const double x : {-5, -3, -1, 1, 3, 5})
    for (const double y : {-5, -3, -1, 1, 3, 5})
      if (x * x + y * y < 36)
        white = std::max(white, map->irradiance({x / 6, y / 6, std::sqrt(36 - x * x - y * y) / 6})[1] / kPi);
  for (const char* expression : {"0.5*Lambertian", "(0.3,0.2,0.1)*Lambertian + 0.4*GGX(alpha=0.3)"}) {
    const auto material = parseMaterialExpression(expression);
    const FitData picture = spherePicture(*material, standard());
    Scene scene;
    scene.materials = {material};
    scene.objects.push_back({"sphere", nullptr, {}, 0});
    scene.environment = SceneEnvironment{map, 0, 1};
    scene.camera.position = {0, 0, 1e5};  // as good as parallel
    scene.camera.viewAngle = 2 * degrees(std::atan(1 / 1e5));
    scene.width = scene.height = 24;
    ReferenceOptions options;
    options.samples = 2048;
    options.pixelCentres = true;
    const ReferencePicture truth = renderReference(scene, options);
    for (std::size_t c = 0; c < picture.channels; ++c) {
      const std::vector<double> seen = radiances(picture, c);
      ASSERT_EQ(seen.size(), places.size());
      double sum = 0, squares = 0, total = 0, noise = 0;
      for (std::size_t k = 0; k < places.size(); ++k) {
        const double expected = double(truth.radiance.values[3 * places[k] + c]) / white;
        sum += seen[k] - expected;
        squares += (seen[k] - expected) * (seen[k] - expected);
        total += expected;
        noise += std::pow(double(truth.standardError.values[3 * places[k] + c]) / white, 2);
      }
      const double n = double(places.size()), spread = std::sqrt(squares / n);
      EXPECT_LT(std::abs(sum / n), 4 * spread / std::sqrt(n) + 1e-3 * total / n) << expression;  // no bias
      EXPECT_LT(std::sqrt(std::max(0.0, squares - noise) / n), 0.06 * total / n) << expression;  // little noise
    }
  }
}

TEST(SpherePicture, TheCostHasItsDerivatives) {
  const auto target = parseMaterialExpression("(0.3,0.1,0.2)*Lambertian + 0.3*CookTorrance(m=0.3)");
  const FitData picture = spherePicture(*target, standard());
  const FitProblem problem(
      {{findModel("Lambertian"), {}, {}, {}}, {findModel("GGX"), {}, {{"alpha", 0.25}, {"ior", 1.6}}, {}}},
      Symmetry::Isotropic);
  JointCost cost(problem, picture, {0, 3});
  const std::vector<double> x = cost.join(problem.start(), {0.2, 0.4, 0.15, 0.3, 0.1, 0.5});
  const NormalEquations equations = cost.normalEquations(x);
  EXPECT_NEAR(equations.squaredError, cost.squaredError(x), 1e-10 * equations.squaredError);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double h = 1e-5 * std::max(0.1, std::abs(x[k]));
    std::vector<double> up = x, down = x;
    up[k] += h, down[k] -= h;
    const double slope = (cost.squaredError(up) - cost.squaredError(down)) / (4 * h);  // J'r is half the gradient
    EXPECT_NEAR(equations.gradient[k], slope, 1e-5 * std::abs(slope) + 1e-6) << k;
  }
}

TEST(SphereFit, FindsWhatThePictureWasMadeOf) {
  const auto target = syntheticTarget("(0.3,0.1,0.2)*Lambertian + (0.4,0.5,0.6)*GGX(alpha=0.15)", 3000);
  FitOptions options;
  options.metric = "sphere";
  const FitReport report =
      fit(target, {{findModel("Lambertian"), {}, {}, {}}, {findModel("GGX"), {}, {}, {}}}, options);
  EXPECT_EQ(report.metric, "sphere");
  EXPECT_EQ(report.strategy, "joint");
  EXPECT_LT(report.error, report.zeroModel.at("sphere"));
  const Comparison comparison = compare(*report.material, target, 90, "sphere");
  EXPECT_NEAR(comparison.metrics.at("sphere"), report.error, 1e-9 * (1 + report.error));

  // By its own metric no fit is better than the one that minimises it.
  options.metric = "cuberoot";
  const FitReport pairs = fit(target, {{findModel("Lambertian"), {}, {}, {}}, {findModel("GGX"), {}, {}, {}}}, options);
  EXPECT_LE(report.error, compare(*pairs.material, target, 90, "sphere").metrics.at("sphere") * (1 + 1e-9));
}

TEST(SphereFit, SeparableIsRefused) {
  const auto target = syntheticTarget("Lambertian", 100);
  FitOptions options;
  options.metric = "sphere";
  options.strategy = Strategy::Separable;
  EXPECT_THROW(fit(target, {{findModel("Lambertian"), {}, {}, {}}}, options), Error);
}

}  // namespace
}  // namespace brdf
