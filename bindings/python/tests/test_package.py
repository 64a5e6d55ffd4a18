"""The package itself: types, time of import, wheel."""

import ast
import importlib.metadata
import inspect
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

import slideline
from slideline import _core

SOURCE = Path(slideline.__file__).parent
#: dunder methods that users call by name or by syntax
SPOKEN = {"__len__", "__getitem__", "__arrow_c_schema__", "__arrow_c_stream__"}


def shown(name):
    return not name.startswith("_") or name in SPOKEN


def names_of(arguments):
    every = [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs]
    return [own.arg for own in every], len(arguments.defaults)


def parameters(function):
    found = inspect.signature(function).parameters.values()
    optional = sum(own.default is not inspect.Parameter.empty for own in found)
    return [own.name for own in found], optional


def compared(stub, live, where):
    """Names and arguments of a stub against what is there."""
    members = {}
    for node in stub:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            members[node.name] = node
        elif isinstance(node, ast.AnnAssign):
            members[node.target.id] = node
    there = {name for name in vars(live) if shown(name)} | ({"__version__"} if live is _core else set())
    assert set(members) == there, where
    for name, node in members.items():
        own = getattr(live, name)
        if isinstance(node, ast.ClassDef):
            compared(node.body, own, f"{where}.{name}")
        elif isinstance(node, ast.FunctionDef) and name not in ("__len__", "__getitem__"):
            assert names_of(node.args) == parameters(own), f"{where}.{name}"
            assert own.__doc__, f"{where}.{name} has no docstring"


def test_the_stubs_are_those_of_the_compiled_part():
    stub = ast.parse((SOURCE / "_core.pyi").read_text(encoding="utf-8"))
    compared(stub.body, _core, "_core")
    assert (SOURCE / "py.typed").exists()


def test_everything_that_is_offered_has_a_docstring():
    for name in slideline.__all__:
        own = getattr(slideline, name)
        if name == "__version__":
            continue
        assert own.__doc__, name
        if inspect.isclass(own) and own.__module__.startswith("slideline"):
            for member, value in vars(own).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    assert value.__doc__, f"{name}.{member}"


def seconds_of_import():
    """Processor time that `import slideline` takes beyond NumPy's, least of several."""
    code = (
        "import time, numpy; began = time.process_time(); import slideline; "
        "print(time.process_time() - began)"
    )
    run = lambda: float(subprocess.run([sys.executable, "-c", code], check=True, capture_output=True).stdout)
    return min(run() for _ in range(5))


def test_import_is_fast():
    """Requirement: at most 50 ms beyond NumPy's."""
    assert seconds_of_import() <= 0.05


def test_the_version_is_that_of_the_program():
    assert slideline.__version__ == _core.__version__
    try:
        assert importlib.metadata.version("slideline") == slideline.__version__
    except importlib.metadata.PackageNotFoundError:
        pytest.skip("slideline is not installed: it runs from its folder")


@pytest.mark.parametrize(
    ("variable", "tags", "compiled"),
    [
        ("SLIDELINE_WHEEL", "cp310-abi3", "_core.abi3.so"),
        ("SLIDELINE_FREE_WHEEL", "cp314-cp314t", "_core.cpython-314t-"),
    ],
)
def test_wheels_are_for_all_pythons_and_small(variable, tags, compiled):
    """Requirement: abi3 from 3.10 and one for free-threaded Python, which has no stable ABI before 3.15;
    each under 12 MB. `.ci/python` says where the wheels are."""
    wheel = os.environ.get(variable)
    if wheel is None:
        pytest.skip("no wheel was built: .ci/python does it")
    name = Path(wheel).name
    assert name.startswith(f"slideline-{slideline.__version__}-{tags}-"), name
    assert Path(wheel).stat().st_size < 12_000_000
    with zipfile.ZipFile(wheel) as files:
        inside = files.namelist()
        [described] = [own for own in inside if own.endswith(".dist-info/WHEEL")]
        assert f"Tag: {tags}-".encode() in files.read(described)
    assert {"slideline/py.typed", "slideline/_core.pyi"} <= set(inside)
    assert any(own.startswith(f"slideline/{compiled}") for own in inside), inside
    assert not any("test" in own for own in inside)
