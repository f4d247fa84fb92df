"""The script that compares two builds reports differences, and nothing if there are none."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "packaging" / "same_build.sh"
pytestmark = pytest.mark.skipif(shutil.which("bash") is None, reason="needs bash")


def compare(a: Path, b: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([SCRIPT, a, b], capture_output=True, text=True, check=False)


def test_different_folders_are_reported_by_their_files(tmp_path: Path) -> None:
    for name, text in (("a", "one"), ("b", "another")):
        (tmp_path / name / "inside").mkdir(parents=True)
        (tmp_path / name / "same.txt").write_text("same")
        (tmp_path / name / "inside" / "other file.txt").write_text(text)
    (tmp_path / "a" / "alone.txt").write_text("")
    result = compare(tmp_path / "a", tmp_path / "b")
    assert result.returncode == 1
    assert result.stdout.splitlines() == ["./alone.txt", "./inside/other file.txt"]


def test_equal_folders_and_files_are_reported_as_such(tmp_path: Path) -> None:
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "file").write_bytes(b"same")
    for paths in ((tmp_path / "a", tmp_path / "b"), (tmp_path / "a/file", tmp_path / "b/file")):
        result = compare(*paths)
        assert (result.returncode, result.stdout) == (0, "Both are identical, byte for byte.\n")
    (tmp_path / "b" / "file").write_bytes(b"other")
    assert compare(tmp_path / "a/file", tmp_path / "b/file").returncode == 1
