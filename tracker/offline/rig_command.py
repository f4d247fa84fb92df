"""``glovetrack rig``: simulated devices that any program opens as if they were real."""

from __future__ import annotations

import argparse
import time
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tracker.vision.rig import StereoRig

CALIBRATION = "camera.yml"
LASTS = 3600.0  # s of motion


def add_rig(parser: argparse.ArgumentParser) -> None:
    """Arguments of the command."""
    parser.add_argument("folder", type=Path, help="gets glove, camera.mjpeg and camera.yml")
    parser.add_argument("--fps", type=float, default=30.0, help="of the camera")
    parser.add_argument("--seed", type=int, default=1, help="of the wearer")
    parser.add_argument("--duration", type=float, metavar="S", help="end by itself")
    parser.set_defaults(func=_rig)


def _rig(args: argparse.Namespace) -> int:
    from tracker import library
    from tracker.simulation.demo import DemoSpec
    from tracker.simulation.rig_device import RigFiles, SimulatedRig

    args.folder.mkdir(parents=True, exist_ok=True)
    spec = DemoSpec(*library.texts(), args.seed, args.duration or LASTS, args.fps)
    end = time.monotonic() + (args.duration or LASTS)
    devices = SimulatedRig(spec, args.folder)
    calibration = args.folder / CALIBRATION

    def ready(files: RigFiles) -> None:
        print(f"glove        {files.glove}")
        print(f"camera       {files.camera}")
        print(f"calibration  {calibration}", flush=True)

    try:
        _save(calibration, devices.rig)
        taken = devices.run(lambda: time.monotonic() > end, ready)
    finally:
        devices.close()
    print(f"{taken} images were taken.")
    return 0


def _save(path: Path, rig: StereoRig) -> None:
    import numpy as np

    from tracker.calibration.stereo.files import save_calibration
    from tracker.sensors.stereo_calibration import Intrinsics

    left, right = (Intrinsics(c.width, c.height, c.K, c.D) for c in (rig.left, rig.right))
    T = np.array([-rig.baseline, 0.0, 0.0])
    save_calibration(path, left, right, np.eye(3), T, "of the simulated camera")
