#!/usr/bin/python3
"""Writes mie.csv beside it: efficiencies and asymmetry of homogeneous spheres in vacuum, by Mie's series as in C. F.
Bohren and D. R. Huffman, Absorption and Scattering of Light by Small Particles (1983), (4.61), (4.62), (4.88), with 300
digits: Riccati-Bessel functions by recurrence upwards, logarithmic derivatives downwards. Nothing of BRDFLab is used.

The spheres are those of W. J. Wiscombe's program MIEV0 (NCAR/TN-140+STR, 1979), cases 5 and 7 to 19, and of Bohren and
Huffman's appendix A (radius 0.525, index 1.55, wavelength 0.6328), with the figures that the tests of the program miepython
give for them (github.com/scottprahl/miepython, tests/test_mie.py); this script ends with an error where its own differ.
Needs mpmath; a minute. Run: python3 mie.py"""
import csv
import os

from mpmath import mp, mpc, mpf, pi

# Index n + i k, size parameter, and what is published: extinction, scattering, backscattering, asymmetry (None: not).
CASES = [
    ("0.75", "0", "0.099", (None, None, None, 0.001448)),
    ("0.75", "0", "10", (2.232265, 2.232265, None, 0.896473)),
    ("0.75", "0", "1000", (1.997908, 1.997908, None, 0.844944)),
    ("1.33", "1e-5", "1", (None, 0.093923, None, 0.184517)),
    ("1.33", "1e-5", "100", (None, 2.096594, None, 0.868959)),
    ("1.33", "1e-5", "10000", (None, 1.723857, None, 0.907840)),
    ("1.5", "1", "0.055", (0.101491, 0.000011, None, 0.000491)),
    ("1.5", "1", "1", (2.336321, 0.663454, None, 0.192136)),
    ("1.5", "1", "100", (2.097502, 1.283697, None, 0.850252)),
    ("1.5", "1", "10000", (2.004368, 1.236575, None, 0.846309)),
    ("10", "10", "1", (None, 2.049405, None, -0.110664)),
    ("10", "10", "100", (None, 1.836785, None, 0.556215)),
    ("10", "10", "10000", (None, 1.795393, None, 0.548194)),
    ("1.55", "0", None, (3.10543, 3.10543, 2.92534, 0.63314)),
]


def efficiencies(index, x):
    terms = int(x + 5 * x ** (mpf(1) / 3) + 20)
    inside = index * x
    # D_n = psi_n'/psi_n downwards from far above, where any beginning is forgotten.
    start = max(terms, int(abs(inside))) + 100
    derivative = [mpc(0)] * (start + 1)
    for n in range(start, 0, -1):
        derivative[n - 1] = n / inside - 1 / (derivative[n] + n / inside)
    psi, above = mp.sin(x), mp.cos(x)  # psi_0, psi_-1
    chi, chi_above = mp.cos(x), -mp.sin(x)  # chi_0, chi_-1
    extinction = scattering = asymmetry = mpf(0)
    back = mpc(0)
    last = None
    for n in range(1, terms + 1):
        before = mpc(psi, -chi)
        psi, above = (2 * n - 1) / x * psi - above, psi
        chi, chi_above = (2 * n - 1) / x * chi - chi_above, chi
        xi = mpc(psi, -chi)
        p, q = derivative[n] / index + n / x, derivative[n] * index + n / x
        a = (p * psi - above) / (p * xi - before)
        b = (q * psi - above) / (q * xi - before)
        extinction += (2 * n + 1) * (a + b).real
        scattering += (2 * n + 1) * (abs(a) ** 2 + abs(b) ** 2)
        back += (2 * n + 1) * (-1) ** n * (a - b)
        asymmetry += mpf(2 * n + 1) / (n * (n + 1)) * (a * mp.conj(b)).real
        if last:
            asymmetry += mpf((n - 1) * (n + 1)) / n * (last[0] * mp.conj(a) + last[1] * mp.conj(b)).real
        last = (a, b)
    factor = 2 / x**2
    return factor * extinction, factor * scattering, abs(back) ** 2 / x**2, 2 * asymmetry / scattering


def main():
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "mie.csv")
    rows = []
    for n, k, size, published in CASES:
        # Recurrence upwards loses digits beyond n = x: as many as psi_n falls, some hundreds at most.
        mp.dps = 300
        x = mpf(size) if size else 2 * pi * mpf("0.525") / mpf("0.6328")
        values = efficiencies(mpc(n, k), x)
        for value, stated in zip(values, published):
            # One unit of the last decimal that is printed.
            if stated is not None and abs(value - stated) > (1.1e-6 if size else 1e-5):
                raise SystemExit(f"{n} + {k} i, {size}: {mp.nstr(value, 9)} is not the published {stated}")
        rows.append([n, k, mp.nstr(x, 20)] + [mp.nstr(value, 15) for value in values])
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["n", "k", "size parameter", "extinction", "scattering", "backscattering", "asymmetry"])
        writer.writerows(rows)


if __name__ == "__main__":
    main()
