"""Device settings in the real window: every value, changes, confirmation, files."""

from __future__ import annotations

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest

from app.storage.own_gloves import own_path
from app.viewmodels.device_settings import AUTOMATIC, Confirmed, differences, to_file
from tests.gui.gui_fakes import (
    ScriptedEngine,
    ScriptedGlove,
    scripted_setup,
    with_camera,
    with_glove,
)
from tracker import GRAVITY
from tracker.base.toml_reader import parse_toml
from tracker.glove.files import parse_glove
from tracker.messages import ImuSample
from tracker.sensors.camera_controls import CameraReport, Control, Locks
from tracker.sensors.camera_fixed import FixedSetting
from tracker.sensors.v4l2 import Limits

RATE = "glove_right.rate_hz"


class Camera:
    """Has exposure with limits and no gain; white balance is constant."""

    def __init__(self) -> None:
        self.wanted = Locks()

    def controls(self) -> tuple[Control, ...]:
        exposure = self.wanted.exposure
        return (
            Control(
                "exposure",
                True,
                157.0 if exposure is None else exposure,
                exposure is not None,
                limits=Limits(3.0, 2047.0, 1.0, 250.0),
            ),
            Control("gain"),
            Control(
                "white_balance",
                True,
                4600.0,
                self.wanted.white_balance is not None,
                verified=self.wanted.white_balance is None,
            ),
        )

    def fixed(self) -> tuple[FixedSetting, ...]:
        return ()

    def reports(self) -> tuple[CameraReport, ...]:
        return (CameraReport(2560, 720, 60.0, "MJPG", "V4L2", "/dev/video0", "ZED-77"),)

    def request_locks(self, locks: Locks) -> None:
        self.wanted = locks


@pytest.fixture
def glove() -> ScriptedGlove:
    return ScriptedGlove()


@pytest.fixture
def camera() -> Camera:
    return Camera()


@pytest.fixture
def devices(window, glove, camera, qtbot):
    """The visible panel, with a glove and a camera."""
    setup = dataclasses.replace(
        scripted_setup(ScriptedEngine()),
        simulated=False,
    )
    setup = with_camera(
        with_glove(setup, glove),
        name="ZED Mini",
        calibration_file="SN77.conf",
        device=SimpleNamespace(fps=60.0, unfit=None),
        controls=camera,
    )
    window.host.adopt(setup)
    window.run_command("show_devices")
    qtbot.waitUntil(lambda: bool(window.panels["devices"].values))
    return window.panels["devices"]


def shown(panel, key: str) -> tuple[str, str]:
    item, field = panel.tree.items[key], panel.tree.fields.get(key)
    return field.currentText() if field is not None else item.text(1), item.text(2)


def choose(panel, key: str, value: object) -> None:
    field = panel.tree.fields[key]
    index = field.findData(value)
    field.setCurrentIndex(index)
    field.activated.emit(index)


def type_in(panel, key: str, text: str) -> None:
    line = panel.tree.fields[key].lineEdit()
    line.setText(text)
    line.setModified(True)
    line.editingFinished.emit()


def again(panel) -> None:
    panel.refresh(panel.host.snapshot())


def test_every_readable_value_is_listed_with_its_unit(devices):
    expected = {
        "glove_right.port": "/dev/ttyUSB0",
        "glove_right.adapter": "0403:6001",
        "glove_right.adapter_serial": "A10K",
        "glove_right.latency_timer_ms": "16 ms",
        "glove_right.serial_number": "1234",
        "glove_right.firmware": "1.2.0",
        "glove_right.gyro_range_dps": "2000 °/s",
        "glove_right.accel_range_g": "16 g",
        "glove_right.battery_v": "3.712 V",
        "glove_right.temperature_c": "29.5 °C",
        "glove_right.measured_rate_hz": "100 Hz",
        "glove_right.motors": "2",
        "glove_right.dorsum_answers": "yes",
        "camera.name": "ZED Mini",
        "camera.granted_fps": "60 Hz",
        "camera.calibration": "SN77.conf",
        "camera.device_1_pixel_format": "MJPG",
        "camera.device_1_serial_number": "ZED-77",
        "camera.device_1_size": "2560 × 720",
    }
    assert {key: shown(devices, key)[0] for key in expected} == expected
    assert shown(devices, RATE)[0] == "100 Hz"
    assert "confirmed by the device" in shown(devices, RATE)[1]
    assert shown(devices, "glove_right.dorsum_gyro_bias")[0].startswith("0.57 ± 0.20, ")
    assert shown(devices, "glove_right.dorsum_accel_bias")[0] == "not reported"
    assert set(devices.tree.fields) == {RATE, "camera.exposure", "camera.white_balance"}
    assert "3 to 2047, default 250" in shown(devices, "camera.exposure")[1]


def test_a_change_waits_for_apply_and_can_be_reverted(devices, glove, store):
    choose(devices, RATE, 50)
    assert devices.edits == {RATE: 50} and glove.now.requested_rate_hz == 100
    assert "not applied" in shown(devices, RATE)[1]
    assert devices.tree.items[RATE].font(0).bold()
    again(devices)
    assert shown(devices, RATE)[0] == "50 Hz"
    devices.revert.click()
    assert shown(devices, RATE)[0] == "100 Hz" and not devices.apply.isEnabled()
    choose(devices, RATE, 50)
    devices.apply.click()
    again(devices)
    assert glove.now.requested_rate_hz == 50 and store.value.glove_rate == 50
    assert "confirmed by the device" in shown(devices, RATE)[1]
    assert devices.edits == {} and not devices.tree.items[RATE].font(0).bold()


def test_an_unconfirmed_value_is_shown_as_such(devices, glove, camera):
    glove.obeys = False
    choose(devices, RATE, 200)
    type_in(devices, "camera.white_balance", "5000")
    type_in(devices, "camera.exposure", "90")
    devices.apply.click()
    again(devices)
    assert camera.wanted == Locks(exposure=90.0, white_balance=5000.0)
    assert shown(devices, RATE)[1].startswith("not confirmed by the device")
    assert shown(devices, "camera.white_balance")[1].startswith("not confirmed by the device")
    assert shown(devices, "camera.exposure")[0] == "90"
    assert shown(devices, "camera.exposure")[1].startswith("confirmed by the device")
    glove.now = glove.now._replace(rate_hz=None)
    again(devices)
    assert shown(devices, RATE)[1].startswith("not confirmed yet")
    choose(devices, "camera.exposure", AUTOMATIC)
    devices.apply.click()
    assert camera.wanted == Locks(white_balance=5000.0)


def test_a_value_out_of_its_limits_is_rejected(devices, camera):
    type_in(devices, "camera.exposure", "9000")
    assert devices.edits == {} and "3 to 2047" in devices.report.toPlainText()
    type_in(devices, "camera.exposure", "bright")
    assert devices.edits == {} and not devices.apply.isEnabled()
    assert camera.wanted == Locks()


def test_motors_run_at_the_press_of_a_button(devices, glove):
    devices.tree.motor.emit("glove_right.motor_1")
    assert glove.vibrated == [(1, 160, 800)]
    assert devices.tree.itemWidget(devices.tree.items["glove_right.motor_0"], 1) is not None


def test_running_a_motor_measures_and_keeps_its_vibration(
    devices, window, glove, tmp_path, monkeypatch
):
    """IMU 3 is shaken by 0.2 g; the amplitude is 160 of 255."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    setup = with_glove(window.host.setup, glove, file="vist-small", own_file="mine")
    rng, packets = np.random.default_rng(1), []
    monkeypatch.setattr(setup.tracked, "recent_imu", lambda: list(packets))
    window.host._setup = setup
    for k in range(200):
        if k == 100:
            devices.tree.motor.emit("glove_right.motor_1")
        accel, gyro = rng.normal(0, 0.02, (7, 3)), rng.normal(0, 0.001, (7, 3))
        accel[3] += 0.2 * GRAVITY * np.sin(1.1 * k) if k > 100 else 0.0
        packets.append(ImuSample(k / 100, k / 100, k / 100, k, accel, gyro, np.ones(7, bool)))
    devices.motors.evaluate()
    words = devices.report.toPlainText().splitlines()
    assert words[0].startswith("Motor 2") and words[1].startswith("index proximal: 0.1")
    imus = parse_glove(own_path("mine").read_text(), setup.hand).imus
    expected = 0.2 * GRAVITY / np.sqrt(2) * np.sqrt(0.01) * 255 / 160
    assert imus[3].vibration.accel == pytest.approx([0.0, expected], rel=0.15)
    assert imus[0].vibration.accel[1] < 0.1 * expected


def test_a_search_filters_the_list(devices):
    devices.search.setText("camera exposure")
    in_sight = [key for key, item in devices.tree.items.items() if not item.isHidden()]
    assert in_sight == ["camera.exposure"]
    devices.search.setText("")
    assert not any(item.isHidden() for item in devices.tree.items.values())


def test_a_file_reports_differences_and_applies_what_is_possible(devices, glove, tmp_path):
    path = tmp_path / "devices.toml"
    devices.save_as(path)
    assert parse_toml(path.read_text("utf-8"), path.name)["glove_right"]["rate_hz"] == 100
    devices.load_from(path)
    assert devices.edits == {} and "matches the current" in devices.report.toPlainText()
    text = path.read_text("utf-8")
    text = text.replace("rate_hz = 100", "rate_hz = 50", 1)
    text = text.replace('"1.2.0"', '"1.1.0"').replace('exposure = "automatic"', "exposure = 90")
    path.write_text(text, "utf-8")
    devices.load_from(path)
    assert devices.edits == {RATE: 50, "camera.exposure": 90}
    report_text = devices.report.toPlainText()
    assert "3 differences, 2 to be applied" in report_text
    assert "1.1.0 in the file, 1.2.0 now (cannot be changed)" in report_text
    path.write_text("not [ TOML", "utf-8")
    devices.load_from(path)
    assert path.name in devices.report.toPlainText()


def test_a_value_of_another_type_cannot_be_applied(devices):
    values = list(devices.values.values())
    found = {d.key: d for d in differences('[camera]\nexposure = "x"\n', "a.toml", values)}
    assert not found["camera.exposure"].can_apply
    assert all(d.now is None for d in differences("[glove_left]\nrate_hz = 50\n", "a", values))
    assert 'white_balance = "automatic"' in to_file(values)
    assert devices.values["camera.gain"].confirmed is Confirmed.UNKNOWN


def test_a_glove_without_a_report_and_no_engine_at_all(live, qtbot):
    live.run_command("show_devices")
    qtbot.waitUntil(lambda: bool(live.panels["devices"].values))
    assert RATE not in live.panels["devices"].values and live.panels["devices"].tree.fields == {}
    assert "glove_right.dorsum_answers" in live.panels["devices"].values
    live.host.shut_down()
    assert live.panels["devices"].values == {} and not live.panels["devices"].save.isEnabled()
