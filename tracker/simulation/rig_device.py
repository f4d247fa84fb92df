"""A simulated glove and camera as a system offers real ones: a serial line, and pipes of images.

What opens them is the code that opens real devices, in this program or another one. POSIX alone has
both.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from tracker.base.errors import DeviceError
from tracker.base.files import check_target
from tracker.simulation.camera_device import SimulatedCamera
from tracker.simulation.demo import DemoSpec, build_scene, hands_of
from tracker.simulation.drawn_ahead import DrawnAhead
from tracker.simulation.glove_device import GloveDeviceParams, SimulatedGlove, link_to
from tracker.simulation.glove_process import GLOVE_IDS
from tracker.simulation.rig_camera import HeldBoard, RigCamera, pipe_paths, smaller_right
from tracker.simulation.scenario import Simulation

WAIT = 0.05  # s for an image, and between two looks for a reader
STARTS_WITHIN = 120.0  # s


class RigFiles(NamedTuple):
    """Where the devices are: each glove's serial line by its side, and images in a pipe (MJPEG; of
    two cameras side by side), or in one of each of two cameras apart."""

    gloves: Mapping[str, Path]
    cameras: Sequence[Path]


class SimulatedRig:
    """The gloves of a scene, and its camera, as files in ``folder``. A glove may be unplugged and
    plugged in again, and a board be held before the camera. ``hand_lengths`` (m) are of the
    wearers' hands by a ruler, by side."""

    def __init__(
        self, spec: DemoSpec, folder: Path, apart: bool = False, force: bool = False
    ) -> None:
        """With ``apart`` two cameras are devices of their own, the right one's images smaller.

        Pipes and links that a killed rig has left in ``folder`` are replaced, other files only with
        ``force``. Raises DeviceError or FileError where there cannot be any.
        """
        hands = hands_of(build_scene(spec))
        self._folder, self._names, self._seed = folder, _names(list(hands)), spec.seed
        _free_names([folder / n for n in self._names.values()], pipe_paths(folder, apart), force)
        self._camera = SimulatedCamera(spec)
        self._sent = RigCamera(folder, apart, spec.right_late)
        self._board: HeldBoard | None = None
        self._packets = {side: DrawnAhead(hand.imu_samples()) for side, hand in hands.items()}
        self._gloves = {side: self._glove_of(hand) for side, hand in hands.items()}
        links = {side: self._link(side) for side in hands}
        self.files = RigFiles(links, self._sent.paths)
        self._seen_by = spec.rig
        self.rig = smaller_right(spec.rig) if apart else spec.rig
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
        while not stop():
            frame = self._camera.read(WAIT)
            if frame is None or frame.left is None:
                continue
            board = self._board
            seen = frame.left, frame.right
            self._sent.put(seen if board is None else board.pair(frame.t - t_0, frame.index))
        return self._sent.taken

    def hold_board(self, held: bool) -> str:
        """Hold a board before the camera, or take it away; what was done."""
        self._board = HeldBoard(self._seen_by, self._seed) if held else None
        return "The board is before the camera." if held else "The hand is before the camera."

    def heed(self, words: str) -> str:
        """Do what a line such as ``unplug left``, ``plug left``, ``board`` or ``hand`` says; what
        was done, or what can be said."""
        verb, _, side = words.strip().partition(" ")
        if verb in ("board", "hand") and not side:
            return self.hold_board(verb == "board")
        if side not in self._gloves or verb not in ("plug", "unplug"):
            return f"Say plug or unplug, and {' or '.join(self._gloves)}; or board, or hand."
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
        self._sent.close()
        for side, glove in self._gloves.items():
            glove.stop()
            self._packets[side].close()
            self.files.gloves[side].unlink(missing_ok=True)

    def _glove_of(self, hand: Simulation) -> SimulatedGlove:
        side = hand.glove.side
        params = GloveDeviceParams(glove_id=GLOVE_IDS[side])
        return SimulatedGlove(self._packets[side], len(hand.glove.imus), params=params)


def _free_names(links: Sequence[Path], pipes: Sequence[Path], force: bool) -> None:
    """Delete what has these names: links to devices and named pipes, which have no content, and
    other files with ``force``. Raises FileError, and deletes nothing, where one is another file."""
    left = [path for path in links if path.is_symlink() and path.readlink().is_relative_to("/dev")]
    left += [path for path in pipes if path.is_fifo() and not path.is_symlink()]
    for path in (*links, *pipes):
        if path not in left:
            check_target(path, force)
    for path in (*links, *pipes):
        path.unlink(missing_ok=True)


def _names(sides: Sequence[str]) -> dict[str, str]:
    """Of the serial lines: one glove alone needs no side."""
    return {side: "glove" if len(sides) == 1 else f"glove_{side}" for side in sides}
