"""Errors of a simulated stereo camera: its lenses distort, and its calibration is not exact.

Calibration with a board leaves reprojection errors of about 0.3 px and a baseline error of about
0.3 %, the tolerance of the printed squares.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tracker.geometry import so3
from tracker.messages import Array
from tracker.simulation.smooth import rng_for
from tracker.vision.lenses import one_camera_rig
from tracker.vision.rig import Camera, StereoRig

GRID = 17
"""Cells along each side of an image over which an error in pixels is averaged."""


@dataclass(frozen=True)
class RigErrorParams:
    """Errors of a calibration. Default: none.

    ``pixel_px`` is the RMS error over each image of points projected with the calibration;
    ``baseline`` the relative error of the cameras' distance; ``pitch_px`` and ``roll_deg`` are the
    rotation of the right camera since its calibration: the downward shift of the image's middle in
    rows, and the angle about the optical axis.
    """

    pixel_px: float = 0.0
    baseline: float = 0.0
    pitch_px: float = 0.0
    roll_deg: float = 0.0


BOARD = RigErrorParams(pixel_px=0.3, baseline=0.003)
"""What a board calibration leaves."""


@dataclass(frozen=True)
class LensParams:
    """Standard deviations between devices, except k1 and k2, which are the design's."""

    k1: float = -0.17
    k2: float = 0.025
    k1_sd: float = 0.005
    tangential: float = 4e-4
    focal: float = 0.005  # relative
    centre_px: float = 6.0
    rotation_deg: float = 0.3  # of a camera in the housing


def with_lenses(rig: StereoRig, seed: int, params: LensParams | None = None) -> StereoRig:
    """The rig with lenses of a wide-angle stereo camera, mounted with tolerances. Its rectified
    images are the same, except at their borders. A single camera has its own axes."""
    p, rng = params or LensParams(), rng_for(seed, "lenses")
    if rig.one_camera:
        left = replace(_lens(rig.left, p, rng), R=rig.left.R)
        return one_camera_rig(left, rig.pose, rig.line_time)
    return replace(rig, left=_lens(rig.left, p, rng), right=_lens(rig.right, p, rng))


def _lens(camera: Camera, p: LensParams, rng: np.random.Generator) -> Camera:
    K = camera.K.copy()
    K[:2, :2] *= 1.0 + rng.normal(0, p.focal)
    K[:2, 2] += rng.normal(0, p.centre_px, 2)
    tangential = rng.normal(0, p.tangential, 2)
    D = np.array([p.k1 + rng.normal(0, p.k1_sd), p.k2, *tangential, 0.0])
    turn = so3.exp(np.deg2rad(rng.normal(0, p.rotation_deg, 3)))
    return replace(camera, K=K, D=D, R=turn @ camera.R)


def true_camera(rig: StereoRig, seed: int, params: RigErrorParams) -> StereoRig:
    """The true rig of a device whose calibration is ``rig``."""
    if params == RigErrorParams():
        return rig
    rng = rng_for(seed, "calibration")
    left = _misplaced(rig.left, rng, params.pixel_px, turns=False)
    if rig.one_camera:
        return one_camera_rig(left, rig.pose, rig.line_time)
    right = _misplaced(rig.right, rng, params.pixel_px, turns=True)
    right = _turned(right, _since(params, rig.fy))
    gain = 1.0 + params.baseline * float(rng.choice([-1.0, 1.0]))
    P = right.P.copy()
    P[0, 3] *= gain
    return replace(rig, left=left, right=replace(right, P=P))


def _since(params: RigErrorParams, fy: float) -> Array:
    """(3,) rad: the right camera's rotation since its calibration, about its rectified axes."""
    return np.array([params.pitch_px / fy, 0.0, np.deg2rad(params.roll_deg)])


def _turned(camera: Camera, turn: Array) -> Camera:
    """The camera after it was rotated by (3,) rad about its rectified axes."""
    return replace(camera, R=so3.exp(turn) @ camera.R) if turn.any() else camera


def _misplaced(camera: Camera, rng: np.random.Generator, pixel_px: float, turns: bool) -> Camera:
    """A camera whose image points differ from those of ``camera`` by ``pixel_px`` (RMS), because of
    errors of focal length, centre, distortion and, if ``turns`` is set, rotation."""
    if pixel_px == 0.0:
        return camera
    f = camera.K[0, 0]
    focal, centre = rng.normal(0, 1.0) / f, rng.normal(0, 0.7, 2)
    bent = rng.normal(0, [4.0, 4.0, 1.0, 1.0]) / f
    turn = rng.normal(0, [1.0, 1.0, 1.5]) / f if turns else np.zeros(3)

    def changed(gain: float) -> Camera:
        K, D = camera.K.copy(), camera.D.copy()
        K[:2, :2] *= 1.0 + gain * focal
        K[:2, 2] += gain * centre
        D[:4] += gain * bent
        return _turned(replace(camera, K=K, D=D), gain * turn)

    # the displacement is proportional to such small errors
    return changed(pixel_px / _displacement(camera, changed(1.0)))


def _displacement(a: Camera, b: Camera) -> float:
    """RMS displacement over the image, px."""
    u, v = np.meshgrid(*((np.arange(GRID) + 0.5) * n / GRID - 0.5 for n in (a.width, a.height)))
    uv = a.rectify(np.column_stack([u.ravel(), v.ravel()]))
    off = b.unrectify(uv) - a.unrectify(uv)
    return float(np.sqrt(np.mean(np.sum(off**2, axis=1))))
