"""Decks that several tests run."""

from pathlib import Path

import pytest

import slideline

ROOT = Path(__file__).resolve().parents[3]
CORPUS = ROOT / "corpus"
PAPER = CORPUS / "diehl1995" / "isl_coarse_mu03.inp"
#: the paper's deck with names in place of its coefficient of friction and its thickness
NAMED = "*PARAMETER\nmu = 0.3\nthickness = 1.5E-3\n"


@pytest.fixture(scope="session")
def paper():
    """The paper's first problem, run once."""
    return slideline.read(PAPER).run()


@pytest.fixture(scope="session")
def named(tmp_path_factory):
    """The same with parameters, as a file."""
    text = PAPER.read_text()
    text = text.replace("*NODE, NSET=BEAM\n", NAMED + "*NODE, NSET=BEAM\n", 1)
    text = text.replace("*FRICTION\n0.3\n", "*FRICTION\n<mu>\n")
    text = text.replace("25.0E-3,1.5E-3", "25.0E-3,<thickness>", 1)
    path = tmp_path_factory.mktemp("named") / "named.inp"
    path.write_text(text)
    return path
