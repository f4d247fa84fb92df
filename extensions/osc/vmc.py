"""Fingers to avatars: the Virtual Motion Capture (VMC) protocol over OSC and UDP.

Messages are those of protocol.vmc.info ("Performer" to "Marionette"). Unity counts the thumb
from one bone further out than anatomy does: its ThumbProximal is the metacarpal, its
ThumbIntermediate the proximal phalanx. The hand bone's own rotation is not sent, since it is
relative to a forearm that nothing measures; the hand's pose goes as a tracker of its own instead.

VMC knows no validity. A lost bone is not sent (the avatar keeps its last pose), and each bone's
state goes with every bundle as ``/Glovetrack/Bone/State name state``, which receivers of plain VMC
pass over, as they do ``/Glovetrack/Gesture name value shown``. Where OpenXR's joints are asked for,
a second bundle has them as
``/Glovetrack/OpenXR/Joint name x y z qx qy qz qw radius state``, without a pose where lost.
Velocities follow in a bundle of ``/Glovetrack/Frame side seq t_unix_ns`` and, for each keypoint or
joint that is not lost, ``/Glovetrack/Velocity name vx vy vz wx wy wz sd angular_sd`` in m/s and
rad/s: in Unity's world, or of OpenXR's joints in theirs.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache

import numpy as np

from extensions.osc.encode import (
    FLOAT,
    INT,
    OscTemplate,
    Value,
    bundle_of,
    elements,
    message,
)
from extensions.osc.extension import VmcOptions
from extensions.osc.vmc_pose import AvatarHand, unity_pose, unity_velocity
from tracker.base.notices import Notice, notice
from tracker.gestures.values import GESTURES
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.hand.openxr import JOINTS
from tracker.messages import Estimate, IntArray, Tracking, Validity
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.payload import moving_points, openxr_of
from tracker.streaming.publisher import STATE_WORDS, Names, Publisher

CALIBRATED, NORMAL_MODE = 3, 0
STATE = "/Glovetrack/Bone/State"
GESTURE = "/Glovetrack/Gesture"
FRAME, VELOCITY = "/Glovetrack/Frame", "/Glovetrack/Velocity"
OPENXR_JOINT = "/Glovetrack/OpenXR/Joint"
TEMPLATES = 256  # for as many combinations of lost and known points
PARTS = ("proximal", "intermediate", "distal")
UNITY_BONES = {
    "thumb_metacarpal": "ThumbProximal",
    "thumb_proximal": "ThumbIntermediate",
    "thumb_distal": "ThumbDistal",
    **{f"{f}_{part}": f"{f.title()}{part.title()}" for f in FINGERS for part in PARTS},
}


class VmcPublisher:
    """Sends one OSC bundle per estimate to one address and never waits."""

    def __init__(
        self,
        hand: HandModel,
        host: str,
        port: int,
        names: Names | None = None,
        velocity: bool = False,
    ) -> None:
        """``names``: of the estimates' rows, where OpenXR's joints or the velocities are sent."""
        self.name = notice("stream.to", stream="VMC", host=host, port=port)
        self._hand, self._names, self._velocity = hand, names, velocity
        self._gestures = names.recogniser() if names is not None else None
        self._avatar = AvatarHand(hand)
        self._segments = np.array(
            [i for i, s in enumerate(hand.segments) if s.name in UNITY_BONES], int
        )
        """Rows of the segments that are bones of an avatar."""
        self._bones = [
            hand.side.title() + UNITY_BONES[hand.segments[i].name] for i in self._segments
        ]
        self._columns = _angle_columns(hand, self._segments)
        self._wrist = hand.keypoint_names.index("wrist")
        self._templates: dict[tuple[int, ...], OscTemplate] = {}  # by the states
        self._socket = DatagramSocket("VMC", host, port)

    def send(self, estimate: Estimate) -> None:
        self._socket.send(self._bundle(estimate))
        if self._names is not None and self._names.openxr:
            self._socket.send(openxr_bundle(estimate, self._names))
        if self._names is not None and self._velocity:
            self._socket.send(velocity_bundle(estimate, self._names))

    def probe(self) -> Notice:
        return self._socket.probe(self.name)

    def close(self) -> None:
        self._socket.close()

    def _bundle(self, e: Estimate) -> bytes:
        wrist, states = int(e.keypoint_state[self._wrist]), self._states(e)
        known = self._segments[states != Validity.LOST]
        key = (wrist, *states.tolist())
        if key not in self._templates:
            self._templates[key] = self._template(*key)
        numbers = [np.array([e.t])]
        if wrist != Validity.LOST:
            numbers += unity_pose(e.keypoints[self._wrist], e.keypoint_q[self._wrist])
        if len(known):
            numbers.append(self._avatar.poses(known, e).ravel())
        values, shown = self._gesture_values(e)
        tracked = int(e.tracking in (Tracking.TRACKING, Tracking.COASTING))
        template = self._templates[key]
        return bundle_of(template.pack(np.concatenate([*numbers, values]), [tracked, *shown]))

    def _template(self, wrist: int, *bones: int) -> OscTemplate:
        """The messages where wrist and bones have these states."""
        serial = f"glovetrack-{self._hand.side}"
        pose: list[Value] = [FLOAT] * 7
        out: list[tuple[str, Sequence[Value]]] = [
            ("/VMC/Ext/OK", [1, CALIBRATED, NORMAL_MODE, INT]),
            ("/VMC/Ext/T", [FLOAT]),
            (STATE, [serial, STATE_WORDS[Validity(wrist)]]),
        ]
        if wrist != Validity.LOST:
            out.append(("/VMC/Ext/Tra/Pos", [serial, *pose]))
        for name, state in zip(self._bones, bones, strict=True):
            out.append((STATE, [name, STATE_WORDS[Validity(state)]]))
            if state != Validity.LOST:
                out.append(("/VMC/Ext/Bone/Pos", [name, *pose]))
        names = GESTURES if self._gestures is not None else ()
        out += [(GESTURE, [name, FLOAT, INT]) for name in names]
        return OscTemplate(out)

    def _gesture_values(self, e: Estimate) -> tuple[list[float], list[int]]:
        """Each gesture's value, 0 where it is lost, and whether it is shown."""
        if self._gestures is None:
            return [], []
        self._gestures.feed(e)
        shown, found = self._gestures.active, self._gestures.values
        values = [0.0 if math.isnan(found[name]) else found[name] for name in GESTURES]
        return values, [int(name in shown) for name in GESTURES]

    def _states(self, e: Estimate) -> IntArray:
        """For each bone: that of its joint's worst angle; lost where it has none."""
        known = np.where(np.isfinite(e.angles), e.angle_state, int(Validity.LOST))
        ends = [int(Validity.LOST), int(Validity.MEASURED)]  # see _angle_columns
        return np.asarray(np.append(known, ends)[self._columns].min(axis=1))


def _angle_columns(hand: HandModel, segments: IntArray) -> IntArray:
    """(n, 3) columns of each segment's angles; -1 for an axis that is fixed, and -2 where all
    are."""
    out = np.array([hand.axis_columns[i] for i in segments], int)
    out[(out < 0).all(axis=1)] = -2
    return out


def openxr_bundle(e: Estimate, names: Names) -> bytes:
    """OpenXR's 26 joints as one OSC bundle; a lost joint has its name and state alone."""
    hand = openxr_of(e, names)
    known = hand.state != Validity.LOST
    numbers = np.column_stack([hand.position, hand.orientation, hand.radius])[known]
    return bundle_of(_openxr_template(tuple(hand.state.tolist())).pack(numbers.ravel()))


@lru_cache(maxsize=TEMPLATES)
def _openxr_template(states: tuple[int, ...]) -> OscTemplate:
    pose: list[Value] = [FLOAT] * 8
    return OscTemplate(
        [
            (
                OPENXR_JOINT,
                [joint, *([] if state == Validity.LOST else pose), STATE_WORDS[Validity(state)]],
            )
            for joint, state in zip(JOINTS, states, strict=True)
        ]
    )


def velocity_bundle(e: Estimate, names: Names) -> bytes:
    """Number, instant and velocities as one OSC bundle; what is lost is left out."""
    frame = elements([message(FRAME, names.side, e.seq, names.wall_ns(e.t) or 0)])
    moving = moving_points(e, names)
    if moving is None:
        return bundle_of(frame)
    linear, angular = moving.linear, moving.angular
    if not names.openxr:
        linear, angular = unity_velocity(linear, angular)
    rows = np.column_stack([linear, angular, moving.linear_sd, moving.angular_sd])
    known = np.isfinite(rows).all(axis=1)
    listed = np.array(JOINTS if names.openxr else names.keypoints)
    template = _velocity_template(tuple(listed[known].tolist()))
    return bundle_of(frame, template.pack(rows[known].ravel()))


@lru_cache(maxsize=TEMPLATES)
def _velocity_template(points: tuple[str, ...]) -> OscTemplate:
    return OscTemplate([(VELOCITY, [name, *[FLOAT] * 8]) for name in points])


def open_stream(options: VmcOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    """Yields the publisher of each hand."""
    for names in hands:
        yield VmcPublisher(names.model, options.host, options.port, names, options.velocity)
