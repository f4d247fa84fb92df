"""A simulated rig's cameras as pipes of JPEG images, and a board that is held before them."""

from __future__ import annotations

import os
import threading
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.channels import Latest
from tracker.base.errors import DeviceError, FileError
from tracker.calibration.stereo.board import BoardSpec
from tracker.sensors.image_input import Pair
from tracker.simulation.board_camera import noisy, true_rig
from tracker.simulation.board_images import BoardRenderer, board_pose
from tracker.simulation.smooth import rng_for
from tracker.vision.rig import StereoRig

Image = NDArray[np.uint8]
QUALITY = 92  # of JPEG
HELD = 0.8  # s that the board stands still in each pose
SMALLER = 0.75  # the right image of two apart, against the left one


class ImagePipe:
    """A named pipe of JPEG images. Who opens it gets those from then on; without a reader they are
    lost, as a camera's are."""

    def __init__(self, path: Path) -> None:
        """Raises DeviceError where the system has no named pipes, FileError where one cannot be."""
        if not hasattr(os, "mkfifo"):
            raise DeviceError(
                "The simulated rig needs named pipes, which this system does not have."
            )
        self.path, self._pipe = path, -1
        try:
            os.mkfifo(path, 0o600)
        except OSError as error:
            raise FileError(f"{path} cannot be made: {error.strerror}.") from error

    def put(self, image: Image) -> bool:
        """The next one, (h, w, 3); waits for a slow reader. False where there is none."""
        if self._pipe < 0 and not self._open():
            return False
        data = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, QUALITY])[1].tobytes()
        try:
            while data:
                data = data[os.write(self._pipe, data) :]
        except BrokenPipeError:
            self._close()
            return False
        return True

    def _open(self) -> bool:
        try:
            self._pipe = os.open(self.path, os.O_WRONLY | os.O_NONBLOCK)
        except OSError:  # no reader
            return False
        os.set_blocking(self._pipe, True)
        return True

    def _close(self) -> None:
        if self._pipe >= 0:
            os.close(self._pipe)
            self._pipe = -1

    def close(self) -> None:
        """Take it away. May be called again."""
        self._close()
        self.path.unlink(missing_ok=True)


def pipe_paths(folder: Path, apart: bool) -> list[Path]:
    """Of one camera, or of two ``apart``, the left one first."""
    names = ("camera_left", "camera_right") if apart else ("camera",)
    return [folder / f"{name}.mjpeg" for name in names]


class RigCamera:
    """Sends what a simulated camera drew through one pipe, both images side by side; or ``apart``,
    through two, where a reader of one does not hold up the other."""

    def __init__(self, folder: Path, apart: bool = False, right_late: float = 0.0) -> None:
        """``right_late`` (s): how much later the right one of two apart sends."""
        self._apart = apart
        late = (0.0, right_late)
        self._senders = [
            _Sender(path, wait) for path, wait in zip(pipe_paths(folder, apart), late, strict=False)
        ]

    @property
    def paths(self) -> tuple[Path, ...]:
        """Of the pipes."""
        return tuple(sender.pipe.path for sender in self._senders)

    @property
    def taken(self) -> int:
        """How many images the first camera's reader took."""
        return self._senders[0].taken

    def put(self, pair: Pair) -> None:
        """The next images of both cameras, or of the only one. Never waits."""
        eyes = [image for image in pair if image is not None]
        if not self._apart:
            self._senders[0].put(np.hstack(eyes))
            return
        left, right = eyes
        self._senders[0].put(left.copy())
        size = _smaller(right.shape[1]), _smaller(right.shape[0])
        self._senders[1].put(np.asarray(cv2.resize(right, size, interpolation=cv2.INTER_AREA)))

    def close(self) -> None:
        """Take the pipes away. May be called again."""
        for sender in self._senders:
            sender.close()


def smaller_right(rig: StereoRig) -> StereoRig:
    """The rig whose right camera gives the images that two apart send."""
    right = rig.right
    K = right.K.copy()
    K[:2] *= SMALLER
    K[:2, 2] += (SMALLER - 1) / 2  # pixels' middles are whole numbers
    small = replace(right, width=_smaller(right.width), height=_smaller(right.height), K=K)
    return replace(rig, right=small)


def _smaller(pixels: int) -> int:
    return round(SMALLER * pixels)


class HeldBoard:
    """Images of a board that somebody holds still before a rig, pose after pose."""

    def __init__(self, rig: StereoRig, seed: int, spec: BoardSpec | None = None) -> None:
        """Takes a second: every pixel's ray is found."""
        self._rig, self._seed, self._spec = true_rig(rig), seed, spec or BoardSpec()
        self._renderer = BoardRenderer(self._rig, self._spec, noise=0.0)
        self._drawn: tuple[int, Pair] | None = None

    def pair(self, t: float, index: int) -> Pair:
        """Those of the time ``t`` (s), each ``index`` with noise of its own."""
        number = int(t / HELD)
        rng = rng_for(self._seed, "board noise", index)
        if self._drawn is None or self._drawn[0] != number:
            pose = board_pose(self._spec, self._rig, number, self._seed)
            self._drawn = number, self._renderer.pair(pose, rng)
        left, right = self._drawn[1]
        return noisy(left, rng), None if right is None else noisy(right, rng)


class _Sender:
    """A thread that sends the newest image, so that a stopped reader does not block others."""

    def __init__(self, path: Path, late: float) -> None:
        self.pipe, self.taken, self._late = ImagePipe(path), 0, late
        self._newest: Latest[Image] = Latest()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name=f"glovetrack-{path.stem}")
        self._thread.daemon = True  # it may wait for a reader that never reads again
        self._thread.start()

    def put(self, image: Image) -> None:
        self._newest.put(image)

    def _run(self) -> None:
        while not self._ended.is_set():
            image = self._newest.get(timeout=0.1)
            if image is not None and not self._ended.wait(self._late):
                self.taken += self.pipe.put(image)

    def close(self) -> None:
        self._ended.set()
        self._thread.join(1.0)
        self.pipe.close()
