"""What a second of tracking costs, and what it holds, after many minutes of it."""

from __future__ import annotations

import time
from collections.abc import Sequence

import psutil

from tracker.engine.pipeline import Pipeline
from tracker.glove import library
from tracker.messages import BlobFrame, ImuSample, Message
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

SEED, FPS = 1, 60.0
MINUTE = 60.0
MB = 1e6


def tracked_for(minutes: Sequence[float]) -> tuple[list[float], list[float]]:
    """Milliseconds for a second of data in the minute that ends at each of ``minutes``, and MB.

    One hand is tracked from the first to the last minute. MB is the process's memory then.
    ``minutes`` ascend and are a minute apart at least.
    """
    hand, glove = library.load()
    motion = RandomPostures(hand, SEED, duration=MINUTE * max(minutes) + 1.0)
    simulation = Simulation(hand, glove, motion, SEED, fps=FPS)
    pipeline = Pipeline(hand, glove, simulation.rig)
    ends = [MINUTE * m for m in minutes]
    costs: list[float] = []
    memory: list[float] = []
    spent = 0.0
    for message in simulation.feed():
        if message.t_arrival >= ends[len(costs)]:
            costs.append(1e3 * spent / MINUTE)
            memory.append(psutil.Process().memory_info().rss / MB)
            spent = 0.0
            if len(costs) == len(ends):
                break
        if message.t_arrival < ends[len(costs)] - MINUTE:
            spent = 0.0  # of each time only the last minute counts
        before = time.process_time()
        _feed(pipeline, message)
        spent += time.process_time() - before
    return costs, memory


def _feed(pipeline: Pipeline, message: Message) -> None:
    if isinstance(message, ImuSample):
        pipeline.feed_imu(message)
    elif isinstance(message, BlobFrame):
        pipeline.feed_frame(message)
    pipeline.take_results()
