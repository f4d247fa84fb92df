"""Check for a screen before Qt is started: Qt ends the program without one."""

from __future__ import annotations

import os
import re
import socket
import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

PLATFORM = "QT_QPA_PLATFORM"
TIMEOUT = 3.0  # s to connect to a screen on another computer
X_PORT = 6000
Address = tuple[str, int] | str
"""Host and port, or the path of a local socket."""


def answers(address: Address) -> bool:
    """Whether a server listens at the address."""
    family = socket.AF_UNIX if isinstance(address, str) else socket.AF_INET
    try:
        if not isinstance(address, str):
            socket.create_connection(address, TIMEOUT).close()
            return True
        with socket.socket(family, socket.SOCK_STREAM) as line:
            line.connect(address)
        return True
    except OSError:
        return False


def addresses(environment: Mapping[str, str]) -> Iterator[Address]:
    """Addresses of the screens that the environment names."""
    found = re.fullmatch(r"(?:(.*)/)?(.*):(\d+)(?:\.\d+)?", environment.get("DISPLAY", ""))
    if found is not None:
        _, host, number = found.groups()
        if host in ("", "unix"):
            yield f"/tmp/.X11-unix/X{number}"
            yield f"\0/tmp/.X11-unix/X{number}"
        else:
            yield host.strip("[]"), X_PORT + int(number)
    wayland = environment.get("WAYLAND_DISPLAY", "")
    if wayland:
        yield str(Path(environment.get("XDG_RUNTIME_DIR", "")) / wayland)


def has_screen(
    environment: Mapping[str, str] = os.environ,
    system: str = sys.platform,
    listens: Callable[[Address], bool] = answers,
) -> bool:
    """Whether Qt will find a screen, or is configured to run without one."""
    if not system.startswith("linux"):
        return True
    platform = environment.get(PLATFORM, "").partition(":")[0]
    if platform and not platform.startswith(("xcb", "wayland")):
        return True
    return any(listens(address) for address in addresses(environment))
