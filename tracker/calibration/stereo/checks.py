"""Plausibility checks of a rig: mirrored, swapped or impossible ones are rejected.

A wrong calibration that is accepted silently appears later as a hand that cannot be found, so each
check reports a message with instructions.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import Notice, failure, notice
from tracker.calibration.stereo.coverage import Coverage
from tracker.calibration.stereo.solve import Solution
from tracker.geometry import so3
from tracker.messages import Array
from tracker.sensors.stereo_calibration import Intrinsics
from tracker.vision.lens_models import distorted, fisheye_reach
from tracker.vision.rig import StereoRig


@dataclass(frozen=True)
class RigLimits:
    """Limits of a plausible stereo camera for a hand at 20 to 80 cm."""

    baseline_least: float = 0.02  # m
    baseline_most: float = 0.35
    baseline_known: float = 0.03  # relative, to the measured distance
    turn_deg: float = 20.0  # between the cameras
    off_axis: float = 0.35  # |T_y| and |T_z| relative to the baseline
    focal_least: float = 0.35  # relative to the image's width: 110° across
    focal_most: float = 4.0  # 14° across
    aspect: float = 0.06  # |fy / fx - 1|
    focal_ratio: float = 1.6  # of the fields of view: colour and infrared of one device differ
    centre: float = 0.15  # of the principal point from the centre, relative to the width
    distortion: float = 0.6  # |shift| at the corner, relative to its distance from the centre


@dataclass(frozen=True)
class QualityLimits:
    """Limits on the uncertainty of a solution from views."""

    rms_px: float = 0.8
    focal_sd: float = 0.006
    area: float = 0.4  # of the images' cells that contain corners
    tilted: int = 3


@dataclass(frozen=True, eq=False)
class Extrinsics:
    """Intrinsics and X_right = R X_left + T; ``right`` is None for a single camera."""

    left: Intrinsics
    right: Intrinsics | None
    R: Array
    T: Array

    @property
    def cameras(self) -> tuple[tuple[str, Intrinsics], ...]:
        """By the name of the lens in reports."""
        if self.right is None:
            return (("lens", self.left),)
        return (("left lens", self.left), ("right lens", self.right))


def extrinsics_of(rig: StereoRig) -> Extrinsics:
    """The motion between the raw cameras of a rectified rig: R1, R2 rotate them parallel."""
    left, right = (
        Intrinsics(c.width, c.height, c.K, c.D, c.fisheye) for c in (rig.left, rig.right)
    )
    if rig.one_camera:
        return Extrinsics(left, None, np.eye(3), np.zeros(3))
    T = rig.right.R.T @ np.array([-rig.baseline, 0.0, 0.0])
    return Extrinsics(left, right, rig.right.R.T @ rig.left.R, T)


def rig_problems(rig: Extrinsics, limits: RigLimits | None = None) -> list[Notice]:
    """The problems of a rig, none for a good one; the most important first."""
    p = limits or RigLimits()
    checks: tuple[Callable[[Extrinsics, RigLimits], list[Notice]], ...] = (
        _finite, _sides, _baseline, _turn, _focal, _centre, _distortion,
    )  # fmt: skip
    if rig.right is None:
        checks = (_finite, _focal, _centre, _distortion)
    for check in checks[:2]:  # the other checks would only repeat these
        if found := check(rig, p):
            return found
    return [problem for check in checks[2:] for problem in check(rig, p)]


def known_baseline_problems(
    rig: Extrinsics, baseline: float, limits: RigLimits | None = None
) -> list[Notice]:
    """Compares the baseline with the cameras' distance (m) from a data sheet or a ruler; 0 for
    unknown.

    Only this detects a wrong size of the squares: everything else scales with it.
    """
    found, p = float(np.linalg.norm(rig.T)), limits or RigLimits()
    if not baseline or rig.right is None or abs(found / baseline - 1) <= p.baseline_known:
        return []
    mm = {"found_mm": 1000 * found, "known_mm": 1000 * baseline}
    return [failure("stereo.baseline_differs", **mm)]


def quality_problems(
    solution: Solution, cover: Coverage, limits: QualityLimits | None = None
) -> list[Notice]:
    """Reports views that are too few, too similar or do not fit."""
    p, out = limits or QualityLimits(), []
    if solution.rms_px > p.rms_px:
        out.append(failure("stereo.views_disagree", rms_px=solution.rms_px))
    if cover.area < p.area:
        out.append(failure("stereo.coverage_low", covered_percent=100 * cover.area))
    if cover.tilted < p.tilted or np.any(solution.focal_sd > p.focal_sd):
        percent = 100 * float(solution.focal_sd.max())
        out.append(failure("stereo.views_alike", tilted=cover.tilted, focal_percent=percent))
    return out


def require_plausible(rig: StereoRig, name: str) -> None:
    """Raise ConfigError for an implausible calibration file."""
    problems = rig_problems(extrinsics_of(rig))
    if problems:
        raise ConfigError(notice("stereo.refused", name=name, problems=problems))


def _finite(rig: Extrinsics, p: RigLimits) -> list[Notice]:
    arrays = (rig.R, rig.T, *(a for _, camera in rig.cameras for a in (camera.K, camera.D)))
    if not all(np.all(np.isfinite(a)) for a in arrays):
        return [failure("stereo.not_finite")]
    if np.linalg.det(rig.R) < 0:
        return [failure("stereo.one_mirrored")]
    return []


def _sides(rig: Extrinsics, p: RigLimits) -> list[Notice]:
    x, rest = float(rig.T[0]), float(np.linalg.norm(rig.T[1:]))
    if abs(x) < rest:
        return [failure("stereo.not_side_by_side")]
    if x > 0:
        return [failure("stereo.exchanged")]
    return []


def _baseline(rig: Extrinsics, p: RigLimits) -> list[Notice]:
    out, baseline = [], float(np.linalg.norm(rig.T))
    if not p.baseline_least <= baseline <= p.baseline_most:
        possible = {"least_mm": 1000 * p.baseline_least, "most_mm": 1000 * p.baseline_most}
        found_mm = 1000 * baseline
        out.append(failure("stereo.baseline_impossible", found_mm=found_mm, **possible))
    if max(abs(rig.T[1]), abs(rig.T[2])) > p.off_axis * baseline:
        off_mm = {"above_mm": 1000 * abs(rig.T[1]), "before_mm": 1000 * abs(rig.T[2])}
        out.append(failure("stereo.offset_impossible", **off_mm))
    return out


def _turn(rig: Extrinsics, p: RigLimits) -> list[Notice]:
    turn_deg = float(np.rad2deg(np.linalg.norm(so3.log(rig.R))))
    if turn_deg <= p.turn_deg:
        return []
    return [failure("stereo.angle_impossible", angle_deg=turn_deg)]


def _focal(rig: Extrinsics, p: RigLimits) -> list[Notice]:
    out = []
    for lens, camera in rig.cameras:
        fx, fy = float(camera.K[0, 0]), float(camera.K[1, 1])
        if not p.focal_least <= fx / camera.width <= p.focal_most:
            image = {"focal_px": fx, "width_px": camera.width}
            out.append(failure("stereo.focal_impossible", lens=lens, **image))
        elif abs(fy / fx - 1) > p.aspect:
            out.append(failure("stereo.pixels_not_square", lens=lens, x_px=fx, y_px=fy))
    if out or rig.right is None:
        return out
    left, right = (camera.K[0, 0] / camera.width for _, camera in rig.cameras)
    ratio = float(right / left)
    if not 1 / p.focal_ratio <= ratio <= p.focal_ratio:
        out.append(failure("stereo.zoom_differs", ratio=ratio))
    return out


def _centre(rig: Extrinsics, p: RigLimits) -> list[Notice]:
    out = []
    for lens, camera in rig.cameras:
        off = camera.K[:2, 2] - [(camera.width - 1) / 2, (camera.height - 1) / 2]
        if np.linalg.norm(off) > p.centre * camera.width:
            off_px = float(np.linalg.norm(off))
            out.append(failure("stereo.centre_off", lens=lens, off_px=off_px))
    return out


def _distortion(rig: Extrinsics, p: RigLimits) -> list[Notice]:
    """The displacement of the image's corner by the lens; a fisheye may have any, but must image
    its corner only once and before `tracker.vision.lens_models.WIDEST`."""
    out = []
    for lens, camera in rig.cameras:
        x = (camera.width / 2) / camera.K[0, 0]
        y = (camera.height / 2) / camera.K[1, 1]
        if camera.fisheye:
            fits = np.isfinite(fisheye_reach(camera.D, float(np.hypot(x, y))))
        else:
            corner = distorted(np.array([[x, y, 1.0]]), np.eye(3), camera.D, fisheye=False)[0]
            fits = bool(abs(corner @ (x, y) / (x * x + y * y) - 1.0) <= p.distortion)
        if not fits:
            out.append(failure("stereo.distortion", lens=lens))
    return out
