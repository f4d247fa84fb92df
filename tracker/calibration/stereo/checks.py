"""Whether a rig can be what a person has on the desk: mirrored, swapped, implausible ones are not.

A wrong calibration accepted silently shows later as a hand that cannot be found, so each of these
refuses in words that say what to do.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tracker.base.errors import ConfigError
from tracker.calibration.stereo.coverage import Coverage
from tracker.calibration.stereo.solve import Solution
from tracker.geometry import so3
from tracker.messages import Array
from tracker.sensors.stereo_calibration import Intrinsics
from tracker.vision.rig import StereoRig


@dataclass(frozen=True)
class RigLimits:
    """Bounds of what a stereo camera for a hand at 20 to 80 cm may be."""

    baseline_least: float = 0.02  # m
    baseline_most: float = 0.35
    baseline_known: float = 0.03  # relative, against what the user has measured
    turn_deg: float = 20.0  # between the cameras
    off_axis: float = 0.35  # |T_y| and |T_z| against the baseline
    focal_least: float = 0.35  # of the image's width: 110° across
    focal_most: float = 4.0  # 14° across
    aspect: float = 0.06  # |fy / fx - 1|
    focal_ratio: float = 1.6  # of the fields of view: colour and infrared of one device differ
    centre: float = 0.15  # of the principal point from the middle, of the width
    distortion: float = 0.6  # |shift| at the corner, of its distance from the middle


@dataclass(frozen=True)
class QualityLimits:
    """Bounds of what a solution from views may leave open."""

    rms_px: float = 0.8
    focal_sd: float = 0.006
    area: float = 0.4  # of the images' cells that hold corners
    tilted: int = 3


@dataclass(frozen=True, eq=False)
class Extrinsics:
    """Intrinsics and X_right = R X_left + T; ``right`` is None of a camera alone."""

    left: Intrinsics
    right: Intrinsics | None
    R: Array
    T: Array

    @property
    def cameras(self) -> tuple[tuple[str, Intrinsics], ...]:
        """By their words in sentences: one of two, or the only one."""
        if self.right is None:
            return (("", self.left),)
        return (("left ", self.left), ("right ", self.right))


def extrinsics_of(rig: StereoRig) -> Extrinsics:
    """The motion between the raw cameras of a rectified rig: R1, R2 turn them parallel."""
    left, right = (Intrinsics(c.width, c.height, c.K, c.D) for c in (rig.left, rig.right))
    if rig.one_camera:
        return Extrinsics(left, None, np.eye(3), np.zeros(3))
    T = rig.right.R.T @ np.array([-rig.baseline, 0.0, 0.0])
    return Extrinsics(left, right, rig.right.R.T @ rig.left.R, T)


def rig_problems(rig: Extrinsics, limits: RigLimits | None = None) -> list[str]:
    """Sentences, none for a good rig; the most telling first."""
    p = limits or RigLimits()
    checks: tuple[Callable[[Extrinsics, RigLimits], list[str]], ...] = (
        _finite, _sides, _baseline, _turn, _focal, _centre, _distortion,
    )  # fmt: skip
    if rig.right is None:
        checks = (_finite, _focal, _centre, _distortion)
    for check in checks[:2]:  # the rest would only repeat these in other words
        if found := check(rig, p):
            return found
    return [problem for check in checks[2:] for problem in check(rig, p)]


def known_baseline_problems(
    rig: Extrinsics, baseline: float, limits: RigLimits | None = None
) -> list[str]:
    """Against the cameras' distance (m) that a data sheet or a ruler tells; 0 for unknown.

    Only this finds squares that are not as large as was said: everything else scales with them.
    """
    found, p = float(np.linalg.norm(rig.T)), limits or RigLimits()
    if not baseline or rig.right is None or abs(found / baseline - 1) <= p.baseline_known:
        return []
    return [
        f"The lenses would stand {1000 * found:.1f} mm apart, but {1000 * baseline:.1f} mm are "
        "known: measure a square of the board again."
    ]


def quality_problems(
    solution: Solution, cover: Coverage, limits: QualityLimits | None = None
) -> list[str]:
    """Sentences about views that are too few, too alike or do not fit."""
    p, out = limits or QualityLimits(), []
    if solution.rms_px > p.rms_px:
        out.append(
            f"The views do not fit one camera: corners are off by {solution.rms_px:.1f} px. "
            "Check the numbers of squares, hold the board flat and still, and turn off autofocus."
        )
    if cover.area < p.area:
        out.append(
            f"The views cover only {100 * cover.area:.0f} % of the images: show the board at "
            "the edges too."
        )
    if cover.tilted < p.tilted or np.any(solution.focal_sd > p.focal_sd):
        out.append(
            f"The views are too alike: only {cover.tilted} show the board tilted, and the focal "
            f"length is uncertain by {100 * float(solution.focal_sd.max()):.1f} %."
        )
    return out


def require_plausible(rig: StereoRig, name: str) -> None:
    """Raise ConfigError where a calibration from a file cannot be right."""
    problems = rig_problems(extrinsics_of(rig))
    if problems:
        raise ConfigError(f"{name} is refused. {' '.join(problems)}")


def _finite(rig: Extrinsics, p: RigLimits) -> list[str]:
    arrays = (rig.R, rig.T, *(a for _, camera in rig.cameras for a in (camera.K, camera.D)))
    if not all(np.all(np.isfinite(a)) for a in arrays):
        return ["The calibration holds values that are no numbers."]
    if np.linalg.det(rig.R) < 0:
        return ["One camera is mirrored against the other: turn off its mirror setting."]
    return []


def _sides(rig: Extrinsics, p: RigLimits) -> list[str]:
    x, rest = float(rig.T[0]), float(np.linalg.norm(rig.T[1:]))
    if abs(x) < rest:
        return [
            "The cameras stand above or behind each other, not side by side: turn the rig, "
            "or the images, by 90 degrees."
        ]
    if x > 0:
        return [
            "Left and right are exchanged: what is called the left camera stands on the right. "
            "Exchange the two images in the camera's set-up, or turn off mirroring, which looks "
            "the same."
        ]
    return []


def _baseline(rig: Extrinsics, p: RigLimits) -> list[str]:
    out, baseline = [], float(np.linalg.norm(rig.T))
    if not p.baseline_least <= baseline <= p.baseline_most:
        out.append(
            f"The cameras would stand {1000 * baseline:.1f} mm apart; between "
            f"{1000 * p.baseline_least:.0f} and {1000 * p.baseline_most:.0f} mm is possible. "
            "Is the size of a square, or the unit of the file, right?"
        )
    if max(abs(rig.T[1]), abs(rig.T[2])) > p.off_axis * baseline:
        out.append(
            f"One camera would stand {1000 * abs(rig.T[1]):.0f} mm above and "
            f"{1000 * abs(rig.T[2]):.0f} mm before the other: they must be side by side."
        )
    return out


def _turn(rig: Extrinsics, p: RigLimits) -> list[str]:
    turn_deg = float(np.rad2deg(np.linalg.norm(so3.log(rig.R))))
    if turn_deg <= p.turn_deg:
        return []
    return [f"The cameras would look {turn_deg:.0f} degrees apart: they must look the same way."]


def _focal(rig: Extrinsics, p: RigLimits) -> list[str]:
    out = []
    for side, camera in rig.cameras:
        fx, fy = float(camera.K[0, 0]), float(camera.K[1, 1])
        if not p.focal_least <= fx / camera.width <= p.focal_most:
            out.append(
                f"The {side}lens would have a focal length of {fx:.0f} px for an image "
                f"{camera.width} px wide, which no usual lens has."
            )
        elif abs(fy / fx - 1) > p.aspect:
            out.append(
                f"The {side}lens would have pixels that are not square ({fx:.0f} by {fy:.0f})."
            )
    if out or rig.right is None:
        return out
    left, right = (camera.K[0, 0] / camera.width for _, camera in rig.cameras)
    ratio = float(right / left)
    if not 1 / p.focal_ratio <= ratio <= p.focal_ratio:
        out.append(
            f"The right lens would magnify {ratio:.2f} times as much as the left one: "
            "are the squares the same for both, and is one of them zoomed?"
        )
    return out


def _centre(rig: Extrinsics, p: RigLimits) -> list[str]:
    out = []
    for side, camera in rig.cameras:
        off = camera.K[:2, 2] - [(camera.width - 1) / 2, (camera.height - 1) / 2]
        if np.linalg.norm(off) > p.centre * camera.width:
            out.append(
                f"The middle of the {side}lens would lie {np.linalg.norm(off):.0f} px from the "
                "middle of the image: is the image cropped, or of another size?"
            )
    return out


def _distortion(rig: Extrinsics, p: RigLimits) -> list[str]:
    """How far the lens shifts the image's corner."""
    out = []
    for side, camera in rig.cameras:
        x = (camera.width / 2) / camera.K[0, 0]
        y = (camera.height / 2) / camera.K[1, 1]
        k1, k2, _, _, k3 = camera.D
        r2 = x * x + y * y
        if abs(k1 * r2 + k2 * r2**2 + k3 * r2**3) > p.distortion:
            out.append(
                f"The {side}lens would bend the image's corners beyond recognition: show the "
                "board in the corners too, or use a lens that is no fisheye."
            )
    return out
