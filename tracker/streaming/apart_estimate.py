"""Estimates as bytes for the outputs' process: a head, then the arrays one after the other.

Pickling an estimate takes 72 µs of the window's interpreter, which tracking needs; this takes 5.
"""

from __future__ import annotations

import struct
from functools import cache
from itertools import accumulate
from math import prod
from operator import attrgetter

import numpy as np

from tracker.messages import Estimate, Motion, Tracking

MARK = b"E"
"""The first byte; a pickle begins with another."""
HEAD = struct.Struct("<cB?5xHHHHdq")  # arrays begin at a multiple of 8 bytes
"""`MARK`, tracking, whether there is a motion, the hand, numbers of keypoints, angles and segments,
t (s) and seq."""
FLOAT, INT = np.dtype("<f8"), np.dtype("<i8")
K, J, S = range(3)
ESTIMATE = (
    ("keypoints", K, (3,), FLOAT),
    ("keypoint_q", K, (4,), FLOAT),
    ("keypoint_state", K, (), INT),
    ("keypoint_sd", K, (), FLOAT),
    ("angles", J, (), FLOAT),
    ("angle_state", J, (), INT),
    ("segment_R", S, (3, 3), FLOAT),
    ("segment_p", S, (3,), FLOAT),
)
MOTION = (
    ("linear", K, (3,), FLOAT),
    ("angular", K, (3,), FLOAT),
    ("linear_sd", K, (), FLOAT),
    ("angular_sd", K, (), FLOAT),
    ("angle_rate", J, (), FLOAT),
    ("angle_rate_sd", J, (), FLOAT),
    ("angle_sd", J, (), FLOAT),
)
"""Fields in the order of the message: name, what its rows are, the shape and type of a row."""
_arrays = attrgetter(*(name for name, *_ in ESTIMATE))
_moving = attrgetter(*(name for name, *_ in MOTION))


def packed(hand: int, e: Estimate, number: int) -> bytes:
    """The estimate ``number`` of the hand ``hand``, in the order of the session's hands."""
    k, j, s = len(e.keypoints), len(e.angles), len(e.segment_p)
    head = HEAD.pack(MARK, e.tracking, e.motion is not None, hand, k, j, s, e.t, number)
    parts = _arrays(e) if e.motion is None else (*_arrays(e), *_moving(e.motion))
    data = b"".join((head, *(a.ravel() for a in parts)))
    if len(data) == _size(e.motion is not None, k, j, s):
        return data
    fields = (*ESTIMATE, *MOTION)[: len(parts)]  # an array of another type
    rows = [a.astype(kind).ravel() for a, (*_, kind) in zip(parts, fields, strict=True)]
    return b"".join((head, *rows))


@cache
def _size(has_motion: bool, *sizes: int) -> int:
    """Bytes of a message, if all arrays have their types."""
    fields = (*ESTIMATE, *MOTION) if has_motion else ESTIMATE
    return HEAD.size + sum(8 * prod((sizes[rows], *row)) for _, rows, row, _ in fields)


def unpacked(data: bytes) -> tuple[int, Estimate]:
    """The hand and its estimate, whose arrays are parts of ``data``."""
    _, tracking, has_motion, hand, *sizes, t, seq = HEAD.unpack_from(data)
    fields = (*ESTIMATE, *MOTION) if has_motion else ESTIMATE
    shapes = [(sizes[rows], *row) for _, rows, row, _ in fields]
    starts = accumulate([prod(shape) * 8 for shape in shapes], initial=HEAD.size)
    arrays = {
        name: np.frombuffer(data, kind, prod(shape), start).reshape(shape)
        for (name, _, _, kind), shape, start in zip(fields, shapes, starts, strict=False)
    }
    motion = None
    if has_motion:
        motion = Motion(**{name: arrays.pop(name) for name, _, _, _ in MOTION})
    return hand, Estimate(t=t, tracking=Tracking(tracking), motion=motion, seq=seq, **arrays)
