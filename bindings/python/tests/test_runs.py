"""Decks are read, checked and run; what comes back is what the files say."""

import csv
import gc
import os
import signal
import threading
import time

import numpy as np
import pytest

import slideline
from conftest import CORPUS, PAPER


def rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def test_tables_are_the_files(tmp_path):
    """Requirement: tables have the columns and the numbers of the CSV files, to the bit."""
    result = slideline.read(PAPER).run(out=tmp_path)
    for name in ["history", "contact", "energy"]:
        written = rows(tmp_path / f"isl_coarse_mu03.{name}.csv")
        table = result.table(name)
        assert table.columns == list(written[0]), name
        assert len(table) == len(written) > 10, name
        for column in table.columns:
            values = table[column]
            if isinstance(values, list):
                assert values == [row[column] for row in written], (name, column)
            else:
                assert np.array_equal(values, [float(row[column]) for row in written], equal_nan=True)


def test_a_run_without_files_has_the_same_bits(paper, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    bare = slideline.read(PAPER).run(out=False, threads=2)
    assert not list(tmp_path.iterdir())
    assert np.array_equal(bare.history(9999, "RF2"), paper.history(9999, "RF2"))
    assert bare.verdict is None and paper.verdict[0] in ("green", "yellow", "red")
    with pytest.raises(RuntimeError, match="out=False"):
        bare.report()


def test_arrays_are_not_copied_and_cannot_be_written(paper):
    force = paper.history(9999, "RF2")
    assert np.shares_memory(force, paper.history(9999, "rf2"))
    assert np.shares_memory(paper.frames[-1].displacement, paper.frames[0].displacement.base)
    for array in [force, paper.time, paper.frames[-1].displacement, paper.table("contact")["CPRESS"]]:
        with pytest.raises(ValueError):
            array[...] = 0.0
    kept = slideline.read(PAPER).run(out=False).history(9999, "RF2")
    gc.collect()  # the result is gone, the array stays
    assert np.array_equal(kept, force)


def test_fields_agree_with_histories(paper):
    """Requirement: frame k, node n is entry k of the history of n."""
    at = int(np.flatnonzero(paper.labels == 9999)[0])
    assert len(paper.frames) == len(paper.time) == paper.increments + 1
    for k, frame in enumerate(paper.frames):
        assert frame.displacement.shape == (len(paper.labels), 2)
        assert frame.displacement[at, 1] == paper.history(9999, "U2")[k]
        assert frame.reaction[at, 1] == paper.history(9999, "RF2")[k]
        assert frame.moment[at, 0] == paper.history(9999, "RM3")[k]
        assert frame.time == paper.time[k]
    assert paper.frames[0].increment == 0 and not paper.frames[0].displacement.any()
    # a node without a history of its own is taken from the fields
    assert 25 not in paper.history_nodes
    tip = int(np.flatnonzero(paper.labels == 25)[0])
    assert np.array_equal(paper.history(25, "U1"), [f.displacement[tip, 0] for f in paper.frames])
    last = slideline.read(PAPER).run(out=False, frames="last")
    assert len(last.frames) == 1
    assert np.array_equal(last.frames[-1].displacement, paper.frames[-1].displacement)
    with pytest.raises(KeyError, match="frames='all'"):
        last.history(25, "U1")


def test_stress_of_a_patch():
    """Source: u = A x in a single element with nu = 0 gives E times the strain everywhere."""
    model = slideline.Model("patch")
    model.nodes({1: (0, 0), 2: (2, 0), 3: (2, 3), 4: (0, 3)})
    model.elements("CPS4", {7: (1, 2, 3, 4)}, set="ALL")
    model.material("M", elastic=(1000.0, 0.0)).solid_section("ALL", "M", 1.0)
    step = model.step("PULL", nlgeom=False)
    for node, (x, y) in {1: (0, 0), 2: (2, 0), 3: (2, 3), 4: (0, 3)}.items():
        step.move(node, 1, 0.01 * x).move(node, 2, -0.02 * y)
    [field] = model.run(out=False).frames[-1].stress
    assert field.labels.tolist() == [7] and field.location == "points" and field.unit == "[F/L2]"
    exact = np.zeros(len(field.components))
    exact[[field.components.index("S11"), field.components.index("S22")]] = 10.0, -20.0
    assert np.abs(field.values - exact).max() < 1e-9


def test_errors_are_objects_with_their_lines():
    job = slideline.read_text("*HEADING\nx\n*NODE\n1, zero, 0.0\n", "wrong")
    assert not job.is_sound
    with pytest.raises(slideline.InputError, match="wrong.inp:4") as raised:
        job.run()
    said = raised.value.diagnoses[0]
    assert (said.severity, said.line, said.card) == ("error", 4, "*NODE")
    assert said.file == "wrong.inp" and said.columns[0] == 1 < said.columns[1]
    assert said.explain().startswith(f"# {said.code}")
    assert slideline.explain("FRICTION").startswith("#") and slideline.explain("NO SUCH") is None


def test_a_missing_deck_is_an_error_of_the_input(tmp_path):
    job = slideline.read(tmp_path / "none.inp")
    with pytest.raises(slideline.InputError, match="SL0701"):
        job.run()
    assert not list(tmp_path.iterdir())


def test_what_converged_is_kept():
    with pytest.raises(slideline.NotConverged, match="SL05") as raised:
        slideline.read(CORPUS / "bad" / "SL0511-toggle.inp").run()
    result = raised.value.result
    assert result.status == "not_converged" and result.increments == len(result.time) - 1 > 0
    assert any(said.code.startswith("SL05") for said in raised.value.diagnoses)


def test_check_gives_advice_and_gaps():
    job = slideline.read(CORPUS / "tutorial" / "snap_fit.inp")
    assert all(said.severity != "error" for said in job.check())
    gaps = job.initial_gaps()
    assert len(gaps) > 0 and np.nanmin(gaps["COPEN"]) > 0.0


def test_parameters_are_those_of_the_deck(named, paper):
    same = slideline.read(named, parameters={"mu": np.float64(0.3)}).run(out=False)
    assert np.array_equal(same.history(9999, "RF2"), paper.history(9999, "RF2"))
    other = slideline.read(named, parameters={"mu": 0.1}).run(out=False)
    assert abs(other.history(9999, "RF2")[-1]) < abs(same.history(9999, "RF2")[-1]) * 0.999
    with pytest.raises(slideline.InputError, match="SL0801"):
        slideline.read(named, parameters={"nu": 0.1}).run()
    with pytest.raises(ValueError, match="dialect is one of"):
        slideline.read(named, dialect="nastran")


def test_progress_is_told_and_may_end_the_run(capsys):
    heard = []
    result = slideline.read(PAPER).run(lambda *said: heard.append(said), out=False)
    assert [said[2] for said in heard] == result.time[1:].tolist()
    slideline.read(PAPER).run(True, out=False)
    assert len(capsys.readouterr().out.splitlines()) == result.increments

    def enough(step, increment, time, iterations):
        if increment == 3:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        slideline.read(PAPER).run(enough, out=False)


def test_control_c_ends_the_increment(tmp_path):
    """Requirement: what converged is kept, in the result and in the files."""
    # where the tests run behind a shell that goes on, Python finds the signal ignored
    signal.signal(signal.SIGINT, signal.default_int_handler)

    def interrupt(step, increment, time_, iterations):
        if increment == 2:
            os.kill(os.getpid(), signal.SIGINT)
        time.sleep(0.03)

    with pytest.raises(slideline.Interrupted) as raised:
        slideline.read(PAPER).run(interrupt, out=tmp_path)
    result = raised.value.result
    assert 2 <= result.increments < 20 and result.status == "interrupted"
    assert len(rows(tmp_path / "isl_coarse_mu03.energy.csv")) == result.increments
    assert isinstance(raised.value, KeyboardInterrupt)


def test_other_threads_go_on_during_a_run():
    """Requirement: the interpreter is let go while solving. Source: a thread that counts does so
    during the run; where the lock is held it could not count at all."""
    counts, over = [0], threading.Event()

    def count():
        while not over.is_set():
            counts[0] += 1
            time.sleep(0)

    counter = threading.Thread(target=count)
    counter.start()
    model = slideline.Model("long")  # so long that the system lets both threads run
    model.nodes({k + 1: (0.1 * k, 0.0) for k in range(4001)}, set="BEAM")
    model.elements("B21", {k: (k, k + 1) for k in range(1, 4001)}, set="BEAM")
    model.material("STEEL", elastic=(210e9, 0.3)).beam_section("BEAM", "STEEL", (1.0, 1.0))
    model.step("PUSH", increment=0.02, direct=True).fix(1, 1, 6).move(4001, 2, 1.0)
    job = model.job()
    before = counts[0]
    job._deck.run(None, 1, False, None, {})
    during = counts[0] - before
    over.set()
    counter.join()
    assert during > 10


def test_report_and_plot(paper):
    page = paper._repr_html_()
    assert page.startswith("<iframe srcdoc=") and "isl_coarse_mu03" in page
    assert paper.report().name == "isl_coarse_mu03.html"
    bare = slideline.read(PAPER).run(out=False)._repr_html_()
    assert "9999.RF2" in bare
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("svg")
    [curve] = paper.plot().get_lines()
    assert np.array_equal(curve.get_ydata(), paper.history(9999, "RF2"))
    assert np.array_equal(curve.get_xdata(), paper.history(9999, "U2"))


def test_tables_are_arrow_streams(paper):
    pyarrow = pytest.importorskip("pyarrow")
    table = paper.table("contact")
    arrow = pyarrow.table(table)
    assert arrow.column_names == table.columns and arrow.num_rows == len(table)
    assert arrow["CPRESS"].to_pylist() == table["CPRESS"].tolist()
    assert arrow["status"].to_pylist() == table["status"]
    assert pyarrow.schema(table).names == table.columns
    pandas = pytest.importorskip("pandas")
    frame = table.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and frame["node"].tolist() == table["node"].tolist()


def test_polars(paper):
    pytest.importorskip("polars")
    assert paper.table("energy").to_polars().columns == paper.table("energy").columns


def test_peaks(paper):
    force = paper.history(9999, "RF2")
    low = paper.peaks["9999.RF2"]["min"]
    assert low == (force.min(), paper.time[force.argmin()])
