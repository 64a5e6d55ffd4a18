"""Models from objects, and laws of friction that are functions."""

import math

import numpy as np
import pytest

import slideline


def cantilever(count=8):
    model = slideline.Model("cantilever")
    model.parameters(thickness=1.0e-3)
    model.nodes({k + 1: (k / count, 0.0) for k in range(count + 1)}, set="BEAM")
    model.elements("B21", {k + 1: (k + 1, k + 2) for k in range(count)}, set="BEAM")
    model.material("STEEL", elastic=(210e9, 0.0))
    model.beam_section("BEAM", "STEEL", (10e-3, "<thickness>"))
    model.step("PUSH", nlgeom=False).fix(1, 1, 6).move(count + 1, 2, -1e-3)
    return model


def test_a_cantilever_is_that_of_the_textbook():
    """Source: F = 3 E I w / L^3 of a slender beam; linear beams of this kind converge from below
    their number, so that few of them stay within a few percent."""
    force = cantilever(40).run(out=False).history(41, "RF2")[-1]
    exact = -3 * 210e9 * (10e-3 * 1e-9 / 12) * 1e-3
    assert force == pytest.approx(exact, rel=2e-3)


def test_the_deck_of_a_model_reads_back():
    model = cantilever()
    again = slideline.read_text(model.text(), "again").run(out=False)
    assert np.array_equal(again.history(9, "RF2"), model.run(out=False).history(9, "RF2"))
    thick = slideline.read_text(model.text(), parameters={"thickness": 2e-3}).run(out=False)
    assert thick.history(9, "RF2")[-1] == pytest.approx(8 * again.history(9, "RF2")[-1], rel=1e-3)


def test_errors_name_the_object():
    model = cantilever()
    model.beam_section("NOWHERE", "STEEL", (10e-3, 1e-3))
    with pytest.raises(slideline.InputError, match="section of NOWHERE: error"):
        model.run()
    model = cantilever()
    model.material("FOAM", elastic=(-1.0, 0.0))
    with pytest.raises(slideline.InputError, match="material FOAM: error"):
        model.job()
    model = cantilever()
    model.step("PULL").fix(999, 1)
    with pytest.raises(slideline.InputError, match="step PULL: error"):
        model.job()


BLOCK = """*HEADING
a block on a plane
*NODE
1, 0.0, 0.0
3, 0.0, 1.0
99, 0.0, -1.0
*RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS
START, -5.0, 0.0
LINE, 5.0, 0.0
*ELEMENT, TYPE=IRS21, ELSET=CONTACT
11, 1, 3, 99
*INTERFACE, ELSET=CONTACT
1.0
*FRICTION, USER=SLIP, PROPERTIES=2, DEPVAR=1
0.3, 1.0E-3
*STEP, NLGEOM
*STATIC
1.0, 1.0
*BOUNDARY
1, 1
1, 6
3, 1, 6
99, 1, 6
*CLOAD
1, 2, -10.0
*END STEP
*STEP, NLGEOM
*STATIC
0.1, 1.0, 1.0E-6, 0.1
*BOUNDARY
1, 1, 1, 0.5
*END STEP
"""


def coulomb(*, pressure, slip, elastic_slip, state, properties, time, dt):
    """Coulomb's law with elastic slip, and the distance slid as its state."""
    mu, critical = properties
    trial = elastic_slip + slip
    size = np.linalg.norm(trial, axis=1)
    slips = size > critical
    way = np.divide(trial, size[:, None], where=size[:, None] > 0.0, out=np.zeros_like(trial))
    part = np.where(slips, 1.0, size / critical)
    stiffness = mu * pressure / critical
    eye = np.eye(2)[None]
    along = way[:, :, None] * way[:, None, :]
    turning = (mu * pressure / np.maximum(size, critical))[:, None, None] * (eye - along)
    dissipated = np.where(slips, size - critical, 0.0)
    return {
        "traction": (mu * pressure * part)[:, None] * way,
        "d_traction_d_slip": np.where(slips[:, None, None], turning, stiffness[:, None, None] * eye),
        "d_traction_d_pressure": (mu * part)[:, None] * way,
        "elastic_slip": np.where(slips[:, None], critical * way, trial),
        "dissipated_slip": dissipated,
        "slips": slips,
        "state": state + dissipated[:, None],
    }


def test_a_law_of_friction_is_a_function():
    """Source: a block under N = 10 with mu = 0.3 is pulled by 3."""
    result = slideline.read_text(BLOCK).run(out=False, friction={"slip": coulomb})
    assert result.history(1, "RF1")[-1] == pytest.approx(3.0, rel=1e-9)
    assert "slip" in result.table("contact")["status"]


def test_a_law_that_is_missing_or_wrong_is_told():
    job = slideline.read_text(BLOCK)
    with pytest.raises(slideline.InputError, match="SL0326"):
        job.run(out=False)
    with pytest.raises(slideline.InputError, match="SL0326"):
        job.run()
    with pytest.raises(TypeError, match="no function"):
        job.run(out=False, friction={"slip": 0.3})
    with pytest.raises(KeyError, match="typo"):
        job.run(out=False, friction={"slip": lambda **asked: asked["typo"]})
    with pytest.raises(ValueError, match="no `traction`"):
        job.run(out=False, friction={"slip": lambda **asked: {}})


def test_a_law_without_an_answer_cuts_the_increment_back():
    """Requirement: ArithmeticError asks for a smaller increment."""

    def shy(*, slip, **asked):
        if math.hypot(*slip[0]) > 0.03:
            raise ArithmeticError("too far")
        return coulomb(slip=slip, **asked)

    result = slideline.read_text(BLOCK).run(out=False, friction={"SLIP": shy})
    assert result.cutbacks > 0 and result.history(1, "RF1")[-1] == pytest.approx(3.0, rel=1e-9)
