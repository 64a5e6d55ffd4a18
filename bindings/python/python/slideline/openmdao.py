"""An evaluator as a component of OpenMDAO, which is imported here alone."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

try:
    import openmdao.api as om
except ImportError as missing:
    raise ImportError("slideline.openmdao needs OpenMDAO: pip install openmdao") from missing

from .studies import Evaluator


class EvaluatorComponent(om.ExplicitComponent):
    """Inputs are the parameters of an evaluator, outputs its responses, all scalars.

    ``values`` are the inputs to begin with, in the order of the parameters, in the units of the deck.
    Partials are exact (docs/sensitivities.md): where a response has none, such as a count, AnalysisError says
    so when they are asked for.

    Raises ``openmdao.api.AnalysisError`` where a point fails, which drivers take for a failed
    evaluation; its text has the code.
    """

    def __init__(self, evaluator: Evaluator, values: Sequence[float]) -> None:
        super().__init__()
        if len(values) != len(evaluator.parameters):
            raise ValueError(f"values has one number for each of {', '.join(evaluator.parameters)}")
        self._evaluator, self._values = evaluator, list(values)

    def setup(self) -> None:
        """Declares inputs, outputs and partials."""
        for name, value in zip(self._evaluator.parameters, self._values):
            self.add_input(name, val=value)
        for name in self._evaluator.responses:
            self.add_output(name)
        self.declare_partials("*", "*")

    def _point(self, inputs: Any) -> np.ndarray:
        return np.array([inputs[name][0] for name in self._evaluator.parameters])

    def compute(self, inputs: Any, outputs: Any) -> None:
        """One point."""
        point = self._point(inputs)
        found = self._evaluator.evaluate(point)
        if not np.isfinite(found).all():
            [code] = self._evaluator.failures(point)
            raise om.AnalysisError(f"no response at {point}: {code or 'none has a value'}")
        for name, value in zip(self._evaluator.responses, found):
            outputs[name] = value

    def compute_partials(self, inputs: Any, partials: Any) -> None:
        """The derivatives of one run."""
        point = self._point(inputs)
        slopes = self._evaluator.jacobian(point)
        if not np.isfinite(slopes).all():
            raise om.AnalysisError(f"a response has no derivative at {point}")
        for j, response in enumerate(self._evaluator.responses):
            for i, parameter in enumerate(self._evaluator.parameters):
                partials[response, parameter] = slopes[j, i]
