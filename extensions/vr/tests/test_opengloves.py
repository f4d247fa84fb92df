"""OpenGloves' pipe, faked by a FIFO and unpacked by NumPy as the C++ structure, and Monado's line,
read by pyserial from the pseudo-terminal."""

from __future__ import annotations

import contextlib
import os
import re
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import serial
from numpy.testing import assert_allclose

from tests.notices import raises
from tests.streaming.posed_hand import posed_estimate
from tests.streaming.recorded_hand import RecordedHand
from tracker.hand.names import FINGERS
from tracker.messages import Estimate
from tracker.streaming.publisher import Names, Publisher, StreamError
from tracker.streaming.registry import StreamSettings, open_streams

C_STRUCT = np.dtype(
    {
        "names": ["flexion", "splay", "joystick", "buttons", "trigger"],
        "formats": [("<f4", (5, 4)), ("<f4", 5), ("<f4", 2), ("?", 8), "<f4"],
        "offsets": [0, 80, 100, 108, 116],
        "itemsize": 120,
    }
)
"""OpenGloves' OpenGloveInputData: flexion[5][4], splay[5], joyX, joyY, eight bools, trgValue."""


def opened(names: Names, kind: str, **options: str) -> Publisher:
    table = {kind: True} | {f"{kind}_{key}": value for key, value in options.items()}
    return open_streams(StreamSettings(table), [names])[kind][0]


def share(recorded: RecordedHand, e: Estimate, joint: str) -> float:
    """Share of the angle's range, from straight (0) to its maximum (1)."""
    names = recorded.names
    low, high = names.model.angle_limits[names.angles.index(joint)]
    angle = recorded.angles(e)[joint]
    return float(np.clip((angle - max(low, 0.0)) / (high - max(low, 0.0)), 0, 1))


def splay(recorded: RecordedHand, e: Estimate, finger: str) -> float:
    """-1 to 1 for 20° to either side."""
    angle = recorded.angles(e)[f"{finger}_mcp_abduction"]
    return float(np.clip(np.rad2deg(angle) / 20, -1, 1))


def test_the_pipe_gets_the_drivers_structure(recorded: RecordedHand, tmp_path: Path) -> None:
    """Its floats have the angles of a recording to 1e-6 of their range."""
    pipe = tmp_path / "right"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    out = opened(recorded.names, "opengloves", pipe=str(tmp_path / "{side}"))
    with contextlib.closing(out):
        for e in recorded.estimates:
            out.send(e)
            assert out.clients == 1
            data = os.read(reader, 4096)
            assert len(data) == 120
            check(np.frombuffer(data, C_STRUCT)[0], recorded, e)
    os.close(reader)


def check(found: np.void, recorded: RecordedHand, e: Estimate) -> None:
    wanted = [[f"{f}_{j}_flexion" for j in ("mcp", "mcp", "pip", "dip")] for f in FINGERS]
    wanted = [[f"thumb_{j}_flexion" for j in ("cmc", "mcp", "ip", "ip")], *wanted]
    shares = [[share(recorded, e, joint) for joint in digit] for digit in wanted]
    assert_allclose(found["flexion"], shares, atol=1e-6)
    splays = [splay(recorded, e, finger) for finger in FINGERS]
    assert_allclose(found["splay"][1:], splays, atol=1e-6)
    assert not found["buttons"][[0, 6, 7]].any()
    assert 0.0 <= found["trigger"] <= 1.0


def test_a_lost_joint_keeps_its_last_value(names: Names, tmp_path: Path) -> None:
    pipe, e = tmp_path / "right", posed_estimate(names, 8)
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    lost = np.array(e.angles)
    lost[names.angles.index("index_pip_flexion")] = np.nan
    out = opened(names, "opengloves", pipe=str(pipe))
    with contextlib.closing(out):
        out.send(e)
        out.send(replace(e, angles=lost))
        first, second = np.frombuffer(os.read(reader, 4096), C_STRUCT)
    os.close(reader)
    assert_allclose(first["flexion"], second["flexion"])


def test_without_the_driver_it_fails_and_opens_the_pipe_later(names: Names, tmp_path: Path) -> None:
    pipe = tmp_path / "right"
    out = opened(names, "opengloves", pipe=str(pipe))
    with contextlib.closing(out):
        for _ in range(2):
            with raises(StreamError, "stream.no_connection", "stream.not_connected"):
                out.send(posed_estimate(names, 8))
        assert out.clients == 0


def parsed(line: str) -> dict[str, int | None]:
    """Keys and values as Monado's driver parses them; a key without a value is a button."""
    assert re.fullmatch(r"(?:(?:\([A-E]{2,3}\)|[A-P])\d*)+\n", line)
    pairs = re.findall(r"(\([A-Z]+\)|[A-Z])(\d*)", line)
    return {key: int(value) if value else None for key, value in pairs}


def test_a_serial_port_gives_monados_line(recorded: RecordedHand, tmp_path: Path) -> None:
    """A line's numbers have 10 bits: the angles of a recording to half a step of 1/1023."""
    out = opened(recorded.names, "monado", link=str(tmp_path / "glove-{side}"))
    with contextlib.closing(out), serial.Serial(str(tmp_path / "glove-right"), timeout=60) as port:
        for e in recorded.estimates:
            out.send(e)
            line = port.readline().decode()
            assert len(line) < 256  # the driver's buffer
            assert out.probe().code == "vr.line_read"
            check_line(parsed(line), recorded, e)
    assert not (tmp_path / "glove-right").is_symlink()


def check_line(found: dict[str, int | None], recorded: RecordedHand, e: Estimate) -> None:
    for letter, finger in zip("BCDE", FINGERS, strict=True):
        shares = [share(recorded, e, f"{finger}_{j}_flexion") for j in ("mcp", "pip", "dip")]
        joints = [found[f"({letter}A{k})"] for k in "BCD"]
        assert_allclose(joints, 1023 * np.array(shares), atol=0.5 + 1e-6)
        assert found[letter] == pytest.approx(1023 * np.mean(shares), abs=0.5 + 1e-6)
        wanted = 1023 * (splay(recorded, e, finger) + 1) / 2
        assert found[f"({letter}B)"] == pytest.approx(wanted, abs=0.5 + 1e-6)
    assert "P" in found


def test_lines_that_nothing_reads_are_discarded(names: Names) -> None:
    out, e = opened(names, "monado"), posed_estimate(names, 9)
    with contextlib.closing(out):
        for _ in range(100):
            out.send(e)
            time.sleep(0.001)  # the kernel counts what it has passed on to the reader's side
        assert out.probe().code == "vr.line_unread"


def test_a_link_that_cannot_be_made_is_reported(names: Names, tmp_path: Path) -> None:
    with raises(StreamError, "opengloves.link"):
        opened(names, "monado", link=str(tmp_path / "none" / "glove"))
