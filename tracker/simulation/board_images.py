"""Images of a printed board in front of a stereo camera with known intrinsics, for demo and tests.

Each pixel's ray, with the lens distortion removed, meets the paper at one point, where the paper is
sampled. Images are drawn at twice their size and averaged, so corners are accurate to a few
hundredths of a pixel.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.calibration.stereo.board import BoardSpec, board_image
from tracker.geometry import so3
from tracker.messages import Array
from tracker.sensors.stereo_calibration import Intrinsics
from tracker.simulation.smooth import rng_for
from tracker.vision.lens_models import undistorted

Image = NDArray[np.uint8]
FINE = 2
SQUARE_PX = 48
PAPER, WALL = 235, 96
INK = 30


@dataclass(frozen=True, eq=False)
class TrueRig:
    """X_right = R X_left + T, T (3,) m; ``right`` is None for a single camera."""

    left: Intrinsics
    right: Intrinsics | None
    R: Array
    T: Array


@dataclass(frozen=True, eq=False)
class BoardPose:
    """The board in the left camera: X_left = R_CB X_board + p_CB, origin at the top left square."""

    R_CB: Array
    p_CB: Array


class BoardRenderer:
    """Draws the board for one rig.

    ``printed`` replaces the board's image: grey, with squares of `SQUARE_PX`.
    """

    def __init__(
        self, rig: TrueRig, spec: BoardSpec, noise: float = 2.0, printed: Image | None = None
    ) -> None:
        self.rig, self.spec, self._noise = rig, spec, noise
        image = board_image(spec, SQUARE_PX) if printed is None else printed
        board = image.astype(np.float32)
        inked = INK + board / 255 * (PAPER - INK)
        sheet = cv2.copyMakeBorder(
            inked, *(SQUARE_PX,) * 4, cv2.BORDER_CONSTANT, value=float(PAPER)
        )
        self._sheet = np.asarray(sheet, np.float32)
        left, right = _rays(rig.left), rig.right
        is_same = right is not None and _same_lens(rig.left, right)
        self._rays = [left, left if right is None or is_same else _rays(right)]

    def pair(self, pose: BoardPose, rng: np.random.Generator) -> tuple[Image, Image | None]:
        """BGR images (h, w, 3) of both cameras, or of the only one."""
        left, other = self._draw(0, self.rig.left, pose, rng), self.rig.right
        if other is None:
            return left, None
        right = BoardPose(self.rig.R @ pose.R_CB, self.rig.R @ pose.p_CB + self.rig.T)
        return left, self._draw(1, other, right, rng)

    def _draw(
        self, side: int, camera: Intrinsics, pose: BoardPose, rng: np.random.Generator
    ) -> Image:
        """Intersects rays with the paper: [R_x R_y p]⁻¹ ray is the point there, up to scale."""
        plane = np.column_stack([pose.R_CB[:, 0], pose.R_CB[:, 1], pose.p_CB])
        on_plane = self._rays[side] @ np.linalg.inv(plane).T.astype(np.float32)
        behind = on_plane[..., 2] <= 1e-6
        at = on_plane[..., :2] / np.where(behind, 1, on_plane[..., 2])[..., None]
        # a texel's centre is half a texel into it; the sheet extends one square beyond the board
        texel = at / self.spec.square * SQUARE_PX + (SQUARE_PX - 0.5)
        texel[behind] = -10
        fine = cv2.remap(
            self._blurred(pose),
            texel.astype(np.float32),
            None,
            cv2.INTER_LINEAR,
            borderMode=cv2.BORDER_CONSTANT,
            borderValue=float(WALL),
        )
        grey = cv2.resize(fine, (camera.width, camera.height), interpolation=cv2.INTER_AREA)
        grey = grey + rng.normal(0, self._noise, grey.shape).astype(np.float32)
        return np.repeat(np.clip(grey, 0, 255).astype(np.uint8)[..., None], 3, axis=2)

    def _blurred(self, pose: BoardPose) -> NDArray[np.float32]:
        """The paper, blurred to the resolution of the image, to avoid aliasing."""
        fx = float(self.rig.left.K[0, 0]) * FINE
        texels = SQUARE_PX / self.spec.square * max(0.05, float(pose.p_CB[2])) / fx
        if texels < 1.0:
            return self._sheet
        return np.asarray(cv2.GaussianBlur(self._sheet, (0, 0), 0.45 * texels), np.float32)


def _same_lens(a: Intrinsics, b: Intrinsics) -> bool:
    sizes = (a.width, a.height, a.fisheye) == (b.width, b.height, b.fisheye)
    return sizes and np.array_equal(a.K, b.K) and np.array_equal(a.D, b.D)


def _rays(camera: Intrinsics) -> NDArray[np.float32]:
    """(FINE h, FINE w, 3): directions through the sub-pixels of a camera."""
    u = (np.arange(camera.width * FINE) + 0.5) / FINE - 0.5
    v = (np.arange(camera.height * FINE) + 0.5) / FINE - 0.5
    uv = np.stack(np.meshgrid(u, v), axis=-1).reshape(-1, 1, 2)
    same = np.eye(3)
    xy = undistorted(uv.reshape(-1, 2), camera.K, camera.D, camera.fisheye, same, same)
    xy = xy.reshape(len(v), len(u), 2)
    return np.concatenate([xy, np.ones((*xy.shape[:2], 1))], axis=2).astype(np.float32)


def board_poses(spec: BoardSpec, rig: TrueRig, count: int, seed: int) -> list[BoardPose]:
    """Poses as a careful person would show: all over the images, tilted, near and far."""
    return [board_pose(spec, rig, k, seed) for k in range(count)]


def board_pose(spec: BoardSpec, rig: TrueRig, k: int, seed: int) -> BoardPose:
    """The k-th of them. Positions cycle through a grid of 3 by 3.

    The board is inside both images as far as possible.
    """
    rng = rng_for(seed, "board pose", k)
    camera = rig.left
    tilt_deg = rng.uniform(0, 38) if k % 4 else rng.uniform(0, 8)
    about = rng.uniform(0, 2 * np.pi)
    tilt = np.deg2rad(tilt_deg) * np.array([np.cos(about), np.sin(about), 0.0])
    R_CB = so3.exp(tilt) @ so3.exp(np.array([0, 0, np.deg2rad(rng.uniform(-25, 25))]))
    middle = np.array([spec.width / 2, spec.height / 2, 0.0])
    share = rng.uniform(0.32, 0.6)  # of the image's width covered by the board
    distance = float(camera.K[0, 0]) * spec.width / (share * camera.width)
    cell = np.array([k % 3 - 1, k // 3 % 3 - 1]) + rng.uniform(-0.3, 0.3, 2)
    margin = np.array([camera.width, camera.height]) / 2 * (1 - np.array([share, share * 1.1]))
    uv = np.array([camera.K[0, 2], camera.K[1, 2]]) + cell * np.maximum(margin, 0)
    x, y = (uv - [camera.K[0, 2], camera.K[1, 2]]) / [camera.K[0, 0], camera.K[1, 1]]
    centre = np.array([x, y, 1.0]) * distance - rig.T / 2  # the midpoint between both cameras
    return BoardPose(R_CB, centre - R_CB @ middle)
