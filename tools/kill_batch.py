#!/usr/bin/env python3
"""Kills `brdf batch` at random moments and checks that nothing acknowledged is lost.

    tools/kill_batch.py build/release/bin/brdf --kills 200 --ranks 2

A small batch is run once undisturbed. Then it is run again and again in a fresh folder, each time killed (SIGKILL) at a
random moment: mpirun, one of the ranks, or all of them at once; the next start goes on in the same folder, until the
batch completes, and then a new round begins. Checked after every kill: each fit that the program has told of is in a
journal, in a whole line, and no start does such a fit again. Checked after every round: results.csv and results.vtkhdf
are those of the undisturbed run, times and dates aside, and every fit is in the journals exactly once.

Exit code 0: all held; 1: something did not; 77: mpirun is missing, so nothing was tested.
"""
import argparse
import collections
import csv
import json
import math
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import zlib

ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_btl_vader_single_copy_mechanism="none")


def write_job(folder, fits):
    """Two small scattered measurements: a diffuse and a glossy term, with reproducible noise."""
    for name, width in (("rough", 0.4), ("smooth", 0.15)):
        noise = random.Random(name)
        rows = ["# isotropic", "theta_i,theta_o,phi_o,value_0"]
        for theta_i in range(5, 80, 15):
            for theta_o in range(0, 80, 8):
                for phi in range(0, 181, 20):
                    i, o, p = (math.radians(x) for x in (theta_i, theta_o, phi))
                    x = math.sin(i) + math.sin(o) * math.cos(p)
                    y = math.sin(o) * math.sin(p)
                    z = math.cos(i) + math.cos(o)
                    theta_h = math.atan2(math.hypot(x, y), z)
                    value = 0.1 + 0.5 * math.exp(-(theta_h / width) ** 2)
                    rows.append(f"{theta_i},{theta_o},{phi},{value * (1 + 0.02 * noise.uniform(-1, 1)):.9g}")
        (folder / f"{name}.csv").write_text("\n".join(rows) + "\n")
    lobes = ["Lambertian + GGX", "Lambertian + Ward", "Lambertian + BlinnPhong", "Lambertian + GGX + Ward"]
    job = {"title": "kill me", "targets": ["rough.csv", "smooth.csv"],
           "fits": {"lobes": lobes, "optimizer": ["lm", "bobyqa", "neldermead"], "metric": ["rms", "log"], "starts": 6}}
    if fits < 48:
        job["fits"].update(lobes=lobes[:2], optimizer=["lm", "bobyqa"], metric=["rms", "log"], starts=20)
    (folder / "job.json").write_text(json.dumps(job))


def journal_keys(folder):
    """The keys of all whole records, each as often as it is there."""
    keys = []
    for path in sorted(folder.glob("journal-*.jsonl")):
        for line in path.read_bytes().split(b"\n")[:-1]:
            if len(line) > 9 and line[:8] == b"%08x" % zlib.crc32(line[9:]):
                keys.append(json.loads(line[9:])["key"])
    return collections.Counter(keys)


def results(folder):
    """results.csv without its times, and the container's content without times and dates."""
    with open(folder / "results.csv", newline="") as file:
        rows = [{k: v for k, v in row.items() if k != "seconds"} for row in csv.DictReader(file)]
    dump = None
    if shutil.which("h5dump"):
        text = subprocess.run(["h5dump", "-m", "%.17g", str(folder / "results.vtkhdf")], check=True, capture_output=True,
                              text=True).stdout
        dump = re.sub(r'\n( *)ATTRIBUTE "(Seconds|Date)" \{.*?\n\1\}', "", text, flags=re.S).split("\n", 1)[1]
    return rows, dump


class Run:
    """One start of the batch, in a process group of its own."""

    def __init__(self, arguments, folder, out):
        self.log = out.open("wb")
        self.stuck = False
        self.out = out
        command = [arguments.brdf, "batch", "job.json", "--out", "results"]
        if arguments.ranks > 1:
            command = ["mpirun", "-n", str(arguments.ranks)] + command
        self.process = subprocess.Popen(command, stdout=self.log, stderr=subprocess.STDOUT, env=ENVIRONMENT,
                                        cwd=folder,
                                        stdin=subprocess.DEVNULL, start_new_session=True)

    def ranks(self):
        """Processes of the program, rank 0 first where the system numbers processes upwards."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            if not entry.name.isdigit():
                continue
            try:
                if (os.getsid(int(entry.name)) == self.process.pid and (entry / "comm").read_text().strip() == "brdf"
                        and "State:\tZ" not in (entry / "status").read_text()):
                    found.append(int(entry.name))
            except (OSError, ProcessLookupError):
                pass
        return sorted(found)

    def kill(self, whom):
        ranks = self.ranks()
        victims = {"mpirun": [self.process.pid], "all": [self.process.pid] + ranks,
                   "rank 0": ranks[:1], "last rank": ranks[-1:]}[whom] or [self.process.pid]
        for victim in victims:
            try:
                os.kill(victim, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def wait(self, seconds):
        """Waits for the end of all processes; returns how long the last one took, or None when a rank stays. An mpirun
        that stays although all its ranks have gone (seen with Open MPI 4.1.4: it loses track of a rank that is killed
        while it connects) is ended and counted."""
        begin = time.monotonic()
        gone = None
        while self.process.poll() is None or self.ranks():
            now = time.monotonic()
            gone = None if self.ranks() else gone or now
            if gone and now - gone > 20:
                self.stuck = True
                self.process.kill()
                self.process.wait()
                break
            if now - begin > seconds:
                return None
            time.sleep(0.02)
        self.log.close()
        return (gone or time.monotonic()) - begin

    def told(self):
        return re.findall(r"^\[\d+/\d+\] .*\(([0-9a-f]{16})\)$", self.out.read_text(errors="replace"), flags=re.M)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("brdf", help="the program")
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--fits", type=int, default=48, help="fewer than 48: a smaller batch of 16")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folder", help="where to work; default a temporary one that is removed")
    arguments = parser.parse_args()
    arguments.brdf = os.path.abspath(arguments.brdf)
    if arguments.ranks > 1 and not shutil.which("mpirun"):
        print("skipped: mpirun is not installed")
        return 77

    work = pathlib.Path(arguments.folder or tempfile.mkdtemp(prefix="kill_batch."))
    work.mkdir(parents=True, exist_ok=True)
    faults = []
    chance = random.Random(arguments.seed)

    def fresh(name):
        folder = work / name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        write_job(folder, arguments.fits)
        return folder

    folder = fresh("undisturbed")
    begin = time.monotonic()
    run = Run(arguments, folder, folder / "out")
    run.wait(600)
    duration = time.monotonic() - begin
    if run.process.returncode != 0:
        print((folder / "out").read_text())
        print("the undisturbed batch failed")
        return 1
    reference = results(folder / "results")
    total = len(reference[0])
    print(f"undisturbed: {total} fits in {duration:.1f} s; container compared: {'yes' if reference[1] else 'no h5dump'}", flush=True)

    kills = collections.Counter()
    rounds = told_in_all = stuck = 0
    whom = ["mpirun", "rank 0", "last rank", "all"] if arguments.ranks > 1 else ["all"]
    longest = 0.0
    while sum(kills.values()) < arguments.kills:
        rounds += 1
        folder = fresh("round")
        told = set()
        starts = 0
        while True:
            starts += 1
            run = Run(arguments, folder, folder / f"out{starts}")
            killed = False
            if sum(kills.values()) < arguments.kills:
                try:
                    run.process.wait(timeout=chance.uniform(0, 0.6 * duration))
                except subprocess.TimeoutExpired:
                    victim = chance.choice(whom)
                    run.kill(victim)
                    kills[victim] += 1
                    killed = True
                    if sum(kills.values()) % 20 == 0:
                        print(f"{sum(kills.values())} kills, {rounds} rounds, {len(faults)} faults", flush=True)
            took = run.wait(300 if not killed else 60)
            if took is None:
                faults.append(f"round {rounds}, start {starts}: a process outlived the kill by a minute")
                break
            stuck += run.stuck
            if killed and not run.stuck:
                longest = max(longest, took)
            now = run.told()
            again = told.intersection(now)
            if again:
                faults.append(f"round {rounds}, start {starts}: told of twice: {sorted(again)}")
            told.update(now)
            told_in_all += len(now)
            lost = told - set(journal_keys(folder / "results")) if (folder / "results").exists() else told
            if lost:
                faults.append(f"round {rounds}, start {starts}: told of, but not in a journal: {sorted(lost)}")
            if not killed:
                if run.process.returncode != 0:
                    faults.append(f"round {rounds}, start {starts}: exit code {run.process.returncode}: "
                                  + run.out.read_text(errors="replace")[-300:])
                break
        twice = [key for key, count in journal_keys(folder / "results").items() if count != 1]
        if twice:
            faults.append(f"round {rounds}: more than once in the journals: {twice}")
        if results(folder / "results") != reference:
            faults.append(f"round {rounds}: the results differ from the undisturbed run's")
        left = [path.name for path in (folder / "results").iterdir()
                if not re.fullmatch(r"journal-\d+\.jsonl|lock|results\.(csv|vtkhdf)", path.name)]
        if left:
            faults.append(f"round {rounds}: left behind: {left}")

    print(f"{sum(kills.values())} kills ({', '.join(f'{n} {w}' for w, n in sorted(kills.items()))}) in {rounds} rounds; "
          f"{told_in_all} fits told of; after a kill the last rank ended within {longest:.2f} s; "
          f"mpirun hung without ranks {stuck} times")
    for fault in faults:
        print("FAULT:", fault)
    print("lost: 0, results identical" if not faults else f"{len(faults)} faults")
    if not arguments.folder:
        shutil.rmtree(work, ignore_errors=True)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
