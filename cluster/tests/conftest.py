"""A study that tests run, and its rows from one machine."""

import json
from pathlib import Path

import pytest

import slideline

CORPUS = Path(__file__).resolve().parents[2] / "corpus"
STUDY = """deck = "../decks/push.inp"
design = "sobol"
cases = {cases}
seed = 3
[parameters]
mu = {{ from = 0.2, to = 0.4 }}
thickness = {{ from = 1.45e-3, to = 1.55e-3 }}
[responses]
force = "peak(RF2@9999)"
work = "work(RF2@9999, U2@9999)"
"""


def written(folder, cases):
    """A study whose deck stands in another folder and includes a file."""
    (folder / "decks").mkdir()
    (folder / "studies").mkdir()
    deck = (CORPUS / "study" / "push.inp").read_text()
    head, mesh = deck.split("*NODE", 1)
    (folder / "decks" / "rest.inp").write_text("*NODE" + mesh)
    (folder / "decks" / "push.inp").write_text(head + "*INCLUDE, INPUT=rest.inp\n")
    study = folder / "studies" / "study.toml"
    study.write_text(STUDY.format(cases=cases))
    return study


@pytest.fixture(scope="session")
def study(tmp_path_factory):
    return written(tmp_path_factory.mktemp("study"), 400)


@pytest.fixture(scope="session")
def rows(study):
    return slideline.sweep(study, threads=2)


@pytest.fixture
def folder(study, tmp_path):
    """A folder of the study whose shards are small: a time of seconds is not for tests."""
    out = tmp_path / "out"
    slideline.sweep(study, out=out, part=(2**62, 2**63))
    layout = out / "study.json"
    told = json.loads(layout.read_text())
    told["cases_a_shard"] = 40
    layout.write_text(json.dumps(told, indent=2))
    return out
