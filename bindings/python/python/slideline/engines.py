"""Studies on several machines: shards as tasks of Ray or Dask.

::

    study, deck, study.json --packed--> task of shard k --bytes--> shard_k.parquet of the folder

A task is a pure function of what is sent and of its number. The machines share no folder; they need
this package in the same version. What a machine loses the engine gives to another one.
"""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from . import _core
from .errors import refuse

#: tasks that wait for a core, for each core
WAITING = 2


class Packed(NamedTuple):
    """Everything that a task needs to know of a study, machines apart."""

    study: str
    """Text of the study."""
    place: str
    """Its path, from the folder that all files have in common."""
    files: tuple[tuple[str, bytes], ...]
    """The deck and what it includes, with such paths."""
    layout: bytes
    """``study.json``."""
    shards: int


def packed(study: str, path: Path, deck: str, layout: Path) -> Packed:
    """Packs a study whose ``study.json`` is there: its text, as if it stood at ``path``, its deck with
    what that includes."""
    told = json.loads(layout.read_text(encoding="utf-8"))
    files = [Path(name).resolve() for name in _core.read(deck, []).files]
    own = path.resolve()
    root = Path(os.path.commonpath([own.parent, *(file.parent for file in files)]))
    sent = tuple((os.path.relpath(file, root), file.read_bytes()) for file in files)
    shards = -(-int(told["cases"]) // int(told["cases_a_shard"]))
    return Packed(study, os.path.relpath(own, root), sent, layout.read_bytes(), shards)


def shard(sent: Packed, number: int) -> bytes:
    """Runs the cases of a shard and returns its file. This is what the machines do."""
    with tempfile.TemporaryDirectory(prefix="slideline-") as name:
        root = Path(name) / "files"
        for place, content in sent.files:
            file = root / place
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content)
        own = root / sent.place
        own.parent.mkdir(parents=True, exist_ok=True)
        folder = Path(name) / "shards"
        folder.mkdir()
        (folder / "study.json").write_bytes(sent.layout)
        made, said = _core.read_study(os.fspath(own), sent.study)
        refuse_in_words(said)
        _, said = made.run_in(os.fspath(folder), 1, (number, sent.shards), None)
        refuse_in_words(said)
        return (folder / file_name(number)).read_bytes()


def refuse_in_words(said: Iterable[_core.Diagnosis]) -> None:
    """Errors of a task travel between machines as text."""
    errors = [str(own) for own in said if own.severity == "error"]
    if errors:
        raise RuntimeError("\n".join(errors))


def file_name(number: int) -> str:
    """Name of the file of a shard."""
    return f"shard_{number:05}.parquet"


def run(
    made: _core.Study,
    study: str,
    path: Path,
    out: Path,
    engine: str,
    progress: Callable[[int, int], None] | None,
) -> tuple[_core.Table | None, list[_core.Diagnosis]]:
    """Runs the shards that ``out`` does not have on an engine, and reads all of them."""
    of = ENGINES.get(engine)
    if of is None:
        raise ValueError(f"engine is one of {', '.join(sorted(ENGINES))}, not {engine!r}")
    # no shard is number 2^62 modulo 2^63: the folder is opened, or made with its layout
    _, said = made.run_in(os.fspath(out), 1, (2**62, 2**63), None)
    refuse(said)
    layout = out / "study.json"
    sent = packed(study, path, made.deck, layout)
    missing = [number for number in range(sent.shards) if not (out / file_name(number)).exists()]
    each = int(json.loads(sent.layout)["cases_a_shard"])
    sizes = {number: min(each, made.cases - number * each) for number in missing}
    done, everything = 0, sum(sizes.values())
    for number, content in of(sent, missing):
        keep(out / file_name(number), content)
        done += sizes[number]
        if progress is not None:
            progress(done, everything)
    return made.run_in(os.fspath(out), 1, (0, 1), None)


def keep(file: Path, content: bytes) -> None:
    """Writes a file whole or not at all."""
    part = file.with_suffix(f".{os.getpid()}.new")
    part.write_bytes(content)
    part.replace(file)


def _ray(sent: Packed, numbers: list[int]) -> Iterator[tuple[int, bytes]]:
    import ray

    if not ray.is_initialized():
        ray.init(log_to_driver=False)
    task = ray.remote(max_retries=-1)(shard)
    everywhere = ray.put(sent)
    left, running = list(reversed(numbers)), {}
    try:
        while left or running:
            room = WAITING * max(1, int(ray.cluster_resources().get("CPU", 1)))
            while left and len(running) < room:
                number = left.pop()
                running[task.remote(everywhere, number)] = number
            ended, _ = ray.wait(list(running), num_returns=1)
            for own in ended:
                yield running.pop(own), ray.get(own)
    finally:
        for own in running:
            ray.cancel(own, force=True)


def _dask(sent: Packed, numbers: list[int]) -> Iterator[tuple[int, bytes]]:
    from distributed import Client, as_completed

    try:
        client, own = Client.current(), None
    except ValueError:
        client = own = Client(processes=True, threads_per_worker=1, dashboard_address=None)
    left = list(reversed(numbers))
    running: dict[Any, int] = {}

    def further() -> Any:
        number = left.pop()
        future = client.submit(shard, sent, number, pure=False, retries=3)
        running[future] = number
        return future

    try:
        room = WAITING * max(1, sum(client.nthreads().values()))
        ended = as_completed([further() for _ in range(min(room, len(left)))])
        for future in ended:
            yield running.pop(future), future.result()
            if left:
                ended.add(further())
    finally:
        client.cancel(list(running))
        if own is not None:
            own.close()


#: how an engine runs shards: in any order, each with its number
ENGINES: dict[str, Callable[[Packed, list[int]], Iterator[tuple[int, bytes]]]] = {
    "dask": _dask,
    "ray": _ray,
}
