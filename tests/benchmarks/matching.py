"""How often 3-DOF matching is right where the hand is not where it was expected."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib import import_module
from importlib.util import find_spec
from typing import NamedTuple

import numpy as np

from tests.benchmarks.rows import BenchRow, Call, row
from tracker.messages import Array, IntArray
from tracker.vision.correspondence import TranslationParams, match_translation, normalised
from tracker.vision.cpd import ExpectedMarkers, HuedPoints, translation_em

SHIFT, TILT = 0.020, np.deg2rad(3.0)  # m, rad (root mean square): error of the prediction
MARKERS, SEEN = 37, 13
NOISE_C = np.array([0.0005, 0.0005, 0.002])  # m, of a triangulated marker
COV_C = np.diag([1e-6, 1e-6, 9e-6])  # m², as given to the matcher


class Frame(NamedTuple):
    """Points (13, 3) m, their hue and true marker (13,); 37 markers where they were expected,
    their hue and prior (37,)."""

    points: Array
    hue: IntArray
    marker: IntArray
    predicted: Array
    marker_hue: IntArray
    prior: Array


Matcher = Callable[[Frame], IntArray]


def hand_points(rng: np.random.Generator, n: int) -> tuple[Array, IntArray]:
    """A cloud like a glove's markers 0.35 m before the camera: p_C (n, 3) m, four hues (n,)."""
    p_C = rng.uniform([-0.07, -0.06, -0.03], [0.07, 0.06, 0.03], (n, 3)) + [0, 0, 0.35]
    return p_C, rng.permutation(np.arange(n) % 4)


def frames(count: int, seed: int) -> Iterator[Frame]:
    """Each moved by `SHIFT` in some direction and turned by `TILT` about some axis."""
    rng = np.random.default_rng(seed)
    for _ in range(count):
        truth, hue = hand_points(rng, MARKERS)
        seen = rng.choice(MARKERS, SEEN, replace=False)
        prior = np.where(np.isin(np.arange(MARKERS), seen), 0.9, rng.uniform(0, 0.5, MARKERS))
        direction, turn = rng.normal(size=3), rng.normal(size=3) * TILT / np.sqrt(3)
        predicted = truth + np.cross(turn, truth - truth.mean(axis=0))
        predicted += SHIFT * direction / np.linalg.norm(direction)
        points = truth[seen] + rng.normal(0, NOISE_C, (SEEN, 3))
        yield Frame(points, hue[seen], seen, predicted, hue, prior)


def ours(frame: Frame) -> IntArray:
    """Marker of each point, -1 for none."""
    points, hue, _, predicted, marker_hue, prior = frame
    return match_translation(points, hue, predicted, marker_hue, prior, COV_C).marker


def registration(frame: Frame) -> Call:
    """The EM alone, as `ours` runs it."""
    params, n = TranslationParams(), len(frame.points)
    each, prior = np.tile(COV_C, (n, 1, 1)), normalised(frame.prior, frame.marker_hue)
    points = HuedPoints(frame.points, frame.hue, each)
    markers = ExpectedMarkers(frame.predicted, frame.marker_hue, prior)
    return lambda: translation_em(points, markers, params.mixture)


def pycpd_rigid(frame: Frame) -> IntArray:
    """Marker of each point as it comes: the likeliest after registration."""
    registration = import_module("pycpd").RigidRegistration(
        X=frame.points, Y=frame.predicted, w=0.1
    )
    registration.register()
    likeliest: IntArray = np.argmax(registration.P, axis=0)
    return likeliest


def right(matcher: Matcher, count: int = 300, seed: int = 15) -> tuple[float, float]:
    """Share of frames without a wrong match, and share of points with the right one."""
    clean = found = 0
    for frame in frames(count, seed):
        got = matcher(frame)
        clean += bool(np.all((got < 0) | (got == frame.marker)))
        found += int(np.sum(got == frame.marker))
    return clean / count, found / (SEEN * count)


def matching_rows() -> list[BenchRow]:
    """The condition under which the times of CPD count."""
    theirs = right(pycpd_rigid)[0] if find_spec("pycpd") is not None else None
    name = "CPD, 3-DOF 13 x 37, frames without a wrong match"
    return [row(name, right(ours)[0], "of all", "pycpd rigid", theirs, ">= 0.97")]
