"""Which firmware a glove has, beside the one that comes with the program."""

from __future__ import annotations

from tracker.base.notices import Notice, notice
from tracker.firmware.image import shipped_image, version_text
from tracker.sensors.discovery import find_gloves
from tracker.sensors.protocol import Hello

Version = tuple[int, int, int]


def is_old(version: Version) -> bool:
    """Whether the program brings a newer one."""
    return version < shipped_image().version


def advice(version: Version) -> Notice | None:
    """Reports that a newer firmware is available; None where there is none."""
    if not is_old(version):
        return None
    newest, installed = version_text(shipped_image().version), version_text(version)
    return notice("firmware.available", version=newest, installed=installed)


def greeting(port: str) -> Hello | None:
    """The identification of the glove at a port; None if none responds."""
    return next((r.hello for r in find_gloves([port]) if r.hello is not None), None)
