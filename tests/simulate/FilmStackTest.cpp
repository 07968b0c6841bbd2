#include <brdf/simulate/wave/FilmStack.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace brdf::wave {
namespace {

constexpr double kPi = std::numbers::pi;

double reflectance(const FilmStack& stack, double theta) {
  const FilmStack::Powers powers = stack.powers(std::sin(theta), std::cos(theta));
  return (powers.reflectedS + powers.reflectedP) / 2;
}

TEST(FilmStack, NormalIncidenceAndBrewster) {
  const FilmStack glass({}, 1.5, 0.5);
  EXPECT_NEAR(reflectance(glass, 0), 0.04, 1e-15);
  const double brewster = std::atan(1.5);
  EXPECT_NEAR(glass.powers(std::sin(brewster), std::cos(brewster)).reflectedP, 0, 1e-30);
  const FilmStack metal({}, {0.2, 3}, 0.5);
  EXPECT_NEAR(reflectance(metal, 0), (0.8 * 0.8 + 9) / (1.2 * 1.2 + 9), 1e-15);
  EXPECT_EQ(reflectance(glass, kPi / 2), reflectance(FilmStack({}, 1.5, 0.5), kPi / 2));
  EXPECT_NEAR(glass.powers(1, 0).reflectedS, 1, 0);
}

TEST(FilmStack, QuarterWaveOfTheGeometricMeanDoesNotReflect) {
  // R = ((n1^2 - n0 ns) / (n1^2 + n0 ns))^2 for a quarter wave of n1: Born and Wolf (1999), section 1.6.4.
  const double wavelength = 0.55;
  const auto quarter = [&](double film, double substrate) {
    return FilmStack({{wavelength / (4 * film), film}}, substrate, wavelength);
  };
  EXPECT_NEAR(reflectance(quarter(std::sqrt(1.5), 1.5), 0), 0, 1e-30);
  for (const double n : {1.38, 2.3})
    EXPECT_NEAR(reflectance(quarter(n, 1.5), 0), std::pow((n * n - 1.5) / (n * n + 1.5), 2), 1e-15);
  // A half wave is not there.
  EXPECT_NEAR(reflectance(FilmStack({{wavelength / (2 * 2.3), 2.3}}, 1.5, wavelength), 0), 0.04, 1e-15);
}

TEST(FilmStack, QuarterWaveMirrorHasItsClosedForm) {
  // (HL)^N H on a substrate: R = ((1 - Y) / (1 + Y))^2, Y = (nH/nL)^(2N) nH^2/ns. Born and Wolf (1999), section 1.6.5.
  const double wavelength = 0.55, high = 2.3, low = 1.38;
  for (const int pairs : {1, 3, 10, 100}) {
    std::vector<FilmStack::Film> films;
    for (int k = 0; k < pairs; ++k) {
      films.push_back({wavelength / (4 * high), high});
      films.push_back({wavelength / (4 * low), low});
    }
    films.push_back({wavelength / (4 * high), high});
    const double y = std::pow(high / low, 2 * pairs) * high * high / 1.52, r = (1 - y) / (1 + y);
    EXPECT_NEAR(reflectance(FilmStack(films, 1.52, wavelength), 0), r * r, 1e-12) << pairs;
  }
}

TEST(FilmStack, TotalReflectionAndTunnelling) {
  // A gap of index 1/1.5 under air is the same as air under glass, scaled: total beyond asin(1/1.5).
  const FilmStack thick({{100, 1 / 1.5}}, 1.0, 0.5);
  const double theta = 60 * kPi / 180;
  EXPECT_NEAR(reflectance(thick, theta), 1, 1e-12);
  const FilmStack thin({{0.01, 1 / 1.5}}, 1.0, 0.5);
  EXPECT_LT(reflectance(thin, theta), 0.1);
  const FilmStack::Powers powers = thin.powers(std::sin(theta), std::cos(theta));
  EXPECT_NEAR(powers.reflectedS + powers.transmittedS, 1, 1e-14);
  EXPECT_NEAR(powers.reflectedP + powers.transmittedP, 1, 1e-14);
}

TEST(FilmStack, EnergyIsKept) {
  const FilmStack clear({{0.123, 2.1}, {0.321, 1.38}, {0.05, 1.9}}, 1.5, 0.633);
  const FilmStack absorbing({{0.123, {2.1, 0.3}}, {0.321, 1.38}, {1e6, {1.9, 2}}}, {4, 0.1}, 0.633);
  for (double degrees = 0; degrees < 90; degrees += 7.3) {
    const double theta = degrees * kPi / 180;
    const FilmStack::Powers a = clear.powers(std::sin(theta), std::cos(theta));
    EXPECT_NEAR(a.reflectedS + a.transmittedS, 1, 1e-13) << degrees;
    EXPECT_NEAR(a.reflectedP + a.transmittedP, 1, 1e-13) << degrees;
    const FilmStack::Powers b = absorbing.powers(std::sin(theta), std::cos(theta));
    EXPECT_LT(b.reflectedS + b.transmittedS, 1);
    EXPECT_GE(b.reflectedP, 0);
    EXPECT_EQ(b.transmittedP, 0) << "a kilometre-thick absorber";
  }
  // An absorbing substrate takes what it does not reflect.
  const FilmStack metal({}, {0.2, 3}, 0.5);
  const FilmStack::Powers m = metal.powers(std::sin(1.0), std::cos(1.0));
  EXPECT_NEAR(m.reflectedS + m.transmittedS, 1, 1e-14);
  EXPECT_NEAR(m.reflectedP + m.transmittedP, 1, 1e-14);
}

TEST(FilmStack, SameMatterMakesNoBoundary) {
  const FilmStack plain({}, 1.5, 0.5), split({{0.2, 1.5}, {0.7, 1.5}}, 1.5, 0.5);
  for (const double theta : {0.0, 0.5, 1.2, 1.57})
    EXPECT_NEAR(reflectance(plain, theta), reflectance(split, theta), 1e-14);
}

}  // namespace
}  // namespace brdf::wave
