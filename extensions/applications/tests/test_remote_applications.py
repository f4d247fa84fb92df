"""Applications in the process that tracks: the window shows and controls them from its own."""

from __future__ import annotations

import pickle
import threading
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.engines.engine import EngineSetup
from extensions.applications.drawing import Mesh
from extensions.applications.extension import LISTENER
from extensions.applications.hand import HandSample
from extensions.applications.live import (
    MOST,
    ArrayReceiver,
    ArraySender,
    LiveApplication,
    Packed,
    RemoteStage,
    stage_of,
)
from extensions.applications.runner import KIND
from extensions.applications.tests.hands import estimates
from extensions.applications.tests.test_touch import PRESS
from tests.gui.apart_engine import Subscribed, connect, eventually
from tests.gui.gui_fakes import models, scripted_setup
from tests.notices import raises
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.live.listeners import ListenedHand, LiveAccess
from tracker.live.telemetry import Telemetry
from tracker.live.work_priority import WorkPriority
from tracker.messages import Event

__all__ = ["connect"]  # a fixture


def sent(packed: Packed) -> Packed:
    """As it arrives in another process."""
    return pickle.loads(pickle.dumps(packed))


def test_large_arrays_are_sent_once() -> None:
    sender, receiver = ArraySender(), ArrayReceiver()
    mesh = Mesh("rabbit", np.random.default_rng(1).normal(size=(5000, 3)), np.arange(900))
    sizes = []
    for x in (0.0, 0.1, 0.2):
        drawing = (replace(mesh, p=np.array([x, 0.0, 0.0])), "a text")
        packed = sender.pack(drawing)
        sizes.append(len(pickle.dumps(packed)))
        (found, text) = receiver.unpack(sent(packed))
        np.testing.assert_array_equal(found.points, mesh.points)
        np.testing.assert_array_equal(found.faces, mesh.faces)
        assert found.p[0] == x and text == "a text"
    assert sizes[0] > mesh.points.nbytes
    assert max(sizes[1:]) < 0.02 * sizes[0]


def test_arrays_that_always_change_are_not_kept() -> None:
    sender, receiver = ArraySender(), ArrayReceiver()
    for k in range(5 * MOST):
        found = receiver.unpack(sent(sender.pack(np.full(1000, float(k)))))
        assert found.sum() == 1000.0 * k
    assert len(sender._sent) <= MOST + 1 and len(receiver._known) <= MOST + 1


class Motors:
    """The motors of a glove, and what the applications report."""

    def __init__(self) -> None:
        self.driven: list[tuple[int, int, int]] = []
        self.events: list[Event] = []
        self.threads: set[str] = set()

    def vibrate(self, *command: int) -> bool:
        self.threads.add(threading.current_thread().name)
        self.driven.append(command)  # type: ignore[arg-type]
        return True

    @property
    def words(self) -> list[str]:
        """What was reported by an application, in order."""
        return [str(e.data["what"]) for e in self.events if e.kind == KIND]


class TouchedEngine(Subscribed):
    """An engine with the listener of applications in its process."""

    def __init__(self) -> None:
        super().__init__()
        self.motors = Motors()
        hand, glove, _ = models()
        live = LiveAccess(
            self.motors.events.append, Telemetry(), monotonic, WorkPriority(), self.motors.vibrate
        )
        made = LISTENER.make(ListenedHand(hand, glove, live))
        assert isinstance(made, LiveApplication)
        self.listener = made

    def press(self, t: float = 0.0) -> None:
        """A flat hand goes down and comes back."""
        for estimate in estimates(PRESS, rate=25.0):
            self.listener.feed(replace(estimate, t=estimate.t + t), monotonic())


@pytest.fixture
def touched(
    connect: Callable[[EngineSetup], EngineSetup],
) -> Any:
    """The engine, and the stage of the window."""
    engine = TouchedEngine()
    listeners = {LISTENER.name: engine.listener}
    setup = connect(replace(scripted_setup(engine), listeners=listeners))
    stage = stage_of(setup.listeners)
    assert isinstance(stage, RemoteStage)
    yield engine, stage
    engine.listener.close()


class Page:
    def __init__(self) -> None:
        self.shown: list[tuple[str, float]] = []
        self.closed = 0

    def show(self, title: str, hand: HandSample, drawing: object) -> None:
        self.shown.append((title, hand.t))

    def close(self) -> None:
        self.closed += 1


def test_the_window_shows_an_application_of_the_process_that_tracks(touched: Any) -> None:
    engine, stage = touched
    page = Page()
    stage.viewers.append(page)
    stage.show("touch", {"size": 0.15})
    assert (stage.name, stage.settings.size) == ("touch", 0.15)  # at once
    assert not stage.delays_window
    engine.press()
    eventually(lambda: stage.outcome is not None and stage.outcome.t > 2.9)
    there = engine.listener.stage
    assert stage.outcome.drawing[0].name == "object"
    np.testing.assert_array_equal(stage.outcome.drawing[0].points, there.outcome.drawing[0].points)
    eventually(lambda: stage.counts == there.counts)
    assert stage.counts["touch"] == stage.counts["release"] > 0
    assert stage.latest["touch"].data["depth_mm"] == there.latest["touch"].data["depth_mm"]
    assert page.shown and page.shown[0][0] == stage.title
    assert [t for _, t in page.shown] == sorted(t for _, t in page.shown)
    assert engine.motors.threads == {"glovetrack-application"}  # without the window
    assert any(amplitude for _, amplitude, _ in engine.motors.driven)
    stage.close()
    assert page.closed == 1


def test_choices_of_the_user_reach_the_application(touched: Any) -> None:
    engine, stage = touched
    with raises(ConfigError, "part.unknown"):
        stage.show("no such application")
    assert stage.name == ""
    stage.show("touch")
    with raises(ConfigError, "toml.number", key="size"):
        stage.set("size", "large")
    stage.set("full_depth", 0.004)
    engine.press()
    eventually(lambda: stage.settings.full_depth == 0.004)
    stage.restart()
    engine.press(t=10.0)
    eventually(lambda: stage.outcome is not None and stage.outcome.t > 12.9)
    assert engine.motors.words.count("begins") == 2
    stage.show("")
    assert stage.name == "" and stage.outcome is None and stage.settings is None
    engine.press(t=20.0)
    eventually(lambda: "ends" in engine.motors.words)
    assert stage.name == ""
