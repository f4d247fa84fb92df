"""The numbers of an episode: what the hands are at each frame, and what the robot does."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from extensions.lerobot.layout import POSITIONS, TURNS, HandNames, Layout
from extensions.lerobot.plan import Episode, hand_sides, robot_topics
from tracker.base.clock import NS
from tracker.hand.openxr import WRIST as WRIST_JOINT
from tracker.hand.openxr import joint_radii, openxr_joints
from tracker.messages import Array, IntArray, Validity
from tracker.session.description import SessionInfo
from tracker.session.export.resample import continuous, sampled_at
from tracker.session.export.series import EstimateSeries
from tracker.session.hand_columns import HandColumns, read_hand, read_joints
from tracker.session.reader import SessionReader

Numbers = NDArray[np.float32]
FEW = 2
"""Estimates below which nothing lies between them."""
BESIDE = NS
"""ns of estimates before and after an episode, by which its ends are smoothed."""


class Frames(NamedTuple):
    """N frames: state (N, D); valid (N, D), 1 where it is known and 0 where lost (numbers, since
    Rerun reads no flags); action (N, A)."""

    state: Numbers
    valid: Numbers
    action: Numbers


class Recorded(NamedTuple):
    """All that a session says of its hands and robots, read once for all its episodes."""

    hands: tuple[tuple[SessionInfo, HandColumns], ...]
    robots: tuple[tuple[IntArray, Array], ...]


def read_recorded(
    path: Path, layout: Layout, watch: Callable[[float], None] = lambda share: None
) -> Recorded:
    """Raises FileError where a hand has no estimates at all."""
    with SessionReader(path) as reader:
        sides = hand_sides(reader)
        robots = tuple(read_joints(reader, topic) for topic in robot_topics(reader).values())
        both = bool(reader.sides)
    hands = []
    for k, side in enumerate(sides):

        def tell(share: float, k: int = k) -> None:
            watch((k + share) / len(sides))

        with SessionReader(path, side=side if both else "") as reader:
            hands.append((reader.info, read_hand(reader, tell)))
    return Recorded(tuple(hands), tuple((r.stamp_ns, r.values) for r in robots))


def frames_of(episode: Episode, layout: Layout, recorded: Recorded) -> Frames:
    """What is lost keeps its last value, or the first that comes; what is never known is no move:
    zeros, and the quaternion of no turn. ``valid`` is 0 there."""
    at = episode.start_ns + np.round(np.arange(episode.frames) * (NS / layout.fps)).astype(np.int64)
    values, valid = [], []
    for (info, columns), names in zip(recorded.hands, layout.hands, strict=True):
        found = _hand(info, columns, names, at, layout.fps)
        valid.append(np.isfinite(found).astype(np.float32))
        values.append(_held(found, _nowhere(names)))
    state, known = np.concatenate(values, axis=1), np.concatenate(valid, axis=1)
    return Frames(state, known, _action(recorded, at) if layout.robot else _next(state))


def _hand(
    info: SessionInfo, columns: HandColumns, names: HandNames, at: IntArray, fps: int
) -> Numbers:
    """(N, numbers of the hand); NaN where lost."""
    m = _series(info, columns, at)
    if len(m) < FEW:
        return np.full((len(at), names.numbers), np.nan, np.float32)
    m = sampled_at(m, (at - m.stamp_ns[0]) / NS, fps)
    hand = openxr_joints(m.keypoints, m.q, m.state, m.keypoint_names, joint_radii(info.hand))
    turns = np.stack([continuous(q) for q in np.moveaxis(hand.orientation, 1, 0)], axis=1)
    n = len(at)
    wrist = [hand.position[:, WRIST_JOINT], turns[:, WRIST_JOINT]]
    parts = [hand.position.reshape(n, POSITIONS), turns.reshape(n, TURNS), *wrist, m.angles]
    return np.concatenate(parts, axis=1).astype(np.float32)


def _series(info: SessionInfo, columns: HandColumns, at: IntArray) -> EstimateSeries:
    """The estimates about the frames, without segments; a second one of the same instant is left
    out."""
    stamp = columns.stamp_ns
    near = (stamp >= at[0] - BESIDE) & (stamp <= at[-1] + BESIDE)
    near &= np.diff(stamp, prepend=np.int64(-1)) > 0
    c = columns.rows(near)
    n, k = c.state.shape
    lost = c.state == Validity.LOST
    keypoints = np.where(lost[:, :, None], np.nan, c.keypoints)
    return EstimateSeries(
        info, info.keypoint_names, info.hand.joint_names, c.stamp_ns, keypoints, c.q,
        c.state.astype(np.int64), np.zeros((n, k)), c.angles, c.angle_state.astype(np.int64),
        np.zeros((n, 0, 3)), np.zeros((n, 0, 4)),
    )  # fmt: skip


def _held(values: Numbers, nowhere: Numbers) -> Numbers:
    """(N, D) without NaN."""
    out = np.empty_like(values)
    row = np.arange(len(values))
    for k, column in enumerate(values.T):
        known = np.isfinite(column)
        if not known.any():
            out[:, k] = nowhere[k]
            continue
        last = np.maximum.accumulate(np.where(known, row, -1))
        out[:, k] = column[np.where(last < 0, np.argmax(known), last)]
    return out


def _nowhere(names: HandNames) -> Numbers:
    """(numbers,) of a hand that is never known."""
    out = np.zeros(names.numbers, np.float32)
    out[POSITIONS + 3 : POSITIONS + TURNS : 4] = 1.0
    out[POSITIONS + TURNS + 6] = 1.0
    return out


def _next(state: Numbers) -> Numbers:
    """The state of the frame after; the last one's own."""
    return np.concatenate([state[1:], state[-1:]])


def _action(recorded: Recorded, at: IntArray) -> Numbers:
    """What the robots' joints were told last before each frame."""
    parts = []
    for stamps, values in recorded.robots:
        row = np.clip(np.searchsorted(stamps, at, side="right") - 1, 0, None)
        told = values[row].astype(np.float32)
        parts.append(_held(told, np.zeros(told.shape[1], np.float32)))
    return np.concatenate(parts, axis=1)
