"""Cameras of Linux, Windows and macOS, with fake system calls."""

from __future__ import annotations

import sys
from typing import NamedTuple

import cv2
import pytest

from app.engines.camera_choice import choose
from app.storage.settings import AppSettings
from tests.notices import raises, shows
from tracker.base.errors import DeviceError
from tracker.base.notices import notice
from tracker.sensors.camera_controls import ControlledInput
from tracker.sensors.camera_plugins import all_cameras
from tracker.sensors.camera_systems import (
    CameraName,
    exposure_switch,
    is_device_path,
    list_cameras,
)
from tracker.sensors.image_input import CaptureFormat, StreamInput
from tracker.simulation.glove_device import SimulatedGlove


class Info(NamedTuple):
    """A row of `cv2_enumerate_cameras`."""

    index: int
    name: str
    path: str | None


class System:
    """Results per backend; another backend is unknown, as in the package."""

    def __init__(self, **answers: list[Info] | Exception) -> None:
        self.answers = {getattr(cv2, f"CAP_{name}"): value for name, value in answers.items()}
        self.asked: list[int] = []

    def __call__(self, backend: int) -> list[Info]:
        self.asked.append(backend)
        if backend not in self.answers:
            raise NotImplementedError(f"Unsupported backend: {backend}!")
        answer = self.answers[backend]
        if isinstance(answer, Exception):
            raise answer
        return answer


ZED = Info(1, "ZED-M", r"\\?\usb#vid_2b03&pid_f682")


@pytest.mark.parametrize(
    ("system", "name"),
    [("linux", "V4L2"), ("win32", "DSHOW"), ("win32", "MSMF"), ("darwin", "AVFOUNDATION")],
)
def test_each_system_is_queried_by_its_own_backend(system: str, name: str) -> None:
    answers = System(**{name: [ZED]})
    (camera,) = list_cameras(system, answers)
    assert camera == CameraName(1, "ZED-M", ZED.path or "", getattr(cv2, f"CAP_{name}"))


def test_the_second_backend_of_windows_is_tried_if_the_first_finds_nothing() -> None:
    answers = System(DSHOW=[], MSMF=[ZED])
    assert [c.backend for c in list_cameras("win32", answers)] == [cv2.CAP_MSMF]
    assert answers.asked == [cv2.CAP_DSHOW, cv2.CAP_MSMF]


def test_no_cameras_are_not_an_error() -> None:
    assert list_cameras("win32", System(DSHOW=[], MSMF=[])) == []
    assert list_cameras("darwin", System(AVFOUNDATION=[])) == []


@pytest.mark.parametrize(
    ("system", "answers", "words"),
    [
        ("darwin", System(), "Unsupported backend"),
        ("darwin", System(AVFOUNDATION=ImportError("No module named 'AVFoundation'")), "AVFound"),
        ("win32", System(DSHOW=OSError("COM failed"), MSMF=OSError("COM failed")), "COM failed"),
        ("freebsd14", System(), "nothing here knows how"),
    ],
)
def test_a_list_that_fails_is_reported(system: str, answers: System, words: str) -> None:
    with raises(DeviceError, "camera.not_listed") as raised:
        list_cameras(system, answers)
    assert words in str(raised.value) and "number" in str(raised.value)


def test_without_a_list_plugins_and_numbers_still_work(monkeypatch, caplog) -> None:
    def refuse() -> list[CameraName]:
        raise DeviceError(notice("camera.not_listed", why="why"))

    monkeypatch.setattr("tracker.sensors.camera_plugins.list_cameras", refuse)
    assert all_cameras() == []
    assert shows(caplog.text, "camera.not_listed")
    chosen = choose(AppSettings(camera="1"), 64, 48, 30.0)
    assert chosen.title == "camera 1"
    with raises(DeviceError, "camera.none_found"):
        choose(AppSettings(), 64, 48, 30.0)


@pytest.mark.parametrize("camera", ["name:ZED-M", "pair:ZED-M|ZED-M", ""])
def test_a_camera_is_opened_by_the_backend_that_listed_it(camera: str, monkeypatch) -> None:
    opened: list[tuple[object, int]] = []

    class Capture:
        def open(self, source: object, backend: int, *_: object) -> bool:
            opened.append((source, backend))
            return False

        def isOpened(self) -> bool:
            return False

        def release(self) -> None: ...

    monkeypatch.setattr("tracker.sensors.image_input.cv2.VideoCapture", Capture)
    known = [CameraName(1, "ZED-M", "", cv2.CAP_DSHOW)]
    source = choose(AppSettings(camera=camera), 64, 48, 30.0, known).source
    assert isinstance(source, ControlledInput)
    with raises(DeviceError, "camera.not_opened"):
        source.open()
    assert opened == [(1, cv2.CAP_DSHOW)]


@pytest.mark.parametrize(
    ("source", "live", "granted", "expected"),
    [
        (0, True, 30.0, 30.0),
        (0, True, 0.0, 60.0),
        ("rtsp://pipe", True, 25.0, 0.0),
        ("film%d.png", False, 24, 24),
    ],
    ids=["a webcam that grants less", "a driver that is silent", "an address", "a film"],
)
def test_no_more_images_are_expected_than_granted(
    source, live, granted, expected, monkeypatch
) -> None:
    """The remaining requested ones would count as lost."""

    class Capture:
        def open(self, *_: object) -> bool:
            return True

        def isOpened(self) -> bool:
            return True

        def set(self, *_: float) -> bool:
            return True

        def get(self, prop: int) -> float:
            return granted if prop == cv2.CAP_PROP_FPS else -1.0

        def getBackendName(self) -> str:
            return "V4L2"

        def release(self) -> None: ...

    monkeypatch.setattr("tracker.sensors.image_input.cv2.VideoCapture", Capture)
    camera = StreamInput(source, CaptureFormat(fps=60.0), live)
    camera.open()
    assert camera.fps == expected


def test_manual_exposure_has_another_value_on_linux() -> None:
    assert exposure_switch("linux") == (1.0, 3.0)
    assert exposure_switch("win32") == exposure_switch("darwin") == (0.0, 1.0)


def test_only_linux_has_cameras_as_files() -> None:
    assert is_device_path("/dev/video2", "linux")
    assert not is_device_path("/dev/video2", "darwin")
    assert not is_device_path("rtsp://host/stream", "linux")


def test_a_system_without_pseudo_terminals_reports_it(monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "pty", None)
    with raises(DeviceError, "simulator.no_terminal"):
        SimulatedGlove(iter(()), 7)
