"""Detection and matching timed beside what they replace, in interleaved rounds.

Every row is the median over rounds of one call's time; ours and the peer's alternate within a
round, so that a busy machine slows both.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import resources
from tests.benchmarks.matching import frames, matching_rows, ours, pycpd_rigid, registration
from tests.benchmarks.peers_vision import PlainOpenCv
from tests.benchmarks.rows import BenchRow, Call, interleaved, row
from tracker.calibration.colours_learn import learn
from tracker.calibration.colours_sample import KnownMarkers, samples_of
from tracker.glove.files import load_glove
from tracker.hand.files import load_hand
from tracker.messages import Array, IntArray
from tracker.simulation.backgrounds import BackgroundParams
from tracker.simulation.desk.lights import LIGHTS
from tracker.simulation.desk.renderer import DeskParams
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.render import RenderParams
from tracker.simulation.rooms import room_of
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.simulation.scene import Extra
from tracker.vision.colours import ColourProfile, load_profile
from tracker.vision.cpd import HuedPixels, parallax_em
from tracker.vision.detector import Detector, DetectorParams
from tracker.vision.hints import DetectionHints
from tracker.vision.rig import ideal_rig
from tracker.vision.stereo import StereoParams, match_stereo

Image = NDArray[np.uint8]
MARKER_SIZE = 0.012  # m
FOUND_WITHIN_PX = 4.0
GOALS, DESK_GOALS = ("0.40", "0.12", "0.12"), ("0.35", "0.12", "0.12")  # of the peer's time
NOISE_PX = 0.3  # of a blob's centroid


@dataclass(frozen=True, eq=False)
class RenderedImage:
    """A rendered image, its visible markers uv (m, 2) px and hue (m,) of the profile."""

    image: Image
    uv: Array
    hue: IntArray


def bench_vision(rounds: int = 9, images: int = 8, seed: int = 1) -> list[BenchRow]:
    """All rows: detection on plain and painted backgrounds and desks, then CPD."""
    profile = load_profile(Path(resources.__file__).parent / "colours" / "fabric-default.toml")
    rows: list[BenchRow] = []
    for kind in ("plain", "painted"):
        rows += detection_rows(profile, make_images(profile, kind, images, seed), kind, rounds)
    rows += desk_rows(profile, images, rounds, seed)
    return rows + cpd_rows(rounds, seed) + matching_rows()


def make_images(profile: ColourProfile, kind: str, count: int, seed: int) -> list[RenderedImage]:
    """Images of a simulated hand, of both cameras in turn."""
    folder = Path(resources.__file__).parent
    hand = load_hand(folder / "hands" / "reference-right.toml")
    glove = load_glove(folder / "gloves" / "vist-small.toml", hand)
    motion = RandomPostures(hand, seed, duration=3.0 * count)
    render: RenderParams | DeskParams = RenderParams(background=BackgroundParams(kind=kind))
    extras: tuple[Extra, ...] = ()
    if kind in LIGHTS:
        render, extras = room_of("desk", kind, seed=seed)
    sim = Simulation(hand, glove, motion, seed, SimulationParams(render=render), extras=extras)
    number = np.array([profile.hue_names.index(h) for h in glove.hues])
    out = []
    for k in range(count):
        t, right = 1.0 + 3.0 * k * (count - 1) / count, bool(k % 2)
        seen = sim.scene.markers_seen(sim.scene.instant(t), right)
        shown = np.flatnonzero(seen.visible)
        out.append(
            RenderedImage(
                sim.renderer.pair(t)[int(right)],
                seen.uv[shown],
                number[glove.marker_hue[shown]],
            )
        )
    return out


def desk_rows(profile: ColourProfile, count: int, rounds: int, seed: int) -> list[BenchRow]:
    """Over a desk in each light, with colours that were learned from another image of it."""
    rows = []
    fx = ideal_rig().fx
    for light in LIGHTS:
        images = make_images(profile, light, count + 1, seed)
        learned = _learned(profile, images[0])
        rows += detection_rows(learned, images[1:], light, rounds, DESK_GOALS)[:2]
        found = Detector(learned, MARKER_SIZE, fx)
        rows += _quality_rows(images[1:], found, _peer(learned, fx), f"coarse to fine, {light}")
    return rows


def _learned(profile: ColourProfile, image: RenderedImage) -> ColourProfile:
    """What the fit makes of the markers of one image."""
    size = np.full((len(image.uv), 2), MARKER_SIZE * ideal_rig().fx / 0.42)
    hues = tuple(profile.hue_names[k] for k in image.hue)
    known = KnownMarkers(image.uv, size, hues, image.uv)
    return learn(profile, samples_of(image.image, known, profile.hue_names))


def _peer(profile: ColourProfile, fx: float) -> PlainOpenCv:
    extent = MARKER_SIZE * fx
    return PlainOpenCv(profile, (extent / 0.9, extent / 0.15))


def detection_rows(
    profile: ColourProfile,
    images: Sequence[RenderedImage],
    kind: str,
    rounds: int,
    goals: tuple[str, str, str] = GOALS,
) -> list[BenchRow]:
    """Full frame, coarse-to-fine and predicted regions against plain OpenCV."""
    fx = ideal_rig().fx
    peer = _peer(profile, fx)
    coarse = Detector(profile, MARKER_SIZE, fx)
    full = coarse.with_params(DetectorParams(stride=1))
    hints = [
        DetectionHints(p.uv, np.full(len(p.uv), 30.0), p.hue, np.full(len(p.uv), 20.0))
        for p in images
    ]
    calls: list[Call] = [
        lambda: [full.detect(p.image) for p in images],
        lambda: [coarse.detect(p.image) for p in images],
        lambda: [coarse.detect(p.image, h) for p, h in zip(images, hints, strict=True)],
        lambda: [peer.detect(p.image) for p in images],
    ]
    ms = interleaved(calls, rounds) * 1e3 / len(images)
    names = ("full frame", "coarse to fine", "predicted regions")
    rows = [
        row(f"detection, {name}, {kind}", ms[k], "ms", "plain OpenCV", ms[3], goal)
        for k, (name, goal) in enumerate(zip(names, goals, strict=True))
    ]
    for name, detector in (("full frame", full), ("coarse to fine", coarse)):
        rows += _quality_rows(images, detector, peer, f"{name}, {kind}")
    return rows


def _quality_rows(
    images: Sequence[RenderedImage], ours: Detector, peer: PlainOpenCv, what: str
) -> list[BenchRow]:
    """Recall, and number of blobs that are not markers, per image."""
    mine, theirs = [], []
    for p in images:
        blobs, _ = ours.detect(p.image)
        mine.append(_counts(blobs.uv, blobs.hue, p))
        theirs.append(_counts(*peer.detect(p.image), p))
    total = sum(len(p.uv) for p in images)
    (found, other), (peer_found, peer_other) = np.sum(mine, axis=0), np.sum(theirs, axis=0)
    n = len(images)
    return [
        row(
            f"recall, {what}", 100 * found / total, "%", "plain OpenCV", 100 * peer_found / total,
            ">= peer - 0.5",
        ),
        row(
            f"other blobs, {what}", other / n, "per image", "plain OpenCV", peer_other / n,
            "<= peer + 0.5",
        ),
    ]  # fmt: skip


def _counts(uv: Array, hue: IntArray, image: RenderedImage) -> tuple[int, int]:
    """Markers that were found, and blobs that are none."""
    d = np.hypot(*np.moveaxis(image.uv[:, None] - uv[None], 2, 0))
    near = (d < FOUND_WITHIN_PX) & (image.hue[:, None] == hue[None])
    return int(near.any(axis=1).sum()), int((~near.any(axis=0)).sum())


def cpd_rows(rounds: int, seed: int) -> list[BenchRow]:
    """1-DOF stereo 15 x 15 and 3-DOF 13 x 37 against pycpd's rigid registration.

    Each is the registration; the row below it is the whole of matching, with start, pairs and
    triangulation, or with priors and assignment. Points have noise: without, pycpd comes to no end
    before its limit of a hundred steps, and takes eight times as long.
    """
    rng = np.random.default_rng(seed)
    rig, frame = ideal_rig(), next(frames(1, seed))
    p, hue = frame.predicted[:15], frame.marker_hue[:15]
    left, right = (
        rig.project(p, side) + rng.normal(0, NOISE_PX, (15, 2)) for side in (False, True)
    )
    stereo, start = StereoParams(), rig.fx * rig.baseline / 0.40
    calls: list[Call] = [
        lambda: parallax_em(HuedPixels(left, hue), HuedPixels(right, hue), start, stereo.mixture),
        lambda: match_stereo(left, hue, right, hue, rig, stereo),
        registration(frame),
        lambda: ours(frame),
    ]
    inner = [1000, 200, 50, 50]
    if find_spec("pycpd") is not None:
        calls += [_pycpd(left, right), lambda: pycpd_rigid(frame)]
        inner += [20, 20]
    us = interleaved(calls, rounds, inner) * 1e6
    theirs = us[4:] if len(us) > 4 else (None, None)
    return [
        row("CPD, 1-DOF 15 x 15", us[0], "µs", "pycpd rigid", theirs[0], "0.01"),
        row("stereo matching, 15 x 15", us[1], "µs", "pycpd rigid", theirs[0], "-"),
        row("CPD, 3-DOF 13 x 37", us[2], "µs", "pycpd rigid", theirs[1], "0.01"),
        row("matching, 13 x 37", us[3], "µs", "pycpd rigid", theirs[1], "-"),
    ]


def _pycpd(target: Array, source: Array) -> Call:
    rigid = import_module("pycpd").RigidRegistration
    return lambda: rigid(X=target, Y=source, w=0.1).register()
