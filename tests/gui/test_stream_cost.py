"""The tool that measures what streams cost: its quotients, and the process that reads streams."""

from __future__ import annotations

import json
import socket
import subprocess
import sys
import time

import pytest

from app.tools.stream_cost import Cost, Processes, StreamTurn, _free_ports
from app.tools.stream_readers import DATAGRAMS
from tracker.streaming.registry import stream_kinds


def test_quotients_are_medians_over_the_pairs_of_turns() -> None:
    cost = Cost(["udp"], Processes(True, False))
    cost.off = [StreamTurn(1.0, 10.0), StreamTurn(2.0, 10.0), StreamTurn(4.0, 40.0)]
    cost.on = [StreamTurn(1.1, 11.0), StreamTurn(2.0, 30.0), StreamTurn(6.0, 42.0)]
    cost.conclude()
    assert cost.median_ratio == pytest.approx(1.1)
    assert cost.p99_ratio == pytest.approx(1.1)
    assert cost.p99_ratio_range == pytest.approx((1.05, 3.0))


def test_readers_count_what_they_receive() -> None:
    (port,) = _free_ports(1)
    command = [sys.executable, "-m", "app.tools.stream_readers", f"udp={port}", "isaac=0"]
    reader = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        for _ in range(3):
            wait_until_bound(port)
            sock.sendto(b"{}", ("127.0.0.1", port))
    assert reader.stdin is not None and reader.stdout is not None
    counts: dict[str, int] = {}
    end = time.monotonic() + 60
    while counts.get("udp") != 3 and time.monotonic() < end:
        reader.stdin.write("\n")
        reader.stdin.flush()
        counts = json.loads(reader.stdout.readline())
    said, _ = reader.communicate("", timeout=60)
    assert json.loads(said) == counts == {"udp": 3}


def wait_until_bound(port: int) -> None:
    end = time.monotonic() + 60
    while time.monotonic() < end:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            try:
                probe.bind(("127.0.0.1", port))
            except OSError:
                return
        time.sleep(0.02)
    raise AssertionError("the reader does not listen")


def test_datagrams_are_of_streams_that_have_ports() -> None:
    kinds = stream_kinds()
    assert all(kinds[name].has("port") for name in DATAGRAMS)
