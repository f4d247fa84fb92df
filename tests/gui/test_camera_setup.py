"""Choosing a camera by name and locking its exposure, through the window."""

from __future__ import annotations

import threading
from dataclasses import replace
from types import SimpleNamespace

import cv2
import numpy as np
import pytest
from PySide6.QtWidgets import QLabel

from app.engines.camera_choice import by_name, by_names, choose
from app.storage.settings import AppSettings
from app.viewmodels.checklist import steps
from app.viewmodels.states import WARN
from app.wizards.camera import CameraSetup
from tests.gui.gui_fakes import ScriptedEngine, models, scripted_setup, with_camera
from tests.notices import raises
from tracker.base.errors import DeviceError
from tracker.calibration.still import StillImu, StillPose
from tracker.engine.pipeline import Pipeline
from tracker.fusion.chain.engine import ChainEngine
from tracker.sensors.camera_controls import (
    PROPERTIES,
    CameraReport,
    Control,
    ControlledInput,
    Locks,
)
from tracker.sensors.camera_fixed import FixedSetting
from tracker.sensors.image_input import CameraName, StreamInput
from tracker.vision.rig import ideal_rig

ZED = CameraName(2, "ZED-M", "/dev/video2")
WEB = CameraName(0, "Webcam", "/dev/video0")


def chosen(camera: str, cameras: tuple[CameraName, ...] | list[CameraName] = ()):
    """What the settings' text opens."""
    return choose(AppSettings(camera=camera), 640, 480, 30.0, list(cameras))


class Controls:
    """A camera with exposure and white balance, and without gain."""

    def __init__(self) -> None:
        self.wanted = Locks()

    def controls(self) -> tuple[Control, ...]:
        w = self.wanted
        return (
            Control("exposure", True, w.exposure or 250.0, w.exposure is not None),
            Control("gain"),
            Control("white_balance", True, w.white_balance or 4600.0, w.white_balance is not None),
        )

    def fixed(self) -> tuple[FixedSetting, ...]:
        return ()

    def reports(self) -> tuple[CameraReport, ...]:
        return ()

    def request_locks(self, locks: Locks) -> None:
        self.wanted = locks


@pytest.fixture
def controls(window) -> Controls:
    """The window on a real camera that can be locked."""
    made = Controls()
    setup = with_camera(replace(scripted_setup(ScriptedEngine()), simulated=False), controls=made)
    window.host.adopt(setup)
    return made


@pytest.fixture
def dialog(window, qtbot):
    made = CameraSetup(window.host, window.store, window.tasks, window, lambda: [WEB, ZED])
    window.set_up.show_dialog("camera", made)
    qtbot.waitUntil(lambda: made.left.count() == 3)
    return made


def exposure_step(window):
    return next(s for s in steps(window.host.snapshot()) if s.name == "Exposure locked")


def test_the_checklist_requests_the_lock_and_its_button_sets_it(window, controls):
    step = exposure_step(window)
    assert not step.done
    assert step.reason == "The camera changes exposure, white balance automatically."
    window.checklist.action.emit(step.command)
    assert controls.wanted == Locks(exposure=250.0, white_balance=4600.0)
    assert window.store.value.camera_locks == "exposure=250 white_balance=4600"
    assert exposure_step(window).done
    assert exposure_step(window).reason == "exposure 250, white balance 4600"


@pytest.mark.parametrize("controls", [None, SimpleNamespace(controls=lambda: (Control("gain"),))])
def test_unreadable_exposure_is_to_be_checked_and_not_done(window, controls):
    setup = scripted_setup(ScriptedEngine())
    window.host.adopt(with_camera(replace(setup, simulated=False), controls=controls))
    step = exposure_step(window)
    assert not step.done and step.passes and step.look(reachable=False) is WARN
    assert step.reason.startswith("Cannot be verified")


class Deaf:
    """A device whose driver accepts every value and reports others: ``stuck`` the exposure, or
    ``automatic`` its switch."""

    def __init__(self, stuck: float | None = None, automatic: bool = False) -> None:
        self._stuck, self._automatic, self._values = stuck, automatic, {}

    def get(self, prop: int) -> float:
        if prop == cv2.CAP_PROP_AUTO_EXPOSURE and self._automatic:
            return PROPERTIES["exposure"].automatic
        if prop == cv2.CAP_PROP_EXPOSURE and self._stuck is not None:
            return self._stuck
        return self._values.get(prop, 0.0)

    def set(self, prop: int, value: float) -> bool:
        self._values[prop] = value
        return True


class OneDevice:
    """An image input on a device."""

    live, name, fps = True, "camera", 30.0

    def __init__(self, device: Deaf) -> None:
        self._device = device

    def open(self) -> None:
        pass

    def read(self):
        return None

    def captures(self):
        return [self._device]

    def close(self) -> None:
        pass


@pytest.mark.long
@pytest.mark.parametrize("device", [Deaf(stuck=600.0), Deaf(automatic=True)])
def test_an_unconfirmed_lock_is_never_shown_as_done(window, qtbot, device):
    source = ControlledInput(OneDevice(device), Locks(exposure=157.0, white_balance=4600.0))
    setup = scripted_setup(ScriptedEngine())
    window.host.adopt(with_camera(replace(setup, simulated=False), controls=source))
    source.read()
    step = exposure_step(window)
    assert not step.done and step.look(reachable=False) is WARN
    assert step.reason == "Cannot be verified: the camera does not confirm exposure."
    window.store.update(camera_locks="exposure=157 white_balance=4600")
    window.run_command("camera_setup")
    states = window.set_up.dialogs["camera"].locks._states
    qtbot.waitUntil(lambda: states["exposure"].text().startswith("◐ cannot be verified"))
    assert states["white_balance"].text() == "● locked at 4600"
    window.set_up.dialogs["camera"].close()
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_a_number_opens_an_unlisted_camera(window, store, qtbot):
    """The error names the field in which to enter it."""
    with raises(DeviceError, "camera.none_found"):
        chosen("")
    made = CameraSetup(window.host, store, window.tasks, window, list)
    window.set_up.show_dialog("camera", made)
    labels = [label.text().replace("&", "") for label in made.findChildren(QLabel)]
    assert "Or number, file" in labels
    qtbot.waitUntil(lambda: not window.tasks.tasks)
    qtbot.keyClicks(made.other, "1")
    made.use.click()
    assert store.value.camera == "1" and chosen(store.value.camera).title == "camera 1"
    again = CameraSetup(window.host, store, window.tasks, window, list)
    qtbot.addWidget(again)
    assert again.other.text() == "1" and again.choice() == "1"
    again.other_right.setText("2")
    assert chosen(again.choice()).source.name == "1 and 2"
    again._show_cameras([replace(WEB, index=1), ZED])
    assert again.choice() == by_names(WEB, ZED), "the same cameras, by their names"
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_a_disconnected_camera_remains_selected(window, store, qtbot):
    store.update(camera=by_name(ZED))
    made = CameraSetup(window.host, store, window.tasks, window, lambda: [WEB])
    window.set_up.show_dialog("camera", made)
    qtbot.waitUntil(lambda: made.left.currentText() == "ZED-M (not connected)")
    made.use.click()
    assert store.value.camera == by_name(ZED)
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_a_finished_search_does_not_change_an_address_being_typed(window, store, qtbot):
    typed = threading.Event()

    def slowly() -> list[CameraName]:
        assert typed.wait(60)
        return [WEB, ZED]

    store.update(camera=by_name(ZED))
    made = CameraSetup(window.host, store, window.tasks, window, slowly)
    window.set_up.show_dialog("camera", made)
    qtbot.keyClicks(made.other, "rtsp://cam")
    typed.set()
    qtbot.waitUntil(lambda: made.left.count() == 3)
    assert made.other.text() == "rtsp://cam" == made.choice()
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_a_lock_is_set_and_released_in_the_dialog(window, controls, dialog):
    dialog._tick()
    assert not dialog.locks.boxes["gain"].isEnabled()
    assert dialog.locks.values["exposure"].value() == 250
    dialog.locks.boxes["exposure"].click()
    assert controls.wanted == Locks(exposure=250.0)
    dialog.locks.values["exposure"].setValue(120)
    assert controls.wanted == Locks(exposure=120.0)
    dialog.locks.boxes["exposure"].click()
    assert controls.wanted == Locks() and window.store.value.camera_locks == ""


def test_a_camera_is_chosen_by_name_and_found_at_another_port(window, store, dialog):
    dialog.left.setCurrentIndex(2)
    dialog.use.click()
    assert store.value.camera == by_name(ZED) == "name:ZED-M"
    moved = replace(ZED, index=7)
    assert choose(store.value, 1280, 720, 60.0, [WEB, moved]).title == "ZED-M"
    with raises(DeviceError, "camera.not_among", camera="ZED-M", connected=("Webcam",)):
        choose(store.value, 1280, 720, 60.0, [WEB])


def test_two_cameras_a_file_and_an_address_can_be_selected_too(store, dialog, tmp_path):
    dialog.left.setCurrentIndex(1)
    dialog.right.setCurrentIndex(dialog.right.count() - 1)
    assert dialog.choice() == by_names(WEB, ZED) == "pair:Webcam|ZED-M"
    pair = chosen(dialog.choice(), [WEB, ZED])
    assert pair.title == "Webcam and ZED-M" and pair.controls is not None
    twins = by_names(WEB, replace(WEB, index=4))
    assert chosen(twins).source.name == "0 and 4"
    dialog.other.setText("rtsp://camera/stereo")
    dialog.use.click()
    assert store.value.camera == "rtsp://camera/stereo"
    stream = chosen(store.value.camera).source
    assert isinstance(stream, StreamInput) and stream.live
    (tmp_path / "film.mp4").write_bytes(b"")
    assert not chosen(str(tmp_path / "film.mp4")).source.live


def test_two_streams_are_two_cameras_with_their_own_sizes(store, dialog, window, qtbot):
    dialog.other.setText("rtsp://left/eye")
    dialog.other_right.setText("rtsp://right/eye")
    dialog.use.click()
    assert store.value.camera == "pair:rtsp://left/eye|rtsp://right/eye"
    pair = choose(store.value, 1280, 720, 30.0, [], 2, (640, 480))
    assert pair.source.name == "rtsp://left/eye and rtsp://right/eye" and pair.source.live
    assert [request_locks.width for request_locks in pair.source._wants] == [1280, 640]
    again = CameraSetup(window.host, store, window.tasks, window, list)
    qtbot.addWidget(again)
    qtbot.waitUntil(lambda: again.other_right.text() == "rtsp://right/eye")
    assert again.other.text() == "rtsp://left/eye"


@pytest.mark.long
def test_images_can_be_exchanged(store, dialog, tmp_path):
    path = tmp_path / "film.avi"
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"MJPG"), 10.0, (64, 32))
    image = np.zeros((32, 64, 3), np.uint8)
    image[:, :32] = 200
    writer.write(image)
    writer.release()

    def brighter_side() -> str:
        source = choose(store.value, 32, 32, 10.0, []).source
        source.open()
        left, right = source.read()
        source.close()
        assert source.fps == 10.0 and not source.live
        return "left" if left.mean() > right.mean() else "right"

    store.update(camera=str(path))
    assert brighter_side() == "left"
    dialog.other.setText(str(path))
    dialog.exchanged.click()
    dialog.use.click()
    assert brighter_side() == "right"


def test_the_dialog_shows_images_only_while_they_arrive(window, dialog, qtbot):
    left, right = dialog.images
    assert left._array is None and dialog.arriving.text() == ""
    window.host.adopt(scripted_setup(ScriptedEngine()))
    frame = window.host.snapshot().frame
    qtbot.waitUntil(lambda: left._array is not None)
    assert (left._array == frame.left).all() and (right._array == frame.right).all()
    height, width = frame.left.shape[:2]
    assert dialog.arriving.text().startswith(f"Receiving {width} × {height} px")
    assert dialog.arriving.text().endswith("(simulated camera)")
    window.host.end()
    qtbot.waitUntil(lambda: left._array is None)


def test_a_missing_camera_is_reported():
    with raises(DeviceError, "camera.none_found"):
        chosen("")


def test_biases_measured_at_rest_reach_the_engine(window):
    hand, glove, _ = models()
    engine = Pipeline(hand, glove, ideal_rig()).engine
    assert isinstance(engine, ChainEngine)
    scripted = ScriptedEngine()
    scripted.command = lambda work, answer=None: work(engine)
    window.host.adopt(scripted_setup(scripted))
    bias = np.array([0.01, -0.02, 0.03])
    imu = StillImu("", bias, 1e-4, 1e-4, np.zeros(3))
    window.set_up.take_bias(StillPose((imu,) * len(glove.imus)))
    row = engine.calibration().segments.index("index_proximal")
    assert engine.calibration().gyro_bias[row] == pytest.approx(bias)
