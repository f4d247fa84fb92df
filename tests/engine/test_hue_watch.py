"""Hues whose names are exchanged are named while no hand is found."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from tracker.base.notices import Notice, Outbox
from tracker.engine.hue_watch import HueWatch
from tracker.engine.pipeline import Pipeline
from tracker.engine.side_watch import ENOUGH, sees
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, ImuSample
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.hue_orders import MOST_HUES, moved, orders

Names = Callable[[tuple[str, ...]], tuple[str, ...]]


def red_and_blue(names: tuple[str, ...]) -> tuple[str, ...]:
    other = {"red": "blue", "blue": "red"}
    return tuple(other.get(name, name) for name in names)


def watched(sim: Simulation, names: Names) -> list[Notice]:
    pipeline, notices = Pipeline(sim.hand, sim.glove, sim.rig), Outbox()
    watch, last, many = HueWatch(pipeline, notices, patience=0.3), 0.0, False
    for message in sim.feed():
        if isinstance(message, ImuSample):
            tracking = pipeline.feed_imu(message).tracking
            watch.packet(message, tracking, message.t - last, many)
            last = message.t
        elif isinstance(message, BlobFrame):
            seen = replace(message, hue_names=names(message.hue_names))
            many = sees(seen, ENOUGH)
            pipeline.feed_frame(seen)
            pipeline.take_results()
            watch.frame(seen)
    return notices.drain()


def test_exchanged_hues_are_named_once(hand: HandModel, glove: GloveModel) -> None:
    """In these images no hand is found with exchanged hues."""
    sim = Simulation(hand, glove, RandomPostures(hand, 3, duration=4.5), 3, fps=20)
    (found,) = watched(sim, red_and_blue)
    assert found.code == "colours.exchanged"
    assert sorted(found.values["hues"]) == ["blue", "red"]


def test_nothing_is_reported_of_right_names(hand: HandModel, glove: GloveModel) -> None:
    sim = Simulation(hand, glove, RandomPostures(hand, 0, duration=2.5), 0, fps=20)
    assert watched(sim, lambda names: names) == []


def test_pairs_are_tried_first_and_many_hues_not_at_all() -> None:
    names = ("red", "yellow", "green", "blue")
    every = list(orders(names))
    assert len(set(every)) == 23 and names not in every
    assert [len(moved(names, order)) for order in every[:7]] == [2, 2, 2, 2, 2, 2, 3]
    assert list(orders(tuple("abcdef"[: MOST_HUES + 1]))) == []
