"""Listeners that packages attach to a hand, fed by live tracking and by a replay."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from app.engines.replay.hands import HandsInFile, OfFile
from tests.base.test_registry import install
from tests.live.test_loop import feed, loop_on, messages_of
from tests.live.test_runner import Tape, sim
from tracker.live.listeners import ListenedHand, Listener, ListenerKind, LiveAccess
from tracker.live.loop import LiveLoop
from tracker.messages import Estimate
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.simulation.scenario import Simulation

__all__ = ["sim"]  # a fixture


class Notebook:
    """Stores what it receives."""

    def __init__(self, hand: ListenedHand) -> None:
        self.hand = hand
        self.estimates: list[Estimate] = []
        self.arrivals: list[float] = []
        self.restarts = self.closed = 0

    def feed(self, estimate: Estimate, t_arrival: float) -> None:
        self.estimates.append(estimate)
        self.arrivals.append(t_arrival)

    def restart(self) -> None:
        self.restarts += 1

    def close(self) -> None:
        self.closed += 1


class Failing(Notebook):
    def feed(self, estimate: Estimate, t_arrival: float) -> None:
        super().feed(estimate, t_arrival)
        raise ValueError("no ink")


def _unmade(hand: ListenedHand) -> Listener:
    raise RuntimeError("no paper")


NOTEBOOK = ListenerKind("notebook", "Notebook", Notebook)
FAILING = ListenerKind("failing", "Failing", Failing)
UNMADE = ListenerKind("unmade", "Unmade", _unmade)


@pytest.fixture
def install_listeners(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Callable[[dict[str, str]], None]:
    """Installs a package with these entry points."""

    def done(entries: dict[str, str]) -> None:
        install(tmp_path / "site", "stationery", entries, "listeners")
        monkeypatch.syspath_prepend(str(tmp_path / "site"))

    return done


def attach(loop: LiveLoop, sim: Simulation) -> dict[str, Listener]:
    hand = loop.seen["right"]
    live = LiveAccess(loop.journal.record, hand.telemetry, loop.clock, loop.priority)
    hand.listeners.attach(ListenedHand(sim.hand, sim.glove, live))
    return dict(hand.listeners.by_name)


def test_a_listener_receives_every_live_estimate_and_restarts_with_a_recording(
    sim: Simulation, install_listeners: Callable[[dict[str, str]], None]
) -> None:
    install_listeners({"notebook": f"{__name__}:NOTEBOOK"})
    loop, clock = loop_on(sim)
    notebook = attach(loop, sim)["notebook"]
    tape = Tape()
    loop.set_recorder(tape)
    feed(loop, clock, messages_of(sim)[:400])
    loop.set_recorder(None)
    assert isinstance(notebook, Notebook)
    recorded = [m for m in tape.messages if isinstance(m, Estimate)]
    assert len(recorded) > 100
    assert [e.t for e in notebook.estimates] == [e.t for e in recorded]
    assert all(a >= e.t for a, e in zip(notebook.arrivals, notebook.estimates, strict=True))
    assert notebook.restarts == 1


def test_a_listener_that_fails_is_removed_and_reported_while_others_go_on(
    sim: Simulation, install_listeners: Callable[[dict[str, str]], None]
) -> None:
    entries = {k: f"{__name__}:{k.upper()}" for k in ("failing", "notebook", "unmade")}
    install_listeners({**entries, "gone": "removed_folder:X"})
    loop, clock = loop_on(sim)
    made = attach(loop, sim)
    assert "unmade" not in made and "gone" not in made
    feed(loop, clock, messages_of(sim)[:100])
    failing, notebook = made["failing"], made["notebook"]
    assert isinstance(failing, Failing) and isinstance(notebook, Notebook)
    assert len(failing.estimates) == 1 and failing.closed == 1
    assert len(notebook.estimates) > 20
    errors = [e.notice for e in loop.journal.drain_events() if e.kind == "error"]
    assert [(n.code, n.values["name"], str(n.values["why"])) for n in errors if n is not None] == [
        ("listener.failed", "unmade", "no paper"),
        ("listener.failed", "failing", "no ink"),
    ]
    assert set(loop.seen["right"].listeners.by_name) == set(made) - {"failing"}


def test_a_replay_feeds_listeners_without_live_access(
    tmp_path: Path, install_listeners: Callable[[dict[str, str]], None]
) -> None:
    install_listeners({"notebook": f"{__name__}:NOTEBOOK"})
    raw, tracked = tmp_path / "raw.mcap", tmp_path / "tracked.mcap"
    simulate(raw, SimulateOptions(seed=3, duration=1.0, fps=30, images=False))
    track(raw, tracked, TrackOptions("chain"))
    hands = HandsInFile(tracked)
    notebook = hands.listeners["right"].by_name["notebook"]
    assert isinstance(notebook, Notebook) and notebook.hand.live is None
    read = [m for m in hands.messages((Estimate,)) if isinstance(m, OfFile)]
    for message in read:
        hands.advance(message, due=True)
    hands.forget()
    hands.close()
    assert len(read) > 50
    assert [e.t for e in notebook.estimates] == [m.message.t for m in read]
    assert notebook.restarts == 1 and notebook.closed == 1


def test_without_the_folder_of_the_applications_a_hand_has_no_stage(
    sim: Simulation, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in [n for n in sys.modules if n.startswith("extensions.applications")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "extensions.applications", None)  # as if removed
    loop, clock = loop_on(sim)
    assert "applications" not in attach(loop, sim)
    feed(loop, clock, messages_of(sim)[:50])
    assert loop.seen["right"].estimate is not None
