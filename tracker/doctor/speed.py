"""How fast this computer tracks: the steps of tracking timed on simulated data."""

from __future__ import annotations

import time
from statistics import median

import numpy as np

from tracker.engine.pipeline import Pipeline
from tracker.glove import library
from tracker.messages import BlobFrame, ImuSample
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.colours import parse_profile
from tracker.vision.detector import Detector

IMAGE_SIZE = (720, 1280)
COLOURS_BGR = ((40, 40, 220), (220, 90, 30), (60, 190, 40), (40, 220, 230))
MARKERS = 40
SEED = 1
WARM, SPAN = 1.0, 1.0
"""s of simulated data that are tracked before the measurement, and in it."""


def detection_s(rounds: int = 9) -> float:
    """Median time of a search for markers in a whole pair of noisy images, s."""
    image = np.random.default_rng(SEED).integers(90, 130, (*IMAGE_SIZE, 3), np.uint8)
    for k in range(MARKERS):
        row, column = divmod(k, 8)
        y, x = 100 + 100 * row, 100 + 140 * column
        image[y : y + 20, x : x + 20] = COLOURS_BGR[k % len(COLOURS_BGR)]
    detector = Detector(parse_profile(library.text("colours", library.DEFAULT_COLOURS)))
    times = []
    for _ in range(rounds + 1):
        start = time.perf_counter()
        for _eye in range(2):
            detector.detect(image)
        times.append(time.perf_counter() - start)
    return median(times[1:])  # the first call loads the compiled code


def tracking_s(fps: float = 60.0, warm: float = WARM, span: float = SPAN) -> float:
    """Time that the filter takes per second of data: seven IMUs at 100 Hz, ``fps`` image pairs.

    ``span`` s are timed after ``warm`` s.
    """
    hand, glove = library.load()
    motion = RandomPostures(hand, SEED, duration=warm + span + 0.1)
    sim = Simulation(hand, glove, motion, SEED, fps=fps)
    pipeline = Pipeline(hand, glove, sim.rig)
    measured = 0.0
    for message in sim.feed():
        if not isinstance(message, ImuSample | BlobFrame):
            continue
        start = time.perf_counter()
        if isinstance(message, ImuSample):
            pipeline.feed_imu(message)
        else:
            pipeline.feed_frame(message)
        pipeline.take_results()
        if message.t_arrival >= warm:
            measured += time.perf_counter() - start
    return measured / span
