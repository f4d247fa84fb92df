"""A hand for Foxglove's 3D panel: foxglove.SceneUpdate as JSON, and the schemas of our channels.

Source: docs.foxglove.dev/docs/sdk/schemas/scene-update. What a scene leaves out has Foxglove's
defaults: an upright pose, no shapes of that kind.

A schema keeps to what Foxglove reads of JSON schema (parseJsonSchema.ts of its mcap-support): one
``type`` a field, so "or null" cannot be expressed; a choice only as numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tracker.gestures.values import GESTURES
from tracker.hand.names import bones
from tracker.hand.openxr import JOINTS
from tracker.messages import Estimate, Validity
from tracker.streaming.publisher import STATE_WORDS, Names
from tracker.streaming.text import HOLE, Column, TextForm, holes

Json = dict[str, Any]

FORMS = 256  # scenes whose text is stored
FRAME = "world"  # G, z up
LIFETIME = {"sec": 1, "nsec": 0}  # of a hand in the view after the last estimate
LINE_LIST = 2  # foxglove.LinePrimitive's type: points 0-1, 2-3, ...
SIZE_M = {Validity.MEASURED: 0.010, Validity.INFERRED: 0.006}
COLOURS = {
    Validity.MEASURED: {"r": 0.12, "g": 0.47, "b": 0.71, "a": 1.0},
    Validity.INFERRED: {"r": 0.85, "g": 0.60, "b": 0.20, "a": 0.6},
}


class FoxgloveScene:
    """Scenes of one hand: a sphere per keypoint, a line per bone.

    What is lost is left out, what is inferred is small and pale, and the entity's metadata tells
    every keypoint's state in words.
    """

    def __init__(self, names: Names) -> None:
        self._names, self._bones = names, bones(names.keypoints)
        self._forms: dict[tuple[object, ...], TextForm] = {}  # by what is known and its states

    def text(self, e: Estimate, stamp_ns: int) -> str:
        """``e`` as a scene; ``stamp_ns`` since 1970."""
        known = np.isfinite(e.keypoints)
        key = e.keypoint_state.tobytes(), known.tobytes(), e.tracking
        if key not in self._forms:
            if len(self._forms) == FORMS:
                self._forms.clear()
            (points,) = holes([e.keypoints.shape], known)
            self._forms[key] = TextForm(self._update(e, points))
        sec, nsec = divmod(stamp_ns, 10**9)
        return self._forms[key].fill(e.keypoints.ravel(), [str(sec), str(nsec)])

    def _update(self, e: Estimate, points: Column) -> Json:
        """``points``: in place of those of ``e``."""
        states = [Validity(int(s)) for s in e.keypoint_state]
        words = (STATE_WORDS[s] for s in states)
        facts = [("tracking", e.tracking.name.lower())]
        facts += zip(self._names.keypoints, words, strict=True)
        entity = {
            "timestamp": {"sec": HOLE, "nsec": HOLE},
            "frame_id": FRAME,
            "id": f"hand {self._names.side}",
            "lifetime": LIFETIME,
            "frame_locked": False,
            "metadata": [{"key": key, "value": value} for key, value in facts],
            "spheres": _spheres(points, states),
            "lines": self._lines(points, states),
        }
        return {"deletions": [], "entities": [entity]}

    def _lines(self, points: Column, states: list[Validity]) -> list[Json]:
        """A bone is as sure as the less sure of its ends."""
        out = []
        for state, size in SIZE_M.items():
            ends = [
                xyz(points[i])
                for bone in self._bones
                if min(states[bone[0]], states[bone[1]]) == state
                and None not in (points[bone[0]], points[bone[1]])
                for i in bone
            ]
            look = {"type": LINE_LIST, "thickness": size / 2, "color": COLOURS[state]}
            if ends:
                out.append({**look, "points": ends})
        return out


def _spheres(points: Column, states: list[Validity]) -> list[Json]:
    """One per keypoint that is known."""
    out = []
    for p, state in zip(points, states, strict=True):
        if state == Validity.LOST or p is None:
            continue
        size = dict.fromkeys("xyz", SIZE_M[state])
        out.append({"pose": {"position": xyz(p)}, "size": size, "color": COLOURS[state]})
    return out


def xyz(p: Sequence[object]) -> dict[str, object]:
    return dict(zip("xyz", p, strict=True))


NUMBER = {"type": "number"}
STRING = {"type": "string"}
INTEGER = {"type": "integer"}


def object_of(title: str = "", /, **properties: Json) -> Json:
    out = {"type": "object", "properties": properties}
    return {"title": title, **out} if title else out


def array_of(items: Json) -> Json:
    return {"type": "array", "items": items}


def estimate_schema(names: Names) -> Json:
    """JSON schema of `payload`, so that Foxglove lists every keypoint and angle for plots.

    What is lost is null in a message, whatever its type here.
    """
    numbers = array_of(NUMBER)
    point = object_of(state=STRING, position=numbers, orientation_xyzw=numbers, sd=NUMBER)
    angle = object_of(state=STRING, value=NUMBER, sd=NUMBER, rate=NUMBER, rate_sd=NUMBER)
    of_each = object_of(**dict.fromkeys(GESTURES, NUMBER))
    velocity = object_of(linear=numbers, angular=numbers, sd=NUMBER, angular_sd=NUMBER)
    joint = object_of(state=STRING, position=numbers, orientation_xyzw=numbers, radius=NUMBER)
    if names.openxr:
        points = {"joints": object_of(**dict.fromkeys(JOINTS, joint))}
    else:
        points = {"keypoints": object_of(**dict.fromkeys(names.keypoints, point))}
    return object_of(
        "glovetrack.Estimate",
        schema=INTEGER,
        side=STRING,
        seq=INTEGER,
        t_unix_ns=INTEGER,
        t=NUMBER,
        tracking=STRING,
        **points,
        velocity=object_of(**dict.fromkeys(JOINTS if names.openxr else names.keypoints, velocity)),
        angles=object_of(**dict.fromkeys(names.angles, angle)),
        gestures=object_of(shown=array_of(STRING), values=of_each, confidence=of_each),
    )


def scene_schema() -> Json:
    """JSON schema of the fields of foxglove.SceneUpdate that `FoxgloveScene` writes."""
    stamp = {"sec": INTEGER, "nsec": INTEGER}
    axes = dict.fromkeys("xyz", NUMBER)
    vector, colour = object_of("foxglove.Vector3", **axes), dict.fromkeys("rgba", NUMBER)
    look = {"color": object_of("foxglove.Color", **colour)}
    sphere = object_of(
        "foxglove.SpherePrimitive",
        pose=object_of("foxglove.Pose", position=vector),
        size=vector,
        **look,
    )
    line_type = {"oneOf": [{"title": "LINE_LIST", "const": LINE_LIST}]}
    points = array_of(object_of("foxglove.Point3", **axes))
    line = object_of(
        "foxglove.LinePrimitive", type=line_type, thickness=NUMBER, points=points, **look
    )
    entity = object_of(
        "foxglove.SceneEntity",
        timestamp=object_of("time", **stamp),
        frame_id=STRING,
        id=STRING,
        lifetime=object_of("duration", **stamp),
        frame_locked={"type": "boolean"},
        metadata=array_of(object_of("foxglove.KeyValuePair", key=STRING, value=STRING)),
        spheres=array_of(sphere),
        lines=array_of(line),
    )
    deletion = object_of(
        "foxglove.SceneEntityDeletion", timestamp=object_of("time", **stamp), id=STRING
    )
    return object_of(
        "foxglove.SceneUpdate", deletions=array_of(deletion), entities=array_of(entity)
    )
