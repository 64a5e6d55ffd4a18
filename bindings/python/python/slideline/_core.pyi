"""Types of the compiled part; tests/test_package.py compares them with it."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

class Diagnosis:
    code: str
    severity: str
    message: str
    help: str | None
    file: str | None
    line: int | None
    columns: tuple[int, int] | None
    card: str | None
    suggestion: str | None
    def explain(self) -> str: ...

class ElementField:
    name: str
    element_type: str
    components: list[str]
    unit: str
    location: str
    labels: NDArray[np.int64]
    values: NDArray[np.float64]

class Table:
    columns: list[str]
    def __len__(self) -> int: ...
    def __getitem__(self, name: str, /) -> NDArray[Any] | list[str | None]: ...
    def to_dict(self) -> dict[str, NDArray[Any] | list[str | None]]: ...
    def to_pandas(self) -> Any: ...
    def to_polars(self) -> Any: ...
    def __arrow_c_schema__(self) -> object: ...
    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...

class Deck:
    name: str
    path: str
    files: list[str]
    hash: str
    is_sound: bool
    diagnoses: list[Diagnosis]
    def node_labels(self, name: str | None = None) -> list[int] | None: ...
    def coordinates(self) -> NDArray[np.float64] | None: ...
    def advice(self) -> list[Diagnosis]: ...
    def initial_gaps(self) -> Table | None: ...
    def run(
        self,
        folder: str | None,
        threads: int,
        all_frames: bool,
        told: Callable[[int, int, float, int], None] | None,
        laws: dict[str, Callable[..., Any]],
    ) -> Run: ...

class Run:
    status: str
    increment_count: int
    iterations: int
    cutbacks: int
    seconds: float
    diagnoses: list[Diagnosis]
    failure: str | None
    raised: BaseException | None
    verdict: tuple[str, list[str]] | None
    steps: NDArray[np.int64]
    increments: NDArray[np.int64]
    times: NDArray[np.float64]
    frames: NDArray[np.int64]
    labels: NDArray[np.int64]
    dofs: list[str]
    motions: NDArray[np.float64]
    reactions: NDArray[np.float64]
    history_nodes: list[int]
    history: Table
    contact: Table
    energy: Table
    def write_report(self) -> str | None: ...
    def history_of(self, label: int, name: str) -> NDArray[np.float64] | None: ...
    def element_field_names(self) -> list[str]: ...
    def element_fields(self, frame: int, name: str) -> list[ElementField]: ...

class Evaluator:
    def evaluate(
        self, points: ArrayLike, threads: int
    ) -> tuple[NDArray[np.float64], list[str | None]]: ...
    def jacobian(
        self, points: ArrayLike, threads: int
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], list[str | None]]: ...

class Study:
    cases: int
    deck: str
    parameters: list[str]
    responses: list[str]
    def run(
        self, begin: int, end: int, threads: int, told: Callable[[int, int], None] | None = None
    ) -> tuple[Table | None, list[Diagnosis]]: ...
    def run_in(
        self,
        folder: str,
        threads: int,
        part: tuple[int, int] = (0, 1),
        told: Callable[[int, int], None] | None = None,
    ) -> tuple[Table | None, list[Diagnosis]]: ...

def read(
    path: str,
    parameters: list[tuple[str, str]],
    dialect: str | None = None,
    friction_onset: str | None = None,
) -> Deck: ...
def read_text(
    name: str,
    text: str,
    parameters: list[tuple[str, str]],
    dialect: str | None = None,
    friction_onset: str | None = None,
) -> Deck: ...
def explain(name: str) -> str | None: ...
def evaluator(
    deck: Deck, parameters: list[str], whole: list[bool], responses: list[tuple[str, str]]
) -> tuple[Evaluator | None, list[Diagnosis]]: ...
def read_study(path: str, text: str) -> tuple[Study | None, list[Diagnosis]]: ...
