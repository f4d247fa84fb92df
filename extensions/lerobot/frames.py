"""The values of an episode: the hands' states and the robot's actions at each frame."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
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
from tracker.session.export.resample import continuous, sampled_at
from tracker.session.export.series import EstimateSeries, recorded_series
from tracker.session.number_rows import NumberRows
from tracker.session.reader import SessionReader

Numbers = NDArray[np.float32]
FEW = 2
"""Fewest estimates between which values are interpolated."""
MARGIN = NS
"""ns of estimates before and after an episode that smooth its ends."""


class Frames(NamedTuple):
    """N frames: state (N, D); valid (N, D), 1 where the state is known and 0 where it is lost
    (numbers, because Rerun does not read booleans); action (N, A)."""

    state: Numbers
    valid: Numbers
    action: Numbers


class Recorded(NamedTuple):
    """The hands and robots of a session, read once for all its episodes."""

    hands: tuple[EstimateSeries, ...]
    robots: tuple[tuple[IntArray, Array], ...]


def read_recorded(
    path: Path, layout: Layout, watch: Callable[[float], None] = lambda share: None
) -> Recorded:
    """Read a session. Raises FileError if a hand has no estimates."""
    with SessionReader(path) as reader:
        sides = hand_sides(reader)
        robots = tuple(_robot_joints(reader, topic) for topic in robot_topics(reader).values())
        both = bool(reader.sides)
    hands = []
    for k, side in enumerate(sides):

        def tell(share: float, k: int = k) -> None:
            watch((k + share) / len(sides))

        with SessionReader(path, watch=tell, side=side if both else "") as reader:
            hands.append(recorded_series(reader, segments=False))
    return Recorded(tuple(hands), robots)


def _robot_joints(reader: SessionReader, topic: str) -> tuple[IntArray, Array]:
    """Stamps (N,) ns and values (N, C) of all JointState messages of a topic, in the order of their
    stamps; columns in the order in which their names first appear."""
    joints = NumberRows(8)
    for raw in reader.raw_messages(frozenset([topic])):
        with reader.source.left_out.reading(raw.topic, raw.log_time):
            joints.feed_joints(raw.data)
    names = tuple(dict.fromkeys(name for run in joints.runs for name in run.names))
    stamps, values = joints.by_name(names)
    order = np.argsort(stamps, kind="stable")
    return stamps[order], values[order]


def frames_of(episode: Episode, layout: Layout, recorded: Recorded) -> Frames:
    """Values at the frames of an episode. Lost values repeat the last known value, or the first one
    at the start; values that are never known are zero and the identity quaternion. ``valid`` is 0
    for both."""
    at = episode.start_ns + np.round(np.arange(episode.frames) * (NS / layout.fps)).astype(np.int64)
    values, valid = [], []
    for series, names in zip(recorded.hands, layout.hands, strict=True):
        found = _hand(series, names, at, layout.fps)
        valid.append(np.isfinite(found).astype(np.float32))
        values.append(_held(found, _nowhere(names)))
    state, known = np.concatenate(values, axis=1), np.concatenate(valid, axis=1)
    return Frames(state, known, _action(recorded, at) if layout.robot else _next(state))


def _hand(series: EstimateSeries, names: HandNames, at: IntArray, fps: int) -> Numbers:
    """(N, values of the hand); NaN where lost."""
    m = _near(series, at)
    if len(m) < FEW:
        return np.full((len(at), names.numbers), np.nan, np.float32)
    m = sampled_at(m, (at - m.stamp_ns[0]) / NS, fps)
    hand = openxr_joints(m.keypoints, m.q, m.state, m.keypoint_names, joint_radii(m.info.hand))
    turns = np.stack([continuous(q) for q in np.moveaxis(hand.orientation, 1, 0)], axis=1)
    n = len(at)
    wrist = [hand.position[:, WRIST_JOINT], turns[:, WRIST_JOINT]]
    parts = [hand.position.reshape(n, POSITIONS), turns.reshape(n, TURNS), *wrist, m.angles]
    return np.concatenate(parts, axis=1).astype(np.float32)


def _near(series: EstimateSeries, at: IntArray) -> EstimateSeries:
    """The estimates around the frames, without duplicates of an instant."""
    stamp = series.stamp_ns
    near = (stamp >= at[0] - MARGIN) & (stamp <= at[-1] + MARGIN)
    near &= np.diff(stamp, prepend=np.int64(-1)) > 0
    m = series.rows(np.flatnonzero(near))
    lost = m.state == Validity.LOST
    return replace(m, keypoints=np.where(lost[:, :, None], np.nan, m.keypoints))


def _held(values: Numbers, nowhere: Numbers) -> Numbers:
    """(N, D): NaN replaced by the last known value."""
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
    """(values,) of a hand that is never known."""
    out = np.zeros(names.numbers, np.float32)
    out[POSITIONS + 3 : POSITIONS + TURNS : 4] = 1.0
    out[POSITIONS + TURNS + 6] = 1.0
    return out


def _next(state: Numbers) -> Numbers:
    """The next frame's state; for the last frame its own."""
    return np.concatenate([state[1:], state[-1:]])


def _action(recorded: Recorded, at: IntArray) -> Numbers:
    """The last commands of the robots' joints before each frame."""
    parts = []
    for stamps, values in recorded.robots:
        row = np.clip(np.searchsorted(stamps, at, side="right") - 1, 0, None)
        commands = values[row].astype(np.float32)
        parts.append(_held(commands, np.zeros(commands.shape[1], np.float32)))
    return np.concatenate(parts, axis=1)
