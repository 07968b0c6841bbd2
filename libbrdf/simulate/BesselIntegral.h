#pragma once
// Internal to libbrdf/simulate.

namespace brdf {

/// The integral of (x/t)^m J0(t) dt from x to infinity, x > 0, m >= 0.
double besselIntegralBeyond(double m, double x);

/// The integral of t J1(t) from 0 to x, x >= 0.
double besselMoment(double x);

}  // namespace brdf
