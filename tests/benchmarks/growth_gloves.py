"""Gloves of many sizes for `bench_growth`: more fingers, more IMUs, more markers on one hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.geometry import so3
from tracker.glove.model import GloveModel, Imu, Marker
from tracker.hand.model import HandModel

FINGERS = ("thumb", "index", "middle", "ring", "little")
PATTERN = "middle"  # what a further finger wears


def with_fingers(hand: HandModel, glove: GloveModel, count: int) -> GloveModel:
    """The first ``count`` fingers equipped; further ones like the middle finger."""
    imus, markers = list(glove.imus), list(glove.markers)
    worn = {i.segment.split("_")[0] for i in imus}
    for finger in FINGERS[:count]:
        if finger in worn:
            continue
        imus += [
            replace(i, name=_moved(i.name, finger), segment=_moved(i.segment, finger))
            for i in glove.imus
            if i.segment.startswith(PATTERN)
        ]
        for m in glove.markers:
            if m.segment.startswith(PATTERN):
                segment = _moved(m.segment, finger)
                markers.append(replace(m, id=len(markers), segment=segment))
    return replace(glove, imus=tuple(imus), markers=tuple(markers))


def _moved(name: str, finger: str) -> str:
    return name.replace(PATTERN, finger)


def with_imus(hand: HandModel, glove: GloveModel, count: int) -> GloveModel:
    """``count`` IMUs: the glove's, and one on the back of each further segment from the wrist."""
    imus = list(glove.imus)
    worn = {i.segment for i in imus}
    for s in hand.segments:
        if len(imus) < count and s.name not in worn:
            place = np.array([s.length / 2, 0.0, s.radius])
            imus.append(Imu(s.name, s.name, place, np.eye(3)))
    return replace(glove, imus=tuple(imus))


def with_markers(glove: GloveModel, count: int) -> GloveModel:
    """``count`` markers: the glove's own again, each time a quarter turn about the segment's axis.

    So they do not overlap those that are there already.
    """
    markers: list[Marker] = []
    for k in range(count):
        again, m = divmod(k, len(glove.markers))
        old, turn = glove.markers[m], so3.rx(again * np.pi / 2)
        markers.append(replace(old, id=k, position=turn @ old.position, normal=turn @ old.normal))
    return replace(glove, markers=tuple(markers))
