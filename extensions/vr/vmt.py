"""Hands to SteamVR by Virtual Motion Tracker: OSC over UDP (gpsnmeajp.github.io, "API").

One bundle for each estimate: ``/VMT/Room/Unity`` with the device's pose, ``/VMT/Skeleton/Unity``
with each bone and ``/VMT/Skeleton/Apply``, and ``/VMT/Input/...`` for controls. The driver has no
field for validity: what is lost is not sent, and the device keeps its last pose.
"""

from __future__ import annotations

import contextlib
import math
import socket
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from extensions.osc import decode
from extensions.osc.decode import OscError
from extensions.osc.encode import FLOAT, OscTemplate, Value, bundle_of, elements, message
from extensions.osc.vmc_pose import quaternions
from extensions.vr.buttons import ButtonGestures, Controls, control_reader
from extensions.vr.extension import VmtOptions
from tracker.base.notices import Notice, notice
from tracker.geometry import so3
from tracker.hand.names import CHAINS
from tracker.hand.openxr import JOINTS, WRIST, OpenXrHand
from tracker.messages import Array, Estimate, IntArray, Validity
from tracker.streaming.connection import LOOPBACK, StreamError
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.payload import openxr_of
from tracker.streaming.publisher import Names, Publisher

DRIVER_PORT, ANSWER_PORT = 39570, 39571
MOST_DEVICE = 57
MODE = {"left": 5, "right": 6}  # a controller with the inputs of a Valve Index
OFF = 0
TRIGGER, GRIP, GRIP_FORCE, FIRST_FINGER = 0, 1, 2, 3
A_BUTTON, B_BUTTON = 1, 3
DRIVER_WAIT = 1.5  # s; the driver reports every second
MOST_ANSWER = 4096  # bytes
NOW = 0.0  # the time offset of every message


@dataclass(frozen=True)
class VmtDevice:
    """What one hand is in SteamVR: ``index`` of VMT's devices, 0 to 57; ``controller`` as in
    `BoneSkeleton`."""

    index: int
    controller: bool = False

    def __post_init__(self) -> None:
        if not 0 <= self.index <= MOST_DEVICE:
            raise StreamError(notice("option.range", option="index", low=0, high=MOST_DEVICE))


class VmtPublisher:
    """Sends one OSC bundle for each estimate of a hand and never waits."""

    def __init__(
        self, names: Names, device: VmtDevice, gestures: ButtonGestures, host: str, port: int
    ) -> None:
        self.name = notice("stream.to", stream="VMT", host=host, port=port)
        self._names = names if names.openxr else names.with_openxr()
        self._device = device.index
        self._skeleton = BoneSkeleton(names.side, device.controller)
        self._controls = control_reader(names, gestures)
        self._templates: dict[bytes, OscTemplate] = {}  # by the bones that are known
        self._socket = DatagramSocket("VMT", host, port)

    def send(self, estimate: Estimate) -> None:
        self._socket.send(self._bundle(estimate))

    def probe(self) -> Notice:
        """VMT's driver reports every second that it runs, to a port that VMT Manager and the
        vibration of this program use, too: where that is taken, only the port is judged."""
        version = driver_version()
        if version is None:
            return self._socket.probe(self.name)
        return notice("vr.vmt_answers", stream=self.name, version=version)

    def close(self) -> None:
        """Turns the device off in SteamVR."""
        if self._socket.is_open:
            at_rest = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
            with contextlib.suppress(OSError):
                self._socket.send(message("/VMT/Room/Unity", self._device, OFF, NOW, *at_rest))
        self._socket.close()

    def _bundle(self, e: Estimate) -> bytes:
        joints = openxr_of(e, self._names)
        device = self._skeleton.device(joints)
        inputs = elements(self._inputs(self._controls.read(e)))
        return bundle_of(inputs if device is None else self._poses(joints, device) + inputs)

    def _poses(self, joints: OpenXrHand, device: RigidMotion) -> bytes:
        bones = self._skeleton.bones(joints, device)
        key = bones.numbers.tobytes()
        if key not in self._templates:
            self._templates[key] = self._template(bones.numbers.tolist())
        R, p = np.concatenate([device.R[None], bones.R]), np.concatenate([device.p[None], bones.p])
        return self._templates[key].pack(in_unity(R, p).ravel())

    def _template(self, bones: Sequence[int]) -> OscTemplate:
        """Messages for the device and the bones of these numbers."""
        device = self._device
        pose: list[Value] = [FLOAT] * 7
        out: list[tuple[str, list[Value]]] = [
            ("/VMT/Room/Unity", [device, MODE[self._names.side], NOW, *pose])
        ]
        out += [("/VMT/Skeleton/Unity", [device, bone, *pose]) for bone in bones]
        return OscTemplate([*out, ("/VMT/Skeleton/Apply", [device, NOW])])

    def _inputs(self, c: Controls) -> list[bytes]:
        fingers = zip(range(FIRST_FINGER, FIRST_FINGER + 4), c.curls[1:].tolist(), strict=True)
        triggers = {TRIGGER: c.trigger, GRIP: c.grip, GRIP_FORCE: c.grip, **dict(fingers)}
        clicks = {TRIGGER: c.trigger_click, GRIP: c.grip_click}
        buttons = {A_BUTTON: c.a, B_BUTTON: c.b}
        known = [(i, x) for i, x in triggers.items() if math.isfinite(x)]
        return [
            *(self._input("Trigger", i, float(x)) for i, x in known),
            *(self._input("Trigger/Click", i, int(x)) for i, x in clicks.items()),
            *(self._input("Button", i, int(x)) for i, x in buttons.items()),
        ]

    def _input(self, kind: str, index: int, value: float) -> bytes:
        return message(f"/VMT/Input/{kind}", self._device, index, NOW, value)


def driver_version(port: int = ANSWER_PORT, timeout: float = DRIVER_WAIT) -> str | None:
    """The version that VMT's driver on this computer reports; None where it reports none."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as answers:
        end = time.monotonic() + timeout
        try:
            answers.bind((LOOPBACK, port))
            while (left := end - time.monotonic()) > 0:
                answers.settimeout(left)
                with contextlib.suppress(OscError):
                    address, values = decode.message(answers.recv(MOST_ANSWER))
                    if address == "/VMT/Out/Alive" and values:
                        return str(values[0])
        except OSError:
            return None
    return None


def open_stream(options: VmtOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    """Yields the publisher of each hand."""
    index = {"right": options.right, "left": options.left}
    gestures = ButtonGestures(options.trigger, options.grip, options.a, options.b)
    for names in hands:
        device = VmtDevice(index[names.side], options.controller)
        yield VmtPublisher(names, device, gestures, options.host, options.port)


# ---- the hand as OpenVR's skeleton of 31 bones, each relative to its parent
#
# OpenVR's world has OpenXR's axes (x right, y up, -z forward). Bones have those of Valve's hand
# models: on the left hand x points to the tip and y out of the palm; the right hand is its mirror
# image with all axes reversed. The wrist's z points to the fingers and y to the thumb. Sources:
# github.com/ValveSoftware/openvr/wiki/Hand-Skeleton and the reference poses there.

ROOT, WRIST_BONE, BONES = 0, 1, 31
DIGITS = {f: [j for j in JOINTS if j.startswith(f"{f}_")] for f in CHAINS}
"""OpenXR's joints of each digit, base first: the bones of the digit, in OpenVR's order."""

_LENGTHS = [len(joints) for joints in DIGITS.values()]
_FIRST = 2 + np.cumsum([0, *_LENGTHS[:-1]])  # the first bone of each digit
PARENT = np.array(
    [
        *(ROOT, ROOT),
        *(WRIST_BONE if k in _FIRST else k - 1 for k in range(2, 2 + sum(_LENGTHS))),
        *[ROOT] * len(DIGITS),
    ]
)
"""For each bone, the one to which it is relative."""
SOURCE = np.array([*range(2 + sum(_LENGTHS)), *(_FIRST + _LENGTHS - 2)])
"""For each bone, the one whose pose it has: an auxiliary one repeats its digit's last joint before
the tip."""

# Columns: a bone's x, y, z in the axes of OpenXR's joint (-z to the tip, y out of the back).
A_BONE = {
    "left": np.array([[0.0, 0, -1], [0, -1, 0], [-1, 0, 0]]),
    "right": np.array([[0.0, 0, -1], [0, 1, 0], [1, 0, 0]]),
}
A_WRIST = {
    "left": np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]]),
    "right": np.array([[0.0, -1, 0], [-1, 0, 0], [0, 0, -1]]),
}
MIRROR_X = np.diag([-1.0, 1.0, 1.0])
MIRROR_Z = np.diag([1.0, 1.0, -1.0])


@dataclass(frozen=True, eq=False)
class RigidMotion:
    """A rigid motion: R (3, 3) and p (3,) m."""

    R: Array
    p: Array

    def __matmul__(self, other: RigidMotion) -> RigidMotion:
        return RigidMotion(self.R @ other.R, self.p + self.R @ other.p)

    @property
    def inverse(self) -> RigidMotion:
        return RigidMotion(self.R.T, -(self.R.T @ self.p))


def in_unity(R: Array, p: Array) -> Array:
    """(n, 7) positions and quaternions xyzw in Unity's axes, of poses R (n, 3, 3) and p (n, 3) in
    OpenVR's."""
    return np.column_stack([p @ MIRROR_Z, quaternions(MIRROR_Z @ R @ MIRROR_Z)])


def _held(side: str) -> RigidMotion:
    """The wrist bone in the axes of a Valve Index controller that is held (its reference pose)."""
    w, x, y, z = -0.055147, -0.078608, -0.920279, 0.379296
    R = so3.matrix_from_quat(np.array([x, y, z, w]) / np.linalg.norm([x, y, z, w]))
    p = np.array([-0.034038, 0.036503, 0.164722])
    if side == "left":
        return RigidMotion(R, p)
    return RigidMotion(MIRROR_X @ R @ MIRROR_X, MIRROR_X @ p)


HELD = {side: _held(side) for side in ("left", "right")}


class Bones(NamedTuple):
    """The bones that are known, by number: R (n, 3, 3) and p (n, 3) m, relative to their parents;
    the parent of the root, the wrist and the auxiliary bones is the device."""

    numbers: IntArray
    R: Array
    p: Array


class BoneSkeleton:
    """Bones of one hand. A ``controller`` device stands where an Index controller would be in the
    hand; otherwise it has the pose of the wrist: -z to the fingers, y out of the back."""

    def __init__(self, side: str, controller: bool) -> None:
        self._side, self._controller = side, controller
        self._rows = np.array([JOINTS.index(j) for joints in DIGITS.values() for j in joints])

    def device(self, joints: OpenXrHand) -> RigidMotion | None:
        """Where the device is in OpenVR's world; None where the wrist is lost."""
        if joints.state[WRIST] == Validity.LOST:
            return None
        wrist = RigidMotion(so3.matrix_from_quat(joints.orientation[WRIST]), joints.position[WRIST])
        if not self._controller:
            return wrist
        return self._wrist_bone(wrist) @ HELD[self._side].inverse

    def _wrist_bone(self, wrist: RigidMotion) -> RigidMotion:
        return RigidMotion(wrist.R @ A_WRIST[self._side], wrist.p)

    def bones(self, joints: OpenXrHand, device: RigidMotion) -> Bones:
        """Each bone that is known and whose parent is."""
        R_joints = so3.matrix_from_quat(joints.orientation[[WRIST, *self._rows]])
        wrist = self._wrist_bone(RigidMotion(R_joints[0], joints.position[WRIST]))
        R = np.concatenate([[device.R, wrist.R], R_joints[1:] @ A_BONE[self._side]])
        p = np.concatenate([[device.p, wrist.p], joints.position[self._rows]])
        known = np.concatenate([[True, True], joints.state[self._rows] != Validity.LOST])
        R, p, known = R[SOURCE], p[SOURCE], known[SOURCE]
        found = np.flatnonzero(known & known[PARENT])
        parents = PARENT[found]
        back = np.swapaxes(R[parents], 1, 2)
        relative = np.einsum("nij,nj->ni", back, p[found] - p[parents])
        return Bones(found, back @ R[found], relative)
