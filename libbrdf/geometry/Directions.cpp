#include <brdf/geometry/Directions.h>

namespace brdf {

HalfDifference toHalfDifference(const Direction& wi, const Direction& wo) {
  // The unnormalised half vector keeps its digits near the mirror direction; |wi - wo| keeps them near
  // retro-reflection.
  const Direction sum{wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]};
  const Direction difference{wi[0] - wo[0], wi[1] - wo[1], wi[2] - wo[2]};
  HalfDifference angles{};
  const Spherical half = toSpherical(sum);
  angles.thetaH = half.theta;
  angles.phiH = half.phi;
  angles.thetaD = std::atan2(std::sqrt(dot(difference, difference)), std::sqrt(dot(sum, sum)));
  // Azimuth of wi about h: components of (wi - wo)/2, which is wi without its part along h, on the frame's axes.
  const double ch = std::cos(half.theta), sh = std::sin(half.theta);
  const double cp = std::cos(half.phi), sp = std::sin(half.phi);
  const double x = ch * (cp * difference[0] + sp * difference[1]) - sh * difference[2];
  const double y = -sp * difference[0] + cp * difference[1];
  angles.phiD = (x == 0 && y == 0) ? 0.0 : std::atan2(y, x);
  return angles;
}

DirectionPair fromHalfDifference(const HalfDifference& angles) {
  const Direction d = fromSpherical(angles.thetaD, angles.phiD);
  const double ch = std::cos(angles.thetaH), sh = std::sin(angles.thetaH);
  const double cp = std::cos(angles.phiH), sp = std::sin(angles.phiH);
  const auto place = [&](double x, double y, double z) {
    const double u = ch * x + sh * z;
    return Direction{cp * u - sp * y, sp * u + cp * y, -sh * x + ch * z};
  };
  return {place(d[0], d[1], d[2]), place(-d[0], -d[1], d[2])};
}

}  // namespace brdf
