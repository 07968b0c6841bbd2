#include <brdf/base/Error.h>
#include <brdf/io/LoadMaterial.h>
#include <brdf/io/SaveMaterial.h>
#include <brdf/material/Resample.h>
#include <brdf/simulate/wave/Roughness.h>
#include <gtest/gtest.h>

#include "../TestFolder.h"
#include "WaveSupport.h"

namespace brdf {
namespace {

constexpr double kPi = std::numbers::pi;
double square(double x) { return x * x; }

TEST(RoughnessLimits, ScatterOfASmoothSurfaceIsThatOfDavies) {
  // H. Davies, Proc. IEE 101, 209 (1954); H. E. Bennett and J. O. Porteus, J. Opt. Soc. Am. 51, 123-129 (1961),
  // doi:10.1364/JOSA.51.000123: TIS = (4 pi sigma cos / lambda)^2 of a good reflector whose correlation length is large
  // against the wavelength, here 50 wavelengths. The perturbation's obliquity differs from 1 by (spread of angles)^2.
  const double wavelength = 0.5, rms = 0.001, length = 25;
  for (const double theta : {0.0, 30.0, 60.0}) {
    const auto model =
        makeWaveBrdf("RayleighRice(wavelength=0.5, eta=1, k=1e6, spectrum=gaussian(rms=0.001, correlation=25))");
    const std::array<double, 3> wi = directionOf(theta, 180);
    // Around the mirror direction, in direction cosines: BRDF cos dOmega = BRDF dx dy.
    double sum = 0;
    const int steps = 160;
    const double reach = 4 * wavelength / (kPi * length), step = 2 * reach / steps;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const double x = -wi[0] - reach + (i + 0.5) * step, y = -reach + (j + 0.5) * step;
        sum += model->evaluate(wi, {x, y, std::sqrt(1 - x * x - y * y)})[0] * step * step;
      }
    EXPECT_NEAR(sum / square(4 * kPi * rms * std::cos(theta * kDegree) / wavelength), 1, 2e-3) << theta;
  }
}

TEST(RoughnessLimits, ThreeTheoriesAgreeNearTheMirrorOfASmoothSurface) {
  // For small heights Phi = g PSD / variance: Harvey-Shack over Rayleigh-Rice is (ci + cs)^2 / (4 ci cs), Beckmann's
  // factor F over that a further |wi + wo|^4 / (4 ...); all of them 1 in the mirror direction.
  const std::string surface = "(wavelength=0.633, eta=1, k=1e6, spectrum=gaussian(rms=1e-5, correlation=2))";
  for (const double theta : {5.0, 30.0, 60.0, 80.0}) {
    const PairOfDirections mirror(theta, theta, 0);
    const double rr = valueOf("RayleighRice" + surface, mirror);
    EXPECT_NEAR(valueOf("HarveyShack" + surface, mirror) / rr, 1, 1e-6) << theta;
    EXPECT_NEAR(valueOf("BeckmannKirchhoff" + surface, mirror) / rr, 1, 1e-4) << theta;
    // Away from it the correlation is short, so that the first order is not below the tail of the second.
    const std::string fine = "(wavelength=0.633, eta=1, k=1e6, spectrum=gaussian(rms=1e-5, correlation=0.2))";
    const PairOfDirections off(theta, 45, 20);
    const double ci = off.wi[2], cs = off.wo[2];
    EXPECT_NEAR(valueOf("HarveyShack" + fine, off) / valueOf("RayleighRice" + fine, off),
                square(ci + cs) / (4 * ci * cs), 1e-6)
        << theta;
  }
}

TEST(RoughnessLimits, ModifiedBeckmannIsOriginalOverItsFactor) {
  const PairOfDirections pair(35, 50, 25);
  const std::string arguments = "(spectrum=gaussian(rms=0.1, correlation=1), k=3";
  const double ci = pair.wi[2], cs = pair.wo[2];
  const double tangential = pair.wi[0] * pair.wo[0] + pair.wi[1] * pair.wo[1];
  EXPECT_NEAR(valueOf("BeckmannKirchhoff" + arguments + ")", pair) /
                  valueOf("BeckmannKirchhoff" + arguments + ", form=modified)", pair),
              square(1 + ci * cs + tangential) / (ci * cs * square(ci + cs)), 1e-12);
}

TEST(RoughnessLimits, RoughSurfacesScatterWhatTheyDoNotReflect) {
  // Energy: specular plus scattered light of a perfect conductor is about 1 for moderate slopes at normal incidence.
  for (const double rms : {0.02, 0.08, 0.3}) {
    const auto model = makeWaveBrdf(
        "HarveyShack(wavelength=0.5, eta=1, k=1e6, spectrum=gaussian(rms=" + std::to_string(rms) + ", correlation=4))");
    const std::array<double, 3> wi{0, 0, 1};
    const double scattered =
        hemisphereIntegral([&](const std::array<double, 3>& wo) { return model->evaluate(wi, wo)[0]; }, 600, 8);
    EXPECT_NEAR(scattered + model->models()[0]->specular(0), 1, 0.02) << rms;
  }
}

TEST(WaveGrating, SharesOfAllOrdersSumToOne) {
  for (const auto profile : {wave::GratingShape::Profile::Sinusoidal, wave::GratingShape::Profile::Lamellar})
    for (const double phase : {0.0, 0.5, kPi, 7.0, 40.0}) {
      wave::GratingShape shape;
      shape.profile = profile;
      shape.duty = 0.3;
      double sum = 0;
      for (int m = -20000; m <= 20000; ++m) sum += wave::orderShare(shape, m, phase);
      // The orders of a lamella beyond M hold at most 8 / (pi^2 M); those of a sinusoid beyond the phase nothing.
      EXPECT_NEAR(sum, 1, profile == wave::GratingShape::Profile::Sinusoidal ? 1e-12 : 8 / (kPi * kPi * 20000))
          << phase;
    }
}

TEST(WaveGrating, ClosedForms) {
  wave::GratingShape half{wave::GratingShape::Profile::Lamellar, 10, 1, 0.5, 0};
  // Phase pi at duty 1/2: no zeroth nor even orders, (2 / (pi m))^2 in the odd ones.
  EXPECT_NEAR(wave::orderShare(half, 0, kPi), 0, 1e-15);
  EXPECT_NEAR(wave::orderShare(half, 1, kPi), 4 / square(kPi), 1e-15);
  EXPECT_NEAR(wave::orderShare(half, 2, kPi), 0, 1e-15);
  EXPECT_NEAR(wave::orderShare(half, -3, kPi), 4 / square(3 * kPi), 1e-15);
  wave::GratingShape sinusoid{wave::GratingShape::Profile::Sinusoidal, 10, 1, 0.5, 0};
  EXPECT_NEAR(wave::orderShare(sinusoid, 1, 2 * 1.8411837813), square(0.5818652243), 1e-9);  // the largest J1
}

TEST(WaveGrating, OrdersLeaveByTheGratingEquation) {
  // sin theta_m = m wavelength/period - sin theta_i with theta_i on the side of +x.
  for (const auto& order : gratingOrders("Grating(wavelength=0.5, period=2, depth=0.1)", 0, 30 * kDegree, 0)) {
    const double sine = order.order * 0.25 - 0.5;
    EXPECT_NEAR(std::sin(order.theta) * std::cos(order.phi), sine, 1e-12);
  }
  EXPECT_EQ(gratingOrders("Grating(wavelength=0.5, period=2)", 0, 30 * kDegree, 0).size(), 7u);  // -1 to 5; 6 grazes
  EXPECT_THROW(gratingOrders("Facet()", 0, 0, 0), Error);
}

TEST(WaveGrating, TheIntegralOverAnOrderIsItsEfficiency) {
  const std::string expression = "Grating(wavelength=0.5, period=2, depth=0.1, eta=0.2, k=3, width=0.003)";
  const auto model = makeWaveBrdf(expression);
  const std::array<double, 3> wi = directionOf(20, 0);
  for (const auto& order : gratingOrders(expression, 0, 20 * kDegree, 0)) {
    if (std::abs(order.order) > 2) continue;
    const double cx = std::sin(order.theta) * std::cos(order.phi), cy = std::sin(order.theta) * std::sin(order.phi);
    double sum = 0;
    const double step = 0.0006;
    for (int i = -40; i <= 40; ++i)
      for (int j = -40; j <= 40; ++j) {
        const double x = cx + i * step, y = cy + j * step;
        sum += model->evaluate(wi, {x, y, std::sqrt(1 - x * x - y * y)})[0] * step * step;
      }
    EXPECT_NEAR(sum / order.efficiency, 1, 1e-3) << order.order;
  }
}

TEST(WaveModels, ErrorsAreOneLineWithColumnAndNearest) {
  try {
    makeWaveBrdf("RaileighRice()");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean RayleighRice?"), std::string::npos) << error.what();
  }
  for (const char* wrong :
       {"RayleighRice(wavelenght=1)", "RayleighRice(wavelength=0)", "RayleighRice(eta=(1,2))", "RayleighRice(eta=1)",
        "Facet(slopes=gausian())", "SubsurfaceParticle(k=0.1)", "SubsurfaceParticle(eta=0.5)",
        "Lambertian(reflectance=2)", "RayleighRice(wavelength=(0.6,0.5))", "RayleighRice(channels=rgb)",
        "Facet(incident=q)", "Facet(films=layer())", "Grating(period=1e6, width=0.2)",
        "RayleighRice(index=table(file=/nowhere.txt))", "RayleighRice(3)", ""})
    EXPECT_THROW(makeWaveBrdf(wrong), Error) << wrong;
}

TEST(WaveModels, TheirSpecularPartReachesMaterialsAndTheirFiles) {
  const std::string text =
      "wave:HarveyShack(wavelength=(0.5, 0.7), eta=0.2, k=3, spectrum=gaussian(rms=0.02, correlation=2))";
  LoadedMaterial material = loadMaterial(text);
  // Fresnel's reflectance of the normal of 0.2 + 3 i, times exp(-(4 pi rms / wavelength)^2).
  const double mirror = (square(0.2 - 1) + 9) / (square(0.2 + 1) + 9);
  ASSERT_EQ(material.components.specular.size(), 1u);
  for (const auto& [channel, wavelength] : {std::pair<std::size_t, double>{0, 0.5}, {1, 0.7}})
    EXPECT_NEAR(material.components.specular[0].at(channel, 0), mirror * std::exp(-square(4 * kPi * 0.02 / wavelength)),
                1e-12);
  const std::filesystem::path folder = testFolder("out");
  material.brdf = resample(*material.brdf, parseGridLayout("spherical:15", *material.brdf)).brdf;
  saveMaterial(material, folder / "wave.vtkhdf", "", "test");
  const Components kept = loadMaterial((folder / "wave.vtkhdf").string()).components;
  ASSERT_EQ(kept.specular.size(), 1u);
  EXPECT_EQ(kept.specular[0].values, material.components.specular[0].values);
  EXPECT_EQ(kept.specular[0].thetaI, material.components.specular[0].thetaI);
  EXPECT_TRUE(loadMaterial("wave:Facet()").components.empty());
  EXPECT_TRUE(loadMaterial("wave:RayleighRice(incident=s)").components.empty());
}

TEST(WaveModels, WavelengthsMakeChannels) {
  EXPECT_EQ(makeWaveBrdf("RayleighRice")->channels(), Channels::monochrome());
  EXPECT_EQ(makeWaveBrdf("RayleighRice(wavelength=(0.4, 0.5))")->channels(), Channels::spectral({400, 500}));
  const auto rgb = makeWaveBrdf("RayleighRice(wavelength=(0.6, 0.55, 0.45), channels=rgb, eta=(0.2, 0.4, 1.5), k=3)");
  EXPECT_EQ(rgb->channels(), Channels::rgb());
  const PairOfDirections pair(20, 30, 40);
  EXPECT_EQ(rgb->evaluate(pair.wi, pair.wo)[1], valueOf("RayleighRice(wavelength=0.55, eta=0.4, k=3)", pair));
}

}  // namespace
}  // namespace brdf
