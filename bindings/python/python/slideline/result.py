"""What came of a run."""

from __future__ import annotations

import html
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core

if TYPE_CHECKING:
    import tempfile

    from .job import Job


class Frame:
    """The fields of one state. Arrays are views that cannot be written."""

    def __init__(self, run: _core.Run, place: int) -> None:
        self._run, self._place = run, place
        state = int(run.frames[place])
        self.step, self.increment = int(run.steps[state]), int(run.increments[state])
        #: total time [T]
        self.time = float(run.times[state])

    def _vectors(self, values: np.ndarray, rotations: bool) -> np.ndarray:
        kinds = [name.startswith("UR") for name in self._run.dofs]
        count = kinds.index(True) if True in kinds else len(kinds)
        return values[self._place, :, count:] if rotations else values[self._place, :, :count]

    @property
    def displacement(self) -> np.ndarray:
        """Displacements [L] along the axes of the model, (nodes, 2 or 3)."""
        return self._vectors(self._run.motions, False)

    @property
    def rotation(self) -> np.ndarray:
        """Rotations [1], (nodes, 0, 1 or 3): UR3 in the plane."""
        return self._vectors(self._run.motions, True)

    @property
    def reaction(self) -> np.ndarray:
        """Forces [F] of the supports on the model, (nodes, 2 or 3)."""
        return self._vectors(self._run.reactions, False)

    @property
    def moment(self) -> np.ndarray:
        """Moments [F L] of the supports on the model, (nodes, 0, 1 or 3)."""
        return self._vectors(self._run.reactions, True)

    @property
    def field_names(self) -> list[str]:
        """Names of the fields that elements offer, as decks ask for them."""
        return self._run.element_field_names()

    def field(self, name: str) -> list[_core.ElementField]:
        """A field of the elements, such as ``"S"`` (stress [F/L2]) or ``"SF"``: one entry for every
        element type and section that has it, with ``labels`` (elements,) and ``values`` (elements,
        places, components). KeyError: no element offers it."""
        found = self._run.element_fields(self._place, name.upper())
        if name.upper() not in self.field_names:
            raise KeyError(f"{name}; there are {', '.join(self.field_names)}")
        return found

    @property
    def stress(self) -> list[_core.ElementField]:
        """The stresses of the elements [F/L2]: ``field("S")``."""
        return self.field("S")

    def __repr__(self) -> str:
        return f"<Frame step {self.step}, increment {self.increment}, time {self.time:.6g}>"


class Frames(Sequence[Frame]):
    """The states whose fields were kept, the start first."""

    def __init__(self, run: _core.Run) -> None:
        self._run = run

    def __len__(self) -> int:
        return len(self._run.frames)

    def __getitem__(self, place):  # type: ignore[override]
        if isinstance(place, slice):
            return [self[k] for k in range(*place.indices(len(self)))]
        if not -len(self) <= place < len(self):
            raise IndexError(f"there are {len(self)} frames")
        return Frame(self._run, place % len(self))

    def __iter__(self) -> Iterator[Frame]:
        return (self[k] for k in range(len(self)))


class Result:
    """What came of a run: histories, fields, contact, energies, verdict.

    Arrays are handed out without copies and cannot be written.
    """

    def __init__(
        self, job: Job, run: _core.Run, temporary: tempfile.TemporaryDirectory[str] | None
    ) -> None:
        self.job = job
        self._run, self._temporary = run, temporary
        self.frames = Frames(run)

    @property
    def status(self) -> str:
        """``completed``, ``not_converged``, ``interrupted``, ``output_error``, ``internal_error``."""
        return self._run.status

    @property
    def verdict(self) -> tuple[str, list[str]] | None:
        """Colour and reasons, as the report has them; None for a run without files."""
        return self._run.verdict

    @property
    def diagnoses(self) -> list[_core.Diagnosis]:
        """What the run had to say."""
        return self._run.diagnoses

    @property
    def increments(self) -> int:
        """Converged increments of all steps."""
        return self._run.increment_count

    @property
    def iterations(self) -> int:
        """Newton iterations, those of failed attempts among them."""
        return self._run.iterations

    @property
    def cutbacks(self) -> int:
        """Failed attempts."""
        return self._run.cutbacks

    @property
    def seconds(self) -> float:
        """Wall time of the run [s]."""
        return self._run.seconds

    @property
    def time(self) -> np.ndarray:
        """Total time [T] of the start and of every converged increment, (states,)."""
        return self._run.times

    @property
    def steps(self) -> np.ndarray:
        """Step of every state, (states,)."""
        return self._run.steps

    @property
    def labels(self) -> np.ndarray:
        """Labels of the nodes in the order of the fields, (nodes,)."""
        return self._run.labels

    @property
    def history_nodes(self) -> list[int]:
        """Nodes that JOB.history.csv has: driven, loaded or asked for."""
        return self._run.history_nodes

    def history(self, node: int | str, name: str) -> np.ndarray:
        """The history of ``name`` (``"U1"``, ``"RF2"``, ``"RM3"`` ...) at a node, or at the one node
        of a set, (states,), the start first; along the axes of the model. Units: [L] and [1] of
        motions, [F] and [F L] of reactions.

        KeyError: there is no such node or component, or it has no history and frames="last" kept no
        fields to take it from.
        """
        label = self._label(node)
        found = self._run.history_of(label, name)
        return self._of_fields(label, name.upper()) if found is None else found

    def _label(self, node: int | str) -> int:
        if not isinstance(node, str):
            return int(node)
        members = self.job.nodes(node)
        if len(members) != 1:
            raise KeyError(f"the set {node} has {len(members)} nodes")
        return members[0]

    def _of_fields(self, label: int, name: str) -> np.ndarray:
        reaction = name.startswith(("RF", "RM"))
        dof = name.replace("RF", "U").replace("RM", "UR") if reaction else name
        place = np.flatnonzero(self.labels == label)
        if len(place) != 1 or dof not in self._run.dofs:
            raise KeyError(f"there is no {name} at node {label}")
        if len(self.frames) != len(self.time):
            raise KeyError(f"node {label} has no history: run with frames='all'")
        values = self._run.reactions if reaction else self._run.motions
        return values[:, place[0], self._run.dofs.index(dof)]

    def table(self, name: str) -> _core.Table:
        """``"history"``, ``"contact"`` or ``"energy"``: the columns of JOB.history.csv and so on
        (docs/files.md). A table is an Arrow stream (pyarrow, DuckDB) and has ``to_pandas()``,
        ``to_polars()`` and its columns as NumPy arrays: ``table["RF2"]``."""
        run = self._run
        tables = {"history": run.history, "contact": run.contact, "energy": run.energy}
        if name not in tables:
            raise KeyError(f"{name}; there are {', '.join(tables)}")
        return tables[name]

    @property
    def peaks(self) -> dict[str, dict[str, tuple[float, float]]]:
        """``{"9999.RF2": {"min": (value, time), "max": (value, time)}}`` of every history."""
        found = {}
        if len(self.time) == 0:
            return found
        skipped = ("step", "increment", "time", "node")
        names = [name for name in self.table("history").columns if name not in skipped]
        for label in self.history_nodes:
            for name in names:
                values = self.history(label, name)
                low, high = int(np.argmin(values)), int(np.argmax(values))
                found[f"{label}.{name}"] = {
                    "min": (float(values[low]), float(self.time[low])),
                    "max": (float(values[high]), float(self.time[high])),
                }
        return found

    def report(self) -> Path:
        """Writes JOB.html, the report, and returns its path; RuntimeError for a run without files.
        In a temporary folder it goes when the result goes: copy it."""
        path = self._run.write_report()
        if path is None:
            raise RuntimeError("a run with out=False has no files to make a report of")
        return Path(path)

    def plot(self, node: int | str | None = None, y: str | None = None, x: str | None = None, ax: Any = None):
        """Draws a history with Matplotlib (extra ``plot``) and returns the axes; ``x`` is time unless
        named. Without a node: the reaction that does most work, over its motion."""
        from .plotting import plot

        return plot(self, node, y, x, ax)

    def _repr_html_(self) -> str:
        if self._run.verdict is None:
            peaks = "".join(
                f"<tr><td>{name}</td><td>{own['min'][0]:.6g}</td><td>{own['max'][0]:.6g}</td></tr>"
                for name, own in self.peaks.items()
                if own["min"][0] != own["max"][0]
            )
            head = "<tr><th></th><th>min</th><th>max</th></tr>"
            return f"<p>{html.escape(repr(self))}</p><table>{head}{peaks}</table>"
        page = html.escape(self.report().read_text(encoding="utf-8"), quote=True)
        return f'<iframe srcdoc="{page}" style="width:100%;height:720px;border:0"></iframe>'

    def __repr__(self) -> str:
        colour = f", {self.verdict[0]}" if self.verdict else ""
        return (
            f"<slideline.Result {self.job.name}: {self.status} after {self.increments} increments, "
            f"{self.iterations} iterations{colour}>"
        )
