"""Where an engine comes from: the demo, the devices, a file. Each gives a job that builds one.

The rooms are imported inside the jobs: they compile kernels and load codecs, and the window is to
open at once.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from app.engines.engine import EngineSetup
from app.engines.engine_host import SetupFactory
from app.platform.tasks import JobProgress
from app.storage.settings import AppSettings

if TYPE_CHECKING:
    from tracker.simulation.camera_device import SimulatedCamera


def demo_factory(
    seed: int = 1, fps: float = 30.0, camera: SimulatedCamera | None = None
) -> SetupFactory:
    """A simulated wearer, glove and camera; ``camera`` may have been started for it before."""
    started = [camera] if camera is not None else []

    def build(progress: JobProgress) -> EngineSetup:
        from app.engines.demo import demo_setup

        return demo_setup(progress, seed, fps, started.pop() if started else None)

    return build


def hardware_factory(settings: AppSettings) -> SetupFactory:
    """The glove on a serial port and the stereo camera."""

    def build(progress: JobProgress) -> EngineSetup:
        from app.engines.hardware import hardware_setup

        return hardware_setup(progress, settings)

    return build


def replay_factory(path: Path) -> SetupFactory:
    """A recorded session."""

    def build(progress: JobProgress) -> EngineSetup:
        from app.engines.replay import open_replay

        return open_replay(path, progress)

    return build
