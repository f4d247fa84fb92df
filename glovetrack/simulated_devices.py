"""Simulated devices to track with."""

from __future__ import annotations

import time

from glovetrack.devices import ConnectedGlove, Devices, glove_link
from tracker.base.errors import ConfigError, DeviceError
from tracker.base.notices import notice
from tracker.glove import library
from tracker.offline.simulate import GLOVES
from tracker.simulation.camera_device import NoSimulatedCamera, SimulatedCamera
from tracker.simulation.demo import DemoSpec, HandTexts
from tracker.simulation.glove_process import GloveProcess

START_TIMEOUT = 120.0  # s, for simulated devices on a loaded computer
LEAD = 0.25  # s until simulated devices begin
DURATION = 3600.0  # s of simulated motion


def simulated_devices(seed: int, fps: float, hands: str, camera: bool) -> Devices:
    """A simulated wearer's gloves and camera. Raises DeviceError where they do not start."""
    sides = [side for side in ("right", "left") if hands in (side, "both")]
    if not sides:
        raise ConfigError(
            notice("option.choice", option="hands", known=("right", "left", "both"), value=hands)
        )
    texts = {side: HandTexts(*library.texts(GLOVES[side])) for side in sides}
    main, *others = texts.values()
    spec = DemoSpec(*main, seed, DURATION, fps, others=tuple(others))
    images = SimulatedCamera(spec) if camera else NoSimulatedCamera()
    process = GloveProcess(spec)

    def end() -> None:
        process.close()
        images.close()

    try:
        if not images.wait_ready(START_TIMEOUT):
            raise DeviceError(notice("simulator.camera_not_started"))
        paths = process.paths(START_TIMEOUT)
        gloves = tuple(
            ConnectedGlove(*texts[side], glove_link(texts[side], paths[side])) for side in sides
        )
    except BaseException:  # Ctrl+C too must not leave processes behind
        end()
        raise

    def begin() -> None:
        t_0 = time.monotonic() + LEAD
        images.begin(t_0)
        process.begin(t_0)

    return Devices(gloves, images, spec.rig if camera else None, True, begin, end)
