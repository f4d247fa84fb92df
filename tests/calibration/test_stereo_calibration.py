"""A known rig is recovered from views of a board; wrong rigs are rejected."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import ConfigError, FileError
from tracker.base.notices import notice, warning
from tracker.calibration.stereo.board import (
    MARGIN,
    BoardSpec,
    board_image,
    page_size,
    print_image,
)
from tracker.calibration.stereo.checks import (
    Extrinsics,
    extrinsics_of,
    known_baseline_problems,
    quality_problems,
    rig_problems,
)
from tracker.calibration.stereo.collect import Collector, ExposureResult
from tracker.calibration.stereo.coverage import advice, coverage, shape_of
from tracker.calibration.stereo.files import MissingFacts, load_rig, save_calibration
from tracker.calibration.stereo.solve import CalibrationError, SolveParams, solve, view_errors
from tracker.calibration.stereo.verify import verify
from tracker.calibration.stereo.views import BoardFinder, BoardLook, StereoView
from tracker.geometry import so3
from tracker.sensors.stereo_calibration import Intrinsics, rectified_rig
from tracker.simulation.board_images import BoardPose, BoardRenderer, TrueRig, board_poses

WIDTH, HEIGHT = 640, 360
SIZES, SIZES_VGA = ((WIDTH, HEIGHT),) * 2, ((640, 480),) * 2
SPEC = BoardSpec()
NOISE_PX = 0.08


def camera(f: float, cx: float, cy: float) -> Intrinsics:
    K = np.array([[f, 0.0, cx], [0.0, f * 1.003, cy], [0.0, 0.0, 1.0]])
    return Intrinsics(WIDTH, HEIGHT, K, np.array([-0.17, 0.026, 0.0004, -0.0003, 0.0]))


RIG = TrueRig(
    camera(350.0, 327.0, 176.0),
    camera(352.0, 318.0, 183.0),
    so3.exp(np.array([0.004, 0.012, -0.003])),
    np.array([-0.063, 0.0004, -0.0002]),
)


def project(rig: TrueRig, p_C: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Pixels (n, 2) in both raw images of points (n, 3) of the left camera."""
    left, _ = cv2.projectPoints(p_C, np.zeros(3), np.zeros(3), rig.left.K, rig.left.D)
    right, _ = cv2.projectPoints(p_C, so3.log(rig.R), rig.T, rig.right.K, rig.right.D)
    return left.reshape(-1, 2), right.reshape(-1, 2)


def view_at(pose: BoardPose, rng: np.random.Generator, rig: TrueRig = RIG) -> StereoView:
    left, right = project(rig, SPEC.points @ pose.R_CB.T + pose.p_CB)
    noise = rng.normal(0, NOISE_PX, (2, len(left), 2))
    return StereoView(np.arange(SPEC.corner_count), SPEC.points, left + noise[0], right + noise[1])


@lru_cache
def views(count: int, seed: int) -> tuple[StereoView, ...]:
    rng = np.random.default_rng(seed)
    return tuple(view_at(p, rng) for p in board_poses(SPEC, RIG, count, seed))


@lru_cache
def solution():
    return solve(views(16, 1), SIZES)


def truth(**changes) -> Extrinsics:
    return replace(Extrinsics(RIG.left, RIG.right, RIG.R, RIG.T), **changes)


# --- the board


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"kind": "dots"}, "board.unknown_kind"),
        ({"columns": 3}, "board.square_count"),
        ({"square": 25.0}, "board.square_size"),
        ({"kind": "chessboard", "columns": 9, "rows": 7}, "board.symmetric"),
    ],
)
def test_an_impossible_board_is_rejected(change, words):
    with raises(ConfigError, words):
        replace(SPEC, **change)


@pytest.mark.parametrize("kind", ["charuco", "chessboard"])
def test_corners_of_the_printed_page_match_the_board(kind):
    """Viewed head-on, the page is the board at its scale, shifted by the margin."""
    spec = replace(SPEC, kind=kind)
    page, per_metre = print_image(spec, dpi=110)
    found = BoardFinder(spec).find(page)
    assert found is not None and len(found) == spec.corner_count
    margin = round(MARGIN * per_metre)
    expected = spec.points_of(found.ids)[:, :2] * per_metre + margin - 0.5
    assert found.uv == pytest.approx(expected, abs=0.1)


def test_the_default_board_fits_common_paper_sizes():
    width, height = page_size(SPEC)
    page, per_metre = print_image(SPEC)
    assert np.allclose(np.array(page.shape[::-1]) / per_metre, (width, height), atol=3e-4)
    for paper in ((0.297, 0.210), (0.2794, 0.2159)):
        assert (
            width < paper[0] - 0.008 and height < paper[1] - 0.008
        )  # unprintable margin of printers


def test_the_printed_ruler_is_100_mm_long():
    page, per_metre = print_image(SPEC, dpi=150)
    below = page[round(per_metre * (SPEC.height + MARGIN)) + 4 :]
    longest = max(below, key=lambda row: int((row < 128).sum()))
    assert (longest < 128).sum() / per_metre == pytest.approx(0.1, abs=1e-3)


# --- images


@pytest.mark.parametrize("kind", ["charuco", "chessboard"])
def test_corners_are_found_at_their_projections(kind):
    spec = replace(SPEC, kind=kind)
    renderer, finder = BoardRenderer(RIG, spec), BoardFinder(spec)
    rng, used = np.random.default_rng(2), 0
    R_CB = so3.exp(np.array([0.3, -0.35, 0.2]))
    for turn in (R_CB, R_CB @ so3.exp(np.array([0, 0, np.pi]))):
        centre = np.array([0.03, 0.0, 0.33])
        pose = BoardPose(turn, centre - turn @ [spec.width / 2, spec.height / 2, 0])
        look = finder.look(*renderer.pair(pose, rng))
        assert look.view is not None, look.problem
        p_C = look.view.points @ pose.R_CB.T + pose.p_CB
        for found, expected in zip(
            (look.view.left, look.view.right), project(RIG, p_C), strict=True
        ):
            # a corner of another number would be 10 px away
            assert np.sqrt(np.mean((found - expected) ** 2)) < 0.15
            assert np.abs(found - expected).max() < 1.0
        used += 1
    assert used == 2


def test_an_unusable_image_is_reported():
    finder = BoardFinder(SPEC)
    page = cv2.copyMakeBorder(board_image(SPEC, 30), *(40,) * 4, cv2.BORDER_CONSTANT, value=255)
    wall = np.full_like(page, 90)
    assert finder.look(page, wall).problem == warning("board.not_seen_side", side="right")
    mirrored = np.ascontiguousarray(page[:, ::-1])
    assert finder.look(mirrored, page).problem == warning("board.mirrored_side", side="left")
    left, right = page.copy(), page.copy()
    left[:, 190:], right[:, :190] = 90, 90
    assert finder.look(left, right).problem == warning("board.parts_differ")


# --- collecting


def test_views_are_taken_when_still_and_new():
    rng = np.random.default_rng(0)
    first, second = (view_at(p, rng) for p in board_poses(SPEC, RIG, 2, 5))
    again = replace(first, left=first.left + 0.3, right=first.right + 0.3)
    collector = Collector(WIDTH)
    answers = [
        collector.offer(BoardLook(None, None, v)) for v in (first, again, again, second, second)
    ]
    assert answers == [
        ExposureResult.MOVING, ExposureResult.TAKEN, ExposureResult.KNOWN,
        ExposureResult.MOVING, ExposureResult.TAKEN,
    ]  # fmt: skip
    assert collector.offer(BoardLook(None, None, None, "nothing")) is ExposureResult.ABSENT
    collector.remove(0)
    assert len(collector.views) == 1


def test_coverage_and_advice_follow_what_is_shown():
    straight = BoardPose(np.eye(3), np.array([-0.12, -0.08, 0.4]))
    rng = np.random.default_rng(0)
    alike = [view_at(straight, rng) for _ in range(20)]
    cover = coverage(alike, SIZES)
    assert cover.tilted == 0 and cover.distances < 1.01
    assert advice(cover) is not None and advice(cover).code == "stereo.cover_empty"
    assert advice(replace(cover, area=0.9)) == notice("stereo.cover_tilt")
    assert advice(replace(cover, area=0.9, tilted=9)) == notice("stereo.cover_distance")
    good = coverage(views(16, 1), SIZES)
    assert good.area > 0.8 and advice(good) is None


def test_tilt_is_detected_without_knowing_the_lens():
    for degrees in (0, 20, 40):
        R_CB = so3.exp(np.array([np.deg2rad(degrees), 0, 0]))
        far = BoardPose(R_CB, np.array([-0.12, -0.08, 1.5]))
        shape = shape_of(view_at(far, np.random.default_rng(1)))
        assert np.rad2deg(shape.tilt) == pytest.approx(degrees, abs=6)


# --- solving


def test_the_true_rig_is_recovered():
    s = solution()
    assert s.dropped == ()
    assert s.rms_px == pytest.approx(NOISE_PX * np.sqrt(2), rel=0.2)
    for found, true in ((s.left, RIG.left), (s.right, RIG.right)):
        assert found.K[[0, 1], [0, 1]] == pytest.approx(true.K[[0, 1], [0, 1]], rel=3e-3)
        assert found.K[:2, 2] == pytest.approx(true.K[:2, 2], abs=1.0)
    assert np.allclose(s.T, RIG.T, rtol=0, atol=4e-4)
    assert np.rad2deg(np.linalg.norm(so3.log(s.R @ RIG.R.T))) < 0.1
    assert rig_problems(Extrinsics(s.left, s.right, s.R, s.T)) == []
    assert quality_problems(s, coverage(views(16, 1), SIZES)) == []


def test_a_bad_view_is_dropped_and_named():
    spoilt = list(views(14, 1))
    rng = np.random.default_rng(9)
    spoilt[5] = replace(
        spoilt[5], right=spoilt[5].right + rng.normal(0, 3.0, spoilt[5].right.shape)
    )
    s = solve(spoilt, SIZES)
    assert s.dropped == (5,)
    assert s.error[5].max() > 2.0 > 10 * np.delete(s.error, 5, axis=0).max()
    assert np.allclose(s.T, RIG.T, rtol=0, atol=4e-4)


def test_too_few_views_are_rejected_and_too_similar_ones_reported():
    with raises(CalibrationError, "stereo.too_few_views"):
        solve(views(6, 1), SIZES)
    rng = np.random.default_rng(3)
    poses = [BoardPose(so3.rx(0.02 * k), np.array([-0.1, -0.08, 0.4])) for k in range(10)]
    alike = [view_at(p, rng) for p in poses]
    problems = quality_problems(solve(alike, SIZES), coverage(alike, SIZES))
    assert "stereo.views_alike" in [p.code for p in problems]


def test_a_cancelled_solution_stops():
    class Stop(Exception):
        pass

    def progress(share: float, text: str) -> None:
        if text == "both together":
            raise Stop

    with pytest.raises(Stop):
        solve(views(16, 1), SIZES, progress=progress)


# --- what is rejected


def codes_of(s) -> list[str]:
    """The problems of the solution's cameras."""
    return [p.code for p in rig_problems(Extrinsics(s.left, s.right, s.R, s.T))]


def test_exchanged_images_are_reported_as_such():
    """Left and right exchanged: the same views solve perfectly and must still be rejected."""
    swapped = [replace(v, left=v.right, right=v.left) for v in views(12, 1)]
    s = solve(swapped, SIZES)
    assert s.rms_px < 0.3
    assert codes_of(s) == ["stereo.exchanged"]


def test_mirrored_images_are_rejected():
    """Both images mirrored look like a rig with its cameras reversed."""

    def flip(uv: np.ndarray) -> np.ndarray:
        return np.column_stack([WIDTH - 1 - uv[:, 0], uv[:, 1]])

    columns = SPEC.corner_columns
    order = np.arange(SPEC.corner_count).reshape(-1, columns)[:, ::-1].ravel()
    mirrored = [
        replace(v, left=flip(v.left)[order], right=flip(v.right)[order]) for v in views(12, 1)
    ]
    s = solve(mirrored, SIZES)
    assert codes_of(s) == ["stereo.exchanged"], "that may be mirroring, too"


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"T": RIG.T * -1}, "stereo.exchanged"),
        ({"T": RIG.T * 1000}, "stereo.baseline_impossible"),
        ({"T": RIG.T * 0.1}, "stereo.baseline_impossible"),
        ({"T": np.array([0.001, 0.06, 0.0])}, "stereo.not_side_by_side"),
        ({"T": np.array([-0.063, 0.0, 0.05])}, "stereo.offset_impossible"),
        ({"R": so3.ry(0.6)}, "stereo.angle_impossible"),
        ({"R": np.diag([-1.0, 1, 1])}, "stereo.one_mirrored"),
        ({"left": camera(100.0, 327, 176)}, "stereo.focal_impossible"),
        ({"right": camera(600.0, 318, 183)}, "stereo.zoom_differs"),
        ({"right": camera(352.0, 60, 183)}, "stereo.centre_off"),
        ({"left": replace(RIG.left, D=np.array([1.5, 0, 0, 0, 0.0]))}, "stereo.distortion"),
        ({"T": RIG.T * np.nan}, "stereo.not_finite"),
    ],
)
def test_an_implausible_rig_is_rejected_with_the_reason(change, code):
    assert rig_problems(truth()) == []
    assert code in [p.code for p in rig_problems(truth(**change))]


def test_a_known_baseline_is_compared_with_the_result():
    assert known_baseline_problems(truth(), 0.0) == []
    assert known_baseline_problems(truth(), 0.064) == []
    (problem,) = known_baseline_problems(truth(), 0.060)
    assert problem.code == "stereo.baseline_differs"
    assert problem.values == {"found_mm": pytest.approx(63.0, abs=0.05), "known_mm": 60.0}


def test_the_motion_between_the_lenses_is_recovered_from_a_rectified_rig():
    back = extrinsics_of(rectified_rig(RIG.left, RIG.right, RIG.R, RIG.T))
    assert np.allclose(back.R, RIG.R, rtol=0, atol=1e-9)
    assert np.allclose(back.T, RIG.T, rtol=0, atol=1e-9)


# --- verification


def test_a_good_rig_passes_on_new_views_and_a_moved_one_does_not():
    fresh = views(6, 77)
    good = verify(solution().rig, fresh)
    assert good.verdict()[0] == "good"
    # two corners with noise on each row
    assert good.rms_px == pytest.approx(NOISE_PX * np.sqrt(2), rel=0.5)
    assert good.shape < 0.004
    bumped = rectified_rig(RIG.left, RIG.right, so3.rx(0.008) @ RIG.R, RIG.T)
    found = verify(bumped, fresh)
    assert found.verdict()[0] == "refused" and abs(found.offset_px) == pytest.approx(
        0.008 * 350, abs=0.3
    )
    assert verify(solution().rig, fresh[:2]).verdict()[0] == "waiting"


def test_a_wrong_size_of_squares_affects_only_the_sizes():
    longer = rectified_rig(RIG.left, RIG.right, RIG.R, RIG.T * 1.05)
    found = verify(longer, views(6, 77))
    assert found.shape == pytest.approx(0.05, abs=0.005)
    assert found.verdict()[0] == "refused"


def test_an_error_of_one_view_is_its_distance_from_truth():
    rng = np.random.default_rng(0)
    shifted = view_at(board_poses(SPEC, RIG, 1, 1)[0], rng)
    shifted = replace(shifted, right=shifted.right + [2.0, 0.0])
    error = view_errors(RIG.left, RIG.right, RIG.R, RIG.T, [shifted])
    assert error[0, 1] == pytest.approx(2.0, abs=0.2) and error[0, 0] < 0.2


# --- files


def test_a_saved_calibration_is_read_unchanged(tmp_path: Path):
    path = tmp_path / "cameras" / "mine.yml"
    save_calibration(path, RIG.left, RIG.right, RIG.R, RIG.T, "16 views")
    rig = load_rig(path, MissingFacts(width=1, height=1, unit=7.0))
    assert (rig.left.width, rig.left.height) == (WIDTH, HEIGHT)
    back = extrinsics_of(rig)
    assert np.allclose(back.T, RIG.T, rtol=0, atol=1e-9)
    assert np.allclose(back.left.K, RIG.left.K, rtol=0, atol=1e-9)
    assert [p.name for p in path.parent.iterdir()] == ["mine.yml"]


@pytest.mark.parametrize(
    ("T", "unit", "words"),
    [
        (RIG.T * 1000, 1.0, "stereo.refused"),
        (-RIG.T * 1000, 1e-3, "stereo.file_refused"),
    ],
)
def test_a_foreign_file_is_checked_too(tmp_path: Path, T, unit, words):
    path = tmp_path / "theirs.yml"
    storage = cv2.FileStorage(str(path), cv2.FILE_STORAGE_WRITE)
    for name, matrix in {
        "M1": RIG.left.K, "D1": RIG.left.D, "M2": RIG.right.K, "D2": RIG.right.D,
        "R": RIG.R, "T": T.reshape(3, 1),
    }.items():  # fmt: skip
        storage.write(name, matrix)
    storage.release()
    with raises(ConfigError, words):
        load_rig(path, MissingFacts(WIDTH, HEIGHT, unit))
    if T[0] < 0:
        rig = load_rig(path, MissingFacts(WIDTH, HEIGHT, 1e-3))
        assert rig.baseline == pytest.approx(0.063, abs=1e-4)


def test_an_invalid_calibration_is_reported(tmp_path: Path):
    (tmp_path / "a.txt").write_text("hello")
    with raises(FileError, "stereo.unknown_file"):
        load_rig(tmp_path / "a.txt")
    with raises(FileError, "file.not_readable"):
        load_rig(tmp_path / "absent.yml")


# --- real images


@pytest.mark.data
def test_real_chessboard_images_give_a_plausible_rig(data_folder: Path):
    """OpenCV's sample images, 10 by 7 squares; figures of PROVENANCE.txt: f 536/542 px, baseline
    3.34 squares, rotated by 0.3 degrees, stereo RMS 0.45 px."""
    folder = data_folder / "stereo_chessboard"
    spec = BoardSpec("chessboard", 10, 7, 0.025)
    finder, found = BoardFinder(spec), []
    for left in sorted(folder.glob("left*.jpg")):
        right = left.with_name(left.name.replace("left", "right"))
        look = finder.look(cv2.imread(str(left)), cv2.imread(str(right)))
        assert look.view is not None, f"{left.name}: {look.problem}"
        found.append(look.view)
    s = solve(found, SIZES_VGA)
    assert s.rms_px < 0.6
    assert (s.left.K[0, 0], s.right.K[0, 0]) == pytest.approx((536, 542), rel=0.015)
    assert np.linalg.norm(s.T) / spec.square == pytest.approx(3.34, rel=0.015)
    assert np.rad2deg(np.linalg.norm(so3.log(s.R))) == pytest.approx(0.3, abs=0.25)
    assert rig_problems(Extrinsics(s.left, s.right, s.R, s.T)) == []
    swapped = [replace(v, left=v.right, right=v.left) for v in found]
    w = solve(swapped, SIZES_VGA)
    assert codes_of(w) == ["stereo.exchanged"]
    # two images verify a rig calibrated from the six others
    six = solve(found[:6], SIZES_VGA, SolveParams(least_views=6))
    assert verify(six.rig, found[6:]).rms_px < 0.5
