"""`verify` distinguishes an overloaded computer from a clock that jumps."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tracker.base.clock import NS
from tracker.base.notices import Notice
from tracker.session.mcap.container import Copier, McapOutput
from tracker.session.mcap.input import McapInput, RawMessage
from tracker.session.mcap.ordering import ordered
from tracker.session.ros import sensors
from tracker.session.verify import is_ok, verify

pytestmark = pytest.mark.long

PACKETS, MS = 600, 1_000_000
Change = Callable[[int, RawMessage], RawMessage | None]


def changed(session: Path, out: Path, change: Change) -> Path:
    """A copy in which ``change`` of (ns since the start, message) replaces each Imu message; None
    removes it."""
    source, output = McapInput(session), McapOutput(out, sync=False)
    try:
        for record in source.metadata():
            output.metadata(record.name, dict(record.metadata))
        for a in source.attachments():
            output.attach_bytes(a.name, a.media_type, a.data, a.log_time)
        copier, start = Copier(source, output), source.contents.spans.bounds()[0]
        found = [
            change(m.log_time - start, m) if m.type == sensors.IMU else m for m in ordered(source)
        ]
        for m in sorted((m for m in found if m is not None), key=lambda m: m.log_time):
            copier.copy(m)
    finally:
        output.finish()
        source.close()
    return out


def held_back(begin: float, end: float) -> Change:
    """Messages from ``begin`` to ``end`` (s) arrive at ``end``."""

    def change(t: int, m: RawMessage) -> RawMessage:
        is_held = begin * NS <= t < end * NS
        return m._replace(log_time=m.log_time - t + round(end * NS)) if is_held else m

    return change


def stamps_moved(begin: float, seconds: float, end: float = 1e9) -> Change:
    """The clock of the timestamps jumps by ``seconds`` at ``begin`` and back at ``end``."""

    def change(t: int, m: RawMessage) -> RawMessage:
        if not begin * NS <= t < end * NS:
            return m
        imu = sensors.unpack_imu(m.data)
        moved = imu._replace(stamp=imu.stamp + round(seconds * NS))
        return m._replace(data=sensors.pack_imu(moved))

    return change


@pytest.fixture
def session(tmp_path: Path, record: Callable[..., Path], maker) -> Path:
    return record(tmp_path / "a.mcap", list(maker.stream(10 * PACKETS, images=False)))


def of_one_imu(path: Path) -> list[Notice]:
    findings = verify(path)
    assert is_ok(findings)
    topic = min(f.where for f in findings if "/imu/" in f.where)
    return [f.what for f in findings if f.where == topic and f.what.code != "check.gaps"]


def test_an_overloaded_computer_is_not_reported_as_a_clock_jump(
    session: Path, tmp_path: Path
) -> None:
    (finding,) = of_one_imu(changed(session, tmp_path / "b.mcap", held_back(2.0, 3.2)))
    assert finding.code == "check.late" and finding.values["count"] == 1
    assert finding.values["late_s"] == pytest.approx(1.2, abs=0.05)


def test_a_delay_that_ends_suddenly_is_not_a_clock_jump(session: Path, tmp_path: Path) -> None:
    """Messages were lost after the late ones."""

    def change(t: int, m: RawMessage) -> RawMessage | None:
        if 2.0 <= t / NS < 2.05:
            return m._replace(log_time=m.log_time + NS)
        return None if 2.05 <= t / NS < 3.08 else m

    (finding,) = of_one_imu(changed(session, tmp_path / "b.mcap", change))
    assert finding.code == "check.late"
    assert finding.values["late_s"] == pytest.approx(1.0, abs=0.05)


@pytest.mark.parametrize(
    ("change", "jumps"),
    [
        (stamps_moved(2.0, 5.0), 1),
        (stamps_moved(2.0, -5.0), 1),
        (stamps_moved(2.0, 5.0, end=4.0), 2),
        (stamps_moved(2.0, -5.0, end=4.0), 2),
    ],
)
def test_a_clock_that_jumps_is_reported(
    session: Path, tmp_path: Path, change: Change, jumps: int
) -> None:
    finding = of_one_imu(changed(session, tmp_path / "b.mcap", change))
    found = {what.code: what.values.get("count") for what in finding}
    assert found["check.jumps"] == jumps and "check.late" not in found
