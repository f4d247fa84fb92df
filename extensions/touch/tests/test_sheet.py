"""The printed sheet: found in its own PDF's drawing and in simulated images, with its true size."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from extensions.sheets.page import PAPERS_MM
from extensions.touch import sheet
from extensions.touch.page import touch_pages
from extensions.touch.pose import SheetFinder, find_sheet
from extensions.touch.sheet import CROSSES, TouchSheet
from extensions.touch.simulated.images import SheetPlace, placed_sheet, sheet_frames
from tracker.base.errors import ConfigError
from tracker.cli import main
from tracker.messages import Array, CameraPose
from tracker.vision.lenses import with_one_camera
from tracker.vision.rig import Camera, StereoRig, ideal_rig

PX_PER_MM = 10


def drawn(paper: str) -> tuple[Array, Array]:
    """Both pages as grey images of ten pixels a millimetre."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    out = []
    for page in touch_pages(paper):
        page.figure.set_dpi(25.4 * PX_PER_MM)
        canvas = FigureCanvasAgg(page.figure)
        canvas.draw()
        rgb = np.asarray(canvas.buffer_rgba())[..., :3].copy()
        out.append(cv2.cvtColor(rgb, cv2.COLOR_RGB2GRAY))
    return out[0], out[1]


def similarity(corners, ids) -> tuple[Array, Array, float]:
    """Image px from sheet mm: (2, 2), (2,), and the largest misfit in px."""
    points = TouchSheet().points(ids)[:, :2] * 1000
    design = np.column_stack([points, np.ones(len(points))])
    solution = np.linalg.lstsq(design, corners, rcond=None)[0]
    return solution[:2].T, solution[2], float(np.abs(design @ solution - corners).max())


@pytest.mark.parametrize("paper", PAPERS_MM)
def test_the_page_has_frame_crosses_and_ruler_at_true_scale(paper: str) -> None:
    page, _ = drawn(paper)
    found = SheetFinder().find(page)
    assert found is not None and len(found) == len(TouchSheet().corner_ids) == 36
    A, b, off = similarity(found.uv, found.ids)
    assert off < 0.7 and np.allclose(A, PX_PER_MM * np.eye(2), atol=0.02)
    for cross in CROSSES:
        u, v = np.round(A @ cross.p_S[:2] * 1000 + b).astype(int)
        dark = page[v - 2 : v + 3, u - 2 : u + 3].min() < 128
        assert dark == (cross.height == 0), cross.name


def test_the_strip_folds_to_a_ridge_of_the_stated_height() -> None:
    _, strip = drawn("a4")
    strip = strip[30 * PX_PER_MM :]  # below the heading
    lines = np.flatnonzero((strip < 160).sum(axis=1) > 0.4 * sheet.RIDGE_LENGTH * 1e4)
    edges = lines[np.r_[True, np.diff(lines) > 20]]
    parts_mm = np.diff(edges) / PX_PER_MM
    assert parts_mm == pytest.approx([15, 25, 20, 25, 15], abs=0.4)
    assert {c.height for c in CROSSES} == {0.0, sheet.RIDGE_HEIGHT}


def test_print_writes_two_pages_the_same_each_time(tmp_path: Path) -> None:
    first, again = tmp_path / "a.pdf", tmp_path / "b.pdf"
    for path in (first, again):
        assert main(["print", "touch", "-o", str(path)]) == 0
    assert first.read_bytes() == again.read_bytes()
    assert len(re.findall(rb"/MediaBox", first.read_bytes())) == 2


@pytest.fixture(scope="module")
def rig() -> StereoRig:
    return ideal_rig()


@pytest.mark.long
@pytest.mark.parametrize("scale", [1.0, 0.99])
def test_pose_and_scale_of_a_simulated_print_are_found(rig: StereoRig, scale: float) -> None:
    """Targets within 0.5 mm; a print that is 1 % too small is reported, a correct one is not."""
    place = placed_sheet(3, scale)
    pose = find_sheet(sheet_frames(place, rig, 2, 3), rig)
    assert pose.scale == pytest.approx(scale, abs=0.002)
    assert abs(pose.scale - scale) < 4 * pose.scale_sd
    off = [np.linalg.norm(pose.target(c.p_S) - place.target(c.p_S)) for c in CROSSES]
    assert max(off) < 5e-4
    codes = {n.code for n in pose.notices()}
    assert ("touch.print_scale" in codes) == (scale != 1.0)
    assert "touch.no_ruler" in codes and "touch.sheet_moved" not in codes


def wrong_baseline(rig: StereoRig, factor: float) -> StereoRig:
    """A calibration with a baseline that is too long."""
    right, P = rig.right, rig.right.P.copy()
    P[0, 3] *= factor
    return replace(rig, right=Camera(right.width, right.height, right.K, right.D, right.R, P))


@pytest.mark.long
def test_a_ruler_separates_print_scale_from_camera_error(rig: StereoRig) -> None:
    frames = list(sheet_frames(placed_sheet(5), rig, 1, 5))
    camera_wrong = find_sheet(frames, wrong_baseline(rig, 1.01), ruler=0.260)
    assert {n.code for n in camera_wrong.notices()} == {"touch.camera_scale"}
    small = list(sheet_frames(placed_sheet(5, 0.99), rig, 1, 5))
    print_wrong = find_sheet(small, rig, ruler=0.2574)
    assert {n.code for n in print_wrong.notices()} == {"touch.print_scale"}


@pytest.mark.long
def test_a_sheet_that_moves_is_noticed(rig: StereoRig) -> None:
    place = placed_sheet(2)
    shifted = SheetPlace(place.R_GS, place.p_GS + [0.004, 0, 0])
    frames = [*sheet_frames(place, rig, 2, 2), *sheet_frames(shifted, rig, 2, 2)]
    codes = [n.code for n in find_sheet(frames, rig).notices()]
    assert "touch.sheet_moved" in codes


def test_one_lens_finds_the_pose_but_no_scale(rig: StereoRig) -> None:
    place, one = placed_sheet(4), with_one_camera(rig)
    frames = [replace(f, right=None) for f in sheet_frames(place, rig, 1, 4)]
    pose = find_sheet(frames, one)
    assert np.isnan(pose.scale) and pose.print_scale == 1.0
    assert np.linalg.norm(pose.target(CROSSES[0].p_S) - place.target(CROSSES[0].p_S)) < 1e-3


def test_without_the_sheet_there_is_an_error(rig: StereoRig) -> None:
    away = CameraPose(rig.pose.R_GC, rig.pose.p_GC + [0.0, 5.0, 0.0])
    frames = sheet_frames(placed_sheet(1), replace(rig, pose=away), 1, 1)
    with pytest.raises(ConfigError) as caught:
        find_sheet(frames, rig)
    assert caught.value.notice.code == "touch.no_sheet"
