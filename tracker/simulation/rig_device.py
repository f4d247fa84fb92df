"""A simulated glove and camera with the interfaces of real ones: a serial line, and image pipes.

They are opened by the code for real devices, in this program or another one. Requires POSIX.
"""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.channels import Latest
from tracker.base.errors import DeviceError, FileError
from tracker.base.files import check_target
from tracker.base.notices import notice
from tracker.calibration.stereo.board import BoardSpec
from tracker.sensors.image_input import Pair
from tracker.simulation.board_camera import noisy, true_rig
from tracker.simulation.board_images import BoardRenderer, board_pose
from tracker.simulation.camera_device import SimulatedCamera
from tracker.simulation.demo import DemoSpec, build_scene, hands_of
from tracker.simulation.drawn_ahead import DrawnAhead
from tracker.simulation.electric import ELECTRIC_FAULTS
from tracker.simulation.glove_device import GloveDeviceParams, SimulatedGlove, link_to
from tracker.simulation.glove_process import GLOVE_IDS
from tracker.simulation.scenario import Simulation
from tracker.simulation.smooth import rng_for
from tracker.vision.rig import StereoRig

Image = NDArray[np.uint8]
QUALITY = 92  # of JPEG
HELD = 0.8  # s, duration of each pose of the board
SMALLER = 0.75  # size of the right image of separate cameras, relative to the left one


class ImagePipe:
    """A named pipe of JPEG images. A reader gets the images from the time it opens the pipe;
    without a reader they are lost, as with a camera."""

    def __init__(self, path: Path) -> None:
        """Raises DeviceError if the system has no named pipes, FileError if one cannot be
        created."""
        if not hasattr(os, "mkfifo"):
            raise DeviceError(notice("simulator.no_pipes"))
        self.path, self._pipe = path, -1
        try:
            os.mkfifo(path, 0o600)
        except OSError as error:
            raise FileError(notice("file.not_created", path=path, why=error.strerror)) from error

    def put(self, image: Image) -> bool:
        """Write the next image, (h, w, 3); blocks for a slow reader. Returns False without a
        reader."""
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
        """Delete the pipe. Idempotent."""
        self._close()
        self.path.unlink(missing_ok=True)


def pipe_paths(folder: Path, apart: bool) -> list[Path]:
    """For one camera, or for two ``apart``, the left one first."""
    names = ("camera_left", "camera_right") if apart else ("camera",)
    return [folder / f"{name}.mjpeg" for name in names]


class RigCamera:
    """Sends the images of a simulated camera through one pipe, side by side; or ``apart``, through
    two, where a slow reader of one does not block the other."""

    def __init__(self, folder: Path, apart: bool = False, right_late: float = 0.0) -> None:
        """``right_late`` (s): delay of the right one of two separate cameras."""
        self._apart = apart
        late = (0.0, right_late)
        self._senders = [
            _Sender(path, wait) for path, wait in zip(pipe_paths(folder, apart), late, strict=False)
        ]

    @property
    def paths(self) -> tuple[Path, ...]:
        """The paths of the pipes."""
        return tuple(sender.pipe.path for sender in self._senders)

    @property
    def taken(self) -> int:
        """Number of images read from the first camera."""
        return self._senders[0].taken

    def put(self, pair: Pair) -> None:
        """Send the next images of both cameras, or of the only one, without blocking."""
        eyes = [image for image in pair if image is not None]
        if not self._apart:
            self._senders[0].put(np.hstack(eyes))
            return
        left, right = eyes
        self._senders[0].put(left.copy())
        size = _smaller(right.shape[1]), _smaller(right.shape[0])
        self._senders[1].put(np.asarray(cv2.resize(right, size, interpolation=cv2.INTER_AREA)))

    def close(self) -> None:
        """Delete the pipes. Idempotent."""
        for sender in self._senders:
            sender.close()


def smaller_right(rig: StereoRig) -> StereoRig:
    """The rig for the right images as sent by separate cameras."""
    right = rig.right
    K = right.K.copy()
    K[:2] *= SMALLER
    K[:2, 2] += (SMALLER - 1) / 2  # pixel centres are at integer coordinates
    small = replace(right, width=_smaller(right.width), height=_smaller(right.height), K=K)
    return replace(rig, right=small)


def _smaller(pixels: int) -> int:
    return round(SMALLER * pixels)


class HeldBoard:
    """Images of a board held still in front of a rig, in successive poses."""

    def __init__(self, rig: StereoRig, seed: int, spec: BoardSpec | None = None) -> None:
        """Computes every pixel's ray, which takes a second."""
        self._rig, self._seed, self._spec = true_rig(rig), seed, spec or BoardSpec()
        self._renderer = BoardRenderer(self._rig, self._spec, noise=0.0)
        self._drawn: tuple[int, Pair] | None = None

    def pair(self, t: float, index: int) -> Pair:
        """The images at the time ``t`` (s), with independent noise for each ``index``."""
        number = int(t / HELD)
        rng = rng_for(self._seed, "board noise", index)
        if self._drawn is None or self._drawn[0] != number:
            pose = board_pose(self._spec, self._rig, number, self._seed)
            self._drawn = number, self._renderer.pair(pose, rng)
        left, right = self._drawn[1]
        return noisy(left, rng), None if right is None else noisy(right, rng)


class _Sender:
    """A thread that sends the newest image, so that a stalled reader does not block others."""

    def __init__(self, path: Path, late: float) -> None:
        self.pipe, self.taken, self._late = ImagePipe(path), 0, late
        self._newest: Latest[Image] = Latest()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name=f"glovetrack-{path.stem}")
        self._thread.daemon = True  # it may be blocked by a stalled reader
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


LED_AT, LED_RADIUS, LED_EXPOSURE = (40, 40), 7, 0.004  # px, px, s


def with_led(image: Image, brightness: float) -> Image:
    """The image (h, w, 3) with an LED at `LED_AT`, of brightness 0 to 1."""
    lit = image.copy()
    cv2.circle(lit, LED_AT, LED_RADIUS, (255, 255, 255), cv2.FILLED)
    return np.asarray(cv2.addWeighted(lit, brightness, image, 1.0 - brightness, 0.0), np.uint8)


WAIT = 0.05  # s to wait for an image, and between two checks for a reader
STARTS_WITHIN = 120.0  # s


class RigFiles(NamedTuple):
    """The paths of the devices: each glove's serial line by its side, and images in a pipe (MJPEG;
    both cameras side by side), or in one pipe for each of two separate cameras."""

    gloves: Mapping[str, Path]
    cameras: Sequence[Path]


class SimulatedRig:
    """The gloves of a scene, and its camera, as files in ``folder``. A glove may be unplugged and
    plugged in again, and a board be held in front of the camera. ``hand_lengths`` (m) are those of
    the wearers' hands measured with a ruler, by side."""

    def __init__(
        self,
        spec: DemoSpec,
        folder: Path,
        apart: bool = False,
        force: bool = False,
        led: bool = False,
    ) -> None:
        """With ``apart`` two cameras are separate devices, the right one with smaller images. With
        ``led`` the first glove has an LED in place of its first motor, which the cameras see.

        Pipes and links left in ``folder`` by a killed rig are replaced, other files only with
        ``force``. Raises DeviceError or FileError if they cannot be created.
        """
        hands = hands_of(build_scene(spec))
        self._folder, self._names, self._seed = folder, _names(list(hands)), spec.seed
        _free_names([folder / n for n in self._names.values()], pipe_paths(folder, apart), force)
        self._camera = SimulatedCamera(spec)
        self._sent = RigCamera(folder, apart, spec.right_late)
        self._board: HeldBoard | None = None
        self._has_led = led
        self._packets = {side: DrawnAhead(hand.imu_samples()) for side, hand in hands.items()}
        self._gloves = {side: self._glove_of(hand) for side, hand in hands.items()}
        links = {side: self._link(side) for side in hands}
        self.files = RigFiles(links, self._sent.paths)
        self._seen_by = next(iter(hands.values())).scene.rig
        self.rig = smaller_right(spec.rig) if apart else spec.rig
        self.hand_lengths = {side: hand.wearer.hand_length for side, hand in hands.items()}

    def run(self, stop: Callable[[], bool], ready: Callable[[RigFiles], None]) -> int:
        """Runs until ``stop()``; ``ready`` is called once all files exist. Returns the number of
        images read.

        Raises DeviceError if the camera does not start.
        """
        if not self._camera.wait_ready(STARTS_WITHIN):
            raise DeviceError(notice("simulator.camera_not_started"))
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
            if board is not None:
                seen = board.pair(frame.t - t_0, frame.index)
            self._sent.put(self._lit(seen, frame.t) if self._has_led else seen)
        return self._sent.taken

    def _lit(self, pair: Pair, t: float) -> Pair:
        """With the LED as it was at the exposure."""
        glove = next(iter(self._gloves.values()))
        share = glove.light(t - LED_EXPOSURE / 2, t + LED_EXPOSURE / 2)
        left, right = pair
        return with_led(left, share), None if right is None else with_led(right, share)

    def hold_board(self, held: bool) -> str:
        """Hold a board in front of the camera, or remove it; returns a report."""
        self._board = HeldBoard(self._seen_by, self._seed) if held else None
        return "The board is before the camera." if held else "The hand is before the camera."

    def execute(self, words: str) -> str:
        """Execute a command such as ``unplug left``, ``plug left``, ``fault left flexed cable``,
        ``board`` or ``hand``; returns a report, or the list of commands."""
        verb, _, side = words.strip().partition(" ")
        if verb == "fault":
            return self._fail(side)
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

    def _fail(self, words: str) -> str:
        """Start an electrical fault of a glove, such as ``left brown-out``; ``left`` ends it."""
        side, _, kind = words.partition(" ")
        if side not in self._gloves or (kind and kind not in ELECTRIC_FAULTS):
            faults = ", ".join(ELECTRIC_FAULTS)
            return f"Say fault, {' or '.join(self._gloves)}, and one of: {faults}."
        self._gloves[side].fail(kind)
        return f"The {side} glove has the fault: {kind or 'none'}."

    def _link(self, side: str) -> Path:
        return link_to(self._folder, self._gloves[side], self._names[side])

    def close(self) -> None:
        """End everything and delete the files. Idempotent."""
        self._camera.close()
        self._sent.close()
        for side, glove in self._gloves.items():
            glove.stop()
            self._packets[side].close()
            self.files.gloves[side].unlink(missing_ok=True)

    def _glove_of(self, hand: Simulation) -> SimulatedGlove:
        side = hand.glove.side
        params = GloveDeviceParams(glove_id=GLOVE_IDS[side])
        return SimulatedGlove(
            self._packets[side],
            len(hand.glove.imus),
            params=params,
            temperature=hand.imus.temperature,
        )


def _free_names(links: Sequence[Path], pipes: Sequence[Path], force: bool) -> None:
    """Delete files with these names: links to devices and named pipes, which have no content, and
    other files with ``force``. Raises FileError, and deletes nothing, if one is another file."""
    left = [path for path in links if path.is_symlink() and path.readlink().is_relative_to("/dev")]
    left += [path for path in pipes if path.is_fifo() and not path.is_symlink()]
    for path in (*links, *pipes):
        if path not in left:
            check_target(path, force)
    for path in (*links, *pipes):
        path.unlink(missing_ok=True)


def _names(sides: Sequence[str]) -> dict[str, str]:
    """The names of the serial lines: a single glove needs no side."""
    return {side: "glove" if len(sides) == 1 else f"glove_{side}" for side in sides}
