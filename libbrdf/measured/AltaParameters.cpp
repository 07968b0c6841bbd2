// The coordinates are those that ALTA documents for each name; where its conversions to and from vectors disagree with
// each other, the documented meaning is taken. V is the viewer, L the light; azimuths of isotropic ones count from L's.
#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/measured/AltaParameters.h>

#include <array>
#include <cmath>
#include <vector>

namespace brdf {
namespace {

/// The difference angles are the viewer's, so that the pair is the light's counterpart of fromHalfDifference.
DirectionPair halfDifference(double thetaH, double phiH, double thetaD, double phiD) {
  const DirectionPair swapped = fromHalfDifference({thetaH, phiH, thetaD, phiD});
  return {swapped.wo, swapped.wi};
}

/// The direction whose polar angle and azimuth are the polar coordinates of (x, y).
Direction fromProjected(double x, double y) {
  const double theta = std::hypot(x, y);
  const double s = theta > 0 ? std::sin(theta) / theta : 0;
  return {s * x, s * y, std::cos(theta)};
}

/// The upper direction over (x, y).
Direction fromDisk(double x, double y) { return {x, y, std::sqrt(1 - x * x - y * y)}; }

/// Stereographic projection from the lower pole: (x, y) = (wx, wy)/(1 + wz).
Direction fromStereographic(double x, double y) {
  const double r2 = x * x + y * y;
  return {2 * x / (1 + r2), 2 * y / (1 + r2), (1 - r2) / (1 + r2)};
}

/// (V + L)/2 has the length `h` along x when projected, (L - V)/2 is `b`.
DirectionPair fromHalves(double h, const Direction& b, double hz) {
  return {{h + b[0], b[1], hz + b[2]}, {h - b[0], -b[1], hz - b[2]}};
}

/// STARK: |projected (V + L)/2|, |(L - V)/2| and the azimuth between them. The two are at right angles, and the squares
/// of their lengths sum to 1.
DirectionPair fromStark(double h, double b, double phi) {
  const double hz = std::sqrt(1 - h * h - b * b);
  const double theta = std::atan2(hz, -h * std::cos(phi));  // of (L - V)/2, from the normal
  const Direction unit = fromSpherical(theta, phi);
  return fromHalves(h, {b * unit[0], b * unit[1], b * unit[2]}, hz);
}

/// NEUMANN: lengths of the projections of (V + L)/2 and (L - V)/2, and the azimuth between them.
DirectionPair fromNeumann(double h, double b, double phi) {
  const double x = b * std::cos(phi), y = b * std::sin(phi);
  return {fromDisk(h + x, y), fromDisk(h - x, -y)};
}

/// The angle between V and L and the azimuth about L, 0 towards the normal; as polar coordinates of (x, y).
DirectionPair fromRetro(double thetaL, double x, double y) {
  const Direction light = fromSpherical(thetaL, 0);
  const Direction towards{-std::cos(thetaL), 0, std::sin(thetaL)};
  const Direction local = fromProjected(x, y);
  Direction view{};
  for (std::size_t i = 0; i < 3; ++i) view[i] = local[2] * light[i] + local[0] * towards[i];
  view[1] += local[1];
  return {light, view};
}

/// Schlick's back vector K, half way between V and L mirrored about the normal, as polar coordinates of (x, y).
DirectionPair fromBack(double thetaL, double x, double y) {
  const Direction light = fromSpherical(thetaL, 0), mirrored{-light[0], 0, light[2]}, k = fromProjected(x, y);
  const double c = 2 * dot(mirrored, k);
  return {light, {c * k[0] - mirrored[0], c * k[1] - mirrored[1], c * k[2] - mirrored[2]}};
}

constexpr std::string_view kAcross = "phi_d = 90 degrees: the values are taken not to depend on it";
constexpr double kRight = kPi / 2;

const AltaParameters kAll[] = {
    {"SPHERICAL_TL_PL_TV_PV",
     4,
     false,
     [](const double* x) {
       return DirectionPair{fromSpherical(x[0], x[1]), fromSpherical(x[2], x[3])};
     },
     {}},
    {"ISOTROPIC_TV_TL_DPHI",
     3,
     true,
     [](const double* x) {
       return DirectionPair{fromSpherical(x[1], x[2]), fromSpherical(x[0], 0)};
     },
     {}},
    {"ISOTROPIC_TL_TV_PROJ_DPHI",
     3,
     true,
     [](const double* x) {
       return DirectionPair{fromSpherical(x[0], 0), fromProjected(x[1], x[2])};
     },
     {}},
    {"ISOTROPIC_TV_PROJ_DPHI", 2, true,
     [](const double* x) {
       return DirectionPair{{0, 0, 1}, fromProjected(x[0], x[1])};
     },
     "the light at the normal"},
    {"RUSIN_TH_PH_TD_PD", 4, false, [](const double* x) { return halfDifference(x[0], x[1], x[2], x[3]); }, {}},
    {"RUSIN_TH_TD_PD", 3, true, [](const double* x) { return halfDifference(x[0], 0, x[1], x[2]); }, {}},
    {"RUSIN_TH_TD", 2, true, [](const double* x) { return halfDifference(x[0], 0, x[1], kRight); }, kAcross},
    {"COS_TH_TD", 2, true, [](const double* x) { return halfDifference(std::acos(x[0]), 0, std::acos(x[1]), kRight); },
     kAcross},
    {"COS_TH", 1, true, [](const double* x) { return halfDifference(std::acos(x[0]), 0, 0, 0); },
     "theta_d = 0: the values are taken to depend on theta_h alone"},
    {"RUSIN_VH", 3, false,
     [](const double* x) {
       const Direction h = normalized({x[0], x[1], x[2]});
       return DirectionPair{h, h};
     },
     "theta_d = 0: the values are taken to depend on the half vector alone"},
    {"COS_TLV", 1, true,
     [](const double* x) {
       return DirectionPair{{0, 0, 1}, {std::sqrt(1 - x[0] * x[0]), 0, x[0]}};
     },
     "the light at the normal: the values are taken to depend on the angle between light and viewer alone"},
    {"SCHLICK_TL_TK_PROJ_DPHI", 3, true, [](const double* x) { return fromBack(x[0], x[1], x[2]); }, {}},
    {"RETRO_TL_TVL_PROJ_DPHI", 3, true, [](const double* x) { return fromRetro(x[0], x[1], x[2]); }, {}},
    {"STARK_3D", 3, true, [](const double* x) { return fromStark(x[0], x[1], x[2]); }, {}},
    {"STARK_2D", 2, true, [](const double* x) { return fromStark(x[0], x[1], kRight); }, kAcross},
    {"NEUMANN_3D", 3, true, [](const double* x) { return fromNeumann(x[0], x[1], x[2]); }, {}},
    {"NEUMANN_2D", 2, true, [](const double* x) { return fromNeumann(x[0], x[1], kRight); }, kAcross},
    {"STEREOGRAPHIC",
     4,
     false,
     [](const double* x) {
       return DirectionPair{fromStereographic(x[2], x[3]), fromStereographic(x[0], x[1])};
     },
     {}},
    {"CARTESIAN",
     6,
     false,
     [](const double* x) {
       return DirectionPair{normalized({x[3], x[4], x[5]}), normalized({x[0], x[1], x[2]})};
     },
     {}},
};

constexpr std::array<std::string_view, 2> kRefused[] = {
    {"COS_TLR",
     "ALTA computes it as the cosine between the light and the viewer turned by half a turn about x, not to "
     "the reflected direction that its name means"},
    {"COS_TK", "ALTA's conversion of it yields vectors that are not of unit length"},
    {"SCHLICK_VK", "ALTA leaves out the back vector's azimuth when converting it"},
    {"SCHLICK_VH", "ALTA leaves out the back vector's azimuth when converting it"},
    {"SCHLICK_TK_PK", "ALTA names it and never defines its conversion"},
    {"RUSIN_VH_VD", "ALTA names it and never defines its conversion"},
    {"RUSIN_TH_PH_TD", "ALTA names it and never reads it from a file"},
    {"ISOTROPIC_TV_TL", "ALTA names it and never defines its conversion"},
    {"ISOTROPIC_TD_PD", "ALTA names it and never defines its conversion"},
    {"UNKNOWN_INPUT", "the file does not say what its coordinates are"},
};

}  // namespace

const AltaParameters& altaParameters(std::string_view name, const std::string& where) {
  std::vector<std::string_view> names;
  for (const AltaParameters& parameters : kAll) {
    if (parameters.name == name) return parameters;
    names.push_back(parameters.name);
  }
  std::string what = "unknown #PARAM_IN";
  for (const auto& [refused, reason] : kRefused)
    if (refused == name) what = "#PARAM_IN is not well defined: " + std::string(reason);
  throw Error(Error::Kind::Format, {std::move(what), where, std::string(name.substr(0, 40)), joined(names)});
}

}  // namespace brdf
