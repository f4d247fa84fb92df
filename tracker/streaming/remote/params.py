"""Which ways in are open and where. As built, none is."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from tracker.base.errors import ConfigError
from tracker.streaming.connection import LOOPBACK, StreamError
from tracker.streaming.remote.doors import (
    Door,
    WebSocketDoor,
    is_loopback,
    osc_door,
    udp_door,
)
from tracker.streaming.remote.reception import Answer

DOORS = ("udp", "osc", "websocket", "lsl")
"""Names of the ways in, as fields of `RemoteParams` and as words of the command line. By ``lsl``
come markers, which are notes and nothing else."""
WITHOUT_PORT = ("lsl",)


@dataclass(frozen=True)
class RemoteParams:
    """All off; where on, this computer alone may ask unless ``host`` is another address of it."""

    udp: bool = False
    osc: bool = False
    websocket: bool = False
    lsl: bool = False
    host: str = LOOPBACK
    udp_port: int = 9760
    osc_port: int = 9761
    websocket_port: int = 9762


def with_doors(params: RemoteParams, words: str, host: str = "") -> RemoteParams:
    """``params`` with the ways in of a comma-separated list open: ``udp,osc:9000``.

    Raises ConfigError for a word that is none of them or a number that is no port.
    """
    for word in filter(None, (w.strip().lower() for w in words.split(","))):
        name, colon, port = word.partition(":")
        if name not in DOORS:
            raise ConfigError(f"Remote control goes by {', '.join(DOORS)}, not by {name!r}.")
        changes: dict[str, Any] = {name: True}
        if colon and name in WITHOUT_PORT:
            raise ConfigError(f"{name} has no port of its own.")
        if colon:
            if not port.isdecimal() or not 1 <= int(port) <= 65535:
                raise ConfigError(f"{port!r} is no port for {name}: ports are 1 to 65535.")
            changes[f"{name}_port"] = int(port)
        params = replace(params, **changes)
    return replace(params, host=host) if host else params


def open_door(name: str, params: RemoteParams, answer: Answer) -> Door:
    """One way in. Raises StreamError in words."""
    if name in WITHOUT_PORT:
        return _marker_door(answer, network=not is_loopback(params.host))
    port: int = getattr(params, f"{name}_port")
    if name == "udp":
        return udp_door(answer, params.host, port)
    if name == "osc":
        return osc_door(answer, params.host, port)
    try:
        return WebSocketDoor(answer, params.host, port)
    except ImportError as error:
        raise StreamError(
            f"Remote control by WebSocket needs a package that is not installed ({error}). "
            'Run: pip install "glovetrack[streams]"'
        ) from error


def _marker_door(answer: Answer, network: bool) -> Door:
    try:
        from tracker.streaming.remote.lsl_markers import MarkerDoor
    except (ImportError, RuntimeError) as error:  # RuntimeError: no liblsl beside pylsl
        raise StreamError(
            f"Markers by LSL need a package that is not installed ({error}). "
            'Run: pip install "glovetrack[streams]"'
        ) from error
    return MarkerDoor(answer, network)
