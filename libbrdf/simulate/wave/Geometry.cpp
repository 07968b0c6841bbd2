#include <brdf/simulate/wave/Geometry.h>

#include <cmath>

namespace brdf::wave {

bool geometryOf(const DirectionPairs<double>& pairs, std::size_t k, Geometry& g) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    g.wi[axis] = pairs.wi[axis][k];
    g.wo[axis] = pairs.wo[axis][k];
  }
  if (!(g.wi[2] > 0 && g.wo[2] > 0)) return false;
  g.cosI = g.wi[2];
  g.cosS = g.wo[2];
  g.sinI = std::hypot(g.wi[0], g.wi[1]);
  g.sinS = std::hypot(g.wo[0], g.wo[1]);
  g.qx = g.wi[0] + g.wo[0];
  g.qy = g.wi[1] + g.wo[1];
  g.forward = g.sinI > 0 ? std::array{-g.wi[0] / g.sinI, -g.wi[1] / g.sinI} : std::array{1.0, 0.0};
  g.outgoing = g.sinS > 0 ? std::array{g.wo[0] / g.sinS, g.wo[1] / g.sinS} : g.forward;
  g.cosPhi = g.forward[0] * g.outgoing[0] + g.forward[1] * g.outgoing[1];
  g.sinPhi = g.forward[0] * g.outgoing[1] - g.forward[1] * g.outgoing[0];
  return true;
}

Jones inPlane(const Ray& in, const Ray& out, Complex perpendicular, Complex parallel) {
  Vector normal = cross(in.d, out.d);
  const double length = std::sqrt(dot(normal, normal));
  if (length > 1e-12)
    for (double& x : normal) x /= length;
  else
    normal = in.s;
  const Vector parallelIn = cross(in.d, normal), parallelOut = cross(out.d, normal);
  const double ss = dot(in.s, normal), ps = dot(in.p, normal);  // from s and p into the perpendicular field
  const double sp = dot(in.s, parallelIn), pp = dot(in.p, parallelIn);
  const double outSs = dot(out.s, normal), outPs = dot(out.p, normal);
  const double outSp = dot(out.s, parallelOut), outPp = dot(out.p, parallelOut);
  return {outSs * perpendicular * ss + outSp * parallel * sp, outSs * perpendicular * ps + outSp * parallel * pp,
          outPs * perpendicular * ss + outPp * parallel * sp, outPs * perpendicular * ps + outPp * parallel * pp};
}

}  // namespace brdf::wave
