#pragma once
// Special functions of the formula language in double: what applyOp and every kernel set call, one lane at a time.
// Internal to libbrdf/formula; compiled for the oldest processor, so that any kernel set may call them.

namespace brdf::formula {

/// Regularised incomplete gamma functions P(a, x) and Q(a, x) = 1 - P(a, x) for a > 0, x >= 0 (DLMF 8.2.4); NaN
/// elsewhere. P(a, 0) = 0, P(a, infinity) = 1.
double gammaP(double a, double x);
double gammaQ(double a, double x);

/// dP(a, x)/da, which has no closed form: the derivative of the power series (DLMF 8.11.4) term by term below
/// x = a + 1, of the continued fraction of Q (DLMF 8.9.2) level by level above.
double gammaPDa(double a, double x);

/// The derivative of digamma, x > 0; NaN elsewhere.
double trigamma(double x);

/// Bessel functions J of any argument, modified Bessel functions I of any argument, K for x >= 0 (infinite at 0, NaN
/// below) (DLMF 10.2, 10.25).
double besselJ0(double x);
double besselJ1(double x);
double besselI0(double x);
double besselI1(double x);
double besselK0(double x);
double besselK1(double x);

}  // namespace brdf::formula
