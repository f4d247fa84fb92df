"""A simulated glove and camera as a system offers real ones: a serial line, and a pipe of images.

What opens them is the code that opens real devices, in this program or another one. POSIX alone has
both.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import cv2
import numpy as np

from tracker.errors import DeviceError, FileError
from tracker.messages import StereoFrame
from tracker.simulation.camera_device import SimulatedCamera
from tracker.simulation.demo import DemoSpec, build_scene, hands_of
from tracker.simulation.drawn_ahead import DrawnAhead
from tracker.simulation.glove_device import GloveDeviceParams, SimulatedGlove, link_to
from tracker.simulation.glove_process import GLOVE_IDS
from tracker.simulation.scenario import Simulation

QUALITY = 92  # of JPEG
WAIT = 0.05  # s for an image, and between two looks for a reader
STARTS_WITHIN = 120.0  # s


class RigFiles(NamedTuple):
    """Where the devices are: each glove's serial line by its side, and images in a pipe (MJPEG; of
    two cameras side by side)."""

    gloves: Mapping[str, Path]
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
    """The gloves of a scene, and its camera, as files in ``folder``. A glove may be unplugged and
    plugged in again. ``hand_lengths`` (m) are of the wearers' hands by a ruler, by side."""

    def __init__(self, spec: DemoSpec, folder: Path) -> None:
        """Raises DeviceError or FileError where there cannot be any."""
        hands = hands_of(build_scene(spec))
        self._folder, self._names = folder, _names(list(hands))
        self._camera = SimulatedCamera(spec)
        self._pipe = ImagePipe(folder / "camera.mjpeg")
        self._packets = {side: DrawnAhead(hand.imu_samples()) for side, hand in hands.items()}
        self._gloves = {side: self._glove_of(hand) for side, hand in hands.items()}
        links = {side: self._link(side) for side in hands}
        self.files = RigFiles(links, self._pipe.path)
        self.rig = spec.rig
        self.hand_lengths = {side: hand.wearer.hand_length for side, hand in hands.items()}

    def run(self, stop: Callable[[], bool], ready: Callable[[RigFiles], None]) -> int:
        """Until ``stop()``; ``ready`` hears when all are there. How many images were taken.

        Raises DeviceError where the camera does not start.
        """
        if not self._camera.wait_ready(STARTS_WITHIN):
            raise DeviceError("The simulated camera did not start.")
        t_0 = time.monotonic()
        self._camera.begin(t_0)
        for glove in self._gloves.values():
            glove.begin(t_0)
        ready(self.files)
        taken = 0
        while not stop():
            frame = self._camera.read(WAIT)
            if frame is not None:
                taken += self._pipe.put(frame)
        return taken

    def heed(self, words: str) -> str:
        """Do what a line such as ``unplug left`` or ``plug left`` says; what was done, or what can
        be said."""
        verb, _, side = words.strip().partition(" ")
        if side not in self._gloves or verb not in ("plug", "unplug"):
            return f"Say plug or unplug, and {' or '.join(self._gloves)}."
        link, glove = self.files.gloves[side], self._gloves[side]
        if os.path.lexists(link) == (verb == "plug"):
            return f"The {side} glove is {verb}ged already."
        if verb == "plug":
            glove.plug()
            self._link(side)
        else:
            link.unlink()
            glove.unplug()
        return f"The {side} glove is {verb}ged."

    def _link(self, side: str) -> Path:
        return link_to(self._folder, self._gloves[side], self._names[side])

    def close(self) -> None:
        """End all and take their files away. May be called again."""
        self._camera.close()
        self._pipe.close()
        for side, glove in self._gloves.items():
            glove.stop()
            self._packets[side].close()
            self.files.gloves[side].unlink(missing_ok=True)

    def _glove_of(self, hand: Simulation) -> SimulatedGlove:
        side = hand.glove.side
        params = GloveDeviceParams(glove_id=GLOVE_IDS[side])
        return SimulatedGlove(self._packets[side], len(hand.glove.imus), params=params)


def _names(sides: Sequence[str]) -> dict[str, str]:
    """Of the serial lines: one glove alone needs no side."""
    return {side: "glove" if len(sides) == 1 else f"glove_{side}" for side in sides}
