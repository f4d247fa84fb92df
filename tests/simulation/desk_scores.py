"""Recall and false blobs of one detector on our images and path-traced photographs."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import resources
from tracker.glove.files import load_glove
from tracker.hand.files import load_hand
from tracker.messages import Array, StereoFrame
from tracker.session.reader import SessionReader
from tracker.simulation.desk.renderer import DeskParams
from tracker.simulation.random_postures import PostureParams, RandomPostures
from tracker.simulation.rooms import Forearm
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.vision.colours import load_profile
from tracker.vision.detector import Detector
from tracker.vision.rig import CameraPose, default_pose, ideal_rig

FOUND_PX, OWN_PX, NEAR_PX = 4.0, 6.0, 30.0
LEAST_SHARE, LARGEST_DEG = 0.6, 70.0
HUES_OF_PHOTOGRAPHS = ("red", "blue", "green", "yellow")
FOLDER = Path(resources.__file__).parent
SURFACES = {"window": "wood", "lamp": "wood", "led": "laminate", "dim": "wood"}


@dataclass(frozen=True, eq=False)
class SeenImage:
    """An image, and its visible markers: position (m, 2) px, hue's name (m,), and whether a
    detector should find it (m,)."""

    image: NDArray[np.uint8]
    uv: Array
    hue: list[str]
    wanted: NDArray[np.bool_]


@dataclass
class Score:
    """Markers to be found, found; false blobs outside and within the hand's surroundings."""

    wanted: int = 0
    found: int = 0
    far: int = 0
    near: int = 0
    images: int = 0

    @property
    def recall(self) -> float:
        return self.found / max(self.wanted, 1)

    @property
    def false_blobs(self) -> float:
        """Per image."""
        return (self.far + self.near) / max(self.images, 1)

    def __str__(self) -> str:
        n = max(self.images, 1)
        return f"recall {self.recall:.3f}, false {self.far / n:.1f} far, {self.near / n:.1f} near"


def score(images: Iterator[SeenImage]) -> Score:
    """For the factory colours and shapes alone: a contrast limit would hide differences."""
    profile = load_profile(FOLDER / "colours" / "fabric-default.toml")
    profile = replace(profile, shape=replace(profile.shape, contrast=0.0))
    detector, out = Detector(profile, fx=640.0), Score()
    for seen in images:
        blobs, _ = detector.detect(seen.image)
        names = np.array(profile.hue_names)[blobs.hue]
        own = np.zeros(len(blobs), bool)
        for uv, hue, wanted in zip(seen.uv, seen.hue, seen.wanted, strict=True):
            gap = np.hypot(*(blobs.uv - uv).T)
            own |= (names == hue) & (gap < OWN_PX)
            out.wanted += bool(wanted)
            out.found += bool(wanted and np.any((names == hue) & (gap < FOUND_PX)))
        low, high = seen.uv.min(axis=0) - NEAR_PX, seen.uv.max(axis=0) + NEAR_PX
        near = np.all((blobs.uv > low) & (blobs.uv < high), axis=1)
        out.near += int(np.sum(~own & near))
        out.far += int(np.sum(~own & ~near))
        out.images += 1
    return out


def photographs(folder: Path) -> Iterator[SeenImage]:
    """A scene of the path-traced photographs."""
    truth = np.load(folder / "visible.npz")
    with SessionReader(folder / "in.mcap") as session:
        frames = [m for m in session.messages() if isinstance(m, StereoFrame)]
    for k, frame in enumerate(frames):
        for side, image in enumerate((frame.left, frame.right)):
            share, angle = truth["frac"][k, side], truth["angle"][k, side]
            some = share > 0.05
            hue = [HUES_OF_PHOTOGRAPHS[h] for h in truth["hue"][some]]
            wanted = (share >= LEAST_SHARE) & (angle < LARGEST_DEG)
            assert image is not None
            yield SeenImage(image, truth["uv_vis"][k, side][some], hue, wanted[some])


def simulated(light: str, seed: int, times: Array, surface: str = "") -> Iterator[SeenImage]:
    """Our own images of a hand at the photographs' distance."""
    hand = load_hand(FOLDER / "hands" / "reference-right.toml")
    glove = load_glove(FOLDER / "gloves" / "vist-small.toml", hand)
    pose = default_pose()
    camera = CameraPose(pose.R_GC, pose.p_GC + np.array([0.0, 0.0, 0.1]))
    far = PostureParams(near=0.38, far=0.46)
    motion = RandomPostures(hand, seed, duration=60.0, params=far, camera=camera)
    params = SimulationParams(render=DeskParams(light, surface=surface))
    rig = ideal_rig(pose=camera)
    sim = Simulation(hand, glove, motion, seed, params, rig=rig, extras=(Forearm(seed),))
    for t in times:
        now, images = sim.scene.instant(float(t)), sim.renderer.pair(float(t))
        for side, image in enumerate(images):
            seen = sim.scene.markers_seen(now, bool(side))
            some = np.isfinite(seen.uv[:, 0]) & (seen.whole > 0.05) & (seen.facing > 0.02)
            cosine = seen.facing / np.maximum(seen.whole, 1e-6)
            wanted = (seen.whole >= LEAST_SHARE) & (cosine > np.cos(np.deg2rad(LARGEST_DEG)))
            hue = [glove.markers[m].hue for m in np.flatnonzero(some)]
            yield SeenImage(image, seen.uv[some], hue, wanted[some])
