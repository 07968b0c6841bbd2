#include "SimpleBrdfs.h"

#include <brdf/base/Error.h>
#include <brdf/view/LobeMesh.h>

#include <gtest/gtest.h>

#include <algorithm>
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
                                              {LobeTransform::Log, 0.14769124230057343},
                                              {LobeTransform::LogFloor, 2.201820131641885}};
  for (const auto& [transform, radius] : radii) {
    LobeMeshOptions options;
    options.scale = {transform, 1e-3};
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
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i) EXPECT_GT(dot(mesh.normals[i], mesh.directions[i]), 0.999);
}

/// How many triangles share each edge: two inside, one on the rim.
void expectConforming(const LobeMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::vector<bool> used(mesh.vertexCount());
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      ++edges[std::minmax(t[k], t[(k + 1) % 3])];
      used[t[k]] = true;
    }
  for (const auto& [edge, count] : edges) {
    const bool rim = mesh.directions[edge.first][2] == 0 && mesh.directions[edge.second][2] == 0;
    ASSERT_EQ(count, rim ? 1 : 2);
  }
  for (bool one : used) ASSERT_TRUE(one);
  // A disk: V - E + F = 1, so nothing is torn and nothing doubled.
  EXPECT_EQ(mesh.vertexCount() + mesh.triangles.size(), edges.size() + 1);
}

/// That no triangle is turned over: the directions of each wind counter-clockwise from outside, and cover the
/// hemisphere's solid angle once (L'Huilier's theorem).
void expectSphereCovered(const LobeMesh& mesh) {
  double covered = 0;
  for (const auto& t : mesh.triangles) {
    const Direction &a = mesh.directions[t[0]], &b = mesh.directions[t[1]], &c = mesh.directions[t[2]];
    ASSERT_GT(dot(cross(a, b), c), 0);
    const double x = angleBetween(b, c), y = angleBetween(c, a), z = angleBetween(a, b), s = (x + y + z) / 2;
    covered += 4 * std::atan(std::sqrt(std::max(
                       0.0, std::tan(s / 2) * std::tan((s - x) / 2) * std::tan((s - y) / 2) * std::tan((s - z) / 2))));
  }
  EXPECT_NEAR(covered, 2 * kPi, 1e-6);
}

TEST(LobeMesh, RefinedMeshIsConforming) {
  for (double thetaI : {0.0, 0.01, 0.5, 2.0, 45.0, 88.7, 89.99})
    for (unsigned subdivisions : {0u, 1u, 3u, 5u}) {
      LobeMeshOptions options;
      options.thetaI = radians(thetaI);
      options.phiI = radians(20);
      options.subdivisions = subdivisions;
      SCOPED_TRACE(thetaI);
      SCOPED_TRACE(subdivisions);
      const LobeMesh mesh = makeLobeMesh(mirrorSpike(radians(0.3)), options);
      expectConforming(mesh);
      expectSphereCovered(mesh);
    }
}

TEST(LobeMesh, TheStartingMeshHasFourTrianglesTimesFourALevel) {
  LobeMeshOptions options;
  options.tolerance = 0;
  for (unsigned level : {0u, 1u, 4u, 6u}) {
    options.subdivisions = level;
    const LobeMesh mesh = makeLobeMesh(constantBrdf(1), options);
    EXPECT_EQ(mesh.triangles.size(), std::size_t{4} << (2 * level));
    expectConforming(mesh);
  }
}

TEST(LobeMesh, NeverHasMoreTrianglesThanAllowed) {
  LobeMeshOptions options;
  options.subdivisions = 3;
  options.tolerance = 1e-6;
  options.maximumTriangles = 5000;
  const LobeMesh mesh = makeLobeMesh(mirrorSpike(radians(20)), options);
  EXPECT_LE(mesh.triangles.size(), 5000u);
  EXPECT_GT(mesh.triangles.size(), 4500u);
  EXPECT_FALSE(mesh.complete);
  EXPECT_GT(mesh.chordError, options.tolerance);
  expectConforming(mesh);
  options.tolerance = 0.05;
  options.maximumTriangles = 20000;
  EXPECT_TRUE(makeLobeMesh(mirrorSpike(radians(20)), options).complete);
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

TEST(LobeMesh, AMirrorLikeLobeShowsItsTruePeak) {
  // GGX, D = alpha^2 / (pi (cos^2 (alpha^2 - 1) + 1)^2) at the half vector: 1 / (pi alpha^2) at the mirror direction.
  for (double alpha : {1e-2, 1e-3, 1e-4}) {
    const FunctionBrdf ggx([alpha](const Direction& wi, const Direction& wo) {
      const double tangent =
          std::tan(angleBetween(normalized({wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]}), {0, 0, 1}));
      const double cosine2 = 1 / (1 + tangent * tangent), bump = 1 + tangent * tangent / (alpha * alpha);
      return 1 / (kPi * alpha * alpha * cosine2 * cosine2 * bump * bump);
    });
    for (double thetaI : {0.0, 33.3, 80.0}) {
      LobeMeshOptions options;
      options.thetaI = radians(thetaI);
      options.phiI = 0.7;
      const LobeMesh mesh = makeLobeMesh(ggx, options);
      EXPECT_NEAR(mesh.maximumRadius * kPi * alpha * alpha, 1, 1e-6) << alpha << " at " << thetaI;
      EXPECT_TRUE(mesh.complete);
    }
  }
}

double distanceToTriangle(const Direction& p, const Direction& a, const Direction& b, const Direction& c) {
  const auto minus = [](const Direction& x, const Direction& y) {
    return Direction{x[0] - y[0], x[1] - y[1], x[2] - y[2]};
  };
  const auto toSegment = [&](const Direction& x, const Direction& y) {
    const Direction d = minus(y, x);
    const double t = std::clamp(dot(minus(p, x), d) / std::max(dot(d, d), 1e-300), 0.0, 1.0);
    const Direction r = minus(p, {x[0] + t * d[0], x[1] + t * d[1], x[2] + t * d[2]});
    return std::sqrt(dot(r, r));
  };
  const Direction n = normalized(cross(minus(b, a), minus(c, a)));
  const bool inside = dot(cross(minus(b, a), minus(p, a)), n) >= 0 && dot(cross(minus(c, b), minus(p, b)), n) >= 0 &&
                      dot(cross(minus(a, c), minus(p, c)), n) >= 0;
  if (inside) return std::abs(dot(minus(p, a), n));
  return std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
}

TEST(LobeMesh, KeepsTheChordToleranceAgainstDenseEvaluation) {
  const auto power = [](const Direction& wi, const Direction& wo, double n) {
    return std::pow(std::max(0.0, -wi[0] * wo[0] - wi[1] * wo[1] + wi[2] * wo[2]), n);
  };
  for (double exponent : {50.0, 5000.0}) {
    const FunctionBrdf lobe([&](const Direction& wi, const Direction& wo) { return 0.1 + power(wi, wo, exponent); });
    for (const auto& [tolerance, subdivisions] : {std::pair{1e-3, 5u}, std::pair{1e-2, 2u}}) {
      LobeMeshOptions options;
      options.tolerance = tolerance;
      options.subdivisions = subdivisions;
      const LobeMesh mesh = makeLobeMesh(lobe, options);
      const Direction wi = fromSpherical(options.thetaI, options.phiI);
      double worst = 0;
      for (int k = 0; k < 600; ++k) {  // in widening rings around the mirror direction, then all over
        const double away = k < 400 ? 1e-4 * std::pow(1e4, k / 400.0) : 0, golden = k * 2.399963229728653;
        const Direction wo = k < 400 ? normalized({-wi[0] + away * std::cos(golden), away * std::sin(golden), wi[2]})
                                     : fromSpherical(std::acos((k - 399.5) / 200), golden);
        if (wo[2] <= 0) continue;
        const double r = lobe.evaluate(wi, wo)[0];
        double nearest = 10;
        for (const auto& t : mesh.triangles)
          nearest = std::min(nearest, distanceToTriangle({r * wo[0], r * wo[1], r * wo[2]}, mesh.position(t[0]),
                                                         mesh.position(t[1]), mesh.position(t[2])));
        worst = std::max(worst, nearest);
      }
      EXPECT_LT(worst, 1.5 * tolerance * mesh.maximumRadius) << exponent;  // inside triangles, too
      EXPECT_LE(mesh.chordError, tolerance);
      EXPECT_LT(mesh.triangles.size(), 40000u);
    }
  }
}

TEST(LobeMesh, DifferenceOfLambertiansIsTheDifferenceOfTheirLengths) {
  const FunctionBrdf a = constantBrdf(0.125), b = constantBrdf(1);
  LobeMeshOptions options;
  options.scale = {LobeTransform::CubeRoot};
  options.shape = LobeShape::Difference;
  const LobeMesh below = makeLobeMesh(a, options, &b);
  for (std::size_t i = 0; i < below.vertexCount(); ++i) {
    ASSERT_NEAR(below.lengths[i], -0.5, 1e-15);
    ASSERT_NEAR(below.radii[i], 0.5, 1e-15);
    ASSERT_NEAR(below.values[i], -0.875, 1e-15);
  }
  options.shape = LobeShape::Displaced;
  const LobeMesh dented = makeLobeMesh(a, options, &b), raised = makeLobeMesh(b, options, &a);
  EXPECT_NEAR(dented.referenceRadius, 0.5, 1e-15);
  EXPECT_NEAR(dented.maximumRadius, 0, 1e-15);
  EXPECT_NEAR(raised.maximumRadius, 1, 1e-15);
  EXPECT_THROW(makeLobeMesh(a, options), Error);
  const FunctionBrdf colour = constantBrdf(1, Channels::rgb());
  EXPECT_THROW(makeLobeMesh(a, options, &colour), Error);
}

TEST(LobeMesh, DegenerateLobesHaveAMesh) {
  const FunctionBrdf zero = constantBrdf(0),
                     holes([](const Direction&, const Direction&) { return 1.0; }, {},
                           [](const Direction&, const Direction&) { return false; }),
                     broken = constantBrdf(std::nan("")), endless = constantBrdf(HUGE_VAL);
  const LobeMesh flat = makeLobeMesh(zero, {});
  EXPECT_EQ(flat.maximumRadius, 0);
  EXPECT_EQ(flat.chordError, 0);
  EXPECT_GT(flat.triangles.size(), 4000u);
  for (const FunctionBrdf* brdf : {&holes, &broken, &endless}) {
    const LobeMesh mesh = makeLobeMesh(*brdf, {});
    EXPECT_EQ(mesh.triangles.size(), 0u);
    EXPECT_EQ(mesh.maximumRadius, 0);
    for (double value : mesh.values) ASSERT_EQ(value, 0);
  }
  LobeMeshOptions options;
  options.shape = LobeShape::Displaced;
  EXPECT_EQ(makeLobeMesh(zero, options, &zero).maximumRadius, 0);
}

TEST(LobeMesh, AStepInTheDataEndsTheRefinement) {
  const FunctionBrdf step([](const Direction&, const Direction& wo) { return wo[0] + 0.3 * wo[1] > 0.1 ? 1.0 : 0.2; });
  const LobeMesh mesh = makeLobeMesh(step, {});
  EXPECT_GT(mesh.vertexCount(), 2000u);
  EXPECT_LT(mesh.vertexCount(), 30000u);
  EXPECT_TRUE(mesh.complete);
  expectConforming(mesh);
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
  for (const std::string& name : lobeTransformNames()) EXPECT_EQ(transformed({parseLobeTransform(name)}, -0.5), 0);
  EXPECT_EQ(transformed({LobeTransform::LogFloor, 0.01}, 0.009), 0);
  EXPECT_NEAR(transformed({LobeTransform::LogFloor, 0.01}, 10), 3, 1e-15);
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
  refused([](LobeMeshOptions& o) { o.scale.floor = 0; });
  refused([](LobeMeshOptions& o) { o.smallestBend = 0; });
  refused([](LobeMeshOptions& o) { o.smallestPeak = 0; });
  EXPECT_THROW(parseLobeTransform("sqrt"), Error);
}

}  // namespace
}  // namespace brdf
