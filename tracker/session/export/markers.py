"""Positions of the glove's markers on the tracked hand."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, Calibration, IntArray, Validity
from tracker.session.export.axes import AXES
from tracker.session.export.series import EstimateSeries
from tracker.session.reader import SessionReader

ABOVE = 0.1
"""m from a bone's line to its dorsal point."""


class Markers(NamedTuple):
    """names (M,); position (N, M, 3) m, NaN where lost; state (N, M) and sd (N, M) m of the
    joint at which the marker's segment begins."""

    names: tuple[str, ...]
    position: Array
    state: IntArray
    sd: Array


class Sizes(NamedTuple):
    """Factors (C, S, 3) of a session's calibrations, the nominal size first, and the instants (C,)
    ns from which on each is valid."""

    since_ns: IntArray
    scale: Array

    def at(self, stamp_ns: IntArray) -> IntArray:
        """Returns (N,) the one that is valid at each instant."""
        return np.maximum(np.searchsorted(self.since_ns, stamp_ns, side="right") - 1, 0)


def read_sizes(reader: SessionReader) -> Sizes:
    hand = reader.info.hand
    since, scale = [np.iinfo(np.int64).min], [np.ones((len(hand.segments), 3))]
    for m in reader.messages([Calibration]):
        assert isinstance(m, Calibration)
        now = scale[-1].copy()
        for name, factors in zip(m.segments, m.scale, strict=True):
            if name in hand.index and np.isfinite(factors).all():
                now[hand.index[name]] = factors
        since.append(reader.anchor.wall(m.t))
        scale.append(now)
    return Sizes(np.array(since, np.int64), np.array(scale))


def carried_markers(reader: SessionReader, m: EstimateSeries) -> Markers:
    """Markers of the estimates ``m``, which contain all keypoints, at their positions on the
    calibrated hand; slip of the fabric is not included.
    """
    glove, hand = m.info.glove, m.info.hand
    names = marker_names(glove)
    return carried(reader, m, names, glove.marker_segment(hand), glove.marker_position)


def dorsal_points(reader: SessionReader, m: EstimateSeries) -> Markers:
    """Returns one point above the back of each segment. Without such points, the rotation of a bone
    about its axis and the flexion of a nearly straight finger are poorly determined."""
    hand = m.info.hand
    position = np.array([[0.5 * s.length, 0.0, ABOVE] for s in hand.segments])
    return carried(reader, m, dorsal_names(hand), np.arange(len(position)), position)


def carried(
    reader: SessionReader,
    m: EstimateSeries,
    names: tuple[str, ...],
    segment: IntArray,
    position: Array,
) -> Markers:
    """Returns points at ``position`` (M, 3) m in the B of their ``segment`` (M,), of nominal
    size."""
    info, sizes = m.info, read_sizes(reader)
    scale = sizes.scale[:, segment]  # (C, M, 3)
    own = np.array([1.0, -1.0, 1.0]) if AXES[str(m.notes["axes"])].left_handed else np.ones(3)
    offset = (position * scale * own)[sizes.at(m.stamp_ns + m.zero_ns)]
    q, p = m.segment_q[:, segment], m.segment_p[:, segment]
    position = np.full(p.shape, np.nan)
    known = np.isfinite(q).all(axis=2) & np.isfinite(p).all(axis=2)
    position[known] = p[known] + Rotation.from_quat(q[known]).apply(offset[known])
    base = _base_of(info.glove.keypoint_segments(info.hand), len(info.hand.segments))[segment]
    state = np.where(known, m.state[:, base], int(Validity.LOST))
    position[state == Validity.LOST] = np.nan
    return Markers(names, position, state, m.sd[:, base])


def marker_names(glove: GloveModel) -> tuple[str, ...]:
    return tuple(f"M{k.id:02d}_{k.segment}" for k in glove.markers)


def dorsal_names(hand: HandModel) -> tuple[str, ...]:
    return tuple(f"{s.name}_dorsal" for s in hand.segments)


def _base_of(segments: IntArray, count: int) -> IntArray:
    """Returns (S,) the row of the first keypoint of each segment; 0 without one."""
    first = {int(s): k for k, s in reversed(list(enumerate(segments)))}
    return np.array([first.get(s, 0) for s in range(count)], np.int64)
