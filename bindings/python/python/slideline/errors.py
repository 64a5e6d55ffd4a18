"""What is raised, and when."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._core import Diagnosis
    from .result import Result


class SlidelineError(Exception):
    """Anything that stands against a deck, a run or a study.

    ``diagnoses`` are the objects that say it, each with code, message, file and line.
    """

    def __init__(self, message: str, diagnoses: Sequence[Diagnosis] = ()) -> None:
        super().__init__(message)
        self.diagnoses: list[Diagnosis] = list(diagnoses)


class InputError(SlidelineError, ValueError):
    """The deck, the model or the study is wrong; nothing was solved."""


class RunError(SlidelineError):
    """A run that did not come to its end; ``result`` has what converged."""

    def __init__(self, message: str, diagnoses: Sequence[Diagnosis], result: Result) -> None:
        super().__init__(message, diagnoses)
        self.result = result


class NotConverged(RunError):
    """An increment was not found."""


class OutputError(RunError):
    """Files could not be written."""


class InternalError(RunError):
    """A fault of ours."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C: the increment was finished; ``result`` has what converged."""

    def __init__(self, result: Result) -> None:
        super().__init__(f"interrupted after {result.increments} increments")
        self.result = result


def told(diagnoses: Sequence[Diagnosis]) -> str:
    """All errors as one text."""
    return "\n".join(str(said) for said in diagnoses if said.severity == "error")


def refuse(diagnoses: Sequence[Diagnosis]) -> None:
    """Raises InputError where errors are among them."""
    errors = [said for said in diagnoses if said.severity == "error"]
    if errors:
        raise InputError(told(errors), diagnoses)
