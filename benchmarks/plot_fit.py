#!/usr/bin/python3
"""Draws how the time of a fit grows with samples, lobes and threads.

    benchmark_fit --benchmark_out=fit.json --benchmark_out_format=json
    benchmarks/plot_fit.py fit.json docs/images/fit-scaling.png

Needs python3-matplotlib.
"""
import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

source, target = sys.argv[1:3]
runs = [run for run in json.load(open(source))["benchmarks"] if run.get("run_type") == "iteration"]


def series(name):
    """Argument, milliseconds, samples and passes of one benchmark."""
    found = [run for run in runs if run["name"].startswith(name + "/")]
    return [(int(run["name"].split("/")[1]), run["real_time"], run.get("samples", 0), run.get("passes", 0)) for run in found]


figure, (samples, lobes, threads) = plt.subplots(1, 3, figsize=(10, 3.2), constrained_layout=True)

by_size = sorted((count, time, passes) for _, time, count, passes in series("tablesBySize"))
samples.loglog([s for s, _, _ in by_size], [t for _, t, _ in by_size], "o-")
samples.loglog([s for s, _, _ in by_size], [by_size[-1][1] * s / by_size[-1][0] for s, _, _ in by_size], ":", color="grey",
               label="in proportion")
samples.set_xlabel("samples (RGB)")
samples.set_ylabel("time of the fit (ms)")
samples.legend()

by_lobes = series("merlLayoutByLobes")
lobes.plot([n for n, *_ in by_lobes], [t for _, t, *_ in by_lobes], "o-")
for n, time, _, passes in by_lobes:
    lobes.annotate(f"{passes:.0f} passes", (n, time), xytext=(-4, 6), textcoords="offset points", ha="right", fontsize=7)
lobes.set_xticks([n for n, *_ in by_lobes])
lobes.set_ylim(0, 1.15 * max(time for _, time, *_ in by_lobes))
lobes.set_xlim(by_lobes[0][0] - 0.8, by_lobes[-1][0] + 0.2)
lobes.set_xlabel("lobes (Lambertian and GGX)")

by_threads = series("merlLayoutByThreads")
threads.plot([n for n, *_ in by_threads], [t for _, t, *_ in by_threads], "o-")
threads.plot([n for n, *_ in by_threads], [by_threads[0][1] / n for n, *_ in by_threads], ":", color="grey",
             label="in proportion")
threads.set_xscale("log", base=2)
threads.set_xticks([n for n, *_ in by_threads], [str(n) for n, *_ in by_threads])
threads.set_ylim(bottom=0)
cores = json.load(open(source))["context"]["num_cpus"]
threads.set_xlabel(f"threads, on {cores} cores")
threads.legend()
for axes in (samples, lobes, threads):
    axes.grid(True, which="both", alpha=0.2)
figure.savefig(target, dpi=110)
