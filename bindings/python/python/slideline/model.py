"""A model from Python objects: they become the cards of a deck, which is read like any other.

What a card means, its options and its data lines are those of the deck (docs/keywords). Every
object remembers its lines, so that what stands against them names the object.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from . import _core
from .errors import InputError
from .job import Job, read_text
from .result import Result

Number = float | int | str
#: Entries of a data line are cut into so many: longer ones go on in the next line.
ENTRIES = 8


@dataclass(frozen=True)
class Card:
    """A card with the name of the object that wrote it."""

    owner: str
    text: str


def _entry(value: Any) -> str:
    """A cell of a data line; numbers read back to the same bits, None is an empty cell."""
    if value is None:
        return ""
    if hasattr(value, "item"):
        value = value.item()
    return value if isinstance(value, str) else repr(value)


def _rows(data: Iterable[Any]) -> list[str]:
    rows = []
    for row in data:
        cells = [row] if isinstance(row, str) or not isinstance(row, Iterable) else list(row)
        rows.append(", ".join(_entry(cell) for cell in cells))
    return rows


def _card(owner: str, keyword: str, data: Iterable[Any], options: Mapping[str, Any]) -> Card:
    """``option=True`` is a word without value, ``None`` and ``False`` are left out."""
    words = [f"*{keyword.upper()}"]
    for name, value in options.items():
        name = name.replace("_", " ").upper()
        if value is True:
            words.append(name)
        elif value not in (None, False):
            words.append(f"{name}={_entry(value)}")
    return Card(owner, "\n".join([", ".join(words), *_rows(data)]) + "\n")


class Step:
    """A step of a model: what is driven and loaded in it."""

    def __init__(self, name: str, first: list[Card]) -> None:
        self.name, self._cards = name, first

    def card(self, keyword: str, data: Iterable[Any] = (), **options: Any) -> Step:
        """Any card of a step, as the deck has it."""
        self._cards.append(_card(f"step {self.name}", keyword, data, options))
        return self

    def fix(self, node: int | str, first: int, last: int | None = None) -> Step:
        """Holds dofs ``first`` to ``last`` (1 to 3: U1 to U3, 4 to 6: UR1 to UR3) of a node or a
        set."""
        return self.card("BOUNDARY", [(node, first, first if last is None else last)])

    def move(self, node: int | str, dof: int, value: Number, amplitude: str | None = None) -> Step:
        """Drives a dof to a value [L or 1] at the end of the step."""
        return self.card("BOUNDARY", [(node, dof, dof, value)], amplitude=amplitude)

    def load(self, node: int | str, dof: int, value: Number, amplitude: str | None = None) -> Step:
        """A force [F] or moment [F L] at a node or at each node of a set."""
        return self.card("CLOAD", [(node, dof, value)], amplitude=amplitude)


class Model:
    """A model that is built from Python.

    ::

        model = slideline.Model("cantilever")
        model.nodes({1: (0.0, 0.0), 2: (1.0, 0.0)}, set="BEAM")
        model.elements("B21", {1: (1, 2)}, set="BEAM")
        model.material("STEEL", elastic=(210e9, 0.3))
        model.beam_section("BEAM", "STEEL", (10e-3, 1e-3))
        model.step("PUSH", increment=0.1).fix(1, 1, 6).move(2, 2, -0.01)
        result = model.run()
    """

    def __init__(self, name: str = "model", heading: str = "") -> None:
        self.name = name
        self._cards: list[Card] = [_card("heading", "HEADING", [heading or name], {})]
        self._steps: list[Step] = []

    def card(self, keyword: str, data: Iterable[Any] = (), *, owner: str | None = None, **options: Any) -> Model:
        """Any card before the first step: ``model.card("MPC", [("BEAM", "CAM", 100)])``. Options are
        keyword arguments, ``True`` for words without value. ``owner`` is what errors call it."""
        if owner is None:
            named = options.get("name", options.get("elset", options.get("nset")))
            owner = keyword.lower() + (f" {named}" if named else "")
        self._cards.append(_card(owner, keyword, data, options))
        return self

    def parameters(self, **values: Number) -> Model:
        """Names for numbers: ``"<mu>"`` in other objects stands for the value of ``mu``, and
        ``Evaluator`` and ``read_text(..., parameters=)`` set it. Texts are expressions."""
        rows = [f"{name} = {_entry(value)}" for name, value in values.items()]
        return self.card("PARAMETER", rows, owner="parameters")

    def nodes(self, positions: Mapping[int, Sequence[Number]], set: str | None = None) -> Model:
        """Nodes by their labels, two or three coordinates [L] each."""
        rows = [(label, *place) for label, place in positions.items()]
        return self.card("NODE", rows, owner=f"nodes {set}" if set else "nodes", nset=set)

    def elements(self, type: str, nodes: Mapping[int, Sequence[int]], set: str) -> Model:
        """Elements of a type by their labels, with the labels of their nodes."""
        rows = []
        for label, own in nodes.items():
            cells = [label, *own]
            cut = [cells[k : k + ENTRIES] for k in range(0, len(cells), ENTRIES)]
            # a line that ends in a comma goes on in the next one
            rows += [[*part, None] for part in cut[:-1]] + [cut[-1]]
        return self.card("ELEMENT", rows, owner=f"elements {set}", type=type, elset=set)

    def node_set(self, name: str, members: Iterable[int | str]) -> Model:
        """Nodes, or sets of them, under a name."""
        return self.card("NSET", [[own] for own in members], owner=f"node set {name}", nset=name)

    def element_set(self, name: str, members: Iterable[int | str]) -> Model:
        """Elements, or sets of them, under a name."""
        return self.card("ELSET", [[own] for own in members], owner=f"element set {name}", elset=name)

    def material(self, name: str, elastic: Sequence[Number] = (), **laws: Iterable[Any]) -> Model:
        """A material: ``elastic=(E [F/L2], nu [1])``; any other law by its keyword, with its data
        lines: ``plastic=[(250e6, 0.0)]``."""
        owner = f"material {name}"
        self.card("MATERIAL", owner=owner, name=name)
        if elastic:
            self.card("ELASTIC", [elastic], owner=owner)
        for law, rows in laws.items():
            self.card(law.replace("_", " "), rows, owner=owner)
        return self

    def beam_section(
        self, set: str, material: str, dimensions: Sequence[Number], shape: str = "RECT", **options: Any
    ) -> Model:
        """The section of beams: of ``RECT`` width and height [L]."""
        owner = f"section of {set}"
        given = {"section": shape, "elset": set, "material": material, **options}
        return self.card("BEAM SECTION", [dimensions], owner=owner, **given)

    def solid_section(self, set: str, material: str, thickness: Number | None = None) -> Model:
        """The section of solids: thickness [L] in the plane."""
        rows = [] if thickness is None else [[thickness]]
        owner = f"section of {set}"
        return self.card("SOLID SECTION", rows, owner=owner, elset=set, material=material)

    def surface(self, name: str, members: Iterable[Any], type: str = "ELEMENT") -> Model:
        """A surface: of ``ELEMENT`` rows of a set and a face, of ``NODE`` sets of nodes."""
        return self.card("SURFACE", members, owner=f"surface {name}", name=name, type=type)

    def rigid_surface(self, name: str, reference: int, segments: Iterable[Sequence[Any]]) -> Model:
        """A rigid profile that moves with a node: ``("START", x, y)``, ``("LINE", x, y)``,
        ``("CIRCL", x, y, x of the centre, y of it)``; its outside is to the left."""
        owner = f"rigid surface {name}"
        self.card("SURFACE", segments, owner=owner, name=name, type="SEGMENTS")
        options = {"ref node": reference, "analytical surface": name}
        return self.card("RIGID BODY", owner=owner, **options)

    def interaction(
        self,
        name: str,
        friction: Number | None = None,
        pressure: tuple[str, Sequence[Sequence[Number]]] | None = None,
        thickness: Number | None = None,
    ) -> Model:
        """How surfaces meet: coefficient of friction mu [1]; pressure-overclosure law and its data
        lines, such as ``("EXPONENTIAL", [(c0 [L], p0 [F/L2])])``; out-of-plane width [L]."""
        owner = f"interaction {name}"
        width = [] if thickness is None else [[thickness]]
        self.card("SURFACE INTERACTION", width, owner=owner, name=name)
        if friction is not None:
            self.card("FRICTION", [[friction]], owner=owner)
        if pressure is not None:
            law, rows = pressure
            self.card("SURFACE BEHAVIOR", rows, owner=owner, **{"pressure-overclosure": law})
        return self

    def contact_pair(self, slave: str, master: str, interaction: str, **options: Any) -> Model:
        """A slave surface that slides on a master surface."""
        owner = f"contact pair {slave}, {master}"
        given = {"interaction": interaction, **options}
        return self.card("CONTACT PAIR", [(slave, master)], owner=owner, **given)

    def step(
        self,
        name: str,
        increment: Number = 1.0,
        period: Number = 1.0,
        *,
        nlgeom: bool = True,
        direct: bool = False,
        increments: int | None = None,
    ) -> Step:
        """A step of a period [T] that begins with an increment [T]; ``direct`` keeps to it.
        ``increments`` is how many there may be."""
        owner = f"step {name}"
        first = _card(owner, "STEP", [name], {"nlgeom": nlgeom, "inc": increments})
        static = _card(owner, "STATIC", [(increment, period)], {"direct": direct})
        step = Step(name, [first, static])
        self._steps.append(step)
        return step

    def _all(self) -> list[Card]:
        cards = list(self._cards)
        for step in self._steps:
            cards += [*step._cards, Card(f"step {step.name}", "*END STEP\n")]
        return cards

    def text(self) -> str:
        """The deck."""
        return "".join(card.text for card in self._all())

    def owner(self, said: _core.Diagnosis) -> str | None:
        """The object that a diagnosis is about; None where it has no line."""
        line = 0
        for card in self._all():
            line += card.text.count("\n")
            if said.line is not None and said.line <= line:
                return card.owner
        return None

    def job(self, **options: Any) -> Job:
        """The job of the deck; ``options`` are those of ``slideline.read``.

        Raises InputError, whose text names the objects that are wrong.
        """
        job = read_text(self.text(), self.name, **options)
        errors = [said for said in job.diagnoses if said.severity == "error"]
        if errors:
            raise InputError("\n".join(self._told(said) for said in errors), job.diagnoses)
        return job

    def _told(self, said: _core.Diagnosis) -> str:
        owner = self.owner(said)
        return f"{owner}: {said}" if owner else str(said)

    def run(self, *arguments: Any, **options: Any) -> Result:
        """``job().run(...)``."""
        return self.job().run(*arguments, **options)
