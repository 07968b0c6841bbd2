#include "SimulationSupport.h"

#include <brdf/base/Error.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace brdf {
namespace {

using testing::anisotropicLayout, testing::flatField, testing::simulated, testing::facetedSurface, testing::wavyField;

constexpr double kSigmas = 5;

void expectSound(const LobeSimulation& lobe, const std::string& what, double mostLost) {
  const EnergyBalance balance = lobe.balance();
  for (std::size_t c = 0; c < balance.sum.size(); ++c) {
    EXPECT_NEAR(balance.sum[c].value, 1, kSigmas * balance.sum[c].error + 1e-9) << what;
    EXPECT_LE(balance.lost[c].value, mostLost) << what;
    for (const auto* list : {&balance.reflected, &balance.transmitted, &balance.absorbed, &balance.lost}) {
      EXPECT_TRUE(std::isfinite((*list)[c].value)) << what;
      EXPECT_GE((*list)[c].value, -1e-12) << what;
    }
    for (std::size_t b = 0; b < lobe.bins().count(); ++b) {
      const Estimate value = lobe.value(c, b);
      EXPECT_TRUE(std::isfinite(value.value) && std::isfinite(value.error) && value.value >= 0) << what;
    }
  }
}

TEST(SimulationExtremes, GrazingLightIsNotLost) {
  for (const char* facet : {"mirror", "lambertian(albedo=0.8)", "dielectric(eta=1.5)"})
    for (const double steepness : {0.01, 1.0})
      for (const double theta : {85.0, 89.9, 89.99})
        expectSound(simulated(facetedSurface(wavyField(steepness), {facet}), anisotropicLayout({theta}, {30}), theta,
                              30, 20'000),
                    std::string(facet) + " " + std::to_string(theta), 2e-4);
}

TEST(SimulationExtremes, SteepSurfacesAndAnySize) {
  for (const double unit : {1e-6, 1.0, 1e6}) {
    HeightField field = wavyField(50);
    field.spacingX *= unit;
    field.spacingY *= unit;
    for (float& h : field.heights) h *= static_cast<float>(unit);
    expectSound(simulated(facetedSurface(field, {"mirror"}), anisotropicLayout({40}, {0}), 40, 0, 20'000),
                "unit " + std::to_string(unit), 5e-4);
  }
  // Needles: every cell a spike a thousand times as high as wide.
  HeightField needles{8, 8, 0.01, 0.01, std::vector<float>(64, 0.0F)};
  for (std::size_t k = 0; k < 64; k += 2) needles.heights[k] = 10;
  expectSound(simulated(facetedSurface(needles, {"lambertian(albedo=0.9)"}), anisotropicLayout({40}, {0}), 40, 0, 5000),
              "needles", 2e-3);
}

TEST(SimulationExtremes, TheSameSurfaceInAnotherUnitIsTheSame) {
  const HeightField field = wavyField(1);
  HeightField large = field;
  large.spacingX *= 1024;  // a power of two: nothing rounds
  large.spacingY *= 1024;
  for (float& h : large.heights) h *= 1024;
  const auto a = simulated(facetedSurface(field, {"mirror"}), anisotropicLayout({40}, {0}), 40, 0, 5000);
  const auto b = simulated(facetedSurface(large, {"mirror"}), anisotropicLayout({40}, {0}), 40, 0, 5000);
  EXPECT_EQ(a.tally().reflected.sum, b.tally().reflected.sum);
}

TEST(SimulationExtremes, EmptyPackings) {
  const SpherePacking none{{}, 1, 1, true}, nothing{{}, 1, 1, false};
  const GridLayout layout = anisotropicLayout({60}, {0});
  const auto plane =
      simulated(facetedSurface(none, {"mirror", "lambertian(albedo=0.25)"}), layout, 60, 0, 1000).balance();
  EXPECT_NEAR(plane.reflected[0].value, 0.25, 1e-12);
  const auto air = simulated(facetedSurface(nothing, {"mirror"}), layout, 60, 0, 1000).balance();
  EXPECT_EQ(air.specularTransmitted[0].value, 1);
}

TEST(SimulationExtremes, DegenerateTrianglesAndEmptyMeshes) {
  const TiledMesh sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5F, 0.5F, 0}},
                        {{0, 1, 2}, {0, 2, 3}, {0, 0, 1}, {0, 4, 2}, {4, 4, 4}},
                        {},
                        1,
                        1};
  const GridLayout layout = anisotropicLayout({60}, {0});
  EXPECT_EQ(simulated(facetedSurface(sheet, {"mirror"}), layout, 60, 0, 1000).balance().specularReflected[0].value, 1);
  const TiledMesh empty{{}, {}, {}, 1, 1};
  EXPECT_EQ(simulated(facetedSurface(empty, {"mirror"}), layout, 60, 0, 1000).balance().specularTransmitted[0].value,
            1);
}

TEST(SimulationExtremes, AMeshThatReachesBeyondItsTileIsWhole) {
  // One square of side 2 in a tile of 4 x 4, over the corner: a quarter of the light meets it wherever it lies.
  const auto square = [](float x, float y) {
    return TiledMesh{{{x, y, 0}, {x + 2, y, 0}, {x + 2, y + 2, 0}, {x, y + 2, 0}}, {{0, 1, 2}, {0, 2, 3}}, {}, 4, 4};
  };
  constexpr std::uint64_t rays = 40'000;
  const GridLayout layout = anisotropicLayout({0}, {0});
  for (const auto& mesh : {square(1, 1), square(3, 3), square(-101, 30.5F)}) {
    const auto balance = simulated(facetedSurface(mesh, {"mirror"}), layout, 0, 0, rays).balance();
    EXPECT_NEAR(balance.specularReflected[0].value, 0.25, kSigmas * std::sqrt(0.25 * 0.75 / rays));
    EXPECT_NEAR(balance.specularTransmitted[0].value, 0.75, kSigmas * std::sqrt(0.25 * 0.75 / rays));
  }
}

TEST(SimulationExtremes, TheBackOfAnOpaqueSheetIsLost) {
  const TiledMesh upsideDown{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 2, 1}, {0, 3, 2}}, {}, 1, 1};
  const auto balance =
      simulated(facetedSurface(upsideDown, {"mirror"}), anisotropicLayout({10}, {0}), 10, 0, 1000).balance();
  EXPECT_EQ(balance.lost[0].value, 1);
}

TEST(SimulationExtremes, SurfacesThatCannotBeTracedAreRefused) {
  const auto refused = [](const Microsurface& surface) { EXPECT_THROW(makeTransport("cpu", surface), Error); };
  HeightField hole = flatField();
  hole.heights[2] = NAN;
  refused(facetedSurface(hole, {"mirror"}));
  refused(facetedSurface(SpherePacking{{{{0, 0, 0}, -1}}, 1, 1, false}, {"mirror"}));
  refused(facetedSurface(SpherePacking{{}, 0, 1, true}, {"mirror", "mirror"}));
  refused(facetedSurface(SpherePacking{{}, 1, 1, true}, {"mirror"}));  // no facet for the plane
  refused(facetedSurface(TiledMesh{{{0, 0, 0}}, {{0, 1, 2}}, {}, 1, 1}, {"mirror"}));
  refused(facetedSurface(flatField(), {}));
  Microsurface channels = facetedSurface(flatField(), {"lambertian(albedo=0.5 0.4 0.3)"});
  channels.channels = Channels::spectral({400, 500});
  refused(channels);
}

}  // namespace
}  // namespace brdf
