"""A deck that was read: checked, run."""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from . import _core
from .errors import InternalError, Interrupted, NotConverged, OutputError, refuse, told
from .result import Result

#: step, increment, total time [T], iterations of an increment that has converged
Progress = Callable[[int, int, float, int], None]
#: A friction law: arrays of all closed points in, a dict of arrays out (see docs/python.md).
FrictionLaw = Callable[..., Mapping[str, Any]]


def settings(parameters: Mapping[str, float | int | str] | None) -> list[tuple[str, str]]:
    """Values as a deck takes them: numbers read back to the same bits, texts are expressions."""
    text = lambda value: value if isinstance(value, str) else repr(value)
    plain = lambda value: value.item() if hasattr(value, "item") else value
    return [(name, text(plain(value))) for name, value in (parameters or {}).items()]


def read(
    path: str | os.PathLike[str],
    *,
    parameters: Mapping[str, float | int | str] | None = None,
    dialect: str | None = None,
    friction_onset: str | None = None,
) -> Job:
    """Reads the deck at ``path`` (``.inp`` may be left out) and everything it includes.

    ``parameters`` are values of names that the deck defines by ``*PARAMETER``, ``dialect`` is
    ``"abaqus"`` (the default) or ``"calculix"``, ``friction_onset`` ``"immediate"``, ``"delayed"``
    or ``"matfru"`` in place of what the deck says.

    Never raises for what stands in the deck: ``check()`` tells it, and ``run()`` raises it.
    """
    given = settings(parameters)
    return Job(_core.read(os.fspath(path), given, dialect, friction_onset))


def read_text(
    text: str,
    name: str = "job",
    *,
    parameters: Mapping[str, float | int | str] | None = None,
    dialect: str | None = None,
    friction_onset: str | None = None,
) -> Job:
    """Reads the text of a deck, which can include no files. ``name`` is that of the job."""
    given = settings(parameters)
    return Job(_core.read_text(name, text, given, dialect, friction_onset))


class Job:
    """A deck that was read."""

    def __init__(self, deck: _core.Deck) -> None:
        self._deck = deck

    @property
    def name(self) -> str:
        """Name of the job: that of the deck without ``.inp``."""
        return self._deck.name

    @property
    def is_sound(self) -> bool:
        """Whether there is a model that can be run."""
        return self._deck.is_sound

    @property
    def diagnoses(self) -> list[_core.Diagnosis]:
        """What reading had to say: errors, warnings, notes."""
        return self._deck.diagnoses

    @property
    def coordinates(self):
        """Where all nodes stand before the first step [L], (nodes, 3); None without a model."""
        return self._deck.coordinates()

    def nodes(self, name: str | None = None) -> list[int]:
        """Labels of the nodes of a set, or of all nodes; KeyError: there is no such set."""
        found = self._deck.node_labels(name)
        if found is None:
            raise KeyError(name)
        return found

    def check(self) -> list[_core.Diagnosis]:
        """Everything there is to say before a run, advice on the model included, as
        ``slideline check``."""
        return self._deck.diagnoses + self._deck.advice()

    def initial_gaps(self) -> _core.Table:
        """Contact points before anything moves: COPEN [L] is the gap, open positive.

        Raises InputError where the deck has errors.
        """
        refuse(self.diagnoses)
        gaps = self._deck.initial_gaps()
        if gaps is None:
            raise RuntimeError("the solver refuses the model; run() says why")
        return gaps

    def run(
        self,
        progress: bool | Progress = False,
        *,
        threads: int = 1,
        out: str | os.PathLike[str] | bool | None = None,
        frames: str = "all",
        friction: Mapping[str, FrictionLaw] | None = None,
    ) -> Result:
        """Runs every step; other threads of Python go on meanwhile.

        ``progress`` prints a line an increment, or is called with step, increment, total time [T]
        and iterations. ``out`` is the folder of the result files (docs/files.md); left out, they go
        to a temporary folder that lives as long as the result, and ``False`` writes none, which is
        faster and leaves no verdict and no report. ``frames="last"`` keeps the fields of the last
        state alone. ``friction`` has the laws that ``*FRICTION, USER=`` names.

        Raises InputError (nothing was solved), NotConverged, OutputError, InternalError and, after
        Ctrl-C, Interrupted: the last four have the ``result`` with what converged.
        """
        refuse(self.diagnoses)
        if frames not in ("all", "last"):
            raise ValueError(f'frames is "all" or "last", not {frames!r}')
        if not 1 <= threads <= 1024:
            raise ValueError("threads is a whole number from 1 to 1024")
        folder, temporary = _folder(out)
        run = self._deck.run(folder, threads, frames == "all", _teller(progress), dict(friction or {}))
        result = Result(self, run, temporary)
        return _judged(result, run)

    def __repr__(self) -> str:
        state = "" if self.is_sound else ", with errors"
        return f"<slideline.Job {self.name}{state}>"


def _folder(
    out: str | os.PathLike[str] | bool | None,
) -> tuple[str | None, tempfile.TemporaryDirectory[str] | None]:
    """Where files go, and the folder that has to be kept for that."""
    if out is False:
        return None, None
    if out is None or out is True:
        temporary = tempfile.TemporaryDirectory(prefix="slideline-")
        return temporary.name, temporary
    Path(out).mkdir(parents=True, exist_ok=True)
    return os.fspath(out), None


def _teller(progress: bool | Progress) -> Progress | None:
    if callable(progress):
        return progress
    return _print_line if progress else None


def _print_line(step: int, increment: int, time: float, iterations: int) -> None:
    print(f"step {step} increment {increment}: time {time:.6g}, {iterations} iterations")
    sys.stdout.flush()


def _judged(result: Result, run: _core.Run) -> Result:
    """The result of a run that came to its end; raises where it did not."""
    if run.raised is not None:
        if isinstance(run.raised, KeyboardInterrupt):
            raise Interrupted(result) from run.raised
        raise run.raised
    kinds = {"not_converged": NotConverged, "output_error": OutputError, "internal_error": InternalError}
    if run.status == "input_error":
        refuse(run.diagnoses)
    if run.status in kinds:
        message = run.failure or told(run.diagnoses)
        raise kinds[run.status](message, run.diagnoses, result)
    return result
