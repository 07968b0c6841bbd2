#!/usr/bin/env python3
"""Writes libbrdf/models/tables/ggxAlbedo.xml, ggxMeanAlbedo.xml and ggxGrazingAlbedo.xml: directional and mean albedo of
GGX without Fresnel, and the directional albedo with (1 - cos_d)^5 for it (the part of Schlick's F that goes with F90 - F0).

E(mu, alpha) is the hemisphere integral of D V cos_i (F = 1, height-correlated Smith), by the visible-normal change of
variables: E = mean over visible normals m of G2(i, o)/G1(o), where i is o mirrored at m, 0 below the horizon. The unit
disk of the projected normals (Heitz 2018) is integrated on a Gauss-Legendre x trapezoid grid, so nothing is random.
x is sqrt(mu) (32 nodes on [0, 1]), y is alpha (32 nodes on [0, 1]; alpha = 0 is the mirror, E = 1).
"""
import pathlib

import numpy as np

NODES = 32
RADII, ANGLES = 200, 400


def directional_albedo(mu, alpha, grazing=False):
    if alpha == 0:
        return (1 - mu) ** 5 if grazing else 1.0
    mu = max(mu, 1e-6)
    nodes, weights = np.polynomial.legendre.leggauss(RADII)
    r2 = 0.5 * (nodes + 1)  # uniform in area
    phi = (np.arange(ANGLES) + 0.5) * 2 * np.pi / ANGLES
    r = np.sqrt(r2)[:, None]
    weight = np.broadcast_to((0.5 * weights)[:, None] / ANGLES, (RADII, ANGLES))
    v = np.array([np.sqrt(1 - mu * mu), 0.0, mu])
    s = np.array([alpha * v[0], 0.0, v[2]])
    s /= np.linalg.norm(s)
    t1 = np.array([0.0, 1.0, 0.0])
    t2 = np.cross(s, t1)
    p1 = r * np.cos(phi)
    p2 = r * np.sin(phi)
    h = 0.5 * (1 + s[2])
    p2 = (1 - h) * np.sqrt(1 - p1 * p1) + h * p2
    p3 = np.sqrt(np.maximum(0, 1 - p1 * p1 - p2 * p2))
    n = p1[..., None] * t1 + p2[..., None] * t2 + p3[..., None] * s
    m = np.stack([alpha * n[..., 0], alpha * n[..., 1], np.maximum(n[..., 2], 1e-12)], -1)
    m /= np.linalg.norm(m, axis=-1, keepdims=True)
    i = 2 * (m @ v)[..., None] * m - v
    ci = np.maximum(i[..., 2], 1e-12)
    lam = lambda c: 0.5 * (np.sqrt(1 + alpha * alpha * (1 - c * c) / (c * c)) - 1)
    ratio = (1 + lam(mu)) / (1 + lam(mu) + lam(ci))
    fresnel = (1 - np.clip(m @ v, 0, 1)) ** 5 if grazing else 1.0
    return float(np.sum(weight * np.where(i[..., 2] > 0, ratio * fresnel, 0)))


def write(name, title, nx, ny, values):
    rows = "\n".join("    " + " ".join(f"{v:.8f}" for v in values[k:k + 8]) for k in range(0, len(values), 8))
    ytext = f' ny="{ny}" y0="0" y1="1"' if ny > 1 else ""
    path = pathlib.Path(__file__).parent.parent / "libbrdf" / "models" / "tables" / f"{name}.xml"
    path.write_text(f'<?xml version="1.0" encoding="UTF-8"?>\n<!-- {title} Written by tools/ggx_albedo.py. -->\n'
                    f'<table name="{name}" nx="{nx}" x0="0" x1="1"{ytext}>\n  <values>\n{rows}\n  </values>\n</table>\n')


def main():
    grid = np.linspace(0, 1, NODES)
    table = [directional_albedo(x * x, a) for a in grid for x in grid]
    write("ggxAlbedo", "E(sqrt(mu), alpha) of GGX, Smith, F = 1.", NODES, NODES, table)
    table = [directional_albedo(x * x, a, True) for a in grid for x in grid]
    write("ggxGrazingAlbedo", "The albedo at (sqrt(mu), alpha) of GGX, Smith, F = (1 - cos_d)^5.", NODES, NODES, table)
    nodes, weights = np.polynomial.legendre.leggauss(48)
    mus = 0.5 * (nodes + 1)
    mean = [float(sum(w * m * directional_albedo(m, a) for m, w in zip(mus, weights))) for a in grid]
    write("ggxMeanAlbedo", "2 integral E(mu, alpha) mu dmu of GGX, Smith, F = 1.", NODES, 1, mean)


if __name__ == "__main__":
    main()
