"""Limits of controls and serial numbers with a fake driver and system."""

from __future__ import annotations

import struct

import cv2

from tracker.sensors.camera_controls import QUERY, ControlledInput, limits_of, serial_number


def test_limits_are_those_of_the_driver_and_none_if_unsupported():
    asked = []

    def ioctl(device: int, request: int, data: bytearray) -> int:
        control = struct.unpack_from("=I", data)[0]
        asked.append((request, control, len(data)))
        if control == 0x00980913:  # gain
            raise OSError(22, "Invalid argument")
        # struct v4l2_queryctrl: id, type, name, minimum, maximum, step, default, flags, reserved
        struct.pack_into("=II32siiiiI", data, 0, control, 1, b"Exposure", 3, 2047, 1, 250, 0)
        return 0

    assert limits_of("/dev/null", "exposure", ioctl) == (3, 2047, 1, 250)
    assert limits_of("/dev/null", "gain", ioctl) is None
    assert asked[0] == (QUERY, 0x009A0902, 68)
    assert limits_of("/dev/no-such-camera", "exposure", ioctl) is None
    assert limits_of("avfoundation-0", "exposure", ioctl) is None

    def disabled(device: int, request: int, data: bytearray) -> int:
        struct.pack_into("=II32siiiiI", data, 0, 0, 1, b"Exposure", 3, 2047, 1, 250, 1)
        return 0

    assert limits_of("/dev/null", "exposure", disabled) is None


def test_a_device_that_is_not_a_camera_has_no_limits():
    assert limits_of("/dev/null", "exposure") is None


def test_a_serial_number_is_that_of_the_usb_device(tmp_path):
    interface = tmp_path / "usb1" / "1-2" / "1-2:1.0"
    interface.mkdir(parents=True)
    (interface.parent / "serial").write_text("SN28\n")
    entry = tmp_path / "class" / "video0"
    entry.mkdir(parents=True)
    (entry / "device").symlink_to(interface)
    assert serial_number("/dev/video0", tmp_path / "class") == "SN28"
    assert serial_number("/dev/video9", tmp_path / "class") == ""


class Grants:
    """What a device granted, by OpenCV's properties."""

    def __init__(self, **values: float) -> None:
        self.values = {getattr(cv2, f"CAP_PROP_{name}"): value for name, value in values.items()}

    def get(self, prop: int) -> float:
        return self.values.get(prop, -1.0)

    def set(self, prop: int, value: float) -> bool:
        return prop in self.values


class Input:
    """An image input on one device."""

    live, name, fps = True, "camera", 30.0

    def __init__(self, device: Grants) -> None:
        self.device = device

    def open(self) -> None: ...

    def read(self) -> None: ...

    def captures(self):
        return [self.device]

    def close(self) -> None: ...


def test_what_a_camera_grants_is_reported_once_images_are_read():
    fourcc = float(cv2.VideoWriter.fourcc(*"MJPG"))
    device = Grants(FRAME_WIDTH=2560.0, FRAME_HEIGHT=720.0, FPS=60.0, FOURCC=fourcc)
    source = ControlledInput(Input(device), paths=("camera 0",))
    assert source.reports() == ()
    source.open()
    source.read()
    (report,) = source.reports()
    assert (report.width, report.height, report.fps) == (2560, 720, 60.0)
    assert (report.pixel_format, report.path, report.serial_number) == ("MJPG", "camera 0", "")
    nothing = ControlledInput(Input(Grants()))
    nothing.open()
    nothing.read()
    assert nothing.reports()[0].pixel_format == "" and nothing.reports()[0].width == 0
