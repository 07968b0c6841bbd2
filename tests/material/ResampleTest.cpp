// Resampling onto other grids, and the error by region of directions.
#include <brdf/base/Error.h>
#include <brdf/material/LobeSum.h>
#include <brdf/material/RegionErrors.h>
#include <brdf/material/Resample.h>

#include <gtest/gtest.h>

#include "GridSupport.h"

namespace {

using namespace gridtest;

const brdf::RegionError& regionOf(const std::vector<brdf::RegionError>& errors, const std::string& name) {
  for (const auto& error : errors)
    if (error.region == name) return error;
  throw std::out_of_range(name);
}

}  // namespace

TEST(RegionErrors, AConstantDifferenceIsThatEverywhere) {
  const auto a = brdf::parseMaterialExpression("0.5*Lambertian"), b = brdf::parseMaterialExpression("0.4*Lambertian");
  const auto errors = brdf::regionErrors(*a, *b, 500);
  ASSERT_EQ(errors.size(), 4u);
  for (const auto& error : errors) {
    EXPECT_NEAR(error.mean, 0.1 / brdf::kPi, 1e-15) << error.region;
    EXPECT_NEAR(error.largest, 0.1 / brdf::kPi, 1e-15) << error.region;
    EXPECT_NEAR(error.relativeMean, 0.25, 1e-12) << error.region;
    EXPECT_EQ(error.pairs, 500u);
    EXPECT_EQ(error.lost, 0u);
  }
}

TEST(RegionErrors, ANarrowLobeDiffersNearTheMirrorDirectionOnly) {
  // Blinn-Phong with exponent 2000: at half angles above 7.5 degrees cos^2000 is below 1e-7.
  const auto a = brdf::parseMaterialExpression("0.5*Lambertian + 0.1*BlinnPhong(n=2000)");
  const auto b = brdf::parseMaterialExpression("0.5*Lambertian");
  const auto errors = brdf::regionErrors(*a, *b);
  EXPECT_GT(regionOf(errors, "near mirror").largest, 1);
  EXPECT_LT(regionOf(errors, "rest").largest, 1e-4);
}

TEST(RegionErrors, InvalidPairsAreCountedAsLost) {
  GridLayout layout{Parametrisation::Spherical, {GridAxis::listedDegrees(AxisQuantity::ThetaO, {0, 40, 60})}};
  layout.axes[0].outside = brdf::Outside::Invalid;
  const auto material = brdf::parseMaterialExpression("0.5*Lambertian");
  const auto errors = brdf::regionErrors(*GridBrdf::tabulate(*material, layout), *material);
  for (const auto& error : errors) EXPECT_EQ(error.pairs + error.lost, 4096u);
  // Cosine-weighted directions beyond 60 degrees are a quarter of all; beyond 75 there are none in the rest.
  const auto rest = regionOf(errors, "rest");
  const double inRest = 0.25 - std::pow(std::cos(radians(75)), 2), all = 1 - std::pow(std::cos(radians(75)), 2);
  EXPECT_NEAR(static_cast<double>(rest.lost) / 4096, inRest / all, 0.02);
  EXPECT_LT(rest.largest, 1e-12);
}

TEST(Resample, GridsCoverEverySymmetryAndReproduceASmoothMaterial) {
  const auto isotropic = brdf::parseMaterialExpression("0.3*Lambertian + 0.2*Ward(ax=0.5, ay=0.5)");
  const auto anisotropic = brdf::parseMaterialExpression("0.3*Lambertian + 0.2*Ward(ax=0.5, ay=0.7)");
  // Away from the horizon, where this lobe's 1 / sqrt(cos cos) has no bound, the error is of second order in the step.
  const auto restOf = [&](const std::string& layout) {
    const auto result = resample(*isotropic, brdf::parseGridLayout(layout, *isotropic));
    EXPECT_EQ(result.losses.size(), 1u) << layout;
    return regionOf(brdf::regionErrors(*result.brdf, *isotropic), "rest").relativeMean;
  };
  for (const std::string layout : {"spherical", "half_difference", "specular"}) {
    const double coarse = restOf(layout + ":10"), fine = restOf(layout + ":5");
    EXPECT_LT(coarse, 0.04) << layout;
    EXPECT_LT(fine, coarse / 3) << layout;
  }
  EXPECT_LT(restOf("merl"), 1e-3);
  for (const char* layout : {"spherical:10", "half_difference:10", "specular:10"}) {
    const auto result = resample(*anisotropic, brdf::parseGridLayout(layout, *anisotropic));
    EXPECT_EQ(result.brdf->symmetry(), brdf::Symmetry::Anisotropic) << layout;
    EXPECT_LT(regionOf(brdf::regionErrors(*result.brdf, *anisotropic), "rest").relativeMean, 0.04) << layout;
  }
}

TEST(Resample, SaysWhatIsLost) {
  const auto anisotropic = brdf::parseMaterialExpression("Ward(ax=0.5, ay=0.7)");
  const auto merl = resample(*anisotropic, brdf::parseGridLayout("merl", *anisotropic));
  ASSERT_EQ(merl.losses.size(), 2u);
  EXPECT_NE(merl.losses[1].find("anisotropy"), std::string::npos);
  EXPECT_THROW(brdf::parseGridLayout("spherical", *anisotropic), brdf::Error);
  EXPECT_THROW(brdf::parseGridLayout("spherical:0", *anisotropic), brdf::Error);
  EXPECT_THROW(resample(*anisotropic, brdf::parseGridLayout("spherical:1", *anisotropic)), brdf::Error);
}
