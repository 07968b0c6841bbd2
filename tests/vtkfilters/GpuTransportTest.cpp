#include "../simulate/SimulationSupport.h"

#include "vtkBRDFHeadlessRenderWindow.h"
#include "vtkBRDFShaderProbe.h"
#include "vtkBRDFShaderText.h"

#include "vtkNew.h"

#include <brdf/base/Error.h>
#include <brdf/simulate/Fresnel.h>
#include <brdf/simulate/SurfaceKinds.h>
#include <gtest/gtest.h>

#include <thread>

namespace {
using namespace brdf;
using brdf::testing::anisotropicLayout, brdf::testing::flatField, brdf::testing::isotropicLayout,
    brdf::testing::facetedSurface, brdf::testing::wavyField;

// Standard errors allowed a figure: 5 sigma happen once in 1.7 million.
constexpr double kSigmas = 5;

LobeSimulation Lobe(const std::string& backend, const Microsurface& surface, const GridLayout& layout, double thetaI,
                    double phiI, std::uint64_t rays, std::uint64_t seed = 1, const TransportOptions& options = {}) {
  LobeSimulation lobe(makeTransport(backend, surface, options), surface.channels, layout, radians(thetaI),
                      radians(phiI), seed);
  lobe.add(rays);
  return lobe;
}

// The same triangles as those of a height field.
TiledMesh MeshOf(const HeightField& field) {
  TiledMesh mesh;
  mesh.periodX = field.periodX();
  mesh.periodY = field.periodY();
  const auto columns = static_cast<std::uint32_t>(field.columns), rows = static_cast<std::uint32_t>(field.rows);
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i)
      mesh.points.push_back({static_cast<float>(i * field.spacingX), static_cast<float>(j * field.spacingY),
                             field.height(i % columns, j % rows)});
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, d = a + columns + 1;
      mesh.triangles.push_back({a, a + 1, d + 1});
      mesh.triangles.push_back({a, d + 1, d});
    }
  return mesh;
}

SpherePacking Packing(bool substrate) {
  return {{{{1, 1, 1}, 1}, {{2.5F, 2.4F, 0.4F}, 0.8F}, {{0.2F, 2.5F, 2.2F}, 0.7F}}, 3, 3, substrate};
}

// What chi-square of so many degrees of freedom exceeds once in 3.5 million (5 sigma, one-sided): Wilson and Hilferty
// 1931, DOI 10.1073/pnas.17.12.684.
double MostChiSquare(double freedom) {
  const double v = 2 / (9 * freedom);
  return freedom * std::pow(1 - v + kSigmas * std::sqrt(v), 3);
}

// Both backends' answers differ by their standard errors: every share of the light, and the bins together by chi-square
// of their combined errors at 5 sigma.
void ExpectSame(const std::string& name, const Microsurface& surface, const GridLayout& layout, double thetaI,
                double phiI, std::uint64_t rays) {
  SCOPED_TRACE(name + " at " + std::to_string(thetaI) + " degrees");
  const LobeSimulation cpu = Lobe("cpu", surface, layout, thetaI, phiI, rays, 1);
  const LobeSimulation gpu = Lobe("gpu", surface, layout, thetaI, phiI, rays, 2);
  ASSERT_EQ(gpu.tally().rays, rays);
  for (std::size_t c = 0; c < surface.channels.count(); ++c) {
    // Where next to nothing happens by chance, a rare event more or less is beyond its standard error.
    for (const Outcome outcome : {Outcome::Reflected, Outcome::Transmitted, Outcome::Absorbed, Outcome::Lost,
                                  Outcome::SpecularReflected, Outcome::SpecularTransmitted, Outcome::Sum}) {
      const Estimate a = cpu.tally().outcome(outcome, c), b = gpu.tally().outcome(outcome, c);
      EXPECT_NEAR(a.value, b.value, kSigmas * std::hypot(a.error, b.error) + 1e-4) << static_cast<int>(outcome);
    }
    // Nothing falls through a height field; elsewhere a ray of thousands may meet an edge within rounding.
    const bool field = std::holds_alternative<HeightField>(surface.shape);
    EXPECT_LE(gpu.tally().outcome(Outcome::Lost, c).value, field ? 0 : 3e-4);
    double chi2 = 0;
    int bins = 0;
    for (std::size_t b = 0; b < cpu.bins().count(); ++b)
      for (const bool above : {true, false}) {
        const Estimate one = above ? cpu.value(c, b) : cpu.transmission(c, b);
        const Estimate two = above ? gpu.value(c, b) : gpu.transmission(c, b);
        // Bins of so few rays that their errors are rough say little.
        if (!(one.error < 0.2 * one.value && two.error < 0.2 * two.value) || one.error + two.error == 0) continue;
        chi2 += std::pow(one.value - two.value, 2) / (one.error * one.error + two.error * two.error);
        ++bins;
      }
    EXPECT_LT(chi2, bins > 0 ? MostChiSquare(bins) : 1) << bins << " bins";
  }
}

TEST(GpuTransport, RandomNumbersArePhilox) {
  // Known answers of Philox4x32-10 (counter, key, result): tests/kat_vectors of the Random123 library of its authors,
  // github.com/DEShawResearch/random123, commit 9545ff6.
  struct Known {
    std::string counter, key;
    std::array<std::uint32_t, 4> words;
  };
  const Known known[] = {{"0u, 0u, 0u, 0u", "0u, 0u", {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
                         {"~0u, ~0u, ~0u, ~0u", "~0u, ~0u", {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
                         {"0x243f6a88u, 0x85a308d3u, 0x13198a2eu, 0x03707344u",
                          "0xa4093822u, 0x299f31d0u",
                          {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}}};
  vtkBRDFShaderProbe probe;
  const std::string functions(vtkBRDFShaderText::File("brdf_transport_path.glsl"));
  for (const Known& answer : known)
    for (const char* half : {">> 16", "& 65535u"}) {
      std::vector<std::string> expressions;
      for (const char* word : {"x", "y", "z", "w"})
        expressions.push_back("float(brdfPhilox(uvec4(" + answer.counter + "), uvec2(" + answer.key + "))." + word +
                              " " + half + ")");
      const auto values = probe.Evaluate(functions, {{"unused", {0}}}, expressions);
      for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t expected = half[0] == '>' ? answer.words[k] >> 16 : answer.words[k] & 65535U;
        EXPECT_EQ(static_cast<std::uint32_t>(values[k][0]), expected) << answer.counter << " word " << k;
      }
    }
}

TEST(GpuTransport, AFlatMirrorIsSpecularExactly) {
  const TiledMesh mesh = MeshOf(flatField(3));
  for (const Microsurface& surface : {facetedSurface(flatField(3), {"mirror"}), facetedSurface(mesh, {"mirror"}),
                                      facetedSurface(SpherePacking{{}, 1, 1, true}, {"mirror", "mirror"})})
    for (const double theta : {0.0, 30.0, 60.0, 89.9}) {
      const auto lobe = Lobe("gpu", surface, anisotropicLayout({theta}, {20}), theta, 20, 4096);
      EXPECT_EQ(lobe.balance().specularReflected[0].value, 1) << theta;
      EXPECT_EQ(lobe.balance().reflected[0].value, 1) << theta;
      EXPECT_EQ(lobe.balance().reflected[0].error, 0) << theta;
    }
}

TEST(GpuTransport, FlatConductorsAndDielectricsAreFresnel) {
  const Microsurface gold = facetedSurface(flatField(), {"conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2)"});
  const Microsurface glass = facetedSurface(flatField(), {"dielectric(eta=1.5)"});
  for (const double theta : {0.0, 45.0, 80.0, 89.9}) {
    const double c = std::cos(radians(theta));
    const auto metal = Lobe("gpu", gold, isotropicLayout({theta}), theta, 0, 2048).balance();
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = conductorReflectance(c, gold.facets[0].eta[k], gold.facets[0].k[k]);
      EXPECT_NEAR(metal.specularReflected[k].value, expected, 2e-6) << theta;
      EXPECT_NEAR(metal.absorbed[k].value, 1 - expected, 2e-6) << theta;
      EXPECT_EQ(metal.sum[k].value, 1);
    }
    double cosT;
    const double expected = dielectricReflectance(c, 1.5, cosT);
    // Both parts of every ray are followed: no noise.
    const auto clear = Lobe("gpu", glass, isotropicLayout({theta}), theta, 0, 2048).balance();
    EXPECT_NEAR(clear.specularReflected[0].value, expected, 2e-6) << theta;
    EXPECT_NEAR(clear.specularTransmitted[0].value, 1 - expected, 2e-6) << theta;
    EXPECT_NEAR(clear.sum[0].value, 1, 1e-7);
  }
}

TEST(GpuTransport, AFlatLambertianSurfaceIsAlbedoOverPi) {
  constexpr std::uint64_t rays = 200'000;
  const Microsurface surface = facetedSurface(flatField(), {"lambertian(albedo=0.6)"});
  const auto lobe = Lobe("gpu", surface, anisotropicLayout({70}, {0}), 70, 0, rays);
  EXPECT_NEAR(lobe.balance().reflected[0].value, 0.6, 1e-7);
  double chi2 = 0;
  for (std::size_t b = 0; b < lobe.bins().count(); ++b) {
    const double measure = lobe.bins().projectedSolidAngles()[b], p = measure / kPi;
    const double sigma = 0.6 * std::sqrt(p * (1 - p) / rays) / measure;
    chi2 += std::pow((lobe.value(0, b).value - 0.6 / kPi) / sigma, 2);
  }
  const double freedom = static_cast<double>(lobe.bins().count()) - 1;
  EXPECT_NEAR(chi2, freedom, kSigmas * std::sqrt(2 * freedom));
}

TEST(GpuTransport, GroovesOf45DegreesSendLightBack) {
  // Back: 1 - tan(theta); past the ridge: tan(theta) (tests/simulate/TransportTest.cpp derives them).
  for (const double theta : {7.5, 22.5, 42.5}) {
    constexpr std::uint64_t rays = 50'000;
    const auto lobe = Lobe("gpu", facetedSurface(brdf::testing::vGrooves(), {"mirror"}),
                           anisotropicLayout({theta}, {0}), theta, 0, rays);
    const double t = std::tan(radians(theta)), sigma = std::sqrt(t * (1 - t) / rays);
    const auto& sums = lobe.tally().reflected.sum;
    const double back = sums[lobe.bins().find(fromSpherical(radians(theta), 0))] / rays;
    const double past = sums[lobe.bins().find(fromSpherical(radians(90 - theta), 0))] / rays;
    EXPECT_NEAR(back, 1 - t, kSigmas * sigma) << theta;
    EXPECT_NEAR(past, t, kSigmas * sigma) << theta;
    EXPECT_NEAR(back + past, 1, 1e-4) << theta;
    EXPECT_EQ(lobe.balance().lost[0].value, 0);
  }
}

TEST(GpuTransport, ASlabAbsorbsByBeerAndLambert) {
  // Of the reflectance R of a face and A = exp(-2 a): R + (1 - R)^2 R A^2 / (1 - R^2 A^2) comes back and
  // (1 - R)^2 A / (1 - R^2 A^2) passes.
  const TiledMesh slab{{{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                       {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}},
                       {},
                       1,
                       1};
  const double R = 0.04;
  for (const double a : {0.05, 1.0}) {
    const auto balance =
        Lobe("gpu", facetedSurface(slab, {"dielectric(eta=1.5, absorption=" + std::to_string(a) + ")"}),
             isotropicLayout({0}), 0, 0, 50'000)
            .balance();
    const double A = std::exp(-2 * a), inside = (1 - R) * (1 - R) / (1 - R * R * A * A);
    EXPECT_NEAR(balance.specularReflected[0].value, R + inside * R * A * A,
                kSigmas * balance.specularReflected[0].error + 1e-6);
    EXPECT_NEAR(balance.specularTransmitted[0].value, inside * A,
                kSigmas * balance.specularTransmitted[0].error + 1e-6);
    EXPECT_EQ(balance.lost[0].value, 0);
  }
}

TEST(GpuTransport, HeightFieldsAnswerLikeTheCpu) {
  Microsurface gaussian = makeSurface("gaussian(rms=0.3, correlation=2, seed=3)").surface;
  gaussian.facets = {parseFacet("mirror")};
  HeightField sine{48, 2, 1.0 / 48, 0.3, {}};  // no change along y, uneven cells
  for (std::size_t k = 0; k < 96; ++k)
    sine.heights.push_back(static_cast<float>(0.2 * std::sin(2 * kPi * static_cast<double>(k % 48) / 48)));
  HeightField uneven{7, 5, 0.3, 0.2, {}};
  for (std::size_t k = 0; k < 35; ++k)
    uneven.heights.push_back(static_cast<float>(100 + 0.2 * std::cos(5.0 * static_cast<double>(k * k))));
  for (const double theta : {0.0, 50.0, 89.9}) {
    const GridLayout layout = anisotropicLayout({theta}, {20});
    ExpectSame("gaussian", gaussian, layout, theta, 20, 30'000);
    ExpectSame("sine", facetedSurface(sine, {"mirror"}), layout, theta, 20, 30'000);
    ExpectSame("uneven", facetedSurface(uneven, {"mirror"}), layout, theta, 20, 30'000);
    ExpectSame("steep white", facetedSurface(wavyField(3), {"lambertian(albedo=0.9)"}), layout, theta, 20, 20'000);
  }
}

TEST(GpuTransport, FacetsAnswerLikeTheCpu) {
  for (const char* facet : {"conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2)", "dielectric(eta=1.5, absorption=0.3)",
                            "dielectric(eta=1.4 1.5 1.6)", "lambertian(albedo=0.6 0.3 0)",
                            "scattering(0.3*Lambertian + (0.5, 0.7, 0.9)*GGX(alpha=0.3, ior=1.5))"})
    for (const double theta : {20.0, 80.0})
      ExpectSame(facet, facetedSurface(wavyField(2), {facet}), anisotropicLayout({theta}, {0}), theta, 0, 20'000);
}

TEST(GpuTransport, MeshesAnswerLikeTheCpu) {
  const TiledMesh mesh = MeshOf(wavyField(2, 16));
  for (const char* facet : {"mirror", "dielectric(eta=1.5)"})
    for (const double theta : {0.0, 60.0, 89.9})
      ExpectSame(facet, facetedSurface(mesh, {facet}), anisotropicLayout({theta}, {20}), theta, 20, 20'000);
}

TEST(GpuTransport, SpheresAnswerLikeTheCpu) {
  struct Case {
    const char *spheres, *plane;
  };
  for (const Case& c :
       {Case{"mirror", "lambertian(albedo=0.5)"}, Case{"dielectric(eta=1.5)", "mirror"},
        Case{"mirror", "dielectric(eta=1.33)"}, Case{"dielectric(eta=1.5)", "dielectric(eta=1.33, absorption=0.2)"},
        Case{"lambertian(albedo=0.8)", ""}})
    for (const double theta : {0.0, 60.0, 89.9}) {
      const bool substrate = *c.plane != 0;
      ExpectSame(std::string(c.spheres) + " on " + c.plane,
                 facetedSurface(Packing(substrate), substrate ? std::vector<std::string>{c.spheres, c.plane}
                                                              : std::vector<std::string>{c.spheres}),
                 anisotropicLayout({theta}, {20}), theta, 20, 10'000);
    }
}

TEST(GpuTransport, TurnedSurfacesAnswerLikeTheCpu) {
  for (const double theta : {30.0, 75.0})
    ExpectSame("turned", facetedSurface(wavyField(1), {"mirror"}), isotropicLayout({theta}), theta, 0, 30'000);
}

TEST(GpuTransport, WhatIsCutCountsAsLost) {
  TransportOptions options;
  options.bounces = 1;
  const Microsurface surface = facetedSurface(brdf::testing::vGrooves(), {"mirror"});
  // Across the grooves at 0 degrees every ray meets both walls; at 26.565 degrees (tan = 1/2) a half.
  EXPECT_EQ(Lobe("gpu", surface, isotropicLayout({0}), 0, 0, 5000, 1, options).balance().lost[0].value, 1);
  const auto balance =
      Lobe("gpu", surface, anisotropicLayout({26}, {0}), degrees(std::atan(0.5)), 0, 40'000, 1, options).balance();
  EXPECT_NEAR(balance.lost[0].value, 0.5, kSigmas * balance.lost[0].error);
  EXPECT_EQ(balance.sum[0].value, 1);
}

TEST(GpuTransport, RaysAreTheSameWhateverTheBatches) {
  const Microsurface surface = facetedSurface(wavyField(2), {"dielectric(eta=1.5)"});
  const GridLayout layout = anisotropicLayout({40}, {0});
  const auto whole = Lobe("gpu", surface, layout, 40, 0, 30'000, 7);
  auto parts = Lobe("gpu", surface, layout, 40, 0, 1, 7);
  for (const std::uint64_t rays : {4999U, 20'000U, 5000U}) parts.add(rays);
  EXPECT_EQ(whole.tally().reflected.sum, parts.tally().reflected.sum);
  EXPECT_EQ(whole.tally().outcomes.square, parts.tally().outcomes.square);
  EXPECT_NE(whole.tally().reflected.sum, Lobe("gpu", surface, layout, 40, 0, 30'000, 8).tally().reflected.sum);
}

TEST(GpuTransport, ComesAndGoesBesideWindowsAndInThreads) {
  vtkNew<vtkBRDFHeadlessRenderWindow> window;
  window->Render();
  const Microsurface surface = facetedSurface(wavyField(1, 8), {"mirror"});
  const GridLayout layout = isotropicLayout({30});
  const auto first = Lobe("gpu", surface, layout, 30, 0, 100);
  for (int k = 0; k < 50; ++k)
    ASSERT_EQ(Lobe("gpu", surface, layout, 30, 0, 100).tally().reflected.sum, first.tally().reflected.sum);
  EXPECT_TRUE(window->IsCurrent()) << "the caller's context stays";
  window->Render();
  std::shared_ptr<Transport> transport = makeTransport("gpu", surface);
  for (int k = 0; k < 3; ++k)
    std::thread([&] {
      LobeSimulation lobe(transport, surface.channels, layout, radians(30.0), 0, 1);
      lobe.add(100);
      EXPECT_EQ(lobe.tally().reflected.sum, first.tally().reflected.sum);
    }).join();
}

TEST(GpuTransport, SaysWhatItCannotTrace) {
  const auto message = [](const Microsurface& surface) {
    try {
      makeTransport("gpu", surface);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  Microsurface surface =
      facetedSurface(Packing(true), {"scattering(Lambertian)", "scattering(GGX(alpha=0.1, ior=1.5))"});
  EXPECT_NE(message(surface).find("one material on facets"), std::string::npos) << message(surface);
  surface.facets[1] = parseFacet("mirror");
  EXPECT_EQ(message(surface), "");
  auto table = Lobe("cpu", facetedSurface(wavyField(1), {"mirror"}), isotropicLayout({30}), 30, 0, 1000).lobe();
  surface.facets[0].brdf = table;
  EXPECT_NE(message(surface).find("a sum of lobes"), std::string::npos) << message(surface);
}
}  // namespace
