"""The kernel that fits a finger's last segment to the cloth, by truth and by sums over samples."""

import numpy as np
import pytest

from tests.cloth_masks import cloth_of, looked_at
from tracker.messages import Array
from tracker.vision import end_cloth
from tracker.vision.cloth import INSIDE, OUTSIDE, cloth_map
from tracker.vision.end_cloth import (
    EndImages,
    ExpectedEnd,
    end_evidence,
    fit_end,
    part_side,
    part_start,
)
from tracker.vision.finger_cloth import SAMPLES, SPACING, cloth_window
from tracker.vision.rig import StereoRig, ideal_rig

JOINT, RADIUS, LENGTH = np.array([0.01, -0.02, 0.4]), 0.0085, 0.02
SD = np.deg2rad([15.0, 4.0])


@pytest.fixture
def rig() -> StereoRig:
    return ideal_rig()


def pointing(flexion: float, lateral: float) -> Array:
    """(3,) m from the joint to the middle of the tip; both rotations are visible in images."""
    c, s = np.cos(flexion), np.sin(flexion)
    return LENGTH * np.array([c * np.cos(lateral), s, -c * np.sin(lateral)])


def expected(flexion: float = 0.0) -> ExpectedEnd:
    J = LENGTH * np.array([[0.0, 1.0, 0.0], [0.0, 0.0, -1.0]])
    axis = LENGTH * np.array([1.0, 0.0, 0.0])
    return ExpectedEnd(JOINT, axis, J, RADIUS, np.array([flexion, 0.0]), np.diag(SD**2))


def images(rig: StereoRig, arm: Array | None, known: Array | None = None) -> EndImages:
    """Both windows of a segment along ``arm``, with its own cap at the joint."""
    pitch = SPACING * rig.fx / JOINT[2]
    windows, sums = [], []
    for right in (False, True):
        camera = rig.right if right else rig.left
        x, y = looked_at(camera.height, camera.width)
        mask = np.zeros(x.shape, bool)
        if arm is not None:
            a, b = rig.project(np.stack([JOINT, JOINT + arm]), right)
            t = ((x - a[0]) * (b - a)[0] + (y - a[1]) * (b - a)[1]) / ((b - a) @ (b - a) + 1e-9)
            t = np.clip(t, 0.0, 1.0)
            away = np.hypot(x - a[0] - t * (b - a)[0], y - a[1] - t * (b - a)[1])
            mask = away <= rig.fx * RADIUS / JOINT[2]
        start = rig.project(JOINT[None], right)[0] - SAMPLES / 2 * pitch
        window = np.array([rig.baseline if right else 0.0, *start, pitch])
        classes, _ = cloth_window(cloth_map(cloth_of(mask)), window, camera.optics, False)
        covered = np.zeros((SAMPLES, SAMPLES)) if known is None else known
        windows.append(window)
        sums.append(end_evidence(classes, covered, np.zeros_like(covered), pitch**2, (0, 0)))
    return EndImages(rig.intrinsics, np.array(windows), np.array(sums))


@pytest.mark.parametrize("degrees", [-25.0, 0.0, 12.0, 35.0])
def test_a_visible_bend_is_found(rig: StereoRig, degrees: float) -> None:
    """Cloth is sampled every 2 px, 0.6 mm here: 3° of 20 mm are 1 mm."""
    found = fit_end(expected(), images(rig, pointing(np.deg2rad(degrees), 0.0)), 1.0)
    assert found[0] > 5.0
    assert found[1] == pytest.approx(np.deg2rad(degrees), abs=np.deg2rad(5.0))
    assert abs(found[1] - np.deg2rad(degrees)) < 3.0 * np.sqrt(found[3])
    assert np.sqrt(found[3]) < 0.6 * SD[0]


def test_the_bend_is_relative_to_the_expected_one(rig: StereoRig) -> None:
    seen = images(rig, pointing(np.deg2rad(21.0), 0.0))
    assert fit_end(expected(np.deg2rad(21.0)), seen, 1.0)[1] == pytest.approx(
        0.0, abs=np.deg2rad(2.0)
    )


@pytest.mark.parametrize("degrees", [-40.0, 10.0])
def test_samples_far_from_the_segment_are_not_needed(rig: StereoRig, degrees: float) -> None:
    """The part of a window that is evaluated contains all that the result depends on."""
    end, whole = expected(), images(rig, pointing(np.deg2rad(degrees), 0.1))
    windows, sums, side = [], [], part_side(end)
    for window, rows in zip(whole.windows, whole.sums, strict=True):
        left, top = part_start(end, rig.intrinsics, window)
        assert 0 < left < left + side < SAMPLES and 0 < top < top + side < SAMPLES
        part = rows[:, top : top + side, left : left + side + 1]
        sums.append(part - part[..., :1])
        windows.append(window + window[3] * np.array([0.0, left, top, 0.0]))
    found = fit_end(end, EndImages(rig.intrinsics, np.array(windows), np.array(sums)), 1.0)
    assert side < SAMPLES / 2
    assert found == pytest.approx(fit_end(end, whole, 1.0), abs=1e-9)


def test_no_cloth_contradicts_the_segment(rig: StereoRig) -> None:
    assert fit_end(expected(), images(rig, None), 1.0)[0] < 0.0


def test_where_other_parts_explain_everything_nothing_is_learned(rig: StereoRig) -> None:
    everything = np.ones((SAMPLES, SAMPLES))
    likely, *mean, a, b, c = fit_end(expected(), images(rig, pointing(0.4, 0.0), everything), 1.0)
    assert likely == 0.0
    assert mean == pytest.approx([0.0, 0.0], abs=1e-9)
    # The grid ends at three standard deviations, and the joint's displacement and steps widen it.
    assert [a, c] == pytest.approx(SD**2, rel=0.5)
    assert abs(b) < 0.05 * SD[0] * SD[1]


def test_less_independent_evidence_gives_a_wider_result(rig: StereoRig) -> None:
    seen = images(rig, pointing(np.deg2rad(20.0), 0.0))
    whole, part = fit_end(expected(), seen, 1.0), fit_end(expected(), seen, 0.1)
    assert part[3] > whole[3]
    assert abs(part[1]) < abs(whole[1])


def test_sums_along_rows_are_those_of_the_covered_samples() -> None:
    rng = np.random.default_rng(4)
    classes = rng.choice([INSIDE, OUTSIDE], (SAMPLES, SAMPLES)).astype(np.uint8)
    free = np.zeros((SAMPLES, SAMPLES))
    sums = end_evidence(classes, free, free, end_cloth.PIXELS_ALIKE, (0, 0))
    inner = np.where(
        classes == INSIDE,
        end_cloth.CLOTH_COVERED - end_cloth.CLOTH_BESIDE,
        end_cloth.NONE_COVERED - end_cloth.NONE_BESIDE,
    )
    y, x = np.mgrid[:SAMPLES, :SAMPLES]
    for a, b, r in (((40.3, 30.1), (52.7, 44.9), 5.3), ((20.0, 60.5), (20.0, 71.0), 4.1)):
        (u, v), (du, dv) = a, np.subtract(b, a)
        t = np.clip(((x - u) * du + (y - v) * dv) / (du * du + dv * dv), 0.0, 1.0)
        away = np.hypot(x - u - t * du, y - v - t * dv) - r
        exact = inner[away < 0.0].sum()
        # Samples that the outline cuts count as a share in the kernel and as 0 or 1 here.
        cut = np.sqrt(np.sum(inner[np.abs(away) < 0.75] ** 2))
        assert end_cloth._covered_sum(sums[0], a, b, r) == pytest.approx(exact, abs=1.5 * cut)
        assert abs(exact) + cut > 1.0
