"""Which firmware a glove has, beside the one that comes with the program."""

from __future__ import annotations

from tracker.firmware.image import shipped_image, version_text
from tracker.sensors.discovery import find_gloves
from tracker.sensors.protocol import Hello

Version = tuple[int, int, int]


def is_old(version: Version) -> bool:
    """Whether the program brings a newer one."""
    return version < shipped_image().version


def advice(version: Version) -> str:
    """What to say of a glove's firmware; empty where there is nothing to say."""
    if not is_old(version):
        return ""
    return (
        f"Firmware {version_text(shipped_image().version)} is available "
        f"(installed: {version_text(version)})."
    )


def greeting(port: str) -> Hello | None:
    """What the glove at a port says it is; None where none answers."""
    return next((r.hello for r in find_gloves([port]) if r.hello is not None), None)
