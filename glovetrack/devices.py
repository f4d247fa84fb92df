"""What is tracked with: real devices or simulated ones."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from tracker.base.errors import ConfigError, DeviceError
from tracker.base.notices import notice
from tracker.glove import library
from tracker.glove.files import parse_glove
from tracker.hand.files import parse_hand
from tracker.sensors.glove_link import GloveLink
from tracker.sensors.glove_port import GlovePort
from tracker.sensors.link_params import LinkParams
from tracker.sensors.protocol import BAUD
from tracker.sensors.sources import CameraSource, GloveSource, NoCamera

if TYPE_CHECKING:
    from tracker.vision.rig import StereoRig

START_TIMEOUT = 120.0  # s, for simulated devices on a loaded computer
LEAD = 0.25  # s until simulated devices begin
DURATION = 3600.0  # s of simulated motion
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
    from tracker.sensors.discovery import find_gloves

    texts = library.texts(glove, hand or None)
    reports = find_gloves([port] if port else None, FIND_GLOVE)
    there = next((report for report in reports if report.is_glove), None)
    if there is None:
        reasons = tuple(report.trouble for report in reports if report.trouble)
        if port:
            raise DeviceError(notice("glove.not_at_port", port=port, reasons=reasons))
        raise DeviceError(notice("glove.not_at_usb", reasons=reasons))
    return Devices(
        (ConnectedGlove(*texts, _link(texts, there.path, there.baud)),), NoCamera(), None
    )


def with_camera(devices: Devices, camera: str | int, calibration: str | Path) -> Devices:
    """The same devices with a stereo camera. Raises ConfigError where it has no calibration."""
    from tracker.calibration.stereo.files import load_rig
    from tracker.sensors.camera import StereoCamera
    from tracker.sensors.camera_plugins import is_plugin, open_plugin
    from tracker.sensors.image_input import CaptureFormat, ImageInput, StreamInput

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


def simulated_devices(seed: int, fps: float, hands: str, camera: bool) -> Devices:
    """A simulated wearer's gloves and camera. Raises DeviceError where they do not start."""
    from tracker.offline.simulate import GLOVES
    from tracker.simulation.camera_device import NoSimulatedCamera, SimulatedCamera
    from tracker.simulation.demo import DemoSpec, HandTexts
    from tracker.simulation.glove_process import GloveProcess

    sides = [side for side in ("right", "left") if hands in (side, "both")]
    if not sides:
        raise ConfigError(
            notice("option.choice", option="hands", known=("right", "left", "both"), value=hands)
        )
    texts = {side: HandTexts(*library.texts(GLOVES[side])) for side in sides}
    main, *others = texts.values()
    spec = DemoSpec(*main, seed, DURATION, fps, others=tuple(others))
    images = SimulatedCamera(spec) if camera else NoSimulatedCamera()
    process = GloveProcess(spec)

    def end() -> None:
        process.close()
        images.close()

    try:
        if not images.wait_ready(START_TIMEOUT):
            raise DeviceError(notice("simulator.camera_not_started"))
        paths = process.paths(START_TIMEOUT)
        gloves = tuple(
            ConnectedGlove(*texts[side], _link(texts[side], paths[side])) for side in sides
        )
    except BaseException:  # Ctrl+C too must not leave processes behind
        end()
        raise

    def begin() -> None:
        t_0 = time.monotonic() + LEAD
        images.begin(t_0)
        process.begin(t_0)

    return Devices(gloves, images, spec.rig if camera else None, True, begin, end)


def _link(texts: tuple[str, str], path: str, baud: int = BAUD) -> GloveLink:
    """Returns the link to the glove at a port, which reopens after the glove was unplugged."""
    imus = len(parse_glove(texts[1], parse_hand(texts[0])).imus)
    return GloveLink(GlovePort(path, baud), imus, LinkParams(baud=baud))
