"""Runs a motor of a glove, and measures how much it shakes the IMUs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from app.engines.engine import EngineSetup
from app.engines.host_parts import CurrentEngine
from app.jobs.own_gloves import OwnGloveSettings, own_vibration, save_own
from app.storage.settings import SettingsOf
from app.viewmodels.device_settings import CONTROLS, DeviceValue, Value, locks_of
from app.viewmodels.names import display_name
from app.words import error_text, local, tr
from tracker import GRAVITY
from tracker.base.errors import DeviceError, GlovetrackError
from tracker.base.files import write_with_folder
from tracker.base.notices import notice
from tracker.base.toml_reader import read_text
from tracker.calibration.motor_vibration import Vibration, vibration_of
from tracker.glove.imu_values import with_vibration
from tracker.glove.model import GloveModel, ImuVibration
from tracker.messages import ImuSample
from tracker.sensors.camera_controls import locks_text

AMPLITUDE, RUN_MS, FULL = 160, 800, 255
SPUN_UP_S = 0.1
WAIT_MS = 300
"""After the run, until its packets have arrived."""
BEFORE_S = 1.0


class MotorTest(QObject):
    """``measured``: the result in words. The glove's own file contains it from then on; the filter
    uses it from the next start on."""

    measured = Signal(str)

    def __init__(
        self, host: CurrentEngine, store: SettingsOf[OwnGloveSettings], parent: QObject
    ) -> None:
        super().__init__(parent)
        self._host, self._store = host, store
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(RUN_MS + WAIT_MS)
        self._timer.timeout.connect(self.evaluate)
        self._run: tuple[str, int, float] | None = None  # side, channel and start of the packets

    def run(self, side: str, channel: int) -> bool:
        """Run a motor; returns whether the command was sent."""
        hand = self._hand(side)
        glove = hand.connection.device if hand is not None else None
        if hand is None or glove is None or not glove.vibrate(channel, AMPLITUDE, RUN_MS):
            return False
        recent = hand.tracked.recent_imu()
        self._run = (side, channel, recent[-1].t) if recent else None
        self._timer.start()
        return True

    def _hand(self, side: str) -> EngineSetup | None:
        return self._host.setup.seen_from(side) if self._host.setup is not None else None

    def evaluate(self) -> None:
        """Compare the packets of the run with those before it."""
        run, self._run = self._run, None
        hand = self._hand(run[0]) if run is not None else None
        if run is None or hand is None:
            return
        _, channel, start = run
        recent = hand.tracked.recent_imu()
        found = vibration_of(*_parts(recent, start))
        if found is None:
            return
        share = AMPLITUDE / FULL
        self.measured.emit(vibration_words(hand.glove, channel, found))
        gyro, accel = (x / share for x in found.densities)
        try:
            self._save(hand, channel, gyro, accel)
        except GlovetrackError as error:
            self.measured.emit(error_text(error))

    def _save(self, hand: EngineSetup, channel: int, gyro: np.ndarray, accel: np.ndarray) -> None:
        if not hand.connection.own_file:
            return
        known = own_vibration(hand)
        device = hand.connection.device
        motors = max(device.report().motors if device is not None else 0, channel + 1)
        new = {
            name: _with_motor(known[name], motors, channel, float(gyro[j]), float(accel[j]))
            for j, name in enumerate(hand.glove.imu_names)
        }
        save_own(self._store, hand, lambda text: with_vibration(text, new))


def _parts(recent: Sequence[ImuSample], start: float) -> tuple[list[ImuSample], list[ImuSample]]:
    end = start + RUN_MS / 1000
    before = [s for s in recent if start - BEFORE_S <= s.t <= start]
    return before, [s for s in recent if start + SPUN_UP_S < s.t <= end]


def _with_motor(
    known: ImuVibration | None, motors: int, channel: int, gyro: float, accel: float
) -> ImuVibration:
    """Of one IMU, with another value of one motor; motors that were not measured have 0."""
    out = []
    for name, value in (("gyro", gyro), ("accel", accel)):
        row = np.zeros(motors)
        before = getattr(known, name) if known is not None else row
        row[: min(motors, len(before))] = before[:motors]
        row[channel] = value
        out.append(row)
    return ImuVibration(*out)


def vibration_words(glove: GloveModel, channel: int, found: Vibration) -> str:
    """A line for the motor, and one for each IMU that it shakes, the most first."""
    lines = [tr("Motor {} shakes the IMUs (standard deviation):").format(channel + 1)]
    for j in np.argsort(-found.accel):
        values = (
            f"{local(found.accel[j] / GRAVITY):.3f}",
            f"{local(np.rad2deg(found.gyro[j])):.2f}",
        )
        lines.append(tr("{}: {} g, {} °/s").format(display_name(glove.imu_names[j]), *values))
    return "\n".join(lines)


# ---- changes of device settings, which are sent to the devices and stored; and settings files


def apply_changes(
    setup: EngineSetup,
    store: SettingsOf[object],
    values: Sequence[DeviceValue],
    edits: Mapping[str, Value],
) -> None:
    """Send ``edits`` to the devices of ``setup``; those of simulated devices are not stored.

    Raises DeviceError for a rate that exceeds the glove's line speed.
    """
    for key, wanted in edits.items():
        device, _, name = key.partition(".")
        if name == "rate_hz" and isinstance(wanted, int):
            _set_rate(setup.seen_from(device.removeprefix("glove_")), wanted)
            if not setup.simulated:
                store.update(glove_rate=wanted)
    controls = setup.camera.controls
    if controls is not None and any(f"camera.{name}" in edits for name in CONTROLS):
        locks = locks_of(values, edits)
        controls.request_locks(locks)
        store.update(camera_locks=locks_text(locks))


def _set_rate(setup: EngineSetup, rate_hz: int) -> None:
    if setup.connection.device is None:
        return
    try:
        setup.connection.device.request_rate(rate_hz)
    except ValueError as error:
        raise DeviceError(notice("window.glove_settings", why=str(error))) from error


def save_settings(text: str, path: Path) -> None:
    """Write a file of settings. Raises FileError."""
    write_with_folder(path, text)


def read_settings(path: Path) -> str:
    """The text of a file of settings. Raises FileError."""
    return read_text(path)
