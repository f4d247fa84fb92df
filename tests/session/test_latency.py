"""Latency of commands, measured in a session with known delays."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from tests.session.conftest import at
from tests.session.test_robot_topics import MODEL, state
from tracker.cli import main
from tracker.messages import Event, Message, RobotState, Status, Tracking
from tracker.session.decode_robot import read_robot
from tracker.session.latency import latencies_of
from tracker.session.reader import SessionReader

TOTAL = "latency_total"


def motor(of: float, late: float) -> Event:
    """A motor command sent ``late`` ms after the sample of ``of`` ms."""
    return Event(at(of + late), "motor", "", {"channel": 0, "amplitude": 90, "of": at(of)})


def driven(of: float, late: float) -> RobotState:
    return replace(state(of, 1), t_sent=at(of + late))


@pytest.fixture
def session(tmp_path: Path, record: Callable[..., Path]) -> Path:
    recorded: list[Message] = [MODEL, Event(at(0), "note", "no latency", {})]
    for k in range(1, 100):
        recorded += [motor(10.0 * k, 5.0), driven(10.0 * k, 8.0)]
    recorded += [
        motor(1000.0, 25.0),
        driven(1000.0, 30.0),
        state(1050.0, 1),
    ]  # the last: driven offline
    return record(tmp_path / "late.mcap", recorded)


def test_a_session_contains_the_latency_of_motors_and_robots(session: Path) -> None:
    found = latencies_of(session)
    assert set(found) == {"motor", "robot claw_left"}
    motors, robot = found["motor"], found["robot claw_left"]
    assert motors["count"] == robot["count"] == 100
    assert motors["median_ms"] == pytest.approx(5.0, abs=1e-3)
    assert robot["median_ms"] == pytest.approx(8.0, abs=1e-3)
    assert (motors["most_ms"], robot["most_ms"]) == pytest.approx((25.0, 30.0), abs=1e-3)
    assert 5.0 < motors["p99_ms"] < 25.0


def test_the_time_of_a_command_is_read_back_and_unknown_for_a_replay(
    session: Path,
) -> None:
    with SessionReader(session) as reader:
        states = [m for m in read_robot(reader, "claw_left") if isinstance(m, RobotState)]
    assert [s.t_sent == pytest.approx(s.t + 0.008) for s in states[:99]] == [True] * 99
    assert states[-1].t_sent != states[-1].t_sent  # NaN


def test_figures_of_the_live_run_and_delays_of_images_are_reported(
    tmp_path: Path, record: Callable[..., Path]
) -> None:
    states = [
        Status(
            at(1000.0 * k),
            Tracking.TRACKING,
            {f"{TOTAL}_ms": 20 + k, f"{TOTAL}_p99_ms": 40 + 2 * k}
            | {"latency_screen_ms": 30.0, "latency_screen_p99_ms": 50.0},
        )
        for k in range(5)
    ]
    found = latencies_of(record(tmp_path / "live.mcap", states))
    assert found == {
        "pose after an image": {"count": 5, "median_ms": 22.0, "p99_ms": 44.0, "most_ms": 48.0},
        "screen": {"count": 5, "median_ms": 30.0, "p99_ms": 50.0, "most_ms": 50.0},
    }


def test_the_command_reports_it_as_text_and_json(
    session: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for command in (["info", "--latency"], ["latency"]):
        assert main([*command, str(session)]) == 0
        table = [line.split() for line in capsys.readouterr().out.splitlines()]
        assert ["sample", "to", "motor", "command", "5.0", "5.2", "25.0", "100"] in table
    assert main(["info", "--latency", str(session), "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["latency"]["motor"]["count"] == 100
