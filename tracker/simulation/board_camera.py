"""One or two simulated cameras in front of which a board is held in successive poses, for the
demo."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

from tracker.calibration.stereo.board import BoardSpec
from tracker.calibration.stereo.checks import extrinsics_of
from tracker.sensors.image_input import Pair
from tracker.simulation.board_images import BoardRenderer, Image, TrueRig, board_pose
from tracker.simulation.smooth import rng_for
from tracker.vision.rig import StereoRig

HOLD = 3
"""Number of images per pose: the board is at rest in all but the first."""
PERIOD = 0.25  # s between images


class BoardCamera:
    """An `ImageInput` of the board ``spec`` seen by the cameras of ``rig``, or by its only one."""

    live = True
    name = "simulated camera"
    fps = 1 / PERIOD

    def __init__(
        self,
        rig: StereoRig,
        spec: BoardSpec,
        seed: int = 1,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        self._rig, self._spec, self._seed, self._sleep = true_rig(rig), spec, seed, sleep
        self._renderer: BoardRenderer | None = None
        self._clean: Pair | None = None
        self._next = 0

    def open(self) -> None:
        """Compute every pixel's ray, which takes a second."""
        self._renderer = BoardRenderer(self._rig, self._spec, noise=0.0)

    def read(self) -> Pair | None:
        """The next image pair, at the camera's rate; None while it is not open."""
        if self._renderer is None:
            return None
        pose, again = divmod(self._next, HOLD)
        rng = rng_for(self._seed, "board noise", self._next)
        self._next += 1
        if again == 0 or self._clean is None:
            drawn = board_pose(self._spec, self._rig, pose, self._seed)
            self._clean = self._renderer.pair(drawn, rng)
        else:
            self._sleep(PERIOD)
        left, right = self._clean
        return noisy(left, rng), None if right is None else noisy(right, rng)

    def close(self) -> None:
        self._renderer = None


def true_rig(rig: StereoRig) -> TrueRig:
    """The raw cameras behind a rectified rig."""
    cameras = extrinsics_of(rig)
    return TrueRig(cameras.left, cameras.right, cameras.R, cameras.T)


def noisy(image: Image, rng: np.random.Generator) -> Image:
    """A grey image (h, w, 3) with sensor noise."""
    grey = image[..., 0] + rng.normal(0, 2.0, image.shape[:2])
    return np.repeat(np.clip(grey, 0, 255).astype(np.uint8)[..., None], 3, axis=2)
