"""The demo's camera, which is a process: started first, it gets ready while the window does."""

from __future__ import annotations

from tracker import library
from tracker.simulation.camera_device import SimulatedCamera
from tracker.simulation.demo import DemoSpec

DURATION = 900.0
"""s of motion; the hand then rests where it is."""
HAND, GLOVE = "reference-right", "vist-small"
SEED, FPS = 1, 30.0
LIGHT = ""  # of a desk, one of `tracker.simulation.desk.lights.LIGHTS`; empty: a plain wall


def demo_spec(seed: int = SEED, fps: float = FPS) -> DemoSpec:
    """The simulated wearer and camera."""
    hand, glove = library.text("hands", HAND), library.text("gloves", GLOVE)
    return DemoSpec(hand, glove, seed, DURATION, fps, light=LIGHT)


def start_camera(seed: int = SEED, fps: float = FPS) -> SimulatedCamera:
    """A process that draws; whoever gets it has to close it."""
    return SimulatedCamera(demo_spec(seed, fps))
