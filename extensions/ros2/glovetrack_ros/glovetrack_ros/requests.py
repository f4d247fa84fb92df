"""Requests to Glovetrack's remote control by UDP: JSON, each with an answer."""

from __future__ import annotations

import json
import socket
from typing import Any

WAIT = 2.0  # s for an answer
MOST_MS = 2000


def ask(address: tuple[str, int], words: dict[str, Any]) -> tuple[bool, str]:
    """Whether it was done, and a sentence about it."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as door:
        door.settimeout(WAIT)
        try:
            door.sendto(json.dumps(words).encode(), address)
            reply = json.loads(door.recv(65536))
        except (OSError, ValueError) as error:
            return False, f"Glovetrack does not respond at {address[0]}:{address[1]}: {error}"
    return bool(reply.get("ok")), str(reply.get("text") or reply.get("error") or "")


def vibration(finger: str, strength: float, seconds: float = 0.1) -> dict[str, Any]:
    """The request for a motor: ``strength`` 0 to 1."""
    amplitude = round(255 * min(max(strength, 0.0), 1.0))
    duration = round(min(max(1000 * seconds, 1), MOST_MS))
    return {"do": "vibrate", "finger": finger, "amplitude": amplitude, "duration_ms": duration}
