#!/usr/bin/python3
"""Writes phase_transform.csv beside it: Phi(g, f) = integral of [exp(-g (1 - rho)) - exp(-g)] exp(-2 pi i f r) d^2r in
um^2 (libbrdf/simulate/wave/PhaseTransform.h), by Gauss and Legendre's rule of 20 points on panels of r that are narrow
against 1 / f, in double precision but for the hypergeometric function. Relative error about 1e-8. Nothing of BRDFLab is
used. Needs mpmath, numpy and scipy; a minute. Run: python3 phase_transform.py"""
import csv
import math
import os

import numpy
from mpmath import besselj, gamma, hyper, mp, mpf, pi
from scipy.special import j0, kv

mp.dps = 25


def k_correlation(b, c):
    """rho of abc(b, c): u^nu K_nu(u) 2^(1 - nu) / Gamma(nu), u = 2 pi r / b, nu = c/2 - 1."""
    nu = c / 2 - 1

    def rho(r):
        u = 2 * numpy.pi * r / b
        return numpy.minimum(2 * (u / 2) ** nu * kv(nu, u) / math.gamma(nu), 1)

    return rho


def gaussian(length):
    return lambda r: numpy.exp(-((r / length) ** 2))


def mixture(parts):
    total = sum(weight for weight, _ in parts)
    return lambda r: sum(weight * rho(r) for weight, rho in parts) / total


def power_law(n, corner):
    """rho of max(f, corner)^-n: of the disk, and of the power law less its part below the corner."""
    n = mpf(n)
    disk = pi * corner ** (2 - n)
    total = disk * (1 + 2 / (n - 2))

    def one(r):
        r = mpf(float(r))
        x = 2 * pi * corner * r
        flat = disk * 2 * besselj(1, x) / x
        # integral from x of t^(1 - n) J0(t) dt = whole - x^(2 - n) / (2 - n) 1F2(1 - n/2; 1, 2 - n/2; -x^2 / 4)
        whole = 2 ** (1 - n) * gamma(1 - n / 2) / gamma(n / 2)
        rest = whole - x ** (2 - n) / (2 - n) * hyper([1 - n / 2], [1, 2 - n / 2], -x * x / 4)
        return (flat + 2 * pi * (2 * pi * r) ** (n - 2) * rest) / total

    return lambda r: numpy.array([float(one(x)) for x in r])


class Panels:
    """By halves from the least distance on, then as wide as `width`, to `last`: rho is taken once at each node."""

    def __init__(self, rho, least, width, last):
        x, w = numpy.polynomial.legendre.leggauss(20)
        ends = [0.0, least]
        while ends[-1] < last:
            ends.append(min(1.5 * ends[-1], ends[-1] + width))
        ends = numpy.array(ends)
        half = (ends[1:] - ends[:-1]) / 2
        self.r = (ends[:-1, None] + half[:, None] * (x + 1)).ravel()
        self.w = (half[:, None] * w).ravel()
        self.rho = rho(self.r)

    def integral(self, values, f):
        return 2 * math.pi * math.fsum(self.w * self.r * values * j0(2 * math.pi * f * self.r))

    def whole(self, g, f):
        near = numpy.exp(-g * (1 - self.rho)) - math.exp(-g)
        return self.integral(numpy.where(self.rho < 0.5, math.exp(-g) * numpy.expm1(g * numpy.minimum(self.rho, 0.5)), near), f)

    def beyond_first(self, g, f):
        """Of exp(-g) (exp(g rho) - 1 - g rho), which falls faster."""
        x = g * self.rho
        small = sum(x**m / math.factorial(m) for m in range(2, 16))
        large = numpy.exp(-g * (1 - self.rho)) - math.exp(-g) * (1 + x)
        return self.integral(numpy.where(abs(x) < 0.5, math.exp(-g) * small, large), f)


def rows():
    for c in ("2.2", "3", "4", "6"):
        panels = Panels(k_correlation(5, float(c)), 1e-28, 0.05, 40.0)
        for g in (0.01, 1, 30) if c == "2.2" else (0.01, 1, 30, 1000):
            for f in (0.002, 0.2, 2, 20):
                yield f"abc(a=0.01, b=5, c={c})", g, f, panels.whole(g, f)
    # Variances 2 pi a / (b^2 (c - 2)) and rms^2 as weights.
    parts = [(2 * math.pi * 0.01 / 25, k_correlation(5, 3)), (0.06**2, gaussian(0.8))]
    panels = Panels(mixture(parts), 1e-16, 0.1, 40.0)
    for g in (0.01, 1, 30):
        for f in (0.02, 0.4, 4):
            yield "sum(abc(a=0.01, b=5, c=3), gaussian(rms=0.06, correlation=0.8))", g, f, panels.whole(g, f)
    corner = 0.1
    for n in (2.5, 3.5):
        panels = Panels(power_law(n, corner), 1e-24, 0.8, 400.0)
        disk = math.pi * corner ** (2 - n) * (1 + 2 / (n - 2))
        for g in (0.01, 1, 30, 1000):
            for f in (0.002, 0.08, 0.13, 0.5, 3):
                first = g * math.exp(-g) * max(f, corner) ** -n / disk
                yield f"fractal(a=0.01, exponent={n}, corner=0.1)", g, f, first + panels.beyond_first(g, f)


def main():
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "phase_transform.csv")
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["spectrum", "g", "f (1/um)", "phi (um^2)"])
        for spectrum, g, f, value in rows():
            writer.writerow([spectrum, g, f, f"{value:.10g}"])
            file.flush()


if __name__ == "__main__":
    main()
