#include "SimpleBrdfs.h"

#include <brdf/base/Error.h>
#include <brdf/view/LobeMesh.h>

#include <gtest/gtest.h>

#include <map>

namespace brdf {
namespace {

using test::angleBetween;
using test::constantBrdf;
using test::FunctionBrdf;

/// A Gaussian of the angle to the mirror direction: height 1000, standard deviation `width`.
FunctionBrdf mirrorSpike(double width) {
  return FunctionBrdf([width](const Direction& wi, const Direction& wo) {
    const double angle = angleBetween({-wi[0], -wi[1], wi[2]}, wo) / width;
    return 1000 * std::exp(-angle * angle / 2);
  });
}

TEST(LobeMesh, LambertianIsAHemisphereOfTheTransformedRadius) {
  const FunctionBrdf lambertian = constantBrdf(0.5 / kPi);
  const std::map<LobeTransform, double> radii{{LobeTransform::None, 0.15915494309189535},
                                              {LobeTransform::CubeRoot, 0.5419260701392891},
                                              {LobeTransform::Log, 0.14769124230057343}};
  for (const auto& [transform, radius] : radii) {
    LobeMeshOptions options;
    options.transform = transform;
    const LobeMesh mesh = makeLobeMesh(lambertian, options);
    EXPECT_NEAR(mesh.maximumRadius, radius, 1e-15);
    for (double r : mesh.radii) ASSERT_NEAR(r, radius, 1e-15);
  }
}

TEST(LobeMesh, HemisphereHasItsAreaAndOutwardNormals) {
  const LobeMesh mesh = makeLobeMesh(constantBrdf(2.0), {});
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Direction a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
    const Direction n = cross({b[0] - a[0], b[1] - a[1], b[2] - a[2]}, {c[0] - a[0], c[1] - a[1], c[2] - a[2]});
    EXPECT_GT(dot(n, mesh.directions[t[0]]), 0);
    area += std::sqrt(dot(n, n)) / 2;
  }
  EXPECT_NEAR(area / (2 * kPi * 4), 1, 2e-3);  // 2 pi r^2, from inside; edges of 2.8 degrees lose less than 2e-3
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i)
    EXPECT_GT(dot(mesh.normals[i], mesh.directions[i]), 0.999);
}

TEST(LobeMesh, RefinedMeshIsConforming) {
  LobeMeshOptions options;
  options.phiI = radians(20);
  const LobeMesh mesh = makeLobeMesh(mirrorSpike(radians(0.3)), options);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++edges[std::minmax(t[k], t[(k + 1) % 3])];
  for (const auto& [edge, count] : edges) {
    const bool rim = mesh.directions[edge.first][2] == 0 && mesh.directions[edge.second][2] == 0;
    ASSERT_EQ(count, rim ? 1 : 2);
  }
}

TEST(LobeMesh, MissesNoPeakAtTheMirrorOrRetroDirection) {
  for (double width : {5.0, 0.5, 0.05}) {
    LobeMeshOptions options;
    options.thetaI = radians(37.3);
    options.phiI = radians(71.9);
    EXPECT_GT(makeLobeMesh(mirrorSpike(radians(width)), options).maximumRadius, 990) << width << " degrees";
    const FunctionBrdf retro([width](const Direction& wi, const Direction& wo) {
      return std::exp(-std::pow(angleBetween(wi, wo) / radians(width), 2) / 2);
    });
    EXPECT_GT(makeLobeMesh(retro, options).maximumRadius, 0.99) << width << " degrees";
  }
}

TEST(LobeMesh, KeepsTheChordToleranceOfASmoothLobe) {
  const FunctionBrdf lobe([](const Direction& wi, const Direction& wo) {
    return std::pow(std::max(0.0, -wi[0] * wo[0] - wi[1] * wo[1] + wi[2] * wo[2]), 50);
  });
  LobeMeshOptions options;
  options.tolerance = 1e-3;
  const LobeMesh mesh = makeLobeMesh(lobe, options);
  const Direction wi = fromSpherical(options.thetaI, options.phiI);
  double worst = 0;
  for (const auto& t : mesh.triangles) {  // at the centroids, which the refinement never looks at
    Direction flat{}, wo{};
    for (std::uint32_t corner : t)
      for (int axis = 0; axis < 3; ++axis) {
        flat[axis] += mesh.position(corner)[axis] / 3;
        wo[axis] += mesh.directions[corner][axis] / 3;
      }
    wo = normalized(wo);
    const double r = lobe.evaluate(wi, wo)[0];
    worst = std::max(worst, std::hypot(r * wo[0] - flat[0], r * wo[1] - flat[1], r * wo[2] - flat[2]));
  }
  EXPECT_LT(worst, 2 * options.tolerance * mesh.maximumRadius);
  EXPECT_LT(mesh.vertexCount(), 20000u);
}

TEST(LobeMesh, AStepInTheDataEndsTheRefinement) {
  const FunctionBrdf step([](const Direction&, const Direction& wo) { return wo[0] + 0.3 * wo[1] > 0.1 ? 1.0 : 0.2; });
  const LobeMesh mesh = makeLobeMesh(step, {});
  EXPECT_GT(mesh.vertexCount(), 2000u);
  EXPECT_LT(mesh.vertexCount(), 30000u);
}

TEST(LobeMesh, UnknownDirectionsLeaveAHole) {
  const FunctionBrdf brdf([](const Direction&, const Direction&) { return 1.0; }, Channels::rgb(),
                          [](const Direction&, const Direction& wo) { return wo[0] < 0.2; });
  const LobeMesh mesh = makeLobeMesh(brdf, {});
  std::size_t unknown = 0;
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
    EXPECT_EQ(mesh.valid[i], mesh.directions[i][0] < 0.2);
    unknown += !mesh.valid[i];
  }
  EXPECT_GT(unknown, 100u);
  for (const auto& t : mesh.triangles)
    for (std::uint32_t corner : t) ASSERT_TRUE(mesh.valid[corner]);
}

TEST(LobeMesh, NegativeValuesHaveNoLength) {
  EXPECT_EQ(transformed(LobeTransform::None, -1), 0);
  EXPECT_EQ(transformed(LobeTransform::CubeRoot, -1), 0);
  EXPECT_EQ(transformed(LobeTransform::Log, -0.5), 0);
}

TEST(LobeMesh, RefusesWhatItCannotDraw) {
  const FunctionBrdf brdf = constantBrdf(1);
  const auto refused = [&](auto change) {
    LobeMeshOptions options;
    change(options);
    EXPECT_THROW(makeLobeMesh(brdf, options), Error);
  };
  refused([](LobeMeshOptions& o) { o.thetaI = kPi / 2; });
  refused([](LobeMeshOptions& o) { o.thetaI = -0.1; });
  refused([](LobeMeshOptions& o) { o.thetaI = std::nan(""); });
  refused([](LobeMeshOptions& o) { o.phiI = std::nan(""); });
  refused([](LobeMeshOptions& o) { o.subdivisions = 10; });
  refused([](LobeMeshOptions& o) { o.tolerance = -1; });
  refused([](LobeMeshOptions& o) { o.weights = {1, 1}; });
  EXPECT_THROW(parseLobeTransform("sqrt"), Error);
}

}  // namespace
}  // namespace brdf
