#!/usr/bin/env python3
"""A simulator that BRDFLab runs: parallel V-grooves with Lambertian walls, by Monte Carlo.

    brdf lobe "program:--stay --channels mono python3 v_groove.py --walls 40 --albedo 0.8" --out grooves.png

Reads lines of wi_x,wi_y,wi_z,wo_x,wo_y,wo_z (unit vectors, normal +z, wi to the light, wo to the viewer) and prints one
value a line: the BRDF in 1/sr, without the cosine. The same random numbers serve every pair, so that lobes are smooth.

The grooves run along y; in the plane of x and z the walls rise from (0, 0) to the edges (-1, h) and (1, h). Light comes
in evenly through the top. At each point where it meets a wall, what goes from there to the viewer unhindered is counted;
then it goes on in a random direction, cosine-distributed about the wall's normal, until it leaves through the top.
"""
import argparse
import sys

import numpy as np


class Grooves:
    """All in the plane of x and z: nothing depends on y. Wall 0 is the left one."""

    def __init__(self, walls, albedo, rays, seed):
        angle = np.radians(walls)
        self.side = np.array([np.sin(angle), -np.sin(angle)])  # x of the normals; z is `up`
        self.up = np.cos(angle)
        self.height = np.tan(angle)
        self.albedo, self.rays, self.seed = albedo, rays, seed

    def way(self, wall, x, z, dx, dz):
        """How far it is from points to a wall, infinite where they head away from it or beside it."""
        speed = self.side[wall] * dx + self.up * dz
        with np.errstate(divide="ignore", invalid="ignore"):
            way = np.where(speed < 0, np.maximum(0, -(self.side[wall] * x + self.up * z) / speed), np.inf)
            return np.where(np.abs(x + way * dx) <= 1, way, np.inf)

    def path(self, wi):
        """Where light from wi meets the walls: a list of (wall, x, z, weight) of the rays left, one entry a bounce."""
        random = np.random.default_rng(self.seed)
        x = (np.arange(self.rays) + random.random(self.rays)) / self.rays * 2 - 1
        z = np.full(self.rays, self.height)
        ways = np.stack([self.way(wall, x, z, -wi[0], -wi[2]) for wall in (0, 1)])
        wall, way = ways.argmin(axis=0), ways.min(axis=0)
        x, z, weight = x - way * wi[0], z - way * wi[2], np.full(self.rays, self.albedo)
        bounces = []
        while len(bounces) < 200 and len(weight):
            bounces.append((wall, x, z, weight))
            r, phi = np.sqrt(random.random(len(wall))), 2 * np.pi * random.random(len(wall))
            along, out = r * np.cos(phi), np.sqrt(1 - r * r)
            dx, dz = along * self.up + out * self.side[wall], out * self.up - along * self.side[wall]
            way = self.way(1 - wall, x, z, dx, dz)
            stays = np.isfinite(way) & (self.albedo > 0)
            x, z = (x[stays] + way[stays] * dx[stays]), (z[stays] + way[stays] * dz[stays])
            wall, weight = 1 - wall[stays], weight[stays] * self.albedo
        return bounces

    def values(self, wi, wo):
        """The BRDF for one wi and an array of wo, in 1/sr."""
        total = np.zeros(len(wo))
        for wall, x, z, weight in self.path(wi):
            wall, x, z = wall[:, None], x[:, None], z[:, None]
            cosine = self.side[wall] * wo[:, 0] + self.up * wo[:, 2]
            free = np.isinf(self.way(1 - wall, x, z, wo[:, 0], wo[:, 2]))
            total += weight @ np.where(free, np.maximum(0, cosine), 0)
        return total / (np.pi * self.rays * wo[:, 2])


def answer(grooves, rows):
    if not rows:
        return
    pairs = np.array(rows)
    lights, which = np.unique(pairs[:, :3], axis=0, return_inverse=True)
    values = np.empty(len(pairs))
    for k, wi in enumerate(lights):
        same = np.flatnonzero(which.ravel() == k)
        for some in np.array_split(same, 1 + len(same) // 512):
            values[some] = grooves.values(wi, pairs[some, 3:])
    np.savetxt(sys.stdout, values, fmt="%.17g")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--walls", type=float, default=40, help="angle of the walls to the surface, 0 to 80 degrees")
    parser.add_argument("--albedo", type=float, default=0.8, help="of the walls, 0 to 1")
    parser.add_argument("--rays", type=int, default=200, help="for each direction of light")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if not (0 <= options.walls <= 80 and 0 <= options.albedo <= 1 and options.rays > 0):
        sys.exit("v_groove.py: --walls must be 0 to 80 degrees, --albedo 0 to 1, --rays at least 1")
    grooves = Grooves(**vars(options))
    next(sys.stdin)  # the names of the columns
    rows = []
    for line in sys.stdin:
        if line.strip():
            rows.append([float(number) for number in line.split(",")])
        else:  # the end of a batch, where BRDFLab lets the program stay
            answer(grooves, rows)
            print(flush=True)
            rows = []
    answer(grooves, rows)


if __name__ == "__main__":
    main()
