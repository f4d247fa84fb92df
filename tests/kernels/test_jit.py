"""numba's disk cache, which is harmless when it is out of date."""

import importlib
import os
import sys

import pytest

pytest.importorskip("numba")
from tracker.kernels.jit import compiled

SOURCE = """
from typing import NamedTuple

class {name}(NamedTuple):
    x: float
    y: float

def total(pair):
    return pair.x + pair.y
"""


def imported(folder, name: str):
    """The module of `SOURCE` in ``folder`` with a named tuple called ``name``, reloaded.

    Its file has the same size and time for any name: numba identifies sources by these.
    """
    path = folder / "kept_kernels.py"
    path.write_text(SOURCE.format(name=name))
    os.utime(path, (1_000_000_000, 1_000_000_000))
    sys.modules.pop("kept_kernels", None)
    importlib.invalidate_caches()
    return importlib.import_module("kept_kernels")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    yield tmp_path
    sys.modules.pop("kept_kernels", None)


def called(module, name: str):
    """The kernel after one call, with a checked result."""
    made = compiled(module.total, {})
    assert made(getattr(module, name)(1.0, 2.0)) == 3.0
    return made.stats


def test_a_second_process_uses_the_compilation_of_the_first(folder) -> None:
    module = imported(folder, "Pair")
    assert sum(called(module, "Pair").cache_misses.values()) == 1
    assert sum(called(module, "Pair").cache_hits.values()) == 1


def test_kernels_of_a_renamed_tuple_are_recompiled(folder) -> None:
    called(imported(folder, "Pair"), "Pair")
    module = imported(folder, "Duet")
    assert sum(called(module, "Duet").cache_misses.values()) == 1
    assert sum(called(module, "Duet").cache_hits.values()) == 1
