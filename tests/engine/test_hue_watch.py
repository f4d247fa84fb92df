"""Hues whose names are exchanged in the colours are called by the right ones within seconds."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from tracker.engine.pipeline import Pipeline
from tracker.engine.side_watch import SideWatch
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, ImuSample, Tracking, Validity
from tracker.online.hue_names import HueNames, exchange, hue_names_event, hue_names_of
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.hue_orders import MOST_HUES, moved, orders

Names = Callable[[tuple[str, ...]], tuple[str, ...]]


def swapped(a: str, b: str) -> Names:
    other = {a: b, b: a}
    return lambda names: tuple(other.get(name, name) for name in names)


class Run:
    """A hand with other names of its hues; what was corrected, by which pipeline or watch."""

    def __init__(self, sim: Simulation, names: Names) -> None:
        pipeline = Pipeline(sim.hand, sim.glove, sim.rig)
        watch = SideWatch(pipeline)
        self.corrected: list[tuple[str, ...]] = []
        self.codes: list[str] = []
        self.corrected_at, self.wrong = np.inf, 0
        for message in sim.feed():
            if isinstance(message, ImuSample):
                estimate = pipeline.feed_imu(message)
                watch.packet(message, estimate.tracking)
                if found := watch.take_names():
                    pipeline.feed_event(hue_names_event(sim.glove.hues, found, message.t))
                if pipeline.hues.names not in (sim.glove.hues, *self.corrected):
                    self.corrected.append(pipeline.hues.names)
                    self.corrected_at = message.t
                if message.seq % 10 == 0 and estimate.tracking == Tracking.TRACKING:
                    (truth,) = sim.truths(np.array([estimate.t]))
                    error = np.linalg.norm(estimate.keypoints - truth.keypoints, axis=1)
                    measured = estimate.keypoint_state == Validity.MEASURED
                    self.wrong += int(np.count_nonzero(measured & (error > 0.05)))
            elif isinstance(message, BlobFrame):
                seen = replace(message, hue_names=names(message.hue_names))
                pipeline.feed_frame(seen)
                watch.frame(seen)
            pipeline.take_results()
            self.codes += [n.code for n in (*pipeline.drain_notices(), *watch.notices.drain())]
        self.tracking = estimate.tracking


def test_names_are_corrected_where_no_hand_is_found(hand: HandModel, glove: GloveModel) -> None:
    """In these images no hand is found with exchanged hues: all orders are searched."""
    run = Run(
        Simulation(hand, glove, RandomPostures(hand, 3, duration=5.0), 3, fps=30),
        swapped("red", "blue"),
    )
    assert run.corrected == [swapped("red", "blue")(glove.hues)]
    assert run.corrected_at < 4.5 and run.tracking == Tracking.TRACKING and run.wrong == 0


def test_names_are_corrected_where_the_other_hues_show_the_hand(
    hand: HandModel, glove: GloveModel
) -> None:
    run = Run(
        Simulation(hand, glove, RandomPostures(hand, 3, duration=2.0), 3, fps=30),
        swapped("blue", "green"),
    )
    assert run.corrected == [swapped("blue", "green")(glove.hues)]
    assert run.codes == ["colours.exchanged_here"] and run.wrong == 0


def test_right_names_are_kept(hand: HandModel, glove: GloveModel) -> None:
    sim = Simulation(hand, glove, RandomPostures(hand, 0, duration=2.5), 0, fps=20)
    run = Run(sim, lambda names: names)
    assert run.corrected == [] and run.codes == []


def test_an_exchange_must_be_clear_and_complete() -> None:
    clear = np.diag([60.0, 60.0, 60.0])[[1, 0, 2]]
    found = exchange(clear)
    assert found is not None and found.tolist() == [1, 0, 2]
    assert exchange(np.diag([60.0] * 3)) is None
    assert exchange(clear + 35.0) is None  # a third have another one
    assert exchange(clear / 7) is None  # few
    one_way = clear.copy()
    one_way[1] = 0.0  # the second hue was not seen: it may be the first one's false objects
    assert exchange(one_way) is None


def test_a_second_exchange_is_relative_to_the_first() -> None:
    """Colours that are fitted while their names are corrected have the right names: the exchange
    that is then seen undoes the correction, without a report."""
    hues = HueNames(("red", "green", "blue"))
    hues.use(("blue", "green", "red"))
    assert hues.as_found == ("blue", "green", "red")
    counts = np.diag([60.0, 60.0, 60.0])[[2, 1, 0]]
    assert hues.learn(1.0, counts) is None
    assert hues.names == ("red", "green", "blue")
    report = hues.learn(2.0, np.diag([60.0] * 3)[[1, 2, 0]])
    assert report is not None and set(report.values["hues"]) == {"red", "green", "blue"}
    # markers of red are called green, those of green blue, those of blue red
    assert hues.names == ("blue", "red", "green") and hues.as_found == ("green", "blue", "red")


def test_names_pass_through_an_event() -> None:
    event = hue_names_event(("red", "green", "blue"), ("blue", "green", "red"), 3.0)
    assert hue_names_of(event) == ("blue", "green", "red")
    assert event.notice is not None and event.notice.values["hues"] == ("red", "blue")


def test_pairs_are_tried_first_and_many_hues_not_at_all() -> None:
    names = ("red", "yellow", "green", "blue")
    every = list(orders(names))
    assert len(set(every)) == 23 and names not in every
    assert [len(moved(names, order)) for order in every[:7]] == [2, 2, 2, 2, 2, 2, 3]
    assert list(orders(tuple("abcdef"[: MOST_HUES + 1]))) == []
