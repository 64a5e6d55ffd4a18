"""Runs CalculiX' own test decks and compares with the results that come with them.

    python3 benches/calculix/published.py                fetches the decks, runs them, prints a table
    python3 benches/calculix/published.py --decks DIR    the same with decks that are there already
    python3 benches/calculix/published.py --program P    another slideline than target/release

The decks are Debian's package calculix-ccx-test: they are downloaded, not copied
into the project.  Looked at are static decks without shells that slideline reads
under `--dialect calculix`.  Compared are the last tables that are published, with ours of the same time: displacements, forces
and stresses at integration points (`.dat`), or displacements and nodal stresses
(`.frd`): the largest deviation over the largest value of a table.  A deck within
0.5 % agrees.
"""

import argparse
import glob
import gzip
import os
import re
import subprocess
import tempfile

AGREES = 5e-3
OTHERS = (
    "HEAT|COUPLED|DYNAMIC|FREQ|BUCKLE|MODAL|STEADY|COMPLEX|UNCOUPLED|ELECTRO|SHELL SECTION|GREEN|SENSI"
)


def opened(path):
    return (gzip.open if path.endswith(".gz") else open)(path, "rt", errors="replace")


def number(text):
    """A number, also where three digits of an exponent leave no room for its E."""
    try:
        return float(text)
    except ValueError:
        return float(re.sub(r"(\d)([+-]\d+)$", r"\1E\2", text))


def tables(path, times=None):
    """The last tables of a `.dat`, CalculiX' or ours: rows by node, or by element and point.

    `times` gets the total time of each by name, where it is given empty; where it holds times,
    tables of later ones are passed over.
    """
    found, name, times = {}, None, {} if times is None else times
    until = dict(times)
    for line in opened(path) if os.path.exists(path) else []:
        heading = re.match(r"\s*(displacements|forces|stresses)\s*\(.*?time\s*(\S+)?", line)
        if heading:
            name, time = heading.group(1), number(heading.group(2) or "0")
            if later(time, until.get(name)):
                name = None
                continue
            found[name], times[name] = {}, time
        elif name and re.match(r"\s*\d+\s", line):
            # ccx marks rows along axes of a material with a word behind the numbers
            words = [word for word in line.split() if not word.isalpha()]
            keys = 2 if name == "stresses" else 1
            found[name][tuple(map(int, words[:keys]))] = [number(w) for w in words[keys:]]
        elif line.strip():
            name = None
    return found


def later(time, until):
    """Whether a table stands behind the last one that is compared."""
    return until is not None and time > until + 1e-4 * abs(until)


def blocks(path, times=None):
    """The last displacements and stresses of a `.frd`; `times` as of `tables`."""
    found, name, rows, time, times = {}, None, {}, 0.0, {} if times is None else times
    until = dict(times)
    for line in opened(path):
        if line.startswith("  100C"):
            time = number(line[12:24])
        elif line.startswith(" -4"):
            name, rows = line.split()[1], {}
            name = None if later(time, until.get(name)) else name
        elif line.startswith(" -1") and name in ("DISP", "STRESS"):
            text = line[13:].rstrip("\n")
            fields = [text[k : k + 12].strip() for k in range(0, len(text), 12)]
            rows[(int(line[3:13]),)] = [number(field) for field in fields if field]
        elif line.startswith(" -3") and name in ("DISP", "STRESS"):
            found[name], times[name] = rows, time
            name = None
    return found


def deviation(theirs, ours):
    """Largest difference over the largest value; None where nothing can be compared."""
    rows = [(row, ours[key]) for key, row in theirs.items() if key in ours]
    largest = max((abs(value) for row, _ in rows for value in row), default=0.0)
    if largest == 0.0:
        return None
    return max(abs(a - b) for row, own in rows for a, b in zip(row, own)) / largest


def fetch(folder):
    """Downloads and unpacks the decks; gives their folder."""
    subprocess.run(["apt-get", "download", "calculix-ccx-test"], cwd=folder, check=True)
    package = glob.glob(os.path.join(folder, "calculix-ccx-test*.deb"))[0]
    subprocess.run(["dpkg", "-x", package, folder], check=True)
    decks = os.path.join(folder, "usr/share/doc/calculix-ccx-test/examples/test")
    subprocess.run(["gunzip", *glob.glob(os.path.join(decks, "*.inp.gz"))], check=True)  # the larger ones
    return decks


def reference(stem):
    """The results that come with a deck."""
    for ending in (".dat.ref", ".frd.ref"):
        for path in (stem + ending, stem + ending + ".gz"):
            if os.path.exists(path):
                yield ending, path


def compare(deck, program, folder):
    """Deviations of a deck by table; None where it is not read."""
    options = ["--dialect", "calculix"]
    check = subprocess.run([program, "check", deck, *options], capture_output=True, timeout=60)
    if check.returncode != 0:
        return None
    run = [program, "run", deck, *options, "--out", folder, "--no-html"]
    if subprocess.run(run, capture_output=True, timeout=600).returncode != 0:
        return {"run": float("inf")}
    own, found = os.path.join(folder, os.path.basename(deck)[:-4]), {}
    for ending, path in reference(deck[:-4]):
        read, times = (tables, {}) if ending == ".dat.ref" else (blocks, {})
        theirs = read(path, times)
        ours = read(own + ending[:-4], times)
        for name, rows in theirs.items():
            found[name] = deviation(rows, ours.get(name, {}))
    return {name: value for name, value in found.items() if value is not None}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--decks", help="folder of the decks; downloaded without")
    parser.add_argument("--program", default="target/release/slideline")
    given = parser.parse_args()
    program = os.path.abspath(given.program)
    with tempfile.TemporaryDirectory() as folder:
        decks = given.decks or fetch(folder)
        looked_at = read = agree = judged = 0
        for deck in sorted(glob.glob(os.path.join(decks, "*.inp"))):
            text = open(deck, errors="replace").read()
            flags = re.MULTILINE | re.IGNORECASE
            if not re.search(r"^\*STATIC", text, flags) or re.search(rf"^\*({OTHERS})", text, flags):
                continue
            looked_at += 1
            found = compare(os.path.abspath(deck), program, os.path.join(folder, "out"))
            if found is None:
                continue
            read += 1
            judged += bool(found)
            agree += bool(found) and max(found.values()) <= AGREES
            words = [f"{name} {value:.1e}" for name, value in found.items()]
            print(f"{os.path.basename(deck)[:-4]:16} {', '.join(words) or 'nothing to compare'}")
        print(f"{looked_at} static decks, {read} read, {judged} compared, {agree} within 0.5 %")


if __name__ == "__main__":
    main()
