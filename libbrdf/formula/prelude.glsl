// Elementary functions of known accuracy for the shaders that formulas print to. Drivers' own are poor (worst relative
// error seen on a software driver: log near 1 2e-2, pow(x, 1e4) 1e-3, acos 2e-4). Every function here is within a few
// float ulps of the exact value (tests/glsl/PreludeTest.cpp measures each); pow's and exp's relative error also grows
// with the size of the exponent, as one ulp of the exponent's rounding does.

const float BRDF_LN2_HIGH = 0.693359375;          // nine bits: products with whole numbers below 2^15 are exact
const float BRDF_LN2_LOW = -2.12194440e-4;        // ln 2 - BRDF_LN2_HIGH
const float BRDF_PI = 3.14159265;

// exp: n = round(x / ln 2), the Taylor polynomial of degree 7 on |r| <= 0.35 (error 6e-9), scaled by 2^n in two steps.
float brdf_exp(float x) {
  float clamped = clamp(x, -104.0, 90.0);
  float n = floor(clamped * 1.44269504 + 0.5);
  float r = (clamped - n * BRDF_LN2_HIGH) - n * BRDF_LN2_LOW;
  float p = 1.0 + r * (1.0 + r * (0.5 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * (1.0 / 120.0 + r * (1.0 / 720.0 + r / 5040.0))))));
  int half1 = int(n) / 2;
  int half2 = int(n) - half1;
  return p * intBitsToFloat((half1 + 127) << 23) * intBitsToFloat((half2 + 127) << 23);
}

// 2 atanh(s) for |s| <= 0.172: odd series through s^13 (error 3e-11 relative).
float brdf_twoAtanh(float s) {
  float z = s * s;
  return 2.0 * s * (1.0 + z * (1.0 / 3.0 + z * (1.0 / 5.0 + z * (1.0 / 7.0 + z * (1.0 / 9.0 + z * (1.0 / 11.0 + z / 13.0))))));
}

// log: x = 2^e m with m in [sqrt(1/2), sqrt(2)); log m = 2 atanh((m - 1)/(m + 1)), where m - 1 is exact.
float brdf_log(float x) {
  if (!(x > 0.0)) return x == 0.0 ? uintBitsToFloat(0xff800000u) : uintBitsToFloat(0x7fc00000u);
  if (x > 3.4028235e38) return x;
  bool tiny = x < 1.17549435e-38;
  float y = tiny ? x * 16777216.0 : x;
  int bits = floatBitsToInt(y);
  int e = (bits >> 23) - 127;
  float m = intBitsToFloat((bits & 0x007fffff) | 0x3f800000);
  if (m > 1.41421356) {
    m *= 0.5;
    e += 1;
  }
  float k = float(tiny ? e - 24 : e);
  return k * BRDF_LN2_HIGH + (brdf_twoAtanh((m - 1.0) / (m + 1.0)) + k * BRDF_LN2_LOW);
}

float brdf_log1p(float x) {
  if (x > -0.29 && x < 0.41) return brdf_twoAtanh(x / (2.0 + x));
  return brdf_log(1.0 + x);
}

float brdf_expm1(float x) {
  if (abs(x) > 0.35) return brdf_exp(x) - 1.0;
  return x * (1.0 + x * (0.5 + x * (1.0 / 6.0 + x * (1.0 / 24.0 + x * (1.0 / 120.0 + x * (1.0 / 720.0 + x * (1.0 / 5040.0 + x / 40320.0)))))));
}

float brdf_pow(float x, float y) {
  if (y == 0.0) return 1.0;
  if (x == 0.0) return y > 0.0 ? 0.0 : uintBitsToFloat(0x7f800000u);
  if (x < 0.0) {
    if (y != floor(y)) return uintBitsToFloat(0x7fc00000u);
    float magnitude = brdf_exp(y * brdf_log(-x));
    return mod(y, 2.0) == 0.0 ? magnitude : -magnitude;
  }
  return brdf_exp(y * brdf_log(x));
}

// atan: two reductions to |z| <= tan(pi/8), then the odd series through z^19 (error 1e-9 relative).
float brdf_atan(float x) {
  float a = abs(x);
  bool inverted = a > 1.0;
  float y = inverted ? 1.0 / a : a;
  bool shifted = y > 0.414213562;
  float s = shifted ? (y - 1.0) / (y + 1.0) : y;
  float z = s * s;
  float p = s * (1.0 - z * (1.0 / 3.0 - z * (1.0 / 5.0 - z * (1.0 / 7.0 - z * (1.0 / 9.0 - z * (1.0 / 11.0 -
            z * (1.0 / 13.0 - z * (1.0 / 15.0 - z * (1.0 / 17.0 - z / 19.0)))))))));
  float r = shifted ? 0.785398163 + p : p;
  r = inverted ? 1.57079633 - r : r;
  return x < 0.0 ? -r : r;
}

float brdf_atan2(float y, float x) {
  if (x == 0.0 && y == 0.0) return 0.0;
  float r = brdf_atan(min(abs(x), abs(y)) / max(abs(x), abs(y)));
  r = abs(y) > abs(x) ? 1.57079633 - r : r;
  r = x < 0.0 ? BRDF_PI - r : r;
  return y < 0.0 ? -r : r;
}

// The same within 1e-5 in half the time (Abramowitz and Stegun 4.4.47), where that is a small part of a table's cell.
float brdf_atan2Coarse(float y, float x) {
  float t = min(abs(x), abs(y)) / max(max(abs(x), abs(y)), 1e-37), z = t * t;
  float r = t * (0.999866 + z * (-0.3302995 + z * (0.180141 + z * (-0.085133 + z * 0.0208351))));
  r = abs(y) > abs(x) ? 1.57079633 - r : r;
  r = x < 0.0 ? BRDF_PI - r : r;
  return y < 0.0 ? -r : r;
}

float brdf_acos(float x) {
  float c = clamp(x, -1.0, 1.0);
  return 2.0 * brdf_atan2(sqrt(1.0 - c), sqrt(1.0 + c));
}

float brdf_asin(float x) {
  float c = clamp(x, -1.0, 1.0);
  return brdf_atan2(c, sqrt((1.0 - c) * (1.0 + c)));
}

float brdf_sinh(float x) {
  float a = abs(x);
  float e = brdf_expm1(min(a, 80.0));
  float r = a > 80.0 ? 0.5 * brdf_exp(a) : 0.5 * (e + e / (e + 1.0));
  return x < 0.0 ? -r : r;
}

float brdf_cosh(float x) {
  float e = brdf_exp(min(abs(x), 80.0));
  return abs(x) > 80.0 ? 0.5 * brdf_exp(abs(x)) : 0.5 * (e + 1.0 / e);
}

float brdf_tanh(float x) {
  float e = brdf_expm1(-2.0 * min(abs(x), 20.0));
  float r = -e / (2.0 + e);
  return x < 0.0 ? -r : r;
}

// exp(-x^2) without the digits that rounding x^2 loses: x = h + l with h of 12 bits.
float brdf_expMinusSquare(float x) {
  float h = intBitsToFloat(floatBitsToInt(x) & 0xfffff000);
  float l = x - h;
  return brdf_exp(-h * h) * brdf_exp(-(x + h) * l);
}

// erfc(x) for x >= 1: continued fraction, Abramowitz and Stegun 7.1.14, 32 levels from below.
float brdf_erfcLarge(float x) {
  float f = x;
  for (int k = 32; k > 0; --k) f = x + 0.5 * float(k) / f;
  return brdf_expMinusSquare(x) * 0.564189584 / f;
}

// erf(x) for |x| < 2: 2/sqrt(pi) exp(-x^2) sum 2^n x^(2n+1)/(1 3 5 ...), all terms positive (A. and S. 7.1.6).
float brdf_erfSmall(float x) {
  float term = x;
  float sum = x;
  for (int n = 1; n < 28; ++n) {
    term *= 2.0 * x * x / float(2 * n + 1);
    sum += term;
  }
  return 1.12837917 * brdf_expMinusSquare(x) * sum;
}

float brdf_erf(float x) {
  float a = abs(x);
  float r = a < 2.0 ? brdf_erfSmall(a) : (a > 4.0 ? 1.0 : 1.0 - brdf_erfcLarge(a));
  return x < 0.0 ? -r : r;
}

// 1 - erf(x) loses a digit by x = 1: 3e-6 relative there, half a float ulp of 2 for negative x.
float brdf_erfc(float x) {
  if (x >= 1.0) return x > 10.1 ? 0.0 : brdf_erfcLarge(x);
  return 1.0 - brdf_erf(x);
}

// Stirling's series after raising the argument above 8 (A. and S. 6.1.41, 6.3.18); arguments above 0 only; 5e-6 absolute
// near the zeros.
float brdf_lgamma(float x) {
  float shift = 1.0;
  float y = x;
  for (int k = 0; k < 8; ++k)
    if (y < 8.0) {
      shift *= y;
      y += 1.0;
    }
  float z = 1.0 / (y * y);
  float series = (1.0 / 12.0 - z * (1.0 / 360.0 - z * (1.0 / 1260.0 - z / 1680.0))) / y;
  return (y - 0.5) * brdf_log(y) - y + 0.918938533 + series - brdf_log(shift);
}

float brdf_digamma(float x) {
  float sum = 0.0;
  float y = x;
  for (int k = 0; k < 8; ++k)
    if (y < 8.0) {
      sum -= 1.0 / y;
      y += 1.0;
    }
  float z = 1.0 / (y * y);
  return sum + brdf_log(y) - 0.5 / y - z * (1.0 / 12.0 - z * (1.0 / 120.0 - z * (1.0 / 252.0 - z / 240.0)));
}

float brdf_trigamma(float x) {
  float sum = 0.0;
  float y = x;
  for (int k = 0; k < 8; ++k)
    if (y < 8.0) {
      sum += 1.0 / (y * y);
      y += 1.0;
    }
  float z = 1.0 / (y * y);
  return sum + (1.0 + 0.5 / y + z * (1.0 / 6.0 - z * (1.0 / 30.0 - z * (1.0 / 42.0 - z / 30.0)))) / y;
}

// Bessel functions J0 and J1. To 8 a Chebyshev series in x^2/32 - 1, its coefficients from 30-digit arithmetic, summed
// by Clenshaw's recurrence; above, Hankel's expansion (A. and S. 9.2.5, 9.2.6) with cos(x - pi/4) written out. Absolute
// error 3e-7, which grows with x as the driver's sine and cosine do.
const float BRDF_J0[11] = float[11](0.1577279715, -0.008723442353, 0.2651786132, -0.3700949939, 0.1580671023,
  -0.03489376941, 0.004819180069, -4.606261662e-4, 3.246032882e-5, -1.761946908e-6, 7.608163592e-8);
const float BRDF_J1[11] = float[11](0.08104484633, -0.1489751451, 0.1609992624, -0.08268049177, 0.02221363965,
  -0.003646940601, 4.050337728e-4, -3.255554867e-5, 1.985877405e-6, -9.521984757e-8, 3.687133759e-9);

float brdf_hankel(float x, float mu, float direct, float crossed) {
  float p = 0.0, q = 0.0, term = 1.0;
  for (int k = 0; k < 10; k += 2) {
    p += term;
    term *= (mu - float((2 * k + 1) * (2 * k + 1))) / (float(k + 1) * 8.0 * x);
    q += term;
    term *= -(mu - float((2 * k + 3) * (2 * k + 3))) / (float(k + 2) * 8.0 * x);
  }
  return (p * direct - q * crossed) / sqrt(BRDF_PI * x);
}

float brdf_besselj0(float x) {
  float a = abs(x);
  if (a > 8.0) return a > 3.4028235e38 ? 0.0 : brdf_hankel(a, 0.0, cos(a) + sin(a), sin(a) - cos(a));
  float t = a * a / 32.0 - 1.0, b0 = 0.0, b1 = 0.0;
  for (int k = 10; k > 0; --k) {
    float b = 2.0 * t * b0 - b1 + BRDF_J0[k];
    b1 = b0;
    b0 = b;
  }
  return t * b0 - b1 + BRDF_J0[0];
}

float brdf_besselj1(float x) {
  float a = abs(x), r;
  if (a > 8.0) {
    r = a > 3.4028235e38 ? 0.0 : brdf_hankel(a, 4.0, sin(a) - cos(a), -sin(a) - cos(a));
  } else {
    float t = a * a / 32.0 - 1.0, b0 = 0.0, b1 = 0.0;
    for (int k = 10; k > 0; --k) {
      float b = 2.0 * t * b0 - b1 + BRDF_J1[k];
      b1 = b0;
      b0 = b;
    }
    r = a * (t * b0 - b1 + BRDF_J1[0]);
  }
  return x < 0.0 ? -r : r;
}

// Modified Bessel functions I: the power series to 10 (A. and S. 9.6.10, all terms positive), above the asymptotic one
// (9.7.1).
float brdf_besseliOf(float a, float order) {
  float term = order > 0.5 ? 0.5 * a : 1.0, sum = term;
  if (a <= 10.0) {
    for (int k = 1; k < 30; ++k) {
      term *= 0.25 * a * a / (float(k) * (float(k) + order));
      sum += term;
    }
    return sum;
  }
  term = 1.0;
  sum = 1.0;
  for (int k = 1; k < 13; ++k) {
    term *= -(4.0 * order * order - float((2 * k - 1) * (2 * k - 1))) / (float(k) * 8.0 * a);
    sum += term;
  }
  return brdf_exp(a - 0.5 * brdf_log(2.0 * BRDF_PI * a)) * sum;
}

float brdf_besseli0(float x) { return brdf_besseliOf(abs(x), 0.0); }
float brdf_besseli1(float x) { return x < 0.0 ? -brdf_besseliOf(-x, 1.0) : brdf_besseliOf(x, 1.0); }

// Modified Bessel functions K: near 0 the series with the logarithm (A. and S. 9.6.11, 9.6.13), elsewhere the trapezoid
// rule on the integral of exp(-x cosh t) cosh(order t) (9.6.24), whose error is exp(-2 pi^2) of the value at this step.
float brdf_besselkOf(float x, float order) {
  if (!(x >= 0.0)) return uintBitsToFloat(0x7fc00000u);
  if (x == 0.0) return uintBitsToFloat(0x7f800000u);
  if (x < 0.5) {
    float y = 0.25 * x * x, l = brdf_log(0.5 * x), g = 0.577215665;
    if (order < 0.5)
      return -(l + g) * (1.0 + y * (1.0 + y * (0.25 + y / 36.0))) + y * (1.0 + y * (0.375 + y * 11.0 / 216.0));
    float i1 = 0.5 * x * (1.0 + y * (0.5 + y * (1.0 / 12.0 + y / 144.0)));
    return 1.0 / x + l * i1 - 0.25 * x * ((1.0 - 2.0 * g) + y * ((2.5 - 2.0 * g) / 2.0 + y * ((10.0 / 3.0 - 2.0 * g) / 12.0 + y * (47.0 / 12.0 - 2.0 * g) / 144.0)));
  }
  float h = min(0.5, 1.0 / sqrt(x)), sum = 0.5;
  for (int k = 1; k < 13; ++k) {
    float s = brdf_sinh(0.5 * float(k) * h);
    sum += brdf_exp(-2.0 * x * s * s) * (order < 0.5 ? 1.0 : 1.0 + 2.0 * s * s);
  }
  return h * sum * brdf_exp(-x);
}

float brdf_besselk0(float x) { return brdf_besselkOf(x, 0.0); }
float brdf_besselk1(float x) { return brdf_besselkOf(x, 1.0); }

// x^a exp(-x)/Gamma(a): by Stirling's series about x = a from a = 8 on.
float brdf_gammaFactor(float a, float x) {
  float shift = 1.0, b = a;
  for (int k = 0; k < 8; ++k)
    if (b < 8.0) {
      shift *= b;
      b += 1.0;
    }
  float z = 1.0 / (b * b);
  float series = (1.0 / 12.0 - z * (1.0 / 360.0 - z / 1260.0)) / b;
  float scale = sqrt(b / (2.0 * BRDF_PI)) * shift;
  if (a >= 8.0) {
    // x/a - log(x/a) - 1: a power series near x = a, where the difference would lose its digits.
    float m = (x - a) / a, loss = m - brdf_log(x / a);
    if (abs(m) < 0.1)
      loss = m * m * (0.5 - m * (1.0 / 3.0 - m * (0.25 - m * (0.2 - m * (1.0 / 6.0 - m * (1.0 / 7.0 - m * 0.125))))));
    return brdf_exp(-a * loss - series) * scale;
  }
  return brdf_exp((a * brdf_log(x) - x) - b * (brdf_log(b) - 1.0) - series) * scale;
}

// Regularised incomplete gamma functions P (part 0) and Q (part 1), a > 0, x >= 0: the power series of P (A. and S.
// 6.5.29) below x = a + 1, the continued fraction of Q (6.5.31) by Lentz's method above. Relative error 1e-5, or one ulp
// for each unit of a and of the result's logarithm.
float brdf_incompleteGamma(float a, float x, int part) {
  if (!(a > 0.0) || !(x >= 0.0)) return uintBitsToFloat(0x7fc00000u);
  if (x == 0.0) return float(part);
  if (x > 3.4028235e38) return float(1 - part);
  float factor = brdf_gammaFactor(a, x);
  if (x < a + 1.0) {
    float term = 1.0 / a, sum = term;
    for (int n = 1; n < 1000; ++n) {
      term *= x / (a + float(n));
      sum += term;
      if (term < 3e-8 * sum) break;
    }
    float p = min(factor * sum, 1.0);
    return part == 0 ? p : 1.0 - p;
  }
  float b = x + 1.0 - a, d = 1.0 / b, c = 1e30, h = d;
  for (int n = 1; n < 1000; ++n) {
    float level = -float(n) * (float(n) - a);
    b += 2.0;
    d = 1.0 / (level * d + b);
    c = b + level / c;
    float step = c * d;
    h *= step;
    if (abs(step - 1.0) < 1e-7) break;
  }
  float q = min(factor * h, 1.0);
  return part == 0 ? 1.0 - q : q;
}

float brdf_gammap(float a, float x) { return brdf_incompleteGamma(a, x, 0); }
float brdf_gammaq(float a, float x) { return brdf_incompleteGamma(a, x, 1); }

// dP/da by a central difference, to a thousandth of its largest value: enough for the steps of a root, its only use.
float brdf_gammapDa(float a, float x) {
  float step = 0.02 * a;
  return (brdf_gammap(a + step, x) - brdf_gammap(a - step, x)) / (2.0 * step);
}
