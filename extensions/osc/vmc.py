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

import numpy as np

from extensions.osc.encode import bundle, message
from extensions.osc.vmc_pose import AvatarHand, unity_pose, unity_velocity
from tracker.base.notices import Notice
from tracker.gestures.recogniser import GestureRecogniser
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.hand.openxr import JOINTS
from tracker.messages import Array, Estimate, Tracking, Validity
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.payload import moving_points, openxr_of
from tracker.streaming.publisher import STATE_WORDS, Names

CALIBRATED, NORMAL_MODE = 3, 0
STATE = "/Glovetrack/Bone/State"
GESTURE = "/Glovetrack/Gesture"
FRAME, VELOCITY = "/Glovetrack/Frame", "/Glovetrack/Velocity"
OPENXR_JOINT = "/Glovetrack/OpenXR/Joint"
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
        self.name = f"VMC to {host}:{port}"
        self._hand, self._names, self._velocity = hand, names, velocity
        self._gestures = GestureRecogniser(hand, names.keypoints) if names is not None else None
        self._avatar = AvatarHand(hand)
        self._bones = [
            (i, hand.side.title() + UNITY_BONES[s.name])
            for i, s in enumerate(hand.segments)
            if s.name in UNITY_BONES
        ]
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
        tracked = int(e.tracking in (Tracking.TRACKING, Tracking.COASTING))
        out = [
            message("/VMC/Ext/OK", 1, CALIBRATED, NORMAL_MODE, tracked),
            message("/VMC/Ext/T", float(e.t)),
            *self._hand_messages(e),
        ]
        states = [self._state(e, i) for i, _ in self._bones]
        known = [i for (i, _), s in zip(self._bones, states, strict=True) if s != Validity.LOST]
        rotations = self._avatar.rotations(known, e.angles).tolist() if known else []
        turned = dict(zip(known, rotations, strict=True))
        for (i, bone), state in zip(self._bones, states, strict=True):
            out.append(message(STATE, bone, STATE_WORDS[state]))
            if i in turned:
                pose = [*self._avatar.offsets[i].tolist(), *turned[i]]
                out.append(message("/VMC/Ext/Bone/Pos", bone, *pose))
        return bundle([*out, *self._gesture_messages(e)])

    def _gesture_messages(self, e: Estimate) -> list[bytes]:
        """Each gesture's value, 0 where it is lost, and whether it is shown."""
        if self._gestures is None:
            return []
        self._gestures.feed(e)
        return [
            message(GESTURE, name, float(np.nan_to_num(value)), int(name in self._gestures.active))
            for name, value in self._gestures.values.items()
        ]

    def _hand_messages(self, e: Estimate) -> list[bytes]:
        """The wrist as a tracker, where it is known."""
        wrist = self._hand.keypoint_names.index("wrist")
        state = Validity(int(e.keypoint_state[wrist]))
        serial = f"glovetrack-{self._hand.side}"
        out = [message(STATE, serial, STATE_WORDS[state])]
        if state != Validity.LOST:
            pose = _pose(*unity_pose(e.keypoints[wrist], e.keypoint_q[wrist]))
            out.append(message("/VMC/Ext/Tra/Pos", serial, *pose))
        return out

    def _state(self, e: Estimate, segment: int) -> Validity:
        """For a bone: that of its joint's worst angle."""
        columns = [c for c in self._hand.axis_columns[segment] if c >= 0]
        if not columns or not np.isfinite(e.angles[columns]).all():
            return Validity.LOST
        return Validity(int(e.angle_state[columns].min()))


def openxr_bundle(e: Estimate, names: Names) -> bytes:
    """OpenXR's 26 joints as one OSC bundle; a lost joint has its name and state alone."""
    hand, out = openxr_of(e, names), []
    for i, joint in enumerate(JOINTS):
        state = Validity(int(hand.state[i]))
        pose = [*_pose(hand.position[i], hand.orientation[i]), float(hand.radius[i])]
        out.append(
            message(
                OPENXR_JOINT, joint, *([] if state == Validity.LOST else pose), STATE_WORDS[state]
            )
        )
    return bundle(out)


def velocity_bundle(e: Estimate, names: Names) -> bytes:
    """Number, instant and velocities as one OSC bundle; what is lost is left out."""
    out = [message(FRAME, names.side, e.seq, names.wall_ns(e.t) or 0)]
    moving = moving_points(e, names)
    if moving is None:
        return bundle(out)
    linear, angular = moving.linear, moving.angular
    if not names.openxr:
        linear, angular = unity_velocity(linear, angular)
    rows = np.column_stack([linear, angular, moving.linear_sd, moving.angular_sd])
    for name, row in zip(JOINTS if names.openxr else names.keypoints, rows, strict=True):
        if np.isfinite(row).all():
            out.append(message(VELOCITY, name, *row.tolist()))
    return bundle(out)


def _pose(p: Array, q: Array) -> list[float]:
    return [*p.tolist(), *q.tolist()]
