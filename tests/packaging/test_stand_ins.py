"""The small libraries that stand in for large ones, compiled and called."""

from __future__ import annotations

import ctypes
import platform
import runpy
import shutil
import struct
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

PACKAGING = Path(__file__).parents[2] / "packaging"
stand_ins = SimpleNamespace(**runpy.run_path(str(PACKAGING / "stand_ins.py")))

pytestmark = pytest.mark.skipif(
    not sys.platform.startswith("linux")
    or platform.machine() not in stand_ins.JUMP
    or shutil.which("cc") is None
    or shutil.which("nm") is None,
    reason="needs a C compiler on Linux",
)


def test_functions_are_passed_on_with_their_arguments(tmp_path: Path) -> None:
    bundle = tmp_path
    for folder in ("scipy.libs", "cv2", "opencv_python_headless.libs"):
        (bundle / folder).mkdir()
    large = bundle / "opencv_python_headless.libs" / "libopenblas-1.so"
    real = bundle / "scipy.libs" / "libscipy_openblas-1.so"
    module = bundle / "cv2" / "cv2.abi3.so"
    sum_of = "double {}(double a, double *b, int c) {{ return a + b[0] + c; }}"
    stand_ins.build(sum_of.format("dgemm_") + "int unused_(void) { return 0; }", "c", large)
    stand_ins.build(sum_of.format("scipy_dgemm_"), "c", real)
    stand_ins.build("double dgemm_(); void *f = dgemm_;", "c", module, str(large))
    stand_ins.replace_opencv_blas(bundle, platform.machine())
    assert stand_ins.symbols(large, defined=True) == {"dgemm_"}
    dgemm = ctypes.CDLL(str(large)).dgemm_
    dgemm.restype = ctypes.c_double
    dgemm.argtypes = [ctypes.c_double, ctypes.POINTER(ctypes.c_double), ctypes.c_int]
    assert dgemm(0.5, ctypes.byref(ctypes.c_double(0.25)), 3) == 3.75


def test_a_function_that_is_nowhere_else_keeps_the_large_library(tmp_path: Path) -> None:
    bundle = tmp_path
    for folder in ("scipy.libs", "cv2", "opencv_python_headless.libs"):
        (bundle / folder).mkdir()
    large = bundle / "opencv_python_headless.libs" / "libopenblas-1.so"
    stand_ins.build("int dgesv_(void) { return 7; }", "c", large)
    stand_ins.build(
        "int other(void) { return 0; }", "c", bundle / "scipy.libs/libscipy_openblas-1.so"
    )
    stand_ins.build("int dgesv_(); void *f = dgesv_;", "c", bundle / "cv2/cv2.abi3.so", str(large))
    before = large.read_bytes()
    stand_ins.replace_opencv_blas(bundle, platform.machine())
    assert large.read_bytes() == before


def test_icu_finds_an_empty_table(tmp_path: Path) -> None:
    """Read as ICU's udata.cpp does: header size, magic, "ToCP", then a count of entries."""
    target = tmp_path / "PySide6/Qt/lib/libicudata.so.73"
    target.parent.mkdir(parents=True)
    target.touch()
    stand_ins.replace_icu_data(tmp_path)
    data = bytes((ctypes.c_char * 40).in_dll(ctypes.CDLL(str(target)), "icudt73_dat"))
    header_size, magic = struct.unpack_from("<H2s", data)
    assert (header_size, magic, data[12:16]) == (32, b"\xda\x27", b"ToCP")
    assert struct.unpack_from("<I", data, header_size) == (0,)
