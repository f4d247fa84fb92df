"""Settings of a camera that tracking needs whatever the user chose, set and read back (Linux).

Flicker of lamps is suppressed for the frequency of the mains; autofocus, digital zoom and mirroring
are switched off, because each of them changes the calibration.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from tracker.base.notices import Notice, warning
from tracker.sensors.v4l2 import ControlIo

POWER_LINE, AUTOFOCUS, ZOOM, MIRROR, FLIP = (
    0x00980918,  # V4L2_CID_POWER_LINE_FREQUENCY: 0 off, 1 50 Hz, 2 60 Hz, 3 automatic
    0x009A090C,  # V4L2_CID_FOCUS_AUTO
    0x009A090D,  # V4L2_CID_ZOOM_ABSOLUTE
    0x00980914,  # V4L2_CID_HFLIP
    0x00980915,  # V4L2_CID_VFLIP
)
POWER_LINE_VALUES = {50: 1, 60: 2}
LOCAL_TIME = Path("/etc/localtime")
SIXTY_HZ_ZONES = frozenset(
    {"Asia/Seoul", "Asia/Taipei", "Asia/Manila", "Asia/Riyadh", "Pacific/Guam"}
)
FIFTY_HZ_AMERICA = ("Argentina", "Buenos_Aires", "Santiago", "La_Paz", "Asuncion", "Montevideo")


@dataclass(frozen=True)
class FixedSetting:
    """One setting of one camera: what is wanted and what the camera reads back."""

    name: str
    wanted: int
    found: int

    @property
    def is_verified(self) -> bool:
        return self.wanted == self.found


def fix_settings(path: str, mains_hz: int, io: ControlIo | None = None) -> list[FixedSetting]:
    """Sets what differs, and reads all of it back; settings that a camera lacks are left out.

    Empty on other systems than Linux and where ``path`` cannot be opened.
    """
    io = io or ControlIo(path)
    wanted: Mapping[str, tuple[int, int | None]] = {
        "power_line": (POWER_LINE, POWER_LINE_VALUES[mains_hz]),
        "autofocus": (AUTOFOCUS, 0),
        "zoom": (ZOOM, None),  # the minimum: no zoom
        "mirror": (MIRROR, 0),
        "flip": (FLIP, 0),
    }
    found = []
    with io:
        for name, (control, value) in wanted.items():
            limits = io.limits(control)
            if limits is None:
                continue
            target = int(limits.least) if value is None else value
            if io.get(control) != target:
                io.set(control, target)
            now = io.get(control)
            if now is not None:
                found.append(FixedSetting(name, target, now))
    return found


def unverified(camera: str, settings: list[FixedSetting]) -> Notice | None:
    """A warning that names the settings that a camera did not apply; None if it applied all."""
    refused = [s.name for s in settings if not s.is_verified]
    if not refused:
        return None
    return warning("camera.not_fixed", camera=camera, settings=[SETTING_NAMES[n] for n in refused])


SETTING_NAMES = {
    "power_line": "power-line frequency",
    "autofocus": "autofocus",
    "zoom": "digital zoom",
    "mirror": "mirrored",
    "flip": "upside down",
}


def local_mains_hz(local_time: Path = LOCAL_TIME) -> int:
    """Mains frequency derived from the system's time zone: 60 Hz in the listed zones, otherwise 50
    Hz.

    In Japan both exist; 50 Hz is assumed there.
    """
    zone = str(local_time.resolve()).partition("zoneinfo/")[2]
    if zone.startswith(("US/", "Canada/")) or zone in SIXTY_HZ_ZONES:
        return 60
    if zone.startswith("America/") and not any(name in zone for name in FIFTY_HZ_AMERICA):
        return 60
    return 50
