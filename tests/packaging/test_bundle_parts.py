"""Permitted contents of a bundle: parts with suitable licences."""

from __future__ import annotations

import runpy
from pathlib import Path
from types import SimpleNamespace

import pytest

PACKAGING = Path(__file__).parents[2] / "packaging"
licences = SimpleNamespace(**runpy.run_path(str(PACKAGING / "licences.py")))


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
def test_copyleft_is_distinguished(licence: str, allowed: bool) -> None:
    assert licences.is_allowed(licence) == allowed


def test_an_unknown_library_is_rejected(tmp_path: Path) -> None:
    for name in ("libxcb-cursor.so.0", "libreadline.so.8", "libsecret.so.1"):
        (tmp_path / name).touch()
    known = {"libx": "GPL-2.0-only", "libxcb": "MIT", "libreadline": "GPL-3.0-or-later"}
    refusals = licences.refused(licences.libraries(tmp_path, known))
    assert refusals == [
        "libreadline.so.8: GPL-3.0-or-later",
        "libsecret.so.1: its licence is not known",
    ]


def test_libraries_within_wheels_are_checked_too(tmp_path: Path) -> None:
    """FFmpeg reports whether it was built with its GPL parts."""
    wheel = tmp_path / "opencv.libs"
    wheel.mkdir()
    (wheel / "libaom-1a.so").touch()
    (wheel / "libavcodec-2b.so").write_bytes(b"\0libavcodec license: LGPL version 2.1 or later\0")
    (wheel / "libavutil-3c.so").write_bytes(b"\0libavutil license: GPL version 3 or later\0")
    found = list(licences.libraries(tmp_path, {"libaom-": "BSD-2-Clause"}))
    assert {p.name: p.licence for p in found}["libavcodec-2b.so"] == "LGPL version 2.1 or later"
    assert licences.refused(found) == ["libavutil-3c.so: GPL version 3 or later"]


@pytest.mark.long
def test_parts_are_found_by_the_files_they_own(tmp_path: Path) -> None:
    """The lists as written by PyInstaller: a file of numpy's and an unknown one."""
    import numpy as np

    own, other = Path(np.__file__), tmp_path / "other.py"
    entry = ("numpy", str(own), "PYMODULE")
    (tmp_path / "PYZ-00.toc").write_text(repr(("x.pyz", [entry])))
    (tmp_path / "COLLECT-00.toc").write_text(repr(([("other.py", str(other), "DATA")],)))
    parts = list(licences.packages(licences.sources(tmp_path), {}))
    assert [p.name for p in parts] == ["numpy"]
    assert "BSD-3-Clause" in licences.as_text(parts)
    assert "NumPy Developers" in licences.as_text(parts)
