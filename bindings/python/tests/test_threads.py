"""Several threads of Python at once, with and without the lock of the interpreter."""

import sys
import sysconfig
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import slideline
from conftest import PAPER
from test_models import BLOCK, coulomb

COEFFICIENTS = [0.0, 0.1, 0.2, 0.3]


def force(named, mu):
    """Force over time, from a deck that this thread reads itself."""
    return slideline.read(named, parameters={"mu": mu}).run(out=False, threads=1).history(9999, "RF2")


def test_the_lock_stays_off_where_python_has_none():
    """Requirement: importing the package does not bring back the lock of a free-threaded Python."""
    if sysconfig.get_config_var("Py_GIL_DISABLED"):
        assert not sys._is_gil_enabled()


def test_runs_side_by_side_have_the_bits_of_single_runs(named):
    alone = [force(named, mu) for mu in COEFFICIENTS]
    assert len({curve.tobytes() for curve in alone}) == len(COEFFICIENTS)
    with ThreadPoolExecutor(len(COEFFICIENTS)) as threads:
        together = list(threads.map(lambda mu: force(named, mu), COEFFICIENTS * 2))
    for curve, expected in zip(together, alone * 2):
        assert np.array_equal(curve, expected)


def test_threads_share_a_deck_and_a_result(named):
    """Requirement: objects may be used by several threads at once."""
    job = slideline.read(PAPER)
    with ThreadPoolExecutor(4) as threads:
        results = list(threads.map(lambda _: job.run(out=False, threads=1), range(8)))
        expected = results[0].history(9999, "RF2").copy()
        assert all(np.array_equal(own.history(9999, "RF2"), expected) for own in results)
        shared = results[0]
        curves = list(threads.map(lambda _: shared.table("contact")["CPRESS"].sum(), range(32)))
    assert len(set(curves)) == 1


def test_laws_in_python_are_called_by_several_runs():
    job = slideline.read_text(BLOCK)
    with ThreadPoolExecutor(4) as threads:
        results = list(threads.map(lambda _: job.run(out=False, friction={"slip": coulomb}), range(8)))
    pulled = {result.history(1, "RF1")[-1] for result in results}
    assert len(pulled) == 1 and pulled.pop() == pytest.approx(3.0, rel=1e-9)
