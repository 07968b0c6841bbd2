#include <brdf/base/Error.h>
#include <brdf/geometry/Directions.h>
#include <brdf/simulate/FacetExpression.h>
#include <brdf/simulate/Fresnel.h>
#include <gtest/gtest.h>

#include <complex>

namespace brdf {
namespace {

TEST(FacetExpression, FormsReadBack) {
  for (const char* text : {"mirror", "conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2)", "dielectric(eta=1.5)",
                           "dielectric(eta=1.5, absorption=0.01 0.02 0.5)", "lambertian(albedo=0.5)"})
    EXPECT_EQ(facetText(parseFacet(text)), text);
  const Facet facet = parseFacet(" conductor( k = 3.9 , eta=(0.2, 0.9, 1.1) ) ");
  EXPECT_EQ(facet.kind, Facet::Kind::Conductor);
  EXPECT_EQ(facet.eta, (std::vector<double>{0.2, 0.9, 1.1}));
  EXPECT_EQ(facet.k, std::vector<double>{3.9});
}

TEST(FacetExpression, AMaterialKeepsItsCommasAndEqualsSigns) {
  const Facet facet = parseFacet("scattering((0.3,0.1,0.05)*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5))");
  ASSERT_TRUE(facet.brdf);
  EXPECT_EQ(facet.brdf->channels(), Channels::rgb());
}

TEST(FacetExpression, ErrorsAreOneLineAndSayWhatIsAllowed) {
  const auto messageOf = [](const char* text) -> std::string {
    try {
      parseFacet(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  for (const auto& [text, part] : std::vector<std::pair<const char*, const char*>>{
           {"", "expected a name"},
           {"miror", "mirror, conductor, dielectric, lambertian, scattering"},
           {"mirror(eta=1)", "unknown parameter"},
           {"conductor(eta=1)", "without k"},
           {"conductor(eta=1, k=x)", "expected a number"},
           {"conductor(eta=1, k=-1)", "out of bounds"},
           {"dielectric(eta=0)", "out of bounds"},
           {"lambertian(albedo=1.5)", "[0, 1]"},
           {"lambertian", "without albedo"},
           {"scattering()", "no material"},
           {"scattering(NoSuchLobe)", "NoSuchLobe"},
           {"mirror(", "parenthesis"}}) {
    const std::string message = messageOf(text);
    EXPECT_NE(message.find(part), std::string::npos) << text << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(FacetExpression, ChannelsFollowTheLists) {
  const auto channels = [](std::vector<std::string> texts) {
    std::vector<Facet> facets;
    for (const std::string& text : texts) facets.push_back(parseFacet(text));
    return facetChannels(facets);
  };
  EXPECT_EQ(channels({"mirror", "lambertian(albedo=0.5)"}), Channels::monochrome());
  EXPECT_EQ(channels({"mirror", "lambertian(albedo=0.5 0.2 0.1)"}), Channels::rgb());
  EXPECT_EQ(channels({"dielectric(eta=1.5)", "scattering((0.1,0.2,0.3)*Lambertian)"}), Channels::rgb());
  EXPECT_THROW(channels({"lambertian(albedo=0.5 0.2)"}), Error);
  EXPECT_THROW(channels({"lambertian(albedo=0.5 0.2 0.1 0.3)", "scattering((0.1,0.2,0.3)*Lambertian)"}), Error);
}

/// Fresnel's equations as they stand in every book, complex throughout: the amplitudes of s and p.
double complexFresnel(double cosI, std::complex<long double> index) {
  const std::complex<long double> c = cosI, s2 = 1.0L - c * c, t = std::sqrt(1.0L - s2 / (index * index));
  return static_cast<double>(
      (std::norm((c - index * t) / (c + index * t)) + std::norm((index * c - t) / (index * c + t))) / 2);
}

TEST(Fresnel, AgreesWithTheComplexEquations) {
  for (const double degreesI : {0.0, 1e-3, 10.0, 45.0, 60.0, 80.0, 89.0, 89.99}) {
    const double c = std::cos(radians(degreesI));
    for (const double eta : {1.001, 1.33, 1.5, 2.4, 100.0}) {
      double cosT;
      EXPECT_NEAR(dielectricReflectance(c, eta, cosT), complexFresnel(c, eta), 1e-13) << degreesI << " " << eta;
      EXPECT_NEAR(std::sqrt(1 - cosT * cosT) * eta, std::sin(radians(degreesI)), 1e-7);  // Snell
      for (const double k : {1e-9, 0.1, 3.0, 50.0})
        EXPECT_NEAR(conductorReflectance(c, eta, k), complexFresnel(c, {eta, k}), 1e-13)
            << degreesI << " " << eta << " " << k;
    }
  }
}

TEST(Fresnel, TotalReflectionBrewsterAndNoInterface) {
  double cosT;
  EXPECT_DOUBLE_EQ(dielectricReflectance(1, 1.5, cosT), 0.04);
  EXPECT_EQ(dielectricReflectance(std::cos(radians(42.0)), 1 / 1.5, cosT), 1);  // beyond 41.8 degrees
  EXPECT_EQ(cosT, 0);
  EXPECT_LT(dielectricReflectance(std::cos(radians(41.5)), 1 / 1.5, cosT), 1);
  // At Brewster's angle only s is reflected: ((n^2 - 1) / (n^2 + 1))^2 of it.
  const double n2 = 2.25, s = (n2 - 1) / (n2 + 1);
  EXPECT_NEAR(dielectricReflectance(std::cos(std::atan(1.5)), 1.5, cosT), s * s / 2, 1e-15);
  EXPECT_EQ(dielectricReflectance(0.3, 1, cosT), 0);
  EXPECT_NEAR(cosT, 0.3, 1e-15);
  EXPECT_EQ(dielectricReflectance(0, 1.5, cosT), 1);
  EXPECT_EQ(conductorReflectance(0, 0.2, 3), 1);
  EXPECT_EQ(conductorReflectance(1, 0, 3), 1);  // a lossless metal
}

}  // namespace
}  // namespace brdf
