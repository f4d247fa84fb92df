"""Calibrates one camera, or two and the motion between them, from views of a board (Zhang 2000,
with OpenCV)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import cv2
import numpy as np

from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice
from tracker.calibration.stereo.views import Size, StereoView
from tracker.messages import Array
from tracker.sensors.stereo_calibration import Intrinsics, rectified_rig, rig_of_one
from tracker.vision.rig import StereoRig

Progress = Callable[[float, str], None]


class CalibrationError(GlovetrackError):
    """The views do not determine a calibration; the text gives the reason."""


@dataclass(frozen=True)
class SolveParams:
    """A view is dropped if its error is above both ``drop_px`` and ``drop_factor`` medians."""

    least_views: int = 8
    drop_px: float = 0.4
    drop_factor: float = 2.5
    drop_most: float = 0.34  # share of the views
    rounds: int = 3
    iterations: int = 60


@dataclass(frozen=True, eq=False)
class Solution:
    """X_right = R X_left + T, R (3, 3), T (3,) m; ``right`` is None for a single camera.

    ``used`` are rows of the given views, ``error`` (views, n) px the RMS of each in the n images,
    including dropped ones. ``focal_sd`` (n,) is the relative standard deviation of each focal
    length.
    """

    left: Intrinsics
    right: Intrinsics | None
    R: Array
    T: Array
    rms_px: float
    used: tuple[int, ...]
    error: Array
    focal_sd: Array

    @property
    def rig(self) -> StereoRig:
        if self.right is None:
            return rig_of_one(self.left)
        return rectified_rig(self.left, self.right, self.R, self.T)

    @property
    def cameras(self) -> tuple[Intrinsics, ...]:
        """One or two."""
        return (self.left,) if self.right is None else (self.left, self.right)

    @property
    def dropped(self) -> tuple[int, ...]:
        return tuple(i for i in range(len(self.error)) if i not in self.used)


@dataclass(eq=False)
class _Rig:
    """A preliminary solution."""

    K: list[Array] = field(default_factory=list)
    D: list[Array] = field(default_factory=list)
    focal_sd: list[float] = field(default_factory=list)
    R: Array = field(default_factory=lambda: np.eye(3))
    T: Array = field(default_factory=lambda: np.zeros(3))
    rms_px: float = 0.0
    error: Array = field(default_factory=lambda: np.zeros((0, 2)))


def solve(
    views: Sequence[StereoView],
    sizes: Sequence[Size],
    params: SolveParams | None = None,
    progress: Progress = lambda _share, _text: None,
) -> Solution:
    """Calibrate, drop views that do not fit, calibrate again.

    ``sizes`` are of each camera's images. ``progress`` may raise to cancel. Raises CalibrationError
    if there are too few or unsuitable views.
    """
    p = params or SolveParams()
    used = list(range(len(views)))
    for k in range(p.rounds):
        if len(used) < p.least_views:
            raise CalibrationError(
                notice("stereo.too_few_views", usable=len(used), needed=p.least_views)
            )
        chosen = [views[i] for i in used]
        rig = _solve_once(chosen, sizes, p, _part(progress, k / p.rounds, 1 / p.rounds))
        bad = _bad_views(rig.error.max(axis=1), len(views) - len(used), len(views), p)
        if not bad.any():
            break
        used = [i for i, b in zip(used, bad, strict=True) if not b]
    else:
        chosen = [views[i] for i in used]
        rig = _solve_once(chosen, sizes, p, progress)
    progress(1.0, "")
    cameras = [Intrinsics(*size, rig.K[s], rig.D[s]) for s, size in enumerate(sizes)]
    right = cameras[1] if len(cameras) == 2 else None
    error = view_errors(cameras[0], right, rig.R, rig.T, views)
    focal_sd = np.array(rig.focal_sd)
    return Solution(cameras[0], right, rig.R, rig.T, rig.rms_px, tuple(used), error, focal_sd)


def _part(progress: Progress, start: float, share: float) -> Progress:
    """Maps the progress of one round to a part of the whole."""
    return lambda fraction, text: progress(start + share * fraction, text)


def _solve_once(
    views: Sequence[StereoView], sizes: Sequence[Size], p: SolveParams, progress: Progress
) -> _Rig:
    points = [v.points.astype(np.float32) for v in views]
    sides = [[v.sides[s].astype(np.float32) for v in views] for s in range(len(sizes))]
    criteria = (cv2.TERM_CRITERIA_COUNT + cv2.TERM_CRITERIA_EPS, p.iterations, 1e-7)
    rig = _Rig()
    try:
        for s, word in zip(range(len(sizes)), ("left lens", "right lens"), strict=False):
            progress(0.25 * s, word if len(sizes) == 2 else "the lens")
            rms, K, D, _, _, sd, _, each = cv2.calibrateCameraExtended(
                points, sides[s], sizes[s], np.eye(3), np.zeros(5), criteria=criteria
            )
            rig.K.append(K)
            rig.D.append(D.reshape(-1)[:5])
            rig.focal_sd.append(float(sd.reshape(-1)[0] / K[0, 0]))
            rig.rms_px, rig.error = float(rms), each.reshape(-1, 1)
        if len(sizes) == 2:
            progress(0.5, "both together")
            _solve_pair(rig, points, sides, sizes[0], criteria)
    except cv2.error as error:
        raise CalibrationError(notice("stereo.no_solution")) from error
    return rig


def _solve_pair(
    rig: _Rig,
    points: list[np.ndarray],
    sides: list[list[np.ndarray]],
    size: Size,
    criteria: tuple[int, int, float],
) -> None:
    """Both cameras and the motion between them jointly, starting from each camera alone."""
    rms, K1, D1, K2, D2, R, T, _, _, _, _, each = cv2.stereoCalibrateExtended(
        points,
        sides[0],
        sides[1],
        rig.K[0],
        rig.D[0],
        rig.K[1],
        rig.D[1],
        size,
        np.eye(3),
        np.zeros((3, 1)),
        flags=cv2.CALIB_USE_INTRINSIC_GUESS,
        criteria=criteria,
    )
    rig.K, rig.D = [K1, K2], [D1.reshape(-1)[:5], D2.reshape(-1)[:5]]
    rig.R, rig.T, rig.rms_px = R, T.reshape(3), float(rms)
    rig.error = each.reshape(-1, 2)


def _bad_views(error: Array, dropped: int, total: int, p: SolveParams) -> np.ndarray:
    """(n,) bool; only the worst ones where there are more than may be dropped."""
    limit = max(p.drop_px, p.drop_factor * float(np.median(error)))
    bad = error > limit
    spare = int(p.drop_most * total) - dropped
    for i in np.argsort(error)[: max(0, len(error) - max(spare, 0))]:
        bad[i] = False
    return bad


def view_errors(
    left: Intrinsics, right: Intrinsics | None, R: Array, T: Array, views: Sequence[StereoView]
) -> Array:
    """(views, n) px RMS of each view in the n images, the board's pose fitted to the left one."""
    cameras = [left] if right is None else [left, right]
    out = np.full((len(views), len(cameras)), np.nan)
    for i, view in enumerate(views):
        found, rvec, tvec = cv2.solvePnP(view.points, view.left, left.K, left.D)
        if not found:
            continue
        R_CB, p_CB = cv2.Rodrigues(rvec)[0], tvec.reshape(3)
        seen = view.points @ R_CB.T + p_CB
        for s, (camera, uv) in enumerate(zip(cameras, view.sides, strict=True)):
            p_C = seen if s == 0 else seen @ R.T + T
            expected, _ = cv2.projectPoints(p_C, np.zeros(3), np.zeros(3), camera.K, camera.D)
            out[i, s] = np.sqrt(np.mean(np.sum((expected.reshape(-1, 2) - uv) ** 2, axis=1)))
    return out
