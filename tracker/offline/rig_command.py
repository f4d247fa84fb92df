"""``glovetrack rig``: simulated devices that any program opens as if they were real."""

from __future__ import annotations

import os
import select
import sys
import time
from collections.abc import Callable
from pathlib import Path

from tracker.base.files import write_whole
from tracker.calibration.stereo.files import rig_text
from tracker.glove import library
from tracker.offline.commands import RigArguments
from tracker.offline.simulate import GLOVES
from tracker.simulation.camera_errors import errors_named
from tracker.simulation.demo import DemoSpec, HandTexts
from tracker.simulation.rig_device import RigFiles, SimulatedRig
from tracker.vision.rig import StereoRig

CALIBRATION = "camera.yml"


LASTS = 3600.0  # s of motion


def run_rig(args: RigArguments) -> int:
    args.folder.mkdir(parents=True, exist_ok=True)
    end = time.monotonic() + (args.duration or LASTS)
    calibration = args.folder / CALIBRATION
    devices = SimulatedRig(_spec(args), args.folder, args.lenses == "apart", args.force, args.led)
    if args.board:
        devices.hold_board(True)
    lines = _Lines(devices.execute)

    def ready(files: RigFiles) -> None:
        for side, path in files.gloves.items():
            print(f"{side + ' glove':<13}{path}")
        for path in files.cameras:
            print(f"{path.stem.replace('_', ' '):<13}{path}")
        print(f"calibration  {calibration}")
        for side, length in devices.hand_lengths.items():
            print(f"{side + ' hand':<13}{1000 * length:.0f} mm long", flush=True)

    def stop() -> bool:
        lines.read()
        return time.monotonic() > end

    try:
        _save(calibration, _calibration(devices.rig), args.force)
        taken = devices.run(stop, ready)
    finally:
        devices.close()
    print(f"{taken} images captured.")
    return 0


def _spec(args: RigArguments) -> DemoSpec:
    sides = ("right", "left") if args.hands == "both" else (args.hands,)
    main, *others = (HandTexts(*library.texts(GLOVES[side])) for side in sides)
    return DemoSpec(
        *main,
        args.seed,
        args.duration or LASTS,
        args.fps,
        others=tuple(others),
        one_camera=args.lenses == "one",
        right_late=args.right_late_ms / 1000 if args.lenses == "apart" else 0.0,
        camera_errors=errors_named(args.camera_errors, args.lenses == "one"),
    )


class _Lines:
    """Lines of standard input; each is passed to ``execute``, and its answer is printed."""

    def __init__(self, execute: Callable[[str], str]) -> None:
        self._heed, self._begun = execute, b""
        self._open = sys.stdin is not None and not sys.stdin.closed

    def read(self) -> None:
        """Those that are there now. Never waits."""
        while self._open and _is_ours() and select.select([sys.stdin], [], [], 0.0)[0]:
            data = os.read(sys.stdin.fileno(), 4096)
            self._open = bool(data)  # the end of input does not stop the devices
            *lines, self._begun = (self._begun + data).split(b"\n")
            for line in lines:
                print(self._heed(line.decode(errors="replace")), flush=True)


def _is_ours() -> bool:
    """Whether standard input may be read: a terminal stops those who read in the background."""
    if not sys.stdin.isatty():
        return True
    return os.tcgetpgrp(sys.stdin.fileno()) == os.getpgrp()


def _save(path: Path, text: str, force: bool) -> None:
    """The same file of an earlier rig stays. Raises FileError for another one unless ``force``."""
    if not (path.is_file() and path.read_bytes() == text.encode()):
        write_whole(path, text, force)


def _calibration(rig: StereoRig) -> str:
    return rig_text(rig, "of the simulated camera")
