"""Glove and camera as the window finds them: a glove on a port, a stereo image from a file."""

from __future__ import annotations

import time

import cv2
import numpy as np
import pytest
from gui_fakes import frame_and_blobs, models, simulation

from app.viewmodels.checklist import steps
from app.wizards.glove.choice import SESSION
from tracker.calibration.stereo.checks import extrinsics_of
from tracker.calibration.stereo.files import save_calibration
from tracker.simulation.glove_device import SimulatedGlove
from tracker.simulation.wiggles import PlayAlong

IMAGES = 2
SECONDS = 2.0


@pytest.fixture
def device():
    """A worn glove on a pseudo-terminal."""
    hand, glove, _ = models()
    glove_device = SimulatedGlove(
        PlayAlong(hand, glove).samples(), len(glove.imus), time.monotonic()
    )
    yield glove_device
    glove_device.stop()


@pytest.fixture(scope="module")
def film(tmp_path_factory):
    """A side-by-side film of the simulated hand."""
    path = tmp_path_factory.mktemp("film") / "stereo.avi"
    size = (2 * 1280, 720)
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"MJPG"), 10.0, size)
    pairs = [frame_and_blobs(30 + i)[0] for i in range(IMAGES)]
    for k in range(round(10 * SECONDS)):
        frame = pairs[k % IMAGES]
        writer.write(np.hstack([frame.left, frame.right]))
    writer.release()
    return path


@pytest.fixture
def connected(window, qtbot, store, tmp_path, device, film):
    """The window on both, found by its own search."""
    rig = extrinsics_of(simulation().rig)
    calibration = tmp_path / "mine.yml"
    save_calibration(calibration, rig.left, rig.right, rig.R, rig.T)
    store.update(port=device.path, camera=str(film), calibration=str(calibration))
    window.sources.open_devices()
    qtbot.waitUntil(lambda: window.host.running, timeout=60_000)
    qtbot.waitUntil(lambda: _done(window, "Glove found"), timeout=30_000)
    return window


def _done(window, name: str) -> bool:
    view = window.host.snapshot()
    return next(s for s in steps(view) if s.name == name).done


def test_both_are_found_and_the_list_follows(connected, qtbot, device):
    assert device.path in connected.windowTitle()
    for name in ("All IMUs answer", "Camera found", "Camera calibrated", "Exposure locked"):
        qtbot.waitUntil(lambda n=name: _done(connected, n), timeout=30_000)
    assert connected.host.setup.camera.endswith("mine")
    # the hand lies still: the biases are measured through the glove in use, and the engine has them
    assert not _done(connected, "Measured at rest")
    connected.run_command("glove_setup")
    dialog = connected.set_up.dialogs["glove"]
    assert dialog.choice.port() == SESSION
    dialog.tabs.setCurrentWidget(dialog.still)
    qtbot.waitUntil(dialog.still.start.isEnabled, timeout=30_000)
    dialog.still.start.click()
    qtbot.waitUntil(lambda: _done(connected, "Measured at rest"), timeout=30_000)


def test_a_glove_that_is_unplugged_is_said_in_the_log(connected, qtbot, device):
    device.unplug()

    def said() -> bool:
        texts = [connected.log.list.item(i).text() for i in range(connected.log.list.count())]
        return any("unplugged" in t for t in texts)

    qtbot.waitUntil(said, timeout=30_000)
