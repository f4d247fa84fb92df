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

import numpy as np

from extensions.osc import decode
from extensions.osc.decode import OscError
from extensions.osc.encode import FLOAT, OscTemplate, Value, bundle_of, elements, message
from extensions.vr.buttons import ButtonGestures, Controls, control_reader
from extensions.vr.extension import VmtOptions
from extensions.vr.skeleton import BoneSkeleton, RigidMotion, in_unity
from tracker.base.notices import Notice, notice
from tracker.hand.openxr import OpenXrHand
from tracker.messages import Estimate
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
ALIVE_WAIT = 1.5  # s; the driver reports every second
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


def driver_version(port: int = ANSWER_PORT, patience: float = ALIVE_WAIT) -> str | None:
    """The version that VMT's driver on this computer reports; None where it reports none."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as answers:
        end = time.monotonic() + patience
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
