"""Environments for programs that tests start."""

import os

SCREENS = ("QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY")


def without_screen() -> dict[str, str]:
    """This process's environment on a computer without a screen."""
    return {name: value for name, value in os.environ.items() if name not in SCREENS}
