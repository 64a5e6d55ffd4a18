"""One deck, many values: studies and evaluations for optimisers."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from . import _core, engines
from .errors import refuse
from .job import Job, read


def cores() -> int:
    """Threads that this process may use."""
    has_affinity = hasattr(os, "sched_getaffinity")
    return len(os.sched_getaffinity(0)) if has_affinity else os.cpu_count() or 1


class Evaluator:
    """Responses of a deck at points that others choose: ``Y = evaluator.evaluate(X)``.

    ``deck`` is a path or a Job, ``parameters`` names of its ``*PARAMETER`` cards, ``responses``
    expressions by name, as in docs/studies.md: ``{"force": "peak(RF2@9999)"}``. Parameters in
    ``whole`` are rounded to whole numbers, such as numbers of elements. Calls keep the room of those
    before, so that a point costs no more than its solution.

    Raises InputError: a deck with errors, a parameter that it does not define (SL0801), a response
    that cannot be evaluated (SL0804) or is of a node that it does not have (SL0805).
    """

    def __init__(
        self,
        deck: str | os.PathLike[str] | Job,
        parameters: Sequence[str],
        responses: Mapping[str, str],
        *,
        whole: Sequence[str] = (),
        threads: int | None = None,
    ) -> None:
        job = deck if isinstance(deck, Job) else read(deck)
        refuse(job.diagnoses)
        unknown = set(whole) - set(parameters)
        if unknown:
            raise ValueError(f"whole names no parameters: {', '.join(sorted(unknown))}")
        self.parameters, self.responses = list(parameters), list(responses)
        self.threads = threads or cores()
        rounded = [name in whole for name in parameters]
        made, said = _core.evaluator(job._deck, self.parameters, rounded, list(responses.items()))
        refuse(said)
        self._evaluator = made

    def _points(self, x: Any) -> np.ndarray:
        points = np.ascontiguousarray(x, dtype=float)
        if points.ndim not in (1, 2) or points.shape[-1] != len(self.parameters):
            shape = " x ".join(map(str, points.shape))
            names = ", ".join(self.parameters)
            raise ValueError(f"X is (points, {len(self.parameters)}) for {names}, not {shape}")
        if not np.isfinite(points).all():
            raise ValueError("X has values that are not finite")
        return points

    def evaluate(self, x: Any) -> np.ndarray:
        """Responses Y (points, responses) at values X (points, parameters); one point (parameters,)
        gives (responses,). Where a point fails, or has no such response, Y is not a number;
        ``failures(X)`` says why. Y has the same bits on any number of threads.

        Raises ValueError for another shape or values that are not finite, KeyboardInterrupt.
        """
        points = self._points(x)
        found, _ = self._evaluator.evaluate(np.atleast_2d(points), self.threads)
        return found if points.ndim == 2 else found[0]

    def jacobian(self, x: Any) -> np.ndarray:
        """Derivatives (points, responses, parameters) of the responses by the parameters at values X
        (points, parameters); one point (parameters,) gives (responses, parameters). They are those of
        the run itself, not differences of runs (docs/sensitivities.md); not a number where a point
        fails, where a response has none (counts, roughness, verdict), and by whole numbers.

        Raises as ``evaluate`` does.
        """
        return self.evaluate_with_jacobian(x)[1]

    def evaluate_with_jacobian(self, x: Any) -> tuple[np.ndarray, np.ndarray]:
        """What ``evaluate`` and ``jacobian`` give, of one run a point."""
        points = self._points(x)
        found, rates, _ = self._evaluator.jacobian(np.atleast_2d(points), self.threads)
        return (found, rates) if points.ndim == 2 else (found[0], rates[0])

    def failures(self, x: Any) -> list[str | None]:
        """The code of what stands against each point, None where nothing does."""
        _, codes = self._evaluator.evaluate(np.atleast_2d(self._points(x)), self.threads)
        return codes

    __call__ = evaluate


def sweep(
    study: str | os.PathLike[str] | Mapping[str, Any],
    *,
    out: str | os.PathLike[str] | None = None,
    threads: int | None = None,
    part: tuple[int, int] = (0, 1),
    progress: Callable[[int, int], None] | None = None,
    folder: str | os.PathLike[str] = ".",
    engine: str | None = None,
) -> _core.Table:
    """Runs a study (docs/studies.md) and returns its rows: ``case``, the parameters, the responses
    (not a number where there is none) and ``code``, what stands against a case that failed.

    ``study`` is the path of a TOML file, or its content as a dict; the deck of a dict stands in
    ``folder``. ``out`` keeps the shards, and goes on where the last call ended; ``part=(i, n)`` runs
    the shards k with k mod n = i. ``progress`` is called with the cases done and those to be done.
    ``engine="ray"`` or ``"dask"`` runs the shards as tasks of the cluster that Ray or Dask is connected
    to, or of this machine where it is to none (docs/cluster.md); the rows have the same bits.

    Raises InputError; KeyboardInterrupt, after which ``out`` has all whole shards.
    """
    path, text = written(study, folder)
    made = load(path, text)
    if engine is not None:
        if part != (0, 1) or threads not in (None, 1):
            raise ValueError("an engine divides the study itself: without part= and threads=")
        with contextlib.ExitStack() as kept:
            named = out or kept.enter_context(tempfile.TemporaryDirectory(prefix="slideline-"))
            rows, said = engines.run(made, text, path, Path(named), engine, progress)
        refuse(said)
        return rows
    if out is None:
        if part != (0, 1):
            raise ValueError("part needs the folder of the study: out=")
        rows, said = made.run(0, made.cases, threads or cores(), progress)
    else:
        rows, said = made.run_in(os.fspath(out), threads or cores(), part, progress)
    refuse(said)
    return rows


def written(
    study: str | os.PathLike[str] | Mapping[str, Any], folder: str | os.PathLike[str]
) -> tuple[Path, str]:
    """A study as the path and the text of its file."""
    if isinstance(study, Mapping):
        return Path(folder) / "study.toml", toml(study)
    path = Path(study)
    return path, path.read_text(encoding="utf-8")


def load(path: Path, text: str) -> _core.Study:
    """A study that was read; InputError where something stands against it."""
    made, said = _core.read_study(os.fspath(path), text)
    refuse(said)
    return made


def toml(study: Mapping[str, Any]) -> str:
    """A study as the text of its file."""
    return "".join(f"{_key(name)} = {_value(value)}\n" for name, value in study.items())


def _key(name: str) -> str:
    return name if name.replace("_", "").isalnum() and name.isascii() else _text(name)


def _text(value: str) -> str:
    escaped = value.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    return f'"{escaped}"'


def _value(value: Any) -> str:
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(name)} = {_value(own)}" for name, own in value.items()) + " }"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        return _text(os.fspath(value))
    if isinstance(value, Sequence):
        return "[" + ", ".join(_value(own) for own in value) + "]"
    raise TypeError(f"a study has numbers, texts, lists and dicts, not {type(value).__name__}")
