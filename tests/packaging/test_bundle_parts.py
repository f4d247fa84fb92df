"""What a bundle may hold: libraries that something needs, under licences that allow it."""

from __future__ import annotations

import runpy
from pathlib import Path
from types import SimpleNamespace

import pytest

PACKAGING = Path(__file__).parents[2] / "packaging"
pruning = SimpleNamespace(**runpy.run_path(str(PACKAGING / "pruning.py")))
licences = SimpleNamespace(**runpy.run_path(str(PACKAGING / "licences.py")))

NEEDS = {
    "module.so": ["libused.so.1", "libsystem.so"],
    "libused.so.1": ["libdeep.so"],
    "libdeep.so": ["libused.so.1"],
    "libplugin.so": ["liblonely.so"],
}


@pytest.fixture
def bundle(tmp_path: Path) -> list[tuple[str, str, str]]:
    places = (
        *("p/module.so", "p/libused.so.1", "p/libdeep.so", "p/liblonely.so"),
        *("q/plugins/libplugin.so", "libpython3.11.so.1.0", "data/words.txt"),
        "p/lib.cpython-311-x86_64-linux-gnu.so",
    )
    entries = []
    for place in places:
        path = tmp_path / Path(place).name
        path.write_bytes(b"words" if path.suffix == ".txt" else b"\x7fELF")
        entries.append((place, str(path), "BINARY"))
    return [*entries, ("libused.so.1", "p/libused.so.1", "SYMLINK")]


def places(entries: list[tuple[str, str, str]], unwanted: list[str]) -> set[str]:
    kept = pruning.prune(entries, [".", "p"], unwanted, lambda f: NEEDS.get(Path(f).name, []))
    return {e[0] for e in kept}


def test_all_stays_that_is_needed(bundle: list[tuple[str, str, str]]) -> None:
    assert places(bundle, []) == {e[0] for e in bundle}


def test_what_only_the_unwanted_needed_goes_too(bundle: list[tuple[str, str, str]]) -> None:
    gone = {e[0] for e in bundle} - places(bundle, ["q/plugins/*"])
    assert gone == {"q/plugins/libplugin.so", "p/liblonely.so"}


def test_links_go_with_their_file_and_rings_do_not_hold(
    bundle: list[tuple[str, str, str]],
) -> None:
    left = places(bundle, ["p/module.so"])
    gone = {"p/module.so", "p/libused.so.1", "p/libdeep.so", "libused.so.1"}
    assert {e[0] for e in bundle} - left == gone


def test_needed_by_reads_a_real_library() -> None:
    import _ctypes

    assert any(name.startswith("libc.so") for name in pruning.needed_by(_ctypes.__file__))


@pytest.mark.parametrize(
    ("licence", "allowed"),
    [
        ("MIT", True),
        ("LGPL-3.0-only OR GPL-2.0-only OR GPL-3.0-only", True),
        ("GNU Lesser General Public License v3 (LGPLv3)", True),
        ("GPL-3.0-or-later WITH GCC-exception-3.1", True),
        ("BSD-3-Clause AND GPL-2.0-only", False),
        ("GPL-3.0-or-later", False),
        ("GNU General Public License v3 (GPLv3)", False),
        ("AGPL-3.0-only", False),
        ("GNU Affero General Public License v3", False),
        ("GPLv2+", False),
        ("", False),
    ],
)
def test_copyleft_is_told_from_the_rest(licence: str, allowed: bool) -> None:
    assert licences.is_allowed(licence) == allowed


def test_a_library_that_nobody_knows_is_refused(tmp_path: Path) -> None:
    for name in ("libxcb-cursor.so.0", "libreadline.so.8", "libsecret.so.1"):
        (tmp_path / name).touch()
    known = {"libx": "GPL-2.0-only", "libxcb": "MIT", "libreadline": "GPL-3.0-or-later"}
    told = licences.refused(licences.libraries(tmp_path, known))
    assert told == [
        "libreadline.so.8: GPL-3.0-or-later",
        "libsecret.so.1: its licence is not known",
    ]


def test_libraries_within_wheels_are_asked_too(tmp_path: Path) -> None:
    """FFmpeg tells by itself whether it was built with its GPL parts."""
    wheel = tmp_path / "opencv.libs"
    wheel.mkdir()
    (wheel / "libaom-1a.so").touch()
    (wheel / "libavcodec-2b.so").write_bytes(b"\0libavcodec license: LGPL version 2.1 or later\0")
    (wheel / "libavutil-3c.so").write_bytes(b"\0libavutil license: GPL version 3 or later\0")
    found = list(licences.libraries(tmp_path, {"libaom-": "BSD-2-Clause"}))
    assert {p.name: p.licence for p in found}["libavcodec-2b.so"] == "LGPL version 2.1 or later"
    assert licences.refused(found) == ["libavutil-3c.so: GPL version 3 or later"]


def test_parts_are_found_by_the_files_they_own(tmp_path: Path) -> None:
    """The lists as PyInstaller leaves them: a file of numpy's and one of nobody's."""
    import numpy as np

    own, other = Path(np.__file__), tmp_path / "other.py"
    entry = ("numpy", str(own), "PYMODULE")
    (tmp_path / "PYZ-00.toc").write_text(repr(("x.pyz", [entry])))
    (tmp_path / "COLLECT-00.toc").write_text(repr(([("other.py", str(other), "DATA")],)))
    parts = list(licences.packages(licences.sources(tmp_path), {}))
    assert [p.name for p in parts] == ["numpy"]
    assert "BSD-3-Clause" in licences.as_text(parts)
    assert "NumPy Developers" in licences.as_text(parts)
