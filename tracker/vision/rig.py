"""A calibrated stereo camera.

Pixels of a message are those of the image as recorded ("raw"); the filter works in rectified pixels
where both cameras share K and rows. The four matrices are those of a ROS CameraInfo: K, D, R, P.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tracker.base.clock import nanoseconds, seconds
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Stack
from tracker.messages import Array, CameraPose
from tracker.vision.lens_models import Lens, pixel_of, undistorted

LONGEST_READOUT = 0.1  # s, from the first row of an image to the last
NEAREST = 0.01  # m in front of the camera, minimum depth for projection


@dataclass(frozen=True, eq=False)
class Camera:
    """One camera: K (3, 3), D (n,) of `tracker.vision.lens_models`, R (3, 3) rectification,
    P (3, 4) projection."""

    width: int
    height: int
    K: Array
    D: Array
    R: Array
    P: Array
    fisheye: bool = False

    @cached_property
    def is_rectified(self) -> bool:
        """Whether raw pixels are rectified pixels already."""
        return bool(
            not self.fisheye
            and not np.any(self.D)
            and np.allclose(self.R, np.eye(3))
            and np.allclose(self.K, self.P[:, :3])
        )

    @cached_property
    def pixel_to_ray(self) -> Array:
        """(3, 3) from rectified pixels (u, v, 1) to directions of the camera as mounted."""
        return np.ascontiguousarray(self.R.T @ self._inverse)

    @cached_property
    def _inverse(self) -> Array:
        """(3, 3) from rectified pixels (u, v, 1) to directions of the rectified camera."""
        return np.asarray(np.linalg.inv(self.P[:, :3]), np.float64)

    def rectify(self, uv: Array) -> Array:
        """Raw pixels (n, 2) to rectified pixels (n, 2)."""
        if self.is_rectified or len(uv) == 0:
            return np.array(uv, float).reshape(-1, 2)
        return undistorted(uv, self.K, self.D, self.fisheye, self.R, self.P[:, :3])

    def unrectify(self, uv: Array) -> Array:
        """Rectified pixels (n, 2) to raw pixels (n, 2); the inverse of `rectify`."""
        if self.is_rectified or len(uv) == 0:
            return np.array(uv, float).reshape(-1, 2)
        return raw_pixels(np.ascontiguousarray(uv, float), self.optics)

    @cached_property
    def optics(self) -> Optics:
        """The camera for kernels."""
        lens = Lens.of(self.K, self.D, self.fisheye)
        return Optics(self.pixel_to_ray, lens, self.is_rectified, self.height)


class Optics(NamedTuple):
    """A camera for kernels: `Camera.pixel_to_ray`, its lens, whether raw pixels are rectified
    pixels, and its rows."""

    pixel_to_ray: Matrix
    lens: Lens
    is_rectified: bool
    height: int


class Readout(NamedTuple):
    """When the rows of both cameras are exposed: the cameras, and the delay of each row after the
    row above it, s."""

    left: Optics
    right: Optics
    left_row: float
    right_row: float


class StereoIntrinsics(NamedTuple):
    """For both rectified cameras: focal lengths and principal point, px; and the baseline, m."""

    fx: float
    fy: float
    cx: float
    cy: float
    baseline: float


@dataclass(frozen=True, eq=False)
class StereoRig:
    """Two cameras and, for a fixed rig, its pose in G.

    A device with ``one_camera`` has only the left one; the right one is then a placeholder, see
    `tracker.vision.lenses.one_camera_rig`. ``line_time`` s, a whole number of nanoseconds, is the
    delay of each row of the left image after the row above it; 0 for a global shutter. The right
    camera has the same readout time. Raises ConfigError for impossible values.
    """

    left: Camera
    right: Camera
    pose: CameraPose
    one_camera: bool = False
    line_time: float = 0.0

    def __post_init__(self) -> None:
        if not 0.0 <= self.line_time * (self.left.height - 1) <= LONGEST_READOUT + 1e-6:
            raise ConfigError(notice("stereo.line_time", line_time_us=self.line_time * 1e6))
        object.__setattr__(self, "line_time", seconds(nanoseconds(self.line_time)))
        if self.baseline <= 1e-4:
            raise ConfigError(notice("stereo.baseline_negative", baseline_mm=self.baseline * 1000))
        if not np.allclose(self.left.P[:, :3], self.right.P[:, :3], rtol=1e-6, atol=1e-6):
            raise ConfigError(notice("stereo.matrices_differ"))

    @property
    def readout(self) -> float:
        """s from the exposure of an image's first row to that of its last."""
        return self.line_time * (self.left.height - 1)

    @property
    def sides(self) -> tuple[str, ...]:
        """The sides of the existing cameras, the left one first."""
        return ("left",) if self.one_camera else ("left", "right")

    @cached_property
    def intrinsics(self) -> StereoIntrinsics:
        """The rig's parameters for kernels."""
        return StereoIntrinsics(self.fx, self.fy, self.cx, self.cy, self.baseline)

    @cached_property
    def fx(self) -> float:
        return float(self.left.P[0, 0])

    @cached_property
    def fy(self) -> float:
        return float(self.left.P[1, 1])

    @cached_property
    def cx(self) -> float:
        return float(self.left.P[0, 2])

    @cached_property
    def cy(self) -> float:
        return float(self.left.P[1, 2])

    @cached_property
    def baseline(self) -> float:
        """Distance of the two cameras, m."""
        return float(-self.right.P[0, 3] / self.right.P[0, 0])

    def row_delays(self, uv: Array) -> Array:
        """(2, n) s by which the rows of rectified pixels uv (2, n, 2) are exposed after the middle
        row, whose instant is that of the image. Rows outside the image count as its edge."""
        return row_delays(np.ascontiguousarray(uv, float), self.rows)

    @cached_property
    def rows(self) -> Readout:
        """When rows are exposed, for kernels."""
        right = self.line_time * self.left.height / self.right.height
        return Readout(self.left.optics, self.right.optics, self.line_time, right)

    def project(self, p_C: Array, right: bool = False) -> Array:
        """Points (…, 3) of C to rectified pixels (…, 2). NaN for points not in front (z < 1 cm)."""
        p = np.ascontiguousarray(p_C, float)
        uv = projected(
            p.reshape(-1, 3), self.baseline if right else 0.0, self.fx, self.fy, self.cx, self.cy
        )
        return uv.reshape(*p.shape[:-1], 2)

    def triangulate(self, left: Array, right: Array) -> Array:
        """Rectified pixel pairs (n, 2), (n, 2) to points (n, 3) of C; NaN where disparity ≤ 0."""
        return triangulated(left, right, self.baseline, self.fx, self.fy, self.cx, self.cy)


@kernel(nogil=False)
def raw_pixels(uv: Matrix, camera: Optics) -> Matrix:
    """(n, 2) raw pixels of rectified pixels uv (n, 2)."""
    out = np.empty_like(uv)
    for k in range(len(uv)):
        out[k] = raw_pixel(uv[k, 0], uv[k, 1], camera)
    return out


@kernel(nogil=False)
def raw_pixel(u: float, v: float, camera: Optics) -> tuple[float, float]:
    """The raw pixel of one rectified pixel."""
    if camera.is_rectified:
        return u, v
    to_ray = camera.pixel_to_ray
    x = to_ray[0, 0] * u + to_ray[0, 1] * v + to_ray[0, 2]
    y = to_ray[1, 0] * u + to_ray[1, 1] * v + to_ray[1, 2]
    z = to_ray[2, 0] * u + to_ray[2, 1] * v + to_ray[2, 2]
    return pixel_of(x, y, z, camera.lens)


@kernel(nogil=False)
def row_delay(u: float, v: float, camera: Optics, per_row: float) -> float:
    """s by which the row of a rectified pixel is exposed after the middle one; 0 for NaN."""
    if not (np.isfinite(u) and np.isfinite(v)):
        return 0.0
    _, row = raw_pixel(u, v, camera)
    last = camera.height - 1
    return (min(max(row, 0.0), last) - last / 2) * per_row


@kernel(nogil=False)
def row_delays(uv: Stack, rows: Readout) -> Matrix:
    """`StereoRig.row_delays` for rectified pixels uv (2, n, 2)."""
    out = np.empty((2, uv.shape[1]))
    for k in range(uv.shape[1]):
        out[0, k] = row_delay(uv[0, k, 0], uv[0, k, 1], rows.left, rows.left_row)
        out[1, k] = row_delay(uv[1, k, 0], uv[1, k, 1], rows.right, rows.right_row)
    return out


@kernel(nogil=False)
def projected(p_C: Matrix, shift: float, fx: float, fy: float, cx: float, cy: float) -> Matrix:
    """(n, 2) rectified pixels of p_C (n, 3), seen from ``shift`` m to the right."""
    out = np.empty((len(p_C), 2))
    for k in range(len(p_C)):
        x, y, z = p_C[k]
        if z < NEAREST:
            z = np.nan
        out[k, 0] = fx * (x - shift) / z + cx
        out[k, 1] = fy * y / z + cy
    return out


@kernel(nogil=False)
def triangulated(
    left: Matrix, right: Matrix, baseline: float, fx: float, fy: float, cx: float, cy: float
) -> Matrix:
    """(n, 3) of C, of rectified pixels left and right (n, 2)."""
    out = np.empty((len(left), 3))
    for k in range(len(left)):
        disparity = left[k, 0] - right[k, 0]
        z = fx * baseline / disparity if disparity > 0 else np.nan
        out[k, 0] = (left[k, 0] - cx) * z / fx
        out[k, 1] = ((left[k, 1] + right[k, 1]) / 2 - cy) * z / fy
        out[k, 2] = z
    return out


def ideal_rig(
    width: int = 1280,
    height: int = 720,
    hfov_deg: float = 90.0,
    vfov_deg: float = 60.0,
    baseline: float = 0.063,
    pose: CameraPose | None = None,
) -> StereoRig:
    """A distortion-free rig, by default of the ZED Mini's field of view (Lee et al. 2021).

    90° by 60° on 1280 by 720 do not give square pixels (fx 640, fy 623.5); both angles are exact.
    """
    fx = width / 2 / np.tan(np.deg2rad(hfov_deg) / 2)
    fy = height / 2 / np.tan(np.deg2rad(vfov_deg) / 2)
    K = np.array([[fx, 0, (width - 1) / 2], [0, fy, (height - 1) / 2], [0, 0, 1.0]])
    P_left = np.column_stack([K, np.zeros(3)])
    P_right = np.column_stack([K, [-fx * baseline, 0, 0]])
    none = np.zeros(5)
    left = Camera(width, height, K, none, np.eye(3), P_left)
    right = Camera(width, height, K, none, np.eye(3), P_right)
    return StereoRig(left, right, pose or default_pose())


def with_readout(rig: StereoRig, readout: float) -> StereoRig:
    """The rig whose rows are exposed one after the other, the last one ``readout`` s after the
    first."""
    return replace(rig, line_time=readout / (rig.left.height - 1))


def default_pose() -> CameraPose:
    """The camera pose of the evaluation: 0.40 m above the origin of G, facing forward and 60°
    down."""
    down = np.deg2rad(60.0)
    z = np.array([np.cos(down), 0.0, -np.sin(down)])  # optical axis in G
    x = np.array([0.0, -1.0, 0.0])  # image right is G's -y
    y = np.cross(z, x)
    return CameraPose(np.column_stack([x, y, z]), np.array([0.0, 0.0, 0.40]))
