"""Compiled kernels that are kept for other checkouts."""

from __future__ import annotations

import os
import sysconfig
from pathlib import Path

import pytest

from tracker.kernels import kept

SUFFIX = sysconfig.get_config_var("EXT_SUFFIX")


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "checkout"
    folder.mkdir()
    monkeypatch.setattr(kept, "HERE", folder)
    monkeypatch.setenv(kept.FOLDER, str(tmp_path / "cache"))
    return folder


def test_what_was_compiled_from_the_same_comes_back(here: Path) -> None:
    module = here / f"_compiled_part{SUFFIX}"
    module.write_bytes(b"machine code")
    kept.keep("made of this", "_compiled_part")
    module.unlink()
    assert kept.fetch("made of this", "_compiled_part")
    assert module.read_bytes() == b"machine code"
    assert not kept.fetch("made of something else", "_compiled_part")


def test_no_more_folders_than_are_wanted(here: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kept, "AT_MOST", 2)
    (here / f"_m{SUFFIX}").write_bytes(b"")
    cache = Path(os.environ[kept.FOLDER])
    for age, made_of in enumerate(["oldest", "older", "old"]):
        kept.keep(made_of, "_m")
        for folder in cache.iterdir():
            if folder.stat().st_mtime > 1e9:
                os.utime(folder, (age, age))
    kept.keep("new", "_m")
    assert [kept.fetch(m, "_m") for m in ("oldest", "older", "old", "new")] == [
        *(False, False),
        *(True, True),
    ]


def test_without_a_folder_nothing_is_kept(here: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(kept.FOLDER, "")
    (here / f"_m{SUFFIX}").write_bytes(b"")
    kept.keep("x", "_m")
    assert not kept.fetch("x", "_m")


def test_a_cache_that_cannot_be_written_stops_nothing(
    here: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv(kept.FOLDER, str(tmp_path / "file" / "cache"))
    (here / f"_m{SUFFIX}").write_bytes(b"")
    kept.keep("x", "_m")
    assert not kept.fetch("x", "_m")
