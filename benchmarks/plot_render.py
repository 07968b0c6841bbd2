#!/usr/bin/python3
"""Draws what render_study measures: docs/rendering-accuracy.md.

    render_study convergence > convergence.csv
    render_study bias > bias.csv
    benchmarks/plot_render.py convergence.csv bias.csv docs/images

Writes render-convergence.png and render-bias.png and prints the tables of the page. Needs python3-matplotlib, -scipy.
"""
import csv
import math
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from scipy import stats

convergence_file, bias_file, folder = sys.argv[1:4]
COLOURS = {"random": "#E69F00", "low-discrepancy": "#0072B2"}  # Okabe and Ito: told apart by all
MAPS = {"studio": "#000000", "venice": "#0072B2", "sunset": "#D55E00", "one texel": "#009E73"}


def fitted(points, errors):
    """Slope of log error over log points and half the width of its 95 % confidence interval."""
    line = stats.linregress([math.log(n) for n in points], [math.log(e) for e in errors])
    return line.slope, stats.t.ppf(0.975, len(points) - 2) * line.stderr, line.intercept


runs = list(csv.DictReader(open(convergence_file)))
cases = list(dict.fromkeys((run["material"], run["map"]) for run in runs))
columns = max(1, math.ceil(len(cases) / 2))
figure, all_axes = plt.subplots(2, columns, figsize=(3.3 * columns, 5.6), sharex=True, sharey=True,
                                constrained_layout=True, squeeze=False)
print("| material | map | random | low-discrepancy | error of 4096 points: random | low-discrepancy |")
print("|---|---|---|---|---|---|")
for axes, (material, name) in zip(all_axes.flat, cases):
    cells, last = [], []
    for sequence, colour in COLOURS.items():
        chosen = [run for run in runs if (run["material"], run["map"], run["sequence"]) == (material, name, sequence)]
        points, errors = [int(run["n"]) for run in chosen], [float(run["error"]) for run in chosen]
        slope, margin, intercept = fitted(points, errors)
        axes.loglog(points, [100 * e for e in errors], "o", markersize=4, color=colour)
        axes.loglog(points, [100 * math.exp(intercept) * n**slope for n in points], color=colour,
                    label=f"{sequence}: {slope:.2f} ± {margin:.2f}")
        cells.append(f"{slope:.2f} ± {margin:.2f}")
        last.append(f"{100 * errors[-1]:.3g} %")
    axes.set_title(f"{material}\nunder {name}", fontsize=8)
    axes.legend(fontsize=7, title="slope", title_fontsize=7, loc="lower left")
    axes.grid(True, which="major", alpha=0.25)
    print(f"| `{material}` | {name} | {cells[0]} | {cells[1]} | {last[0]} | {last[1]} |")
for axes in all_axes[-1]:
    axes.set_xlabel("points a pixel")
for row in all_axes:
    row[0].set_ylabel("rms error (% of the picture's rms)")
figure.savefig(f"{folder}/render-convergence.png", dpi=110)

rows = list(csv.DictReader(open(bias_file)))
counts = sorted({int(row["samples"]) for row in rows})
figure, all_axes = plt.subplots(1, len(counts), figsize=(3.3 * len(counts), 3.3), sharey=True, constrained_layout=True)
for axes, count in zip(all_axes, counts):
    for name, colour in MAPS.items():
        chosen = [row for row in rows if row["map"] == name and int(row["samples"]) == count]
        alphas = [float(row["alpha"]) for row in chosen]
        axes.loglog(alphas, [100 * float(row["bias"]) for row in chosen], "o-", color=colour, markersize=4, label=name)
        axes.loglog(alphas, [100 * float(row["noise"]) for row in chosen], ":", color=colour)
    axes.set_title(f"{count} samples a pixel", fontsize=9)
    axes.set_xticks(alphas, [f"{alpha:g}" for alpha in alphas], fontsize=8)
    axes.minorticks_off()
    axes.set_xlabel("roughness alpha of GGXConductor")
    axes.grid(True, which="major", alpha=0.25)
all_axes[0].set_ylabel("bias; dotted: noise\n(% of the picture's rms)")
all_axes[0].legend(fontsize=7, title="map", title_fontsize=7)
figure.savefig(f"{folder}/render-bias.png", dpi=110)

print()
alphas = list(dict.fromkeys(row["alpha"] for row in rows))
print("| map | samples |" + "".join(f" {alpha} |" for alpha in alphas))
print("|---|---|" + "---|" * len(alphas))
for name in MAPS:
    for count in counts:
        found = {row["alpha"]: row for row in rows if row["map"] == name and int(row["samples"]) == count}
        print(f"| {name} | {count} |" + "".join(
            f" {100 * float(found[a]['bias']):.1f} ({100 * float(found[a]['noise']):.1f}) |" for a in alphas))
