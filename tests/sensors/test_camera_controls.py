"""Locks of exposure, gain and white balance with a fake V4L2 driver."""

from __future__ import annotations

import threading

import cv2
import numpy as np
import pytest

from tracker.base.errors import DeviceError
from tracker.sensors.camera_controls import (
    ABSENT,
    ControlledInput,
    Locks,
    locks_from,
    locks_text,
    set_control,
)

EXPOSURE = cv2.CAP_PROP_EXPOSURE


class Driver:
    """Exposure can be set only in manual mode, and there is no gain."""

    def __init__(self) -> None:
        self.values = {
            cv2.CAP_PROP_AUTO_EXPOSURE: 3.0,
            cv2.CAP_PROP_EXPOSURE: 250.0,
            cv2.CAP_PROP_AUTO_WB: 1.0,
            cv2.CAP_PROP_WB_TEMPERATURE: 4600.0,
        }

    def get(self, prop: int) -> float:
        return self.values.get(prop, ABSENT)

    def set(self, prop: int, value: float) -> bool:
        if prop not in self.values:
            return False
        if prop == cv2.CAP_PROP_EXPOSURE and self.values[cv2.CAP_PROP_AUTO_EXPOSURE] != 1.0:
            return False
        if prop == cv2.CAP_PROP_WB_TEMPERATURE and self.values[cv2.CAP_PROP_AUTO_WB]:
            return False
        self.values[prop] = value
        return True


class Input:
    """An image input with drivers; records the thread that accesses them."""

    live, name, fps = True, "camera", 30.0

    def __init__(self, *drivers: Driver) -> None:
        self.drivers, self.is_open, self.threads = drivers, False, set()

    def open(self) -> None:
        if not self.drivers:
            raise DeviceError("There is no camera.")
        self.is_open = True

    def read(self):
        image = np.zeros((2, 2, 3), np.uint8)
        return image, image

    def captures(self):
        self.threads.add(threading.get_ident())
        return list(self.drivers) if self.is_open else []

    def close(self) -> None:
        self.is_open = False


def by_name(source: ControlledInput):
    return {c.name: c for c in source.controls()}


def test_supported_settings_are_read_and_missing_ones_reported():
    source = ControlledInput(Input(Driver()))
    assert not any(c.available for c in source.controls())
    source.open()
    assert source.read() is not None
    found = by_name(source)
    assert found["exposure"].available and found["exposure"].value == 250
    assert not found["exposure"].locked and not found["gain"].available


def test_a_lock_disables_automatic_mode_and_can_be_released():
    driver = Driver()
    source = ControlledInput(Input(driver), Locks(exposure=157.0))
    source.open()
    source.read()
    assert driver.values[cv2.CAP_PROP_AUTO_EXPOSURE] == 1.0
    assert by_name(source)["exposure"].locked and by_name(source)["exposure"].value == 157
    assert driver.values[cv2.CAP_PROP_AUTO_WB] == 1.0
    source.request_locks(Locks(white_balance=5000.0))
    assert driver.values[cv2.CAP_PROP_AUTO_WB] == 1.0  # not before the next image
    source.read()
    assert driver.values[cv2.CAP_PROP_AUTO_EXPOSURE] == 3.0
    assert driver.values[cv2.CAP_PROP_WB_TEMPERATURE] == 5000.0
    assert not by_name(source)["exposure"].locked and by_name(source)["white_balance"].locked


def test_a_missing_control_is_never_reported_as_locked():
    source = ControlledInput(Input(Driver()), Locks(gain=3.0))
    source.open()
    source.read()
    assert not by_name(source)["gain"].available and not by_name(source)["gain"].locked


def test_two_cameras_get_the_same_settings_also_after_reconnection():
    drivers = Driver(), Driver()
    inner = Input(*drivers)
    source = ControlledInput(inner, Locks(exposure=99.0))
    source.open()
    source.read()
    assert [d.values[cv2.CAP_PROP_EXPOSURE] for d in drivers] == [99.0, 99.0]
    drivers[1].values.update(Driver().values)  # unplugged and plugged in again
    source.close()
    source.open()
    source.read()
    assert drivers[1].values[cv2.CAP_PROP_EXPOSURE] == 99.0


def test_drivers_are_accessed_only_by_the_reading_thread():
    inner = Input(Driver())
    source = ControlledInput(inner)
    source.open()
    reader = threading.Thread(target=source.read)
    source.request_locks(Locks(exposure=10.0))
    reader.start()
    reader.join()
    assert threading.get_ident() not in inner.threads and len(inner.threads) == 1


def test_a_missing_camera_is_reported_as_before():
    with pytest.raises(DeviceError, match="no camera"):
        ControlledInput(Input()).open()


def test_locks_are_stored_as_text():
    locks = Locks(exposure=-5.5, white_balance=4600.0)
    assert locks_from(locks_text(locks)) == locks
    assert locks_from("exposure=bright nonsense gain=2") == Locks(gain=2.0)
    assert locks_text(Locks()) == ""


def test_a_lock_is_confirmed_by_reading_it_back():
    class Rounds(Driver):
        """Exposure in steps, as V4L2 cameras have them."""

        def set(self, prop: int, value: float) -> bool:
            return super().set(prop, round(value / 5) * 5 if prop == EXPOSURE else value)

    class Ignores(Driver):
        """Accepts an exposure and does not change."""

        def get(self, prop: int) -> float:
            return 250.0 if prop == EXPOSURE else super().get(prop)

    class Resumes(Driver):
        """Remains in automatic mode."""

        def get(self, prop: int) -> float:
            return 3.0 if prop == cv2.CAP_PROP_AUTO_EXPOSURE else super().get(prop)

    for driver, verified in ((Driver, True), (Rounds, True), (Ignores, False), (Resumes, False)):
        exposure = set_control(driver(), "exposure", 157.0)
        assert exposure.locked and exposure.verified is verified, driver.__name__
        assert exposure.is_unverified is not verified and not exposure.is_open
    assert set_control(Driver(), "exposure", None).is_open


def test_both_of_two_cameras_must_confirm():
    class Ignores(Driver):
        def get(self, prop: int) -> float:
            return 250.0 if prop == EXPOSURE else super().get(prop)

    for pair, verified in (((Driver(), Driver()), True), ((Driver(), Ignores()), False)):
        source = ControlledInput(Input(*pair), Locks(exposure=157.0))
        source.open()
        source.read()
        assert by_name(source)["exposure"].verified is verified
