"""Inputs found by fuzzing are still read or rejected, and so are randomly damaged ones."""

from __future__ import annotations

import time
import tracemalloc
from pathlib import Path

import numpy as np
import pytest

from tests.fuzz.examples import examples
from tests.fuzz.targets import INFO, TARGETS, topics

FOUND = Path(__file__).with_name("found")
SECONDS, BYTES = 2.0, 10**9
CASES = sorted(p.relative_to(FOUND).as_posix() for p in FOUND.rglob("*") if p.is_file())


def read(name: str, data: bytes) -> None:
    """Within the time and memory limits for a file of this size."""
    topics()  # created once, independent of the file
    tracemalloc.start()
    began = time.process_time()
    TARGETS[name](data)
    took = time.process_time() - began
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert took < SECONDS and peak < BYTES


@pytest.mark.parametrize("case", CASES)
def test_found_inputs_are_read_or_rejected(case: str) -> None:
    read(case.split("/")[0], (FOUND / case).read_bytes())


@pytest.mark.long
@pytest.mark.parametrize("name", sorted(TARGETS))
def test_damaged_examples_are_read_or_rejected(name: str) -> None:
    """Bytes changed, removed, doubled and inserted; shallow, but in every test run."""
    rng = np.random.default_rng(sorted(TARGETS).index(name))
    for example in examples(name, INFO, topics()):
        read(name, example)
        for _ in range(6):
            read(name, damaged(example, rng))


def damaged(data: bytes, rng: np.random.Generator) -> bytes:
    out = bytearray(data)
    for _ in range(int(rng.integers(1, 5))):
        at, length = int(rng.integers(len(out) + 1)), int(rng.integers(1, 9))
        kind = rng.integers(4)
        if kind == 0:
            out[at : at + length] = rng.bytes(length)
        elif kind == 1:
            del out[at : at + length]
        elif kind == 2:
            out[at:at] = out[at : at + 40]
        else:
            out[at : at + length] = b"\xff" * length
    return bytes(out)
