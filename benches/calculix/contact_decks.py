"""CalculiX' own test decks with contact, run by both programs.

    python3 benches/calculix/contact_decks.py                fetches the decks, prints a table
    python3 benches/calculix/contact_decks.py --decks DIR    the same with decks that are there already
    python3 benches/calculix/contact_decks.py --only ring1,friction1 --keep DIR

Needs the program `ccx`, or --ccx PATH.  Looked at are static decks without shells that
have a *CONTACT PAIR.  Both programs run the same deck, which is asked for displacements and
stresses of all nodes too; compared are the last tables of displacements, forces (their
sum, over the largest one) and stresses in `.dat` and `.frd`: the largest difference over
the largest value of a table.  Where only stresses differ, look at displacements and forces first: stresses
at nodes are extrapolated, and CalculiX' elements of one name are not always ours.

CalculiX' contact is a penalty, so its result may depend on the stiffness that the deck
gives and on the size of the increments.  For decks that do not agree within 1 % it is run
a second time with ten times the stiffness (`K x 10`): where its own result then moves by
more than that, the deck cannot decide.
"""

import argparse
import glob
import os
import re
import subprocess
import tempfile
from pathlib import Path

from published import OTHERS, blocks, deviation, fetch, tables

AGREES = 1e-2
FLAGS = re.MULTILINE | re.IGNORECASE


def decks(folder):
    """Static decks with contact, by name."""
    for path in sorted(glob.glob(os.path.join(folder, "*.inp"))):
        text = open(path, errors="replace").read()
        static = re.search(r"^\*STATIC", text, FLAGS) and not re.search(rf"^\*({OTHERS})", text, FLAGS)
        if static and re.search(r"^\*CONTACT ?PAIR", text, FLAGS):
            yield Path(path).stem, text


def asking(text):
    """The deck with all displacements and stresses asked for in its last step."""
    place = [found.start() for found in re.finditer(r"^\*END ?STEP", text, FLAGS)][-1]
    return text[:place] + "*NODE FILE\nU\n*EL FILE\nS\n" + text[place:]


def stiffer(text):
    """The deck with ten times the stiffness of its linear laws, and their tension."""

    def tenfold(found):
        numbers = [n for n in re.split(r"[,\s]+", found.group(2)) if n]
        return found.group(1) + ",".join(repr(10.0 * float(n)) for n in numbers) + "\n"

    return re.sub(r"(^\*SURFACE ?BEHAVIOR.*LINEAR.*\n)(.*\n)", tenfold, text, flags=FLAGS)


def run(command, folder, seconds):
    """Whether the program ended well in the time it is given, and what it said."""
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    try:
        done = subprocess.run(
            command, cwd=folder, env=environment, timeout=seconds, capture_output=True, text=True, errors="replace"
        )
    except subprocess.TimeoutExpired:
        return False, f"not done in {seconds} s"
    return done.returncode == 0, done.stdout + done.stderr


def results(folder):
    """Tables of a finished run, of `.dat` and `.frd`."""
    found = tables(str(folder / "job.dat"))
    if (folder / "job.frd").exists():
        found.update(blocks(str(folder / "job.frd")))
    return found


def off_in_sum(theirs, ours):
    """The largest difference of the sums of forces over the largest force of a node."""
    both = [key for key in theirs if key in ours]
    largest = max((abs(value) for key in both for value in theirs[key]), default=0.0)
    sums = [[sum(column) for column in zip(*(table[key] for key in both))] for table in (theirs, ours)]
    return max(abs(a - b) for a, b in zip(*sums)) / largest if largest > 0.0 else None


def differences(theirs, ours):
    found = {}
    for name, rows in theirs.items():
        compared = off_in_sum if name == "forces" else deviation
        found[name] = compared(rows, ours.get(name, {}))
    return {name: value for name, value in found.items() if value is not None}


def with_ccx(ccx, text, folder, seconds):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "job.inp").write_text(text)
    well, said = run([ccx, "job"], folder, seconds)
    return results(folder) if well and "*ERROR" not in said else {}


def compare(name, text, given, base):
    """What is said of a deck, and whether it was read, ran and agrees."""
    folder, text = base / name, asking(text)
    own = folder / "own"
    own.mkdir(parents=True, exist_ok=True)
    (own / "job.inp").write_text(text)
    program = [os.path.abspath(given.program)]
    options = ["--dialect", "calculix"]
    read, said = run(program + ["check", "job.inp"] + options, own, given.seconds)
    if not read:
        found = re.search(r"error\[?(.*)", said)
        return "not read: " + (found.group(0) if found else said.strip().splitlines()[-1])[:100], (0, 0, 0)
    ran, said = run(program + ["run", "job.inp", "--no-html", "--quiet"] + options, own, given.seconds)
    if not ran:
        found = re.search(r"error\[?(.*)", said)
        return "does not end: " + (found.group(0) if found else said[:80])[:100], (1, 0, 0)
    theirs = with_ccx(given.ccx, text, folder / "ccx", given.seconds)
    if not theirs:
        return "ccx does not end", (1, 1, 0)
    found = differences(theirs, results(own))
    if not found:
        return "nothing to compare", (1, 1, 0)
    words = ", ".join(f"{name} {100.0 * value:.2g} %" for name, value in found.items())
    if max(found.values()) <= AGREES:
        return words, (1, 1, 1)
    again = stiffer(text)
    moved = with_ccx(given.ccx, again, folder / "stiffer", given.seconds) if again != text else None
    if moved:
        by = differences(theirs, moved)
        words += "; K x 10: " + ", ".join(f"{name} {100.0 * value:.2g} %" for name, value in by.items())
    return words, (1, 1, 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--decks", help="folder of the decks; downloaded without")
    parser.add_argument("--ccx", default="ccx", help="the program to compare with")
    parser.add_argument("--program", default="target/release/slideline")
    parser.add_argument("--only", help="decks, separated by commas")
    parser.add_argument("--seconds", type=int, default=300, help="time that a run is given")
    parser.add_argument("--keep", type=Path, help="folder for decks and results")
    given = parser.parse_args()
    only = set(given.only.split(",")) if given.only else None
    with tempfile.TemporaryDirectory() as temporary:
        base = given.keep or Path(temporary)
        totals, count = [0, 0, 0], 0
        for name, text in decks(given.decks or fetch(temporary)):
            if only and name not in only:
                continue
            words, marks = compare(name, text, given, base)
            totals = [a + b for a, b in zip(totals, marks)]
            count += 1
            print(f"{name:20} {words}", flush=True)
        print(f"{count} static decks with contact: {totals[0]} read, {totals[1]} run, {totals[2]} agree within 1 %")


if __name__ == "__main__":
    main()
