"""A library compiled on one computer is valid on all: no constant depends on the processor."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from numpy.lib import introspect

ROOT = Path(__file__).parents[2]
FINGERPRINTS = """
import importlib
from tracker.kernels.exported import exported
from tracker.kernels.fingerprint import fingerprint
for name in sorted(exported()):
    module, _, function = name.rpartition(".")
    kernel = getattr(importlib.import_module(module), function)
    print(name, fingerprint(kernel.py_func, kernel.options))
"""


def fingerprints(blas: str, without: str = "") -> list[str]:
    """The environment of a computer with these instructions: of BLAS, and ``without`` some of
    NumPy's."""
    computer = {"OPENBLAS_CORETYPE": blas, "NPY_DISABLE_CPU_FEATURES": without}
    result = subprocess.run(
        [sys.executable, "-c", FINGERPRINTS],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT), **computer},
        capture_output=True,
        text=True,
        check=True,
    )
    return result.stdout.splitlines()


@pytest.mark.long
def test_kernels_have_the_same_fingerprints_on_other_processors() -> None:
    chosen = introspect.opt_func_info(func_name="^sin$", signature="float64")["sin"]
    best = str(next(iter(chosen.values()))["current"])
    plain = fingerprints("Nehalem", without="" if best.startswith("baseline") else best)
    assert len(plain) > 50
    has_avx512 = best == "X86_V4" or best.startswith("AVX512")
    assert fingerprints("SkylakeX" if has_avx512 else "Haswell") == plain
