"""Runs problem 1 in CalculiX and compares its force with the exact one.

    python3 benches/calculix/measure.py              the set-ups of docs/benchmarks.md
    python3 benches/calculix/measure.py --short      the best one with 24 elements, a few seconds
    python3 benches/calculix/measure.py --list       the set-ups, without running
    python3 benches/calculix/measure.py --keep DIR   keeps decks and results there

Needs the program `ccx` (Debian: calculix-ccx), or --ccx PATH.  The program is
run as it is and is no part of this project.
"""

import argparse
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

from decks import Variant, deck
from reference import INCREMENTS, forces

SURFACE = "SURFACE TO SURFACE"
EXPONENTIAL = "EXPONENTIAL, 0.01, 4.8"  # the paper's: 1e-5 m, 4.8e6 Pa

BEST = Variant("slaves on the circle, node to surface, K = 1e3")
VARIANTS = [
    BEST,
    Variant("the same, tension of the law left to its default", law="LINEAR, 1e3"),
    Variant("the same, K = 1e4", law="LINEAR, 1e4, 1e-3"),
    Variant("the same, K = 1e5", law="LINEAR, 1e5, 1e-3"),
    Variant("100 x 2 elements, 0.5 degrees, K = 1e4", law="LINEAR, 1e4, 1e-3", elements=100, degrees=0.5),
    Variant("slaves on the circle, surface to surface", kind=SURFACE),
    Variant("the same, 100 increments", kind=SURFACE, increments=100),
    Variant("slaves on the strip, surface to surface", slaves="strip", kind=SURFACE),
    Variant("slaves on the strip, node to surface", slaves="strip"),
    Variant("exponential law, slaves on the circle, node to surface", law=EXPONENTIAL),
    Variant("exponential law, slaves on the circle, surface to surface", kind=SURFACE, law=EXPONENTIAL),
    Variant("exponential law, slaves on the strip, node to surface", slaves="strip", law=EXPONENTIAL),
]
FRICTION = (0.0, 0.3)


def forces_of(dat):
    """From the text of JOB.dat: time -> force that pushes the circle down."""
    result = {}
    lines = iter(dat.splitlines())
    for line in lines:
        if "for set NCIRCLE and time" in line:
            time = float(line.split()[-1])
            next(lines)
            result[time] = -float(next(lines).split()[1])
    return result


def run(variant, folder, ccx, limit):
    """Forces by time, processor time, completed increments."""
    job = "job"
    (folder / f"{job}.inp").write_text(deck(variant))
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(folder / f"{job}.log", "w") as log:
        try:
            command = [ccx, job]
            subprocess.run(
                command, cwd=folder, stdout=log, stderr=log, env=environment, timeout=limit
            )
        except subprocess.TimeoutExpired:
            print("stopped: time limit", file=sys.stderr)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    # The exit code says little; what was reached stands in the files.
    dat, sta = folder / f"{job}.dat", folder / f"{job}.sta"
    found = forces_of(dat.read_text()) if dat.exists() else {}
    rows = sta.read_text().splitlines() if sta.exists() else []
    attempts = [row.split() for row in rows if row.split()[:1] and row.split()[0].isdigit()]
    cutbacks = sum(1 for row in attempts if row[2].endswith("U"))
    increments = len(attempts) - cutbacks
    return found, spent, increments, cutbacks


def errors(found, exact):
    """Root mean square and largest error over the common times, % of the peak."""
    off = []
    for k in range(1, INCREMENTS + 1):
        near = [value for time, value in found.items() if abs(time - k / INCREMENTS) < 1e-6]
        if not near:
            return None
        off.append(near[0] - exact[k])
    peak = max(exact)
    mean = (sum(value * value for value in off) / len(off)) ** 0.5
    return 100.0 * mean / peak, 100.0 * max(map(abs, off)) / peak


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--ccx", default="ccx", help="the program to run")
    parser.add_argument("--short", action="store_true", help="only the best set-up")
    parser.add_argument("--list", action="store_true", help="print the set-ups and end")
    parser.add_argument("--keep", type=Path, help="folder for decks and results")
    parser.add_argument("--limit", type=float, default=300.0, help="seconds a run may take")
    arguments = parser.parse_args()
    chosen = [BEST] if arguments.short else VARIANTS
    if arguments.list:
        for variant in chosen:
            print(variant.name)
        return 0
    exact = {friction: forces(friction=friction) for friction in FRICTION}
    print("set-up,mu,increments,cut back,CPU s,RMS %,largest %")
    for number, variant in enumerate(chosen):
        for friction in FRICTION:
            with tempfile.TemporaryDirectory() as temporary:
                folder = Path(temporary)
                if arguments.keep:
                    folder = arguments.keep / f"{number:02}_mu{friction:g}"
                    folder.mkdir(parents=True, exist_ok=True)
                try:
                    found, spent, increments, cutbacks = run(
                        variant.with_friction(friction), folder, arguments.ccx, arguments.limit
                    )
                except FileNotFoundError:
                    print(f"error: there is no program {arguments.ccx}", file=sys.stderr)
                    return 1
            off = errors(found, exact[friction])
            if off:
                result = f"{off[0]:.3f},{off[1]:.2f}"
            else:
                result = f"stopped at t = {max(found, default=0.0):g},"
            name = f'"{variant.name}"'
            print(f"{name},{friction:g},{increments},{cutbacks},{spent:.1f},{result}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
