"""Whether there is a screen; to be asked before Qt is, which ends the program if it finds none."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping

NO_SCREEN = (
    "There is no screen to open the window on: neither DISPLAY nor WAYLAND_DISPLAY is set.\n"
    "Without one: `glovetrack demo --headless-report 20`, or any other command (see the README)."
)
PLATFORM = "QT_QPA_PLATFORM"


def has_screen(environment: Mapping[str, str] = os.environ, system: str = sys.platform) -> bool:
    """Whether Qt will find a screen, or has been told what to do without."""
    if not system.startswith("linux"):
        return True
    return any(environment.get(name) for name in (PLATFORM, "DISPLAY", "WAYLAND_DISPLAY"))


def do_without() -> None:
    """Qt paints into memory."""
    os.environ[PLATFORM] = "offscreen"
