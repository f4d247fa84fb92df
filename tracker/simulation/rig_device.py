"""A simulated glove and camera as a system offers real ones: a serial line, and a pipe of images.

What opens them is the code that opens real devices, in this program or another one. POSIX alone has
both.
"""

from __future__ import annotations

import contextlib
import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import cv2
import numpy as np

from tracker.errors import DeviceError, FileError
from tracker.messages import StereoFrame
from tracker.simulation.camera_device import SimulatedCamera
from tracker.simulation.demo import DemoSpec, build_scene, hands_of
from tracker.simulation.drawn_ahead import DrawnAhead
from tracker.simulation.glove_device import SimulatedGlove, link_to

QUALITY = 92  # of JPEG
WAIT = 0.05  # s for an image, and between two looks for a reader
STARTS_WITHIN = 120.0  # s


class RigFiles(NamedTuple):
    """Where the devices are: the glove's serial line, and side-by-side images (MJPEG) in a pipe."""

    glove: Path
    camera: Path


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
        path.unlink(missing_ok=True)
        try:
            os.mkfifo(path)
        except OSError as error:
            raise FileError(f"{path} cannot be made: {error.strerror}.") from error

    def put(self, frame: StereoFrame) -> bool:
        """Left and right beside each other; waits for a slow reader. False where there is none."""
        if self._pipe < 0 and not self._open():
            return False
        eyes = [image for image in (frame.left, frame.right) if image is not None]
        data = cv2.imencode(".jpg", np.hstack(eyes), [cv2.IMWRITE_JPEG_QUALITY, QUALITY])[
            1
        ].tobytes()
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
        except OSError:  # nobody reads
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


class SimulatedRig:
    """The first hand of a scene with its glove, and the camera, as files in ``folder``."""

    def __init__(self, spec: DemoSpec, folder: Path) -> None:
        """Raises DeviceError or FileError where there cannot be any."""
        simulation = next(iter(hands_of(build_scene(spec)).values()))
        self._camera = SimulatedCamera(spec)
        self._pipe = ImagePipe(folder / "camera.mjpeg")
        self._packets = DrawnAhead(simulation.imu_samples())
        self._glove = SimulatedGlove(self._packets, len(simulation.glove.imus))
        self.files = RigFiles(link_to(folder, self._glove), self._pipe.path)
        self.rig = simulation.rig

    def run(self, stop: Callable[[], bool], ready: Callable[[RigFiles], None]) -> int:
        """Until ``stop()``; ``ready`` hears when both are there. How many images were taken.

        Raises DeviceError where the camera does not start.
        """
        if not self._camera.wait_ready(STARTS_WITHIN):
            raise DeviceError("The simulated camera did not start.")
        t_0 = time.monotonic()
        self._camera.begin(t_0)
        self._glove.begin(t_0)
        ready(self.files)
        taken = 0
        while not stop():
            frame = self._camera.read(WAIT)
            if frame is not None:
                taken += self._pipe.put(frame)
        return taken

    def close(self) -> None:
        """End both and take their files away. May be called again."""
        self._camera.close()
        self._pipe.close()
        self._glove.stop()
        self._packets.close()
        with contextlib.suppress(OSError):
            self.files.glove.unlink(missing_ok=True)
