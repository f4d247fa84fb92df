"""Public orientation filters in the paper's experiment: `vqf` and `imufusion`, optional extras.

Each sensor is filtered separately and its angle is computed from the direction of gravity. The
settings are fair: VQF's bias clip and initial sigma cover the simulated ±5 °/s (its defaults, 2 and
0.5 °/s, do not), and imufusion's gain is high enough to compensate it. For the ``_zeroed`` rows,
the gyroscopes' mean over the static start is subtracted, which our filter also learns there; with
this, VQF's defaults and imufusion's default gain are best. imufusion also starts at the known pose.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable

import numpy as np

from extensions.evaluation.inertial.errors import Errors
from extensions.evaluation.inertial.motion import STATIC, FingerMotion
from tracker import GRAVITY
from tracker.inertial.plane import MIDDLE, in_plane, out_of_plane
from tracker.messages import Array

OrientationFilter = Callable[[Array, Array, float], Array]
"""gyro (n, 3) rad/s, accel (n, 3) m/s², dt s to q_GB (n, 4) xyzw."""

_CLIP_DEG = 10.0  # °/s, twice the simulated offset
_SIGMA_DEG = 5.0  # °/s
_GAIN, _STRONG_GAIN = 0.5, 2.0  # imufusion's default; against ±5 °/s
_REJECTION_DEG = 20.0  # of imufusion; with 10 the filter without zeroing rejects everything
_WIDE_REJECTION_DEG = 90.0  # best on BROAD, with the default gain


def available() -> tuple[str, ...]:
    """Names of the installed peers."""
    installed = [n for n in ("vqf", "imufusion") if importlib.util.find_spec(n) is not None]
    return tuple(name for n in installed for name in (n, f"{n}_zeroed"))


def peer_angles(name: str, motion: FingerMotion, errors: Errors, dt: float) -> Array:
    """Angles θ (n, 2) rad of both sensors by one of `available`; gravity must be in the plane."""
    gyro, accel = readings_3d(motion, errors)
    if name.endswith("_zeroed"):
        gyro = gyro - np.mean(gyro[: round(STATIC / dt)], axis=0)
    orientation = _FILTERS[name]
    theta = []
    for k in range(gyro.shape[1]):
        g, a = np.ascontiguousarray(gyro[:, k]), np.ascontiguousarray(accel[:, k])
        theta.append(_angle(_up(orientation(g, a, dt))))
    return np.column_stack(theta)


def readings_3d(motion: FingerMotion, errors: Errors) -> tuple[Array, Array]:
    """gyro, accel (n, 2, 3) in each phalanx's B, errors included."""
    gyro, accel = errors.gyro.copy(), errors.accel + out_of_plane(motion.ideal.accel)
    gyro[..., 1] += motion.ideal.gyro
    accel[..., 1] += motion.normal_gravity
    return gyro, accel


def _angle(up_B: Array) -> Array:
    """Angle θ (n,) that rotates the upward vector in B onto the plane's, within π of MIDDLE."""
    angle = np.angle(-1j * np.conj(in_plane(up_B)))
    return np.asarray(np.where(angle < MIDDLE - np.pi, angle + 2 * np.pi, angle))


def vqf_orientation(gyro: Array, accel: Array, dt: float, **settings: float) -> Array:
    """q_GB (n, 4) xyzw by VQF."""
    from vqf import VQF  # deferred: an extra

    filtered = VQF(dt, **settings).updateBatch(gyro, accel)
    return np.roll(filtered["quat6D"], -1, axis=1)


def imufusion_orientation(
    gyro: Array,
    accel: Array,
    dt: float,
    gain: float = _GAIN,
    rejection_deg: float = _WIDE_REJECTION_DEG,
    upright: bool = False,
) -> Array:
    """q_GB (n, 4) xyzw by imufusion, which takes degrees per second and g.

    ``upright``: start at the identity instead of the first accelerations.
    """
    import imufusion  # deferred: an extra

    ahrs = imufusion.Ahrs()
    ahrs.set_settings(
        imufusion.AhrsSettings(
            sample_rate=1 / dt,
            gain=gain,
            gyroscope_range=0.0,
            acceleration_rejection=rejection_deg,
            rejection_timeout=5.0,
        )
    )
    if upright:
        ahrs.skip_startup()
    out = np.empty((len(gyro), 4))
    for i, (g, a) in enumerate(zip(np.rad2deg(gyro), accel / GRAVITY, strict=True)):
        ahrs.update_no_magnetometer(g, a)
        out[i] = ahrs.get_quaternion()
    return np.roll(out, -1, axis=1)


def _up(q_GB: Array) -> Array:
    """The third row of each R_GB: G's z in B."""
    x, y, z, w = q_GB.T
    return np.column_stack([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)])


_FILTERS: dict[str, OrientationFilter] = {
    "vqf": lambda g, a, dt: vqf_orientation(g, a, dt, biasClip=_CLIP_DEG, biasSigmaInit=_SIGMA_DEG),
    "vqf_zeroed": vqf_orientation,
    "imufusion": lambda g, a, dt: imufusion_orientation(
        g, a, dt, _STRONG_GAIN, _REJECTION_DEG, upright=True
    ),
    "imufusion_zeroed": lambda g, a, dt: imufusion_orientation(
        g, a, dt, _GAIN, _REJECTION_DEG, upright=True
    ),
}
