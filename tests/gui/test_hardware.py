"""Glove and camera as found by the window: a glove on a port, a stereo image from a file."""

from __future__ import annotations

import time

import cv2
import numpy as np
import pytest

from app.engines.protocols import RecordingRequest
from app.viewmodels.checklist import steps
from app.viewmodels.sensors import imu_states
from app.viewmodels.states import IDLE
from app.wizards.camera import CameraSetup
from app.wizards.glove.choice import SESSION
from app.wizards.glove.feed import InstructedWearer
from app.wizards.stereo.image_choices import image_choices
from app.words import notice_text
from tests.gui.gui_fakes import frame_and_blobs, models, simulation
from tests.notices import shows
from tracker.base.notices import failure
from tracker.calibration.stereo.board import BoardSpec
from tracker.calibration.stereo.checks import extrinsics_of
from tracker.calibration.stereo.files import save_calibration
from tracker.messages import Event, Tracking, Validity
from tracker.sensors.stereo_calibration import Intrinsics
from tracker.simulation.glove_device import GloveDeviceParams, SimulatedGlove

IMAGES = 2
SECONDS, FPS = 8.0, 10.0  # of the film: an ended one is not found


@pytest.fixture
def device():
    """A worn glove on a pseudo-terminal."""
    hand, glove, _ = models()
    glove_device = SimulatedGlove(
        InstructedWearer(hand, glove).samples(),
        len(glove.imus),
        time.monotonic(),
        GloveDeviceParams(firmware=(0, 9, 0)),
    )
    yield glove_device
    glove_device.stop()


@pytest.fixture(scope="module")
def film(tmp_path_factory):
    """A side-by-side film of the simulated hand."""
    path = tmp_path_factory.mktemp("film") / "stereo.avi"
    size = (2 * 1280, 720)
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"MJPG"), FPS, size)
    pairs = [frame_and_blobs(30 + i)[0] for i in range(IMAGES)]
    for k in range(round(FPS * SECONDS)):
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
    qtbot.waitUntil(lambda: window.host.running)
    qtbot.waitUntil(lambda: _done(window, "Glove found"))
    return window


def _done(window, name: str) -> bool:
    view = window.host.snapshot()
    return next(s for s in steps(view) if s.name == name).done


@pytest.mark.long
def test_both_are_found_and_the_list_follows(connected, qtbot, device):
    assert device.path in connected.windowTitle()
    for name in ("All IMUs respond", "Camera found", "Camera calibrated"):
        qtbot.waitUntil(lambda n=name: _done(connected, n))

    def exposure():  # of a film
        return next(s for s in steps(connected.host.snapshot()) if s.name == "Exposure locked")

    qtbot.waitUntil(lambda: exposure().check)
    assert exposure().reason.startswith("Cannot be verified")
    assert connected.host.setup.camera.name.endswith("mine")
    found = next(s for s in steps(connected.host.snapshot()) if s.name == "Glove found")
    assert "(installed: 0.9.0)" in found.reason
    # the hand is at rest: the biases are measured through the glove in use, and applied to the
    # engine
    assert not _done(connected, "Measured at rest")
    connected.run_command("glove_setup")
    dialog = connected.set_up.dialogs["glove"]
    assert dialog.choice.port() == SESSION
    dialog.tabs.setCurrentWidget(dialog.still)
    qtbot.waitUntil(dialog.still.start.isEnabled)
    dialog.still.start.click()
    qtbot.waitUntil(lambda: _done(connected, "Measured at rest"))


@pytest.mark.long
def test_an_unplugged_glove_is_logged(connected, qtbot, device):
    device.unplug()

    def is_logged() -> bool:
        texts = [connected.log.list.item(i).text() for i in range(connected.log.list.count())]
        return any("unplugged" in t for t in texts)

    qtbot.waitUntil(is_logged)


@pytest.fixture
def glove_alone(window, qtbot, store, device, monkeypatch):
    """The window on a glove; there is no camera and no calibration."""
    monkeypatch.setattr("app.engines.camera_choice.all_cameras", list)
    store.update(port=device.path, camera="", calibration="")
    window.sources.open_devices()
    qtbot.waitUntil(lambda: window.host.running)
    return window


@pytest.mark.long
def test_a_glove_without_a_camera_is_shown_by_its_imus(glove_alone, qtbot):
    window = glove_alone
    qtbot.waitUntil(lambda: window.hand._scene is not None)
    assert shows(window.banner.text(), "camera.none_found")
    assert shows(window.banner.text(), "window.no_rig")
    for name in ("Glove found", "All IMUs respond"):
        qtbot.waitUntil(lambda n=name: _done(window, n))
    assert not _done(window, "Camera found") and not _done(window, "Camera calibrated")
    qtbot.waitUntil(lambda: "Position unknown" in window.hand._scene.caption)
    scene, view = window.hand._scene, window.host.snapshot()
    assert np.isfinite(scene.segment_p).all()
    assert scene.segment_state[0] == Validity.LOST and Validity.MEASURED in scene.segment_state
    assert view.estimate.tracking == Tracking.LOST
    window.sources.set_engine("chain")
    assert shows(window.banner.text(), "engine.needs_camera")


def test_a_glove_alone_is_recorded_and_replayed(glove_alone, qtbot, tmp_path):
    window = glove_alone
    qtbot.waitUntil(lambda: window.hand._scene is not None)
    path = tmp_path / "alone.mcap"
    assert window.host.recording.begin(RecordingRequest(path, "", ""))
    qtbot.waitUntil(lambda: window.host.recording.written > 100)
    window.host.recording.end()
    window.sources.open_session(path)
    qtbot.waitUntil(lambda: (s := window.host.setup) is not None and s.player is not None)
    window.host.setup.player.play(True)  # its first instants may be those of a search
    qtbot.waitUntil(lambda: window.hand._scene is not None)
    assert "Position unknown" in window.hand._scene.caption
    assert len(window.host.snapshot().imu) > 0


@pytest.mark.long
def test_one_webcam_is_a_complete_rig(window, qtbot, store, tmp_path, device):
    """Its image is not wide enough for two; its calibration is of one camera."""
    path, rig = tmp_path / "webcam.avi", extrinsics_of(simulation().rig)
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"MJPG"), FPS, (1280, 720))
    for k in range(round(FPS * SECONDS)):
        writer.write(frame_and_blobs(30 + k % IMAGES)[0].left)
    writer.release()
    save_calibration(tmp_path / "webcam.yml", rig.left)
    calibration = str(tmp_path / "webcam.yml")
    store.update(port=device.path, camera=str(path), calibration=calibration)
    window.sources.open_devices()
    qtbot.waitUntil(lambda: window.host.running)
    assert window.host.setup.whole and window.host.setup.camera.rig.one_camera
    qtbot.waitUntil(lambda: window.host.snapshot().frame is not None)
    frame = window.host.snapshot().frame
    assert frame.left.shape == (720, 1280, 3) and frame.right is None
    assert _done(window, "Camera calibrated")
    qtbot.waitUntil(lambda: window.cameras.right.isHidden())
    assert not window.cameras.left.isHidden()


@pytest.mark.long
def test_a_camera_without_glove_or_calibration_gives_its_images(window, qtbot, store, film):
    store.update(port="", camera=str(film), calibration="")
    window.sources.open_devices()
    qtbot.waitUntil(lambda: window.host.running)
    qtbot.waitUntil(lambda: _done(window, "Camera found"))
    assert shows(window.banner.text(), "window.no_glove")
    assert not _done(window, "Glove found") and not _done(window, "Camera calibrated")
    view = window.host.snapshot()
    assert view.frame.left is not None and len(view.blobs.left) > 5, "colours can be tuned"
    assert window.host.setup.camera.device.fps == pytest.approx(FPS), (
        "a film is paced by its own rate"
    )


@pytest.mark.long
def test_a_device_that_disappears_changes_its_row_within_a_second(connected, qtbot, device):
    qtbot.waitUntil(lambda: _done(connected, "All IMUs respond"))
    device.unplug()
    looked = [time.monotonic()]

    def has_no_packets() -> bool:
        looked.append(time.monotonic())
        return not _done(connected, "Glove found")

    qtbot.waitUntil(has_no_packets)
    stalled = np.maximum(np.diff(looked) - 0.1, 0.0).sum()  # of a busy computer
    assert looked[-1] - looked[0] - stalled < 1.5
    assert not _done(connected, "All IMUs respond")
    view = connected.host.snapshot()
    states = imu_states(view.setup.glove.imu_names, view.imu, view.packets_arrive)
    assert {s.look for s in states} == {IDLE}, "no green dot of an IMU that is gone"


@pytest.mark.long
def test_stop_clears_live_data(connected, qtbot):
    qtbot.waitUntil(lambda: connected.host.snapshot().frame is not None)
    connected.host.stop()
    view = connected.host.snapshot()
    assert view.frame is None and view.estimate is None and len(view.imu) == 0
    assert not any(s.done for s in steps(view))


def test_the_board_wizard_accepts_an_uncalibrated_camera(window, qtbot, store, film):
    store.update(port="", camera=str(film), calibration="")
    window.sources.open_devices()
    qtbot.waitUntil(lambda: window.host.running)
    qtbot.waitUntil(lambda: window.host.snapshot().frame is not None)
    in_use = image_choices(window.host, store.value, [])[0]
    assert in_use.title == "Camera in use"
    assert in_use.make(BoardSpec()).read()[0].shape == (720, 1280, 3)


@pytest.mark.long
def test_a_camera_that_does_not_match_is_shown_and_calibrated(window, qtbot, store, film, tmp_path):
    """With the calibration of another one it could neither be displayed nor calibrated."""
    path = tmp_path / "small.yml"
    K = np.array([[600.0, 0, 319.5], [0, 600.0, 239.5], [0, 0, 1]])
    save_calibration(path, Intrinsics(640, 480, K, np.zeros(5)))
    store.update(port="", camera=f"one:{film}", calibration=str(path))
    window.sources.open_devices()
    qtbot.waitUntil(lambda: window.host.running)
    why = "but its calibration is for 640 by 480."
    qtbot.waitUntil(lambda: why in window.cameras.left._placeholder)
    view = window.host.snapshot()
    step = next(s for s in steps(view) if s.name == "Camera found")
    assert why in step.reason and step.command == "stereo"
    images = image_choices(window.host, store.value, [])[0].make(BoardSpec())
    assert images.read()[0].shape[:2] == view.unfit.pair[0].shape[:2]
    dialog = CameraSetup(window.host, store, window.tasks, window, list)
    qtbot.addWidget(dialog)
    dialog._tick()
    assert why in dialog.arriving.text() and dialog.images[0]._array is not None


@pytest.mark.long
def test_the_board_wizard_offers_no_camera_in_use_where_there_is_none(glove_alone, store):
    titles = [c.title for c in image_choices(glove_alone.host, store.value, [])]
    assert titles == ["Simulated board (demo)"]


def test_a_glove_of_the_other_hand_is_reported_above_the_panels(live, engine, qtbot):
    """In the layout *Watch* the log, its only place before, is hidden."""
    other = failure("glove.other_hand", other="left", glove="mine", side="right")
    engine.events.append(Event.of(0.0, "error", other))
    text = notice_text(other)
    qtbot.waitUntil(lambda: live.banner.text() == text)
    assert live.messages.isVisible()
    assert live.log.model.ends_with(text)
