"""The listener program of the user guide, run unchanged."""

from __future__ import annotations

import re
import socket
from pathlib import Path
from threading import Thread

import pytest

from tracker.streaming.publisher import LOOPBACK, Names
from tracker.streaming.udp import DEFAULT_PORT, UdpPublisher

PAGE = Path(__file__).parents[2] / "docs" / "guide" / "streaming.md"
BLOCK = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)


class _Enough(Exception):
    """Ends a program that would listen forever."""


def free_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind((LOOPBACK, 0))
        return int(probe.getsockname()[1])


def test_the_guides_program_prints_an_estimate(make_estimate, names: Names) -> None:
    """Its own lines, on a free port."""
    (text,) = BLOCK.findall(PAGE.read_text("utf-8"))
    assert str(DEFAULT_PORT) in text
    port = free_port()
    shown: list[tuple[float, str, list[float]]] = []

    def show(t: float, state: str, position: list[float]) -> None:
        shown.append((t, state, position))
        raise _Enough

    def listen() -> None:
        with pytest.raises(_Enough):
            exec(text.replace(str(DEFAULT_PORT), str(port)), {"print": show})

    listener = Thread(target=listen, daemon=True)
    listener.start()
    publisher, estimate = UdpPublisher(names, LOOPBACK, port), make_estimate()
    for _ in range(500):
        publisher.send(estimate)
        listener.join(0.01)
        if not listener.is_alive():
            break
    publisher.close()
    ((t, state, position),) = shown
    assert (t, state) == (estimate.t, "measured")
    row = names.keypoints.index("index_tip")
    assert position == pytest.approx(estimate.keypoints[row], abs=1e-4)
