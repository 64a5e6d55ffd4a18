"""Studies and evaluations at points that others choose."""

import numpy as np
import pytest

import slideline

RESPONSES = {"force": "peak(RF2@9999)", "work": "work(RF2@9999, U2@9999)"}


def study(named, **more):
    values = {"mu": [0.1, 0.2, 0.3], "thickness": [1.4e-3, 1.5e-3]}
    return {"deck": str(named), "parameters": values, "responses": RESPONSES} | more


def test_a_sweep_has_the_rows_of_single_runs(named):
    table = slideline.sweep(study(named), threads=2)
    assert table.columns == ["case", "mu", "thickness", "force", "work", "code"]
    assert len(table) == 6 and table["code"] == [None] * 6
    for k in (0, 5):
        values = {name: table[name][k] for name in ("mu", "thickness")}
        force = slideline.read(named, parameters=values).run(out=False).history(9999, "RF2")
        assert table["force"][k] == np.abs(force).max()


def test_a_folder_keeps_what_was_done(named, tmp_path):
    heard = []
    first = slideline.sweep(study(named), out=tmp_path / "study", progress=lambda *said: heard.append(said))
    again = slideline.sweep(study(named), out=tmp_path / "study")
    plain = slideline.sweep(study(named), threads=1)
    for name in plain.columns[:-1]:
        assert np.array_equal(first[name], plain[name]) and np.array_equal(again[name], plain[name])
    assert (tmp_path / "study" / "study.json").exists() and heard
    with pytest.raises(slideline.InputError, match="SL0807"):
        slideline.sweep(study(named, responses={"force": "last(RF2@9999)"}), out=tmp_path / "study")


def test_a_file_is_a_study_too(named):
    path = named.parent / "study.toml"
    path.write_text(
        'deck = "named.inp"\ndesign = "sobol"\ncases = 4\n[parameters]\nmu = { from = 0.1, to = 0.3 }\n'
        '[responses]\nforce = "peak(RF2@9999)"\n'
    )
    written = {
        "deck": "named.inp", "design": "sobol", "cases": 4,
        "parameters": {"mu": {"from": 0.1, "to": 0.3}}, "responses": {"force": "peak(RF2@9999)"},
    }
    one, other = slideline.sweep(path), slideline.sweep(written, folder=named.parent)
    assert np.array_equal(one["force"], other["force"]) and len(one) == 4


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"parameters": {"nu": [0.1]}}, "SL0801"),
        ({"parameters": {"mu": []}}, "SL0803"),
        ({"responses": {"force": "peak(RF2@77777)"}}, "SL0805"),
        ({"responses": {"force": "peek(RF2@9999)"}}, "SL0804"),
        ({"design": "hexagonal"}, "SL0806"),
    ],
)
def test_what_is_wrong_is_said_before_anything_runs(named, change, code):
    with pytest.raises(slideline.InputError, match=code):
        slideline.sweep(study(named) | change)


def test_an_evaluator_has_the_bits_of_a_sweep(named):
    table = slideline.sweep(study(named))
    evaluator = slideline.Evaluator(named, ["mu", "thickness"], RESPONSES)
    points = np.column_stack([table["mu"], table["thickness"]])
    for threads in (1, 2, 3):
        evaluator.threads = threads
        found = evaluator.evaluate(points)
        assert np.array_equal(found, np.column_stack([table["force"], table["work"]]))
    assert np.array_equal(evaluator(points[3]), found[3])
    assert evaluator.evaluate(np.empty((0, 2))).shape == (0, 2)


def test_a_jacobian_is_that_of_differences(named):
    evaluator = slideline.Evaluator(named, ["mu", "thickness"], RESPONSES | {"strain": "fibre_strain"})
    point = np.array([0.2, 1.5e-3])
    values, exact = evaluator.evaluate_with_jacobian(point)
    assert np.array_equal(values, evaluator.evaluate(point)) and exact.shape == (len(values), 2)
    steps = np.diag(1e-4 * point)
    found = evaluator.evaluate(np.vstack([point + steps, point - steps]))
    slopes = (found[:2] - found[2:]).T / (2e-4 * point)
    assert np.allclose(exact, slopes, rtol=1e-4, atol=1e-4 * np.abs(values)[:, None] / point)
    assert evaluator.jacobian([point, point]).shape == (2, len(values), 2)


def test_an_evaluator_tells_failures_and_wrong_input(named):
    evaluator = slideline.Evaluator(named, ["thickness"], {"force": "peak(RF2@9999)"})
    points = [[1.5e-3], [-1.0]]
    found = evaluator.evaluate(points)
    assert np.isfinite(found[0, 0]) and np.isnan(found[1, 0])
    [none, code] = evaluator.failures(points)
    assert none is None and code.startswith("SL")
    with pytest.raises(ValueError, match="X is"):
        evaluator.evaluate([[1.0, 2.0]])
    with pytest.raises(ValueError, match="finite"):
        evaluator.evaluate([[np.nan]])
    with pytest.raises(slideline.InputError, match="SL0801"):
        slideline.Evaluator(named, ["nu"], {"force": "peak(RF2@9999)"})
    with pytest.raises(slideline.InputError, match="SL0805"):
        slideline.Evaluator(named, ["mu"], {"force": "peak(RF2@77777)"})
