// Every parametrisation of ALTA: coordinates computed here from their documented meaning come back as the same pair.
#include <brdf/base/Text.h>
#include <brdf/geometry/Directions.h>

#include <algorithm>
#include <random>

#include "MeasuredSupport.h"

namespace {

using brdf::Direction;
using brdf::dot;
using brdf::normalized;
using Coordinates = std::vector<double> (*)(const Direction& light, const Direction& view);

double theta(const Direction& w) { return std::acos(w[2]); }
double phi(const Direction& w) { return std::atan2(w[1], w[0]); }
Direction half(const Direction& a, const Direction& b, double sign = 1) {
  return {(a[0] + sign * b[0]) / 2, (a[1] + sign * b[1]) / 2, (a[2] + sign * b[2]) / 2};
}
double length(const Direction& w) { return std::sqrt(dot(w, w)); }
double projected(const Direction& w) { return std::hypot(w[0], w[1]); }

/// phi_d of the viewer: its azimuth about the half vector, from the plane of normal and half vector, growing as phi
/// does.
double phiD(const Direction& light, const Direction& view) {
  const Direction h = normalized(half(light, view));
  const Direction y = normalized(brdf::cross({0, 0, 1}, h)), x = brdf::cross(y, h);
  return std::atan2(dot(view, y), dot(view, x));
}

struct Case {
  const char* name;
  Coordinates coordinates;
  bool complete;  ///< determines all of wi.z, wo.z and wi.wo
};

const Case kCases[] = {
    {"SPHERICAL_TL_PL_TV_PV",
     [](const Direction& l, const Direction& v) {
       return std::vector{theta(l), phi(l), theta(v), phi(v)};
     },
     true},
    {"ISOTROPIC_TV_TL_DPHI",
     [](const Direction& l, const Direction& v) {
       return std::vector{theta(v), theta(l), phi(l) - phi(v)};
     },
     true},
    {"ISOTROPIC_TL_TV_PROJ_DPHI",
     [](const Direction& l, const Direction& v) {
       const double d = phi(v) - phi(l);
       return std::vector{theta(l), theta(v) * std::cos(d), theta(v) * std::sin(d)};
     },
     true},
    {"RUSIN_TH_PH_TD_PD",
     [](const Direction& l, const Direction& v) {
       const Direction h = normalized(half(l, v));
       return std::vector{theta(h), phi(h), std::acos(dot(h, v)), phiD(l, v)};
     },
     true},
    {"RUSIN_TH_TD_PD",
     [](const Direction& l, const Direction& v) {
       const Direction h = normalized(half(l, v));
       return std::vector{theta(h), std::acos(dot(h, v)), phiD(l, v)};
     },
     true},
    {"RUSIN_TH_TD",
     [](const Direction& l, const Direction& v) {
       const Direction h = normalized(half(l, v));
       return std::vector{theta(h), std::acos(dot(h, v))};
     },
     false},
    {"COS_TH_TD",
     [](const Direction& l, const Direction& v) {
       const Direction h = normalized(half(l, v));
       return std::vector{h[2], dot(h, v)};
     },
     false},
    {"SCHLICK_TL_TK_PROJ_DPHI",
     [](const Direction& l, const Direction& v) {
       const Direction k = normalized(half(v, {-l[0], -l[1], l[2]}));
       const double d = phi(k) - phi(l);
       return std::vector{theta(l), theta(k) * std::cos(d), theta(k) * std::sin(d)};
     },
     true},
    {"RETRO_TL_TVL_PROJ_DPHI",
     [](const Direction& l, const Direction& v) {
       // the dihedral angle at L between the great circles to the normal and to V
       const double angle = std::acos(dot(l, v));
       const Direction toN = normalized(brdf::cross(l, {0, 0, 1})), toV = normalized(brdf::cross(l, v));
       const double a = std::acos(std::clamp(dot(toN, toV), -1.0, 1.0));
       return std::vector{theta(l), angle * std::cos(a), angle * std::sin(a)};
     },
     true},
    {"STARK_3D",
     [](const Direction& l, const Direction& v) {
       const Direction h = half(l, v), b = half(l, v, -1);
       return std::vector{projected(h), length(b), phi(b) - phi(h)};
     },
     true},
    {"STARK_2D",
     [](const Direction& l, const Direction& v) {
       return std::vector{projected(half(l, v)), length(half(l, v, -1))};
     },
     false},
    {"NEUMANN_3D",
     [](const Direction& l, const Direction& v) {
       const Direction h = half(l, v), b = half(l, v, -1);
       return std::vector{projected(h), projected(b), phi(b) - phi(h)};
     },
     true},
    {"NEUMANN_2D",
     [](const Direction& l, const Direction& v) {
       return std::vector{projected(half(l, v)), projected(half(l, v, -1))};
     },
     false},
    {"STEREOGRAPHIC",
     [](const Direction& l, const Direction& v) {
       return std::vector{v[0] / (1 + v[2]), v[1] / (1 + v[2]), l[0] / (1 + l[2]), l[1] / (1 + l[2])};
     },
     true},
    {"CARTESIAN",
     [](const Direction& l, const Direction& v) { return std::vector{v[0], v[1], v[2], l[0], l[1], l[2]}; }, true},
    {"COS_TH", [](const Direction& l, const Direction& v) { return std::vector{normalized(half(l, v))[2]}; }, false},
    {"COS_TLV", [](const Direction& l, const Direction& v) { return std::vector{dot(l, v)}; }, false},
    {"RUSIN_VH",
     [](const Direction& l, const Direction& v) {
       const Direction h = normalized(half(l, v));
       return std::vector{h[0], h[1], h[2]};
     },
     false},
    {"ISOTROPIC_TV_PROJ_DPHI",
     [](const Direction& l, const Direction& v) {
       const double d = phi(v) - phi(l);
       return std::vector{theta(v) * std::cos(d), theta(v) * std::sin(d)};
     },
     false},
};

std::string fileText(const std::string& name, std::size_t dimension, const std::string& rows) {
  return "#DIM " + std::to_string(dimension) + " 1\n#PARAM_IN " + name + "\n#PARAM_OUT INV_STERADIAN\n" + rows;
}

}  // namespace

TEST(AltaParameters, CoordinatesComeBackAsThePair) {
  const auto dir = measuredtest::folder("alta_parameters");
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const Case& item : kCases) {
    std::string rows;
    std::vector<std::pair<Direction, Direction>> pairs;
    std::size_t dimension = 0;
    for (int i = 0; i < 50; ++i) {
      const auto random = [&] {
        return brdf::fromSpherical(std::acos(0.05 + 0.9 * uniform(engine)), 2 * brdf::kPi * uniform(engine));
      };
      const Direction light = random(), view = random();
      const auto x = item.coordinates(light, view);
      dimension = x.size();
      for (const double value : x) rows += brdf::formatNumber(value) + " ";
      rows += "1\n";
      pairs.emplace_back(light, view);
    }
    brdf::writeFile(dir / "a.alta", fileText(item.name, dimension, rows));
    const auto result = brdf::readMeasured(dir / "a.alta");
    const auto& data = measuredtest::dataOf(result);
    ASSERT_EQ(data.pairs.size(), pairs.size()) << item.name;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [light, view] = pairs[i];
      const Direction wi{data.pairs.wi[0][i], data.pairs.wi[1][i], data.pairs.wi[2][i]};
      const Direction wo{data.pairs.wo[0][i], data.pairs.wo[1][i], data.pairs.wo[2][i]};
      EXPECT_NEAR(dot(wi, wi), 1, 1e-12) << item.name;
      EXPECT_NEAR(dot(wo, wo), 1, 1e-12) << item.name;
      if (item.complete) {
        EXPECT_NEAR(wi[2], light[2], 1e-12) << item.name;
        EXPECT_NEAR(wo[2], view[2], 1e-12) << item.name;
        EXPECT_NEAR(dot(wi, wo), dot(light, view), 1e-12) << item.name;
      }
      // The coordinates of the pair read are those written.
      if (wi[2] <= 0 || wo[2] <= 0) continue;
      const auto expected = item.coordinates(light, view), found = item.coordinates(wi, wo);
      for (std::size_t k = 0; k < expected.size(); ++k) {
        const bool mirrored = data.isotropic && std::abs(found[k] - expected[k]) > 1e-9;  // isotropic: the sign of an
        EXPECT_NEAR(
            mirrored ? std::abs(std::remainder(found[k], 2 * brdf::kPi)) : found[k],  // azimuth is free, and 2 pi
            mirrored ? std::abs(std::remainder(expected[k], 2 * brdf::kPi)) : expected[k], 2e-7)
            << item.name << " coordinate " << k;
      }
    }
  }
}

TEST(AltaParameters, WhatIsNotWellDefinedIsRefusedWithTheReason) {
  const auto dir = measuredtest::folder("alta_refused");
  const struct {
    const char *name, *reason;
  } cases[] = {{"COS_TLR", "half a turn"},
               {"COS_TK", "unit length"},
               {"SCHLICK_VH", "azimuth"},
               {"UNKNOWN_INPUT", "does not say"},
               {"ISOTROPIC_TV_TL", "never defines"},
               {"WHATEVER", "unknown #PARAM_IN"}};
  for (const auto& [name, reason] : cases) {
    brdf::writeFile(dir / "a.alta", fileText(name, 1, "0.5 1\n"));
    const std::string error = measuredtest::errorOf([&] { brdf::readMeasured(dir / "a.alta"); });
    EXPECT_NE(error.find(reason), std::string::npos) << error;
    EXPECT_NE(error.find("SPHERICAL_TL_PL_TV_PV"), std::string::npos) << error;
  }
}
