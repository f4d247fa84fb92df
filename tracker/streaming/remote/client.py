"""Sends requests to a window on another computer, or in another session of this one, over UDP."""

from __future__ import annotations

import json
import socket
from typing import Any

from tracker.base.notices import notice
from tracker.streaming.connection import StreamError

ANSWER_BYTES = 65536
UDP_PORT = 9760


def ask(words: dict[str, Any], host: str, port: int = UDP_PORT, wait: float = 5.0) -> str:
    """Send one request and wait ``wait`` s for its answer, as JSON. Raises StreamError.

    It is sent once: if the answer to a start is lost, a second one would be refused.
    """
    try:
        family, kind, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[0]
        with socket.socket(family, kind) as asking:
            asking.settimeout(wait)
            asking.connect(address)
            asking.send(json.dumps(words).encode())
            return asking.recv(ANSWER_BYTES).decode("utf-8")
    except (OSError, UnicodeError, OverflowError) as error:
        reason = str(error) or type(error).__name__
        raise StreamError(notice("remote.no_window", host=host, port=port, why=reason)) from error
