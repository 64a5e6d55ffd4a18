"""The scripts for batch systems, run as those run them."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import slideline

CLUSTER = Path(__file__).resolve().parents[1]
PROGRAM = os.environ.get("SLIDELINE", "slideline")


def joined(folder):
    return np.genfromtxt(folder / "study.csv", delimiter=",", names=True, usecols=range(5))


def assert_same(folder, rows):
    found = joined(folder)
    assert list(found["case"]) == list(rows["case"])
    assert all(np.array_equal(found[name], rows[name]) for name in ("mu", "thickness", "force", "work"))


def slurm(study, folder, **variables):
    command = ["bash", str(CLUSTER / "slurm.sh"), str(study), str(folder)]
    environment = os.environ | {"SLIDELINE": PROGRAM} | variables
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)


def test_an_array_of_slurm_has_the_rows_of_one_machine(study, rows, folder):
    for task in ("7", "5", "6"):
        array = {"SLURM_ARRAY_TASK_ID": task, "SLURM_ARRAY_TASK_MIN": "5", "SLURM_ARRAY_TASK_COUNT": "3"}
        ended = slurm(study, folder, **array)
        assert ended.returncode == 0, ended.stderr
    subprocess.run([PROGRAM, "sweep", str(study), "--out", str(folder), "--csv", "--quiet"], check=True)
    assert_same(folder, rows)


def test_an_array_with_gaps_is_refused(study, folder):
    ended = slurm(study, folder, SLURM_ARRAY_TASK_ID="9", SLURM_ARRAY_TASK_MIN="0", SLURM_ARRAY_TASK_COUNT="4")
    assert ended.returncode == 64 and "gaps" in ended.stderr
    assert slurm(study, folder).returncode == 64


def test_hyperqueue_has_the_rows_of_one_machine(study, rows, folder):
    pytest.importorskip("hyperqueue")
    script = [sys.executable, str(CLUSTER / "hyperqueue_job.py"), str(study), str(folder)]
    options = ["--parts", "3", "--local", "2", "--program", PROGRAM]
    ended = subprocess.run(script + options, capture_output=True, text=True, check=False, timeout=300, cwd=folder)
    assert ended.returncode == 0, ended.stderr
    assert_same(folder, rows)


def test_dakota_asks_the_driver(study, tmp_path):
    pytest.importorskip("dakota")
    deck = study.parents[1] / "decks" / "push.inp"
    driven = tmp_path / "driven.toml"
    driven.write_text(f'deck = "{deck}"\nparameters.thickness = [1.5e-3]\nresponses.force = "peak(RF2@9999)"\n')
    (tmp_path / "dakota.in").write_text(
        "environment\n  tabular_data\n    tabular_data_file 'table'\n"
        "method\n  multidim_parameter_study\n    partitions = 2\n"
        "variables\n  continuous_design = 1\n    descriptors 'thickness'\n"
        "    lower_bounds 1.4e-3\n    upper_bounds 1.6e-3\n"
        f"interface\n  fork\n    analysis_drivers '{PROGRAM} dakota --study {driven}'\n"
        "responses\n  descriptors 'force'\n  objective_functions 1\n  no_gradients\n  no_hessians\n"
    )
    dakota = Path(sys.executable).with_name("dakota")
    ended = subprocess.run([dakota, "-i", "dakota.in"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    table = np.genfromtxt(tmp_path / "table", names=True, usecols=(2, 3))
    own = slideline.Evaluator(deck, ["thickness"], {"force": "peak(RF2@9999)"})
    assert len(table) == 3
    # Dakota writes ten digits
    np.testing.assert_allclose(own.evaluate(table["thickness"][:, None])[:, 0], table["force"], rtol=1e-9)
