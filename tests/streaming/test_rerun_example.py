"""The example for Rerun: its file, read again by Rerun itself, has the poses that were streamed."""

from __future__ import annotations

import socket
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("rerun", reason="rerun-sdk is not installed")

from tests.streaming.recorded_hand import RecordedHand, assert_near
from tracker.streaming.udp import UdpPublisher

EXAMPLE = Path(__file__).parents[2] / "docs" / "examples" / "rerun" / "glovetrack_rerun.py"
MESSAGES = 5


def free_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind(("127.0.0.1", 0))
        port: int = sock.getsockname()[1]
        return port


def rows(path: Path) -> dict[str, list[Any]]:
    """The columns of each entity, ``entity column``, as Rerun reads its file."""
    from rerun import chunk as rerun_chunk

    found: dict[str, list[Any]] = {}
    for chunk in rerun_chunk.RrdReader(path).stream().to_chunks():
        batch = chunk.to_record_batch()
        for name in batch.schema.names:
            found.setdefault(f"{chunk.entity_path} {name}", []).extend(batch[name].to_pylist())
    return found


@pytest.mark.long
def test_rerun_reads_the_recorded_hand_that_was_streamed(
    recorded: RecordedHand, tmp_path: Path
) -> None:
    """One fingertip is lost, and has no row."""
    names, e = recorded.names, recorded.estimates[-1]
    state = e.keypoint_state.copy()
    state[names.keypoints.index("index_tip")] = 0
    port, path = free_port(), tmp_path / "hand.rrd"
    command = [sys.executable, str(EXAMPLE), "--port", str(port), "--save", str(path)]
    example = subprocess.Popen([*command, "--messages", str(MESSAGES)])
    publisher = UdpPublisher(names, port=port)
    try:
        while example.poll() is None:
            publisher.send(replace(e, keypoint_state=state))
            with_patience(example)
    finally:
        publisher.close()
        example.kill()
    assert example.returncode == 0
    found, wanted = rows(path), recorded.points(e)
    known = [name for name in names.keypoints if name != "index_tip"]
    points = found["/hand/right/keypoints Points3D:positions"]
    assert len(points) == MESSAGES
    assert_near(points[0], [wanted[name] for name in known])
    assert found["/hand/right/keypoints Points3D:labels"][0] == known
    for name, angle in recorded.angles(e).items():
        (value,) = found[f"/hand/right/angles/{name} Scalars:scalars"][0]
        assert value == pytest.approx(np.rad2deg(angle), abs=1e-3)
    session = found["/hand/right/keypoints session"][0]
    assert session.total_seconds() == pytest.approx(e.t, abs=1e-6)
    wall = found["/hand/right/keypoints wall"][0]
    assert wall.timestamp() == pytest.approx(recorded.unix_ns(e) / 1e9, abs=1e-3)


def with_patience(example: subprocess.Popen[bytes]) -> None:
    """Wait a moment for the example to end."""
    try:
        example.wait(0.05)
    except subprocess.TimeoutExpired:
        return
