"""What a bundled program does before anything else: its compiled kernels find their place."""

from __future__ import annotations

import os
import runpy
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

FROZEN = Path(__file__).parents[2] / "packaging" / "frozen"
start = SimpleNamespace(**runpy.run_path(str(FROZEN / "start.py")))

KERNEL = """
import numba

@numba.njit(cache=True)
def twice(x):
    return 2 * x
"""
USE = """
import sys
sys._MEIPASS, sys.path[:0] = sys.argv[1], sys.argv[1:3]
from engine.kernels import twice
assert twice(21) == 42
print(sum(twice.stats.cache_hits.values()))
"""


@pytest.fixture
def shipped(tmp_path: Path) -> Path:
    folder = tmp_path / "bundle" / "kernels"
    (folder / "vision").mkdir(parents=True)
    (folder / "vision" / "one.nbc").write_bytes(b"code")
    return folder


def test_kernels_are_copied_once_and_those_of_other_builds_go(
    shipped: Path, tmp_path: Path
) -> None:
    cache = tmp_path / "cache"
    (cache / "glovetrack" / "kernels-old").mkdir(parents=True)
    target = start.lay_out(shipped, "new", cache)
    assert target == cache / "glovetrack" / "kernels-new"
    assert (target / "vision" / "one.nbc").read_bytes() == b"code"
    assert [p.name for p in target.parent.iterdir()] == ["kernels-new"]
    (target / "later.nbc").touch()
    assert start.lay_out(shipped, "new", cache) == target
    assert (target / "later.nbc").exists()


def test_without_a_place_in_the_users_cache_there_is_another(
    shipped: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (shipped.parent / "BUILD").write_text("new\n")
    (tmp_path / "file").touch()  # where a folder would have to be; root may write everywhere
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    place = start.choose(shipped.parent)
    assert (place / "vision" / "one.nbc").exists()


def test_a_processor_is_known_by_its_flags() -> None:
    flags = "fpu avx avx2 bmi1 bmi2 f16c fma abm movbe sse4_2"
    assert start.has_level(f"processor : 0\nflags\t\t: {flags}\n")
    assert not start.has_level(f"flags : {flags.replace('avx2', '')}\n")
    assert not start.has_level("Features : fp asimd\n")  # arm64 has other words


def test_compiled_kernels_are_used_wherever_the_bundle_lies(tmp_path: Path) -> None:
    """The cache made in one folder serves the program in another one."""
    found = []
    for name in ("here", "there"):
        bundle = tmp_path / name
        (bundle / "engine").mkdir(parents=True)
        (bundle / "engine" / "__init__.py").touch()
        (bundle / "engine" / "kernels.py").write_text(KERNEL)
        environment = {
            **os.environ,
            start.PLACE: str(tmp_path / "cache"),
            "NUMBA_CACHE_LOCATOR_CLASSES": "kernel_locator.KernelLocator",
        }
        made = subprocess.run(
            [sys.executable, "-c", USE, str(bundle), str(FROZEN)],
            env=environment,
            capture_output=True,
            text=True,
        )
        assert made.returncode == 0, made.stderr
        found.append(int(made.stdout))
    assert found == [0, 1]
