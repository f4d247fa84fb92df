"""The project as a whole: versions, pinned packages, the files it ships, its inner borders."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tomllib
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

import tracker
from tracker.glove.files import glove_hand_name, load_glove
from tracker.glove.model import GloveModel
from tracker.hand.files import load_hand
from tracker.hand.model import HandModel
from tracker.vision.colours import load_profile

ROOT = Path(__file__).parents[1]
RESOURCES = ROOT / "resources"
HANDS = sorted((RESOURCES / "hands").glob("*.toml"))
GLOVES = sorted((RESOURCES / "gloves").glob("*.toml"))
COLOURS = sorted((RESOURCES / "colours").glob("*.toml"))
MIRROR = np.diag([1.0, -1.0, 1.0])  # of a right hand into a left one


def project() -> dict[str, Any]:
    return tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def tracked_files() -> list[Path]:
    if not (ROOT / ".git").exists() or shutil.which("git") is None:
        pytest.skip("needs a git checkout")
    listed = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    return [path for name in listed.stdout.split("\0") if name and (path := ROOT / name).is_file()]


def load_shipped_glove(path: Path) -> tuple[GloveModel, HandModel]:
    hand_name = glove_hand_name(path.read_text(), path.name)
    hand = load_hand(RESOURCES / "hands" / f"{hand_name}.toml")
    return load_glove(path, hand), hand


def test_the_version_is_the_same_everywhere() -> None:
    assert project()["version"] == tracker.__version__ == version("glovetrack")


def test_the_lock_pins_what_the_project_asks_for() -> None:
    lines = (ROOT / "requirements.lock").read_text().splitlines()
    pins = [line for line in lines if not line.startswith("#")]
    assert pins == sorted(pins, key=str.lower)
    locked = {canonicalize_name(n): v for n, v in (pin.split("==") for pin in pins)}
    assert len(locked) == len(pins)
    extras = project()["optional-dependencies"]
    for text in [*project()["dependencies"], *extras["test"], *extras["peers"]]:
        asked = Requirement(text)
        assert asked.specifier.contains(locked[canonicalize_name(asked.name)]), text


@pytest.mark.parametrize("path", HANDS, ids=lambda p: p.stem)
def test_shipped_hands_load_under_their_file_name(path: Path) -> None:
    assert load_hand(path).name == path.stem


@pytest.mark.parametrize("path", GLOVES, ids=lambda p: p.stem)
def test_shipped_gloves_load_and_fit_their_hands(path: Path) -> None:
    glove, hand = load_shipped_glove(path)
    assert glove.name == path.stem
    assert set(glove.hues) <= {hue.name for hue in load_profile(COLOURS[0]).hues}
    for marker in glove.markers:
        segment = hand.segments[hand.index[marker.segment]]
        assert -0.01 <= marker.position[0] <= segment.length + 0.015
        assert marker.position @ marker.normal > 0, "turned into the hand"


@pytest.mark.parametrize("path", COLOURS, ids=lambda p: p.stem)
def test_shipped_colour_profiles_load(path: Path) -> None:
    assert load_profile(path).name == path.stem


@pytest.mark.parametrize("path", [p for p in HANDS if "left" in p.stem], ids=lambda p: p.stem)
def test_a_left_hand_mirrors_its_right_one(path: Path) -> None:
    left = load_hand(path)
    right = load_hand(path.with_stem(path.stem.replace("left", "right")))
    assert (left.side, right.side) == ("left", "right")
    assert left.segment_names == right.segment_names
    for a, b in zip(left.segments, right.segments, strict=True):
        assert (a.parent, a.length, a.radius, a.width) == (b.parent, b.length, b.radius, b.width)
        assert_allclose(a.origin, MIRROR @ b.origin, atol=1e-9)
        assert_allclose(a.R_rest, MIRROR @ b.R_rest @ MIRROR, atol=1e-7)
    for a, b in zip(left.joints, right.joints, strict=True):
        assert (a.name, a.child, a.axes) == (b.name, b.child, b.axes)
        for axis in a.axes:
            low, high = b.limits[axis]
            assert_allclose(
                a.limits[axis], (low, high) if axis == "flexion" else (-high, -low), atol=1e-9
            )
    assert left.synergies == right.synergies


@pytest.mark.parametrize("path", [p for p in GLOVES if "left" in p.stem], ids=lambda p: p.stem)
def test_a_left_glove_mirrors_its_right_one(path: Path) -> None:
    left, left_hand = load_shipped_glove(path)
    right, right_hand = load_shipped_glove(path.with_stem(path.stem.removesuffix("-left")))
    assert (left.side, left_hand.side) == ("left", "left")
    assert left.hues == right.hues
    assert_allclose(left.marker_position, right.marker_position @ MIRROR, atol=1e-9)
    assert_allclose(left.marker_normal, right.marker_normal @ MIRROR, atol=1e-9)
    assert np.array_equal(left.marker_hue, right.marker_hue)
    assert np.array_equal(left.marker_segment(left_hand), right.marker_segment(right_hand))
    for a, b in zip(left.imus, right.imus, strict=True):
        assert (a.name, a.segment) == (b.name, b.segment)
        assert_allclose(a.position, MIRROR @ b.position, atol=1e-9)
    for a, b in zip(left.keypoints, right.keypoints, strict=True):
        assert (a.name, a.segment) == (b.name, b.segment)
        assert_allclose(a.position, MIRROR @ b.position, atol=1e-9)


def test_import_contracts_hold() -> None:
    lint_imports = Path(sys.executable).with_name("lint-imports")
    done = subprocess.run([lint_imports], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_no_file_knows_the_machine_it_was_written_on() -> None:
    somewhere = re.compile(rb"(?<![\w.}])/(work|farm|root|home/\w+)/")
    this = Path(__file__).resolve()
    guilty = [
        f"{path.relative_to(ROOT)}: {line.decode(errors='replace').strip()}"
        for path in tracked_files()
        if path != this and path.suffix not in {".png", ".svg"}
        for line in path.read_bytes().splitlines()
        if somewhere.search(line)
    ]
    assert not guilty


def test_scripts_parse_and_can_be_run() -> None:
    scripts = [p for p in tracked_files() if p.suffix == ".sh" or p.parent.name == ".ci"]
    assert len(scripts) >= 4
    for script in scripts:
        assert script.stat().st_mode & 0o100, f"{script.name} is not executable"
        subprocess.run(["bash", "-n", script], check=True)


@pytest.mark.parametrize("name", ["README.md", "resources/firmware/README.md"])
def test_links_of_a_readme_lead_somewhere(name: str) -> None:
    page = ROOT / name
    links = re.findall(r"\]\(([^)#]+)", page.read_text())
    for link in links:
        assert link.startswith("https://") or (page.parent / link).exists(), link
