"""The simulated camera as a separate device."""

import time

import numpy as np
import pytest

from tests.fixtures import RESOURCES
from tracker.simulation.camera_device import SimulatedCamera
from tracker.simulation.camera_errors import ZED
from tracker.simulation.demo import DemoSpec, build
from tracker.simulation.stamps import MOST_JITTER

SPEC = DemoSpec(
    (RESOURCES / "hands" / "reference-right.toml").read_text(),
    (RESOURCES / "gloves" / "vist-small.toml").read_text(),
    seed=3,
    duration=60.0,
    fps=15.0,
)


@pytest.mark.long
@pytest.mark.parametrize("drawn", [0, 4], ids=["drawn in time", "drawn before"])
def test_images_arrive_on_time_and_are_those_of_the_simulation(drawn: int) -> None:
    camera = SimulatedCamera(SPEC, drawn=drawn)
    try:
        assert camera.wait_ready(60.0)
        t_0 = time.monotonic() + 0.1
        camera.begin(t_0)
        frames = []
        deadline = time.monotonic() + 40
        while len(frames) < 4 and time.monotonic() < deadline:
            frame = camera.read(0.2)
            if frame is not None:
                assert time.monotonic() >= frame.t_arrival - 1e-3
                frames.append(frame)
        if drawn:
            while not camera.drain_events() and time.monotonic() < deadline:
                assert camera.read(0.2) is None  # it had no more
    finally:
        camera.close()
        camera.close()
    assert len(frames) == 4
    assert all(f.t_arrival - f.t > 0.028 for f in frames), "no sooner than a real camera"
    expected = {k: t for k, t, _ in build(SPEC).exposures() if k <= frames[-1].index}
    sim = build(SPEC)
    for frame in frames:
        t = expected[frame.index]
        assert abs(frame.t - t_0 - t) < MOST_JITTER * ZED.stamp_jitter + 1e-6
        left, right = sim.renderer.pair(t)
        assert np.array_equal(frame.left, left) and np.array_equal(frame.right, right)


def test_a_camera_whose_process_dies_reports_it() -> None:
    camera = SimulatedCamera(SPEC)
    camera._process.kill()
    camera.begin(0.0)
    deadline = time.monotonic() + 20
    events = []
    while not events and time.monotonic() < deadline:
        camera.read(0.2)
        events = list(camera.drain_events())
    assert "simulation.camera_ended" in [e.code for e in events]
    assert camera.read(0.0) is None
