"""What is tracked with: real devices or simulated ones."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from tracker.base.errors import ConfigError, DeviceError
from tracker.base.notices import notice
from tracker.calibration.stereo.files import load_rig
from tracker.glove import library
from tracker.glove.files import parse_glove
from tracker.hand.files import parse_hand
from tracker.sensors.camera import StereoCamera
from tracker.sensors.camera_plugins import is_plugin, open_plugin
from tracker.sensors.discovery import find_gloves
from tracker.sensors.glove_link import GloveLink
from tracker.sensors.glove_port import GlovePort
from tracker.sensors.image_input import CaptureFormat, ImageInput, StreamInput
from tracker.sensors.link_params import LinkParams
from tracker.sensors.protocol import BAUD
from tracker.sensors.sources import CameraSource, GloveSource, NoCamera
from tracker.vision.rig import StereoRig

FIND_GLOVE = 4.0  # s that each port is asked
CAMERA_FPS = 60.0  # asked for; a slower camera grants less


@dataclass(frozen=True, eq=False)
class ConnectedGlove:
    """A glove: the texts of its hand file and glove file, and the source of its packets."""

    hand_text: str
    glove_text: str
    source: GloveSource


@dataclass(frozen=True, eq=False)
class Devices:
    """The gloves and the camera to track with (``rig`` is None without a camera), and functions
    that start and stop them."""

    gloves: tuple[ConnectedGlove, ...]
    camera: CameraSource
    rig: StereoRig | None
    simulated: bool = False
    begin: Callable[[], None] = lambda: None
    end: Callable[[], None] = lambda: None


def glove_devices(port: str = "", glove: str = library.DEFAULT_GLOVE, hand: str = "") -> Devices:
    """A real glove alone. Raises DeviceError where no glove answers."""
    texts = library.texts(glove, hand or None)
    reports = find_gloves([port] if port else None, FIND_GLOVE)
    there = next((report for report in reports if report.is_glove), None)
    if there is None:
        reasons = tuple(report.problem for report in reports if report.problem)
        if port:
            raise DeviceError(notice("glove.not_at_port", port=port, reasons=reasons))
        raise DeviceError(notice("glove.not_at_usb", reasons=reasons))
    return Devices(
        (ConnectedGlove(*texts, glove_link(texts, there.path, there.baud)),), NoCamera(), None
    )


def with_camera(devices: Devices, camera: str | int, calibration: str | Path) -> Devices:
    """The same devices with a stereo camera. Raises ConfigError where it has no calibration."""
    if not calibration:
        raise ConfigError(notice("api.needs_calibration"))
    rig = load_rig(Path(calibration))
    count = len(rig.sides)
    want = CaptureFormat(rig.left.width, rig.left.height, CAMERA_FPS)
    if isinstance(camera, str) and is_plugin(camera):
        source: ImageInput = open_plugin(camera, want)
    else:
        number = int(camera) if str(camera).isdigit() else str(camera)
        live = isinstance(number, int) or not Path(number).is_file()
        source = StreamInput(number, replace(want, width=count * want.width), live, count)
    return replace(devices, camera=StereoCamera(source, rig), rig=rig)


def glove_link(texts: tuple[str, str], path: str, baud: int = BAUD) -> GloveLink:
    """Returns the link to the glove at a port, which reopens after the glove was unplugged."""
    imus = len(parse_glove(texts[1], parse_hand(texts[0])).imus)
    return GloveLink(GlovePort(path, baud), imus, LinkParams(baud=baud))
