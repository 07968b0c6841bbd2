#include <gtest/gtest.h>

#include "WaveSupport.h"

namespace brdf {
namespace {

using wave::Complex;
using wave::Jones;
using wave::Mueller;

std::array<double, 4> stokesOf(Complex s, Complex p) {
  return {std::norm(s) + std::norm(p), std::norm(s) - std::norm(p), 2 * (s * std::conj(p)).real(),
          2 * (std::conj(s) * p).imag()};
}

TEST(Polarization, StokesVectorsOfKnownStates) {
  // exp(-i omega t): where p lags s by a quarter turn (p = i s), the field turns from s to p, counter-clockwise for who
  // looks at the source, as {s, p, direction} is right-handed.
  EXPECT_EQ(stokesOf(1, Complex(0, 1))[3], 2);
  const auto& states = wave::polarizationStates();
  EXPECT_EQ(states[5].name, "lcp");
  EXPECT_EQ(states[5].stokes[3], 1);
}

TEST(Polarization, MuellerMatricesActAsTheirJonesMatrices) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto number = [&] { return Complex(normal(random), normal(random)); };
  for (int k = 0; k < 100; ++k) {
    const Jones j{number(), number(), number(), number()};
    const Complex s = number(), p = number();
    const auto in = stokesOf(s, p), out = stokesOf(j.ss * s + j.pToS * p, j.sToP * s + j.pp * p);
    const Mueller m = wave::muellerOf(j);
    for (std::size_t r = 0; r < 4; ++r) {
      double sum = 0;
      for (std::size_t c = 0; c < 4; ++c) sum += m(r, c) * in[c];
      EXPECT_NEAR(sum, out[r], 1e-13 * out[0]);
    }
    EXPECT_NEAR(m(0, 0), wave::unpolarized(j), 1e-14 * m(0, 0));
    EXPECT_NEAR(wave::leastCoherency(m), 0, 1e-14);
    const Jones other{number(), number(), number(), number()};
    const Mueller product = wave::muellerOf(other * j), composed = wave::muellerOf(other) * m;
    for (std::size_t e = 0; e < 16; ++e) EXPECT_NEAR(product.m[e], composed.m[e], 1e-12 * product.m[0]);
  }
}

TEST(Polarization, CoherencyTellsWhatIsPossible) {
  Mueller depolarizer;
  depolarizer.m[0] = 1;
  EXPECT_NEAR(wave::leastCoherency(depolarizer), 0.25, 1e-15);
  Mueller impossible;
  for (const std::size_t k : {0u, 5u, 10u}) impossible.m[k] = 1;
  impossible.m[15] = -1;  // turns circular light over and leaves linear light alone
  EXPECT_LT(wave::leastCoherency(impossible), -0.1);
}

TEST(Polarization, ValuesAreTheMatricesBetweenStateAndAnalyser) {
  const std::string model = "DoubleInteraction(eta=0.2, k=3, scatterer=mie(radius=0.3)";
  const PairOfDirections pair(40, 55, 70);
  const auto plain = makeWaveBrdf(model + ")");
  const Mueller m = muellerOf(*plain, pair);
  const auto& states = wave::polarizationStates();
  for (const auto& in : states) {
    double sum = 0;
    for (std::size_t c = 0; c < 4; ++c) sum += m(0, c) * in.stokes[c];
    EXPECT_NEAR(valueOf(model + ", incident=" + in.name + ")", pair), sum, 1e-13 * m(0, 0)) << in.name;
    for (const auto& out : states) {
      if (out.name == "unpolarized") continue;
      double passed = 0;
      for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) passed += out.stokes[r] * m(r, c) * in.stokes[c] / 2;
      EXPECT_NEAR(valueOf(model + ", incident=" + in.name + ", detected=" + out.name + ")", pair), passed,
                  1e-13 * m(0, 0));
    }
  }
  // Two crossed analysers pass all light between them.
  EXPECT_NEAR(valueOf(model + ", detected=s)", pair) + valueOf(model + ", detected=p)", pair), m(0, 0),
              1e-13 * m(0, 0));
}

const char* const kModels[] = {
    "Lambertian()",
    "RayleighRice(eta=4.05, k=0.05, spectrum=abc(a=0.01, b=362, c=2.5))",
    "HarveyShack(eta=0.2, k=3, spectrum=gaussian(rms=0.1, correlation=1))",
    "BeckmannKirchhoff(spectrum=gaussian(rms=0.1, correlation=1, correlation_y=3))",
    "Facet(eta=0.97, k=6.4, slopes=exponential(s=0.2, sy=0.4), shadowing=smith(w=0.2))",
    "DoubleInteraction(eta=4.05, k=0.05, scatterer=mie(radius=0.2), films=films(layer(thickness=0.1)))",
    "SubsurfaceParticle(scatterer=mie(radius=0.2, eta=2, k=0.1))",
    "FirstDiffuse()",
    "Grating(depth=0.2, angle=30, width=0.1)",
    "ThinFilms(films=films(layer(thickness=0.1, eta=2)), width=0.1)"};

TEST(Polarization, EveryModelIsPhysicallyPossible) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(0, 89), azimuth(0, 360);
  for (const char* expression : kModels) {
    const auto model = makeWaveBrdf(expression);
    for (int k = 0; k < 200; ++k) {
      const PairOfDirections pair(angle(random), angle(random), azimuth(random));
      EXPECT_GE(wave::leastCoherency(muellerOf(*model, pair)), -1e-13) << expression;
    }
  }
}

TEST(Polarization, ExchangedDirectionsTransposeTheMatrix) {
  // Reciprocity of Mueller matrices: M(exchanged) = Q M^T Q, Q = diag(1, 1, -1, 1) in this basis. Z. Sekera, J. Opt.
  // Soc. Am. 56, 1732 (1966), doi:10.1364/JOSA.56.001732.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0, 85), azimuth(0, 360);
  for (const char* expression : kModels) {
    const auto model = makeWaveBrdf(expression);
    for (int k = 0; k < 50; ++k) {
      PairOfDirections pair(angle(random), angle(random), azimuth(random));
      const Mueller there = muellerOf(*model, pair);
      std::swap(pair.wi, pair.wo);
      const Mueller back = muellerOf(*model, pair);
      for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) {
          const double sign = (r == 2) != (c == 2) ? -1 : 1;
          EXPECT_NEAR(back(r, c), sign * there(c, r), 1e-10 * there(0, 0) + 1e-300) << expression << " " << r << c;
        }
    }
  }
}

TEST(Polarization, NormalDirectionsAreTheLimitOfTheirAzimuth) {
  for (const char* expression : kModels) {
    const auto model = makeWaveBrdf(expression);
    for (const auto& [thetaI, thetaS] : {std::pair{0.0, 40.0}, {40.0, 0.0}, {0.0, 0.0}}) {
      const Mueller at = muellerOf(*model, PairOfDirections(thetaI, thetaS, thetaS == 0 ? 0 : 70));
      const Mueller near =
          muellerOf(*model, PairOfDirections(std::max(thetaI, 1e-7), std::max(thetaS, 1e-7), thetaS == 0 ? 0 : 70));
      for (std::size_t e = 0; e < 16; ++e)
        EXPECT_NEAR(at.m[e], near.m[e], 1e-6 * near.m[0] + 1e-300) << expression << " " << thetaI << " " << thetaS;
    }
  }
}

}  // namespace
}  // namespace brdf
