"""Sliding contact of beams, solids and rigid bodies: read a deck, run it, vary it.

::

    import slideline

    job = slideline.read("snap_fit.inp")
    for said in job.check():
        print(said)
    result = job.run(progress=True)
    force = result.history(100, "RF1")          # NumPy, not copied
    table = result.table("contact").to_pandas()

Units are those of the deck, as long as they are consistent. [L], [F], [T] in the docstrings are
length, force and time. docs/python.md has the guide.
"""

from ._core import Diagnosis, ElementField, Table, __version__, explain
from .errors import (
    InputError,
    InternalError,
    Interrupted,
    NotConverged,
    OutputError,
    RunError,
    SlidelineError,
)
from .job import Job, read, read_text
from .model import Model
from .result import Frame, Result
from .studies import Evaluator, sweep

__all__ = [
    "Diagnosis",
    "ElementField",
    "Evaluator",
    "Frame",
    "InputError",
    "InternalError",
    "Interrupted",
    "Job",
    "Model",
    "NotConverged",
    "OutputError",
    "Result",
    "RunError",
    "SlidelineError",
    "Table",
    "__version__",
    "explain",
    "read",
    "read_text",
    "sweep",
]
