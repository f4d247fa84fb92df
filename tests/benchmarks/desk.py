"""Photographs of a desk with a gloved hand and the truth about them: how well colours serve.

A scene is a folder with ``in.mcap`` (IMU packets and stereo images), ``truth.npz`` and
``visible.npz``; its README describes the arrays.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.messages import Array, Blobs, Estimate, ImuSample, StereoFrame, Validity
from tracker.offline.track import make_detector
from tracker.session.description import SessionInfo
from tracker.session.images import PackedFrame
from tracker.session.reader import SessionReader
from tracker.vision.colours import ColourProfile
from tracker.vision.detector import detect_frame

SCENES = ("window", "lamp", "led", "dim")
LEAST_VISIBLE, MOST_TURNED_DEG = 0.6, 70.0  # of a marker that should be found
FOUND_WITHIN_PX = 4.0
ANY_MARKER_PX = 8.0  # a blob this near a marker's middle, of its hue, is not a false one
NEAR_HAND_PX = 60.0  # of a keypoint
POINTS = ("thumb_tip", "index_tip", "middle_tip", "dorsum")
BADLY_WRONG = 0.05  # m
GOOD = 0.02  # m


def folder() -> Path | None:
    """Where the scenes are; None without the data."""
    root = os.environ.get("GLOVETRACK_DATA", "")
    path = Path(root) / "desk_pictures"
    return path if root and path.is_dir() else None


@dataclass(frozen=True, eq=False)
class Scene:
    """``messages``: packets and unpacked images in the order of feeding."""

    name: str
    info: SessionInfo
    messages: list[ImuSample | StereoFrame]
    truth: dict[str, Array]
    visible: dict[str, Array]

    @property
    def frames(self) -> list[StereoFrame]:
        return [m for m in self.messages if isinstance(m, StereoFrame)]


@lru_cache(maxsize=4)
def load(path: Path) -> Scene:
    """A scene with all its images, 240 MB."""
    with SessionReader(path / "in.mcap") as reader:
        info = replace(reader.info, rig=reader.rig())
        messages: list[ImuSample | StereoFrame] = []
        for m in reader.packed_messages((ImuSample, StereoFrame)):
            if isinstance(m, PackedFrame):
                frame = m.unpack()
                assert frame is not None
                messages.append(frame)
            elif isinstance(m, ImuSample):
                messages.append(m)
    with np.load(path / "truth.npz") as truth, np.load(path / "visible.npz") as visible:
        return Scene(path.name, info, messages, dict(truth), dict(visible))


@dataclass
class Detection:
    """Sums over images."""

    images: int = 0
    expected: int = 0
    found: int = 0
    false_near: int = 0
    false_far: int = 0
    by_hue: dict[str, list[int]] = field(default_factory=dict)  # found, expected

    @property
    def recall(self) -> float:
        return self.found / max(self.expected, 1)


def detection(scene: Scene, profile: ColourProfile, every: int = 1) -> Detection:
    """How well whole images are searched with ``profile``."""
    detector, out = make_detector(profile, scene.info), Detection()
    for k, frame in list(enumerate(scene.frames))[::every]:
        for side, image in enumerate((frame.left, frame.right)):
            assert image is not None
            _count(out, scene, k, side, detector.detect(image)[0], profile.hue_names)
    return out


def _count(
    out: Detection, scene: Scene, k: int, side: int, blobs: Blobs, names: tuple[str, ...]
) -> None:
    seen = scene.visible
    hue = np.array([names.index(m.hue) for m in scene.info.glove.markers])
    should = (seen["frac"][k, side] >= LEAST_VISIBLE) & (seen["angle"][k, side] <= MOST_TURNED_DEG)
    d = np.linalg.norm(blobs.uv[:, None] - seen["uv_vis"][k, side][None], axis=2)
    d = np.where(blobs.hue[:, None] == hue[None], np.nan_to_num(d, nan=np.inf), np.inf)
    found = np.logical_and((d <= FOUND_WITHIN_PX).any(axis=0), should)
    false = ~(d <= ANY_MARKER_PX).any(axis=1)
    near = _to_hand(scene, k, side, blobs.uv) <= NEAR_HAND_PX
    out.images += 1
    out.expected += int(np.sum(should))
    out.found += int(found.sum())
    out.false_near += int((false & near).sum())
    out.false_far += int((false & ~near).sum())
    for h, name in enumerate(names):
        sums = out.by_hue.setdefault(name, [0, 0])
        sums[0] += int(np.sum(found[hue == h]))
        sums[1] += int(np.sum(should[hue == h]))


def _to_hand(scene: Scene, k: int, side: int, uv: Array) -> Array:
    """(n,) px from the nearest keypoint."""
    rig = scene.info.rig
    assert rig is not None
    points = rig.project(scene.truth["keypoints_camera"][k], bool(side))
    return np.linalg.norm(uv[:, None] - points[None], axis=2).min(axis=1)


@dataclass(frozen=True)
class Figures:
    """Errors are over fingertips and dorsum of what is not lost, at the exposures' instants."""

    error_mm: float
    late_error_mm: float  # of the second half
    first_good: float  # s from the first image; nan where there is none
    lost: float  # share of the instants
    wrong: float  # share of instants at which a measured keypoint is badly wrong
    longest_wrong: float  # s
    by_point_mm: dict[str, float]


def tracked(scene: Scene, profile: ColourProfile, settings: Settings | None = None) -> Figures:
    """How well the scene is tracked with ``profile`` by the default engine."""
    return figures(scene, estimates(scene, profile, settings))


def estimates(
    scene: Scene, profile: ColourProfile, settings: Settings | None = None
) -> list[Estimate]:
    info = scene.info
    pipeline = Pipeline(info.hand, info.glove, info.rig, settings or Settings())
    detector = make_detector(profile, info)
    out = []
    for m in scene.messages:
        if isinstance(m, ImuSample):
            out.append(pipeline.feed_imu(m))
        else:
            pipeline.feed_frame(detect_frame(detector, m))
            pipeline.take_results()
    return out


def figures(scene: Scene, given: list[Estimate]) -> Figures:
    """For the estimate nearest to each exposure."""
    truth, info = scene.truth, scene.info
    assert info.rig is not None
    names = list(info.keypoint_names)
    theirs = [names.index(n) for n in truth["names"] if n in names]
    ours = [k for k, n in enumerate(truth["names"]) if n in names]
    t = np.array([e.t for e in given])
    frames = scene.frames
    error = np.full((len(frames), len(ours)), np.nan)
    measured = np.zeros(error.shape, bool)
    for k, frame in enumerate(frames):
        e = given[int(np.argmin(np.abs(t - frame.t)))]
        pose = frame.pose or info.rig.pose
        p_C = (e.keypoints[theirs] - pose.p_GC) @ pose.R_GC
        error[k] = np.linalg.norm(p_C - truth["keypoints_camera"][k][ours], axis=1)
        measured[k] = e.keypoint_state[theirs] == int(Validity.MEASURED)
    return _summary([str(truth["names"][k]) for k in ours], error, measured, frames)


def _summary(names: list[str], error: Array, measured: Array, frames: list[StereoFrame]) -> Figures:
    columns = [names.index(p) for p in POINTS]
    t = np.array([f.t for f in frames])
    mean = error[:, columns].mean(axis=1)
    wrong = np.any(np.logical_and(measured, error > BADLY_WRONG), axis=1)
    good = np.flatnonzero(mean < GOOD)
    half = len(mean) // 2

    def mm(x: Array) -> float:
        return float(1e3 * np.nanmean(x)) if np.isfinite(x).any() else np.nan

    return Figures(
        mm(mean), mm(mean[half:]), float(t[good[0]] - t[0]) if len(good) else np.nan,
        float(np.isnan(mean).mean()), float(wrong.mean()), _longest(np.atleast_1d(wrong), t),
        {n: mm(error[:, c]) for n, c in zip(POINTS, columns, strict=True)},
    )  # fmt: skip


def _longest(wrong: NDArray[np.bool_], t: Array) -> float:
    """s of the longest run, from its first instant to its last and half a period on each side."""
    period, best, run = float(np.median(np.diff(t))), 0, 0
    for x in wrong:
        run = run + 1 if x else 0
        best = max(best, run)
    return best * period


def lines(scene: Scene, profile: ColourProfile, every: int = 1) -> Iterator[str]:
    """The scene in words."""
    d, f = detection(scene, profile, every), tracked(scene, profile)
    hues = " ".join(f"{n} {a}/{b}" for n, (a, b) in d.by_hue.items())
    yield (
        f"{scene.name:7} recall {100 * d.recall:5.1f} %  false {d.false_far / d.images:6.1f} far "
        f"{d.false_near / d.images:5.1f} near  ({hues})"
    )
    points = " ".join(f"{n} {e:.1f}" for n, e in f.by_point_mm.items())
    yield (
        f"        error {f.error_mm:6.1f} mm (late {f.late_error_mm:.1f})  first good "
        f"{f.first_good:.2f} s  lost {100 * f.lost:.0f} %  wrong {100 * f.wrong:.0f} % longest "
        f"{f.longest_wrong:.1f} s  ({points})"
    )
