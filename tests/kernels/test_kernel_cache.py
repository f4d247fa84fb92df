"""The cache of compiled kernels that checkouts share."""

from __future__ import annotations

import os
import sysconfig
from pathlib import Path

import pytest

from tracker.kernels import cache

SUFFIX = sysconfig.get_config_var("EXT_SUFFIX")


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "checkout"
    folder.mkdir()
    monkeypatch.setattr(cache, "HERE", folder)
    monkeypatch.setenv(cache.FOLDER, str(tmp_path / "cache"))
    return folder


def test_parts_compiled_from_the_same_source_are_fetched(here: Path) -> None:
    module = here / f"_compiled_part{SUFFIX}"
    module.write_bytes(b"machine code")
    cache.store("made of this", "_compiled_part")
    module.unlink()
    assert cache.fetch("made of this", "_compiled_part")
    assert module.read_bytes() == b"machine code"
    assert not cache.fetch("made of something else", "_compiled_part")


def test_no_more_folders_than_the_limit(here: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache, "AT_MOST", 2)
    (here / f"_m{SUFFIX}").write_bytes(b"")
    root = Path(os.environ[cache.FOLDER])
    for age, made_of in enumerate(["oldest", "older", "old"]):
        cache.store(made_of, "_m")
        for folder in root.iterdir():
            if folder.stat().st_mtime > 1e9:
                os.utime(folder, (age, age))
    cache.store("new", "_m")
    assert [cache.fetch(m, "_m") for m in ("oldest", "older", "old", "new")] == [
        *(False, False),
        *(True, True),
    ]


def test_without_a_folder_nothing_is_cached(here: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(cache.FOLDER, "")
    (here / f"_m{SUFFIX}").write_bytes(b"")
    cache.store("x", "_m")
    assert not cache.fetch("x", "_m")


def test_an_unwritable_cache_is_ignored(
    here: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv(cache.FOLDER, str(tmp_path / "file" / "cache"))
    (here / f"_m{SUFFIX}").write_bytes(b"")
    cache.store("x", "_m")
    assert not cache.fetch("x", "_m")
