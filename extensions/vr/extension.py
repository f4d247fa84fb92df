"""Descriptors of virtual reality: streams to its runtimes, and vibration from them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from tracker.gestures.values import GESTURES
from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.reception import Answer
from tracker.streaming.remote.registry import DoorKind

CONTROLS = ("", *GESTURES)
RIGHT, LEFT = 57, 56
"""The last two devices of VMT: the first ones are used by full-body trackers."""


@dataclass(frozen=True)
class VmtOptions:
    host: str = option(LOOPBACK, "computer that runs SteamVR")
    port: int = option(39570, "port of VMT's driver")
    right: int = option(RIGHT, "number of the right hand's device, 0 to 57")
    left: int = option(LEFT, "number of the left hand's device, 0 to 57")
    controller: bool = option(
        False,
        "whether the device is at the position of a controller in the hand instead of at the wrist",
    )
    trigger: str = option("pinch_index", "gesture for the trigger", CONTROLS)
    grip: str = option("grasp", "gesture for the grip", CONTROLS)
    a: str = option("pinch_middle", "gesture for button A", CONTROLS)
    b: str = option("pinch_ring", "gesture for button B", CONTROLS)


@dataclass(frozen=True)
class OpenGlovesOptions:
    pipe: str = option(
        r"\\.\pipe\vrapplication\input\glove\v2\{side}",
        "path of the driver's pipe; {side} stands for left or right",
    )
    trigger: str = option("pinch_index", "gesture for the trigger", CONTROLS)
    grip: str = option("grasp", "gesture for the grip", CONTROLS)
    a: str = option("pinch_middle", "gesture for button A", CONTROLS)
    b: str = option("pinch_ring", "gesture for button B", CONTROLS)


@dataclass(frozen=True)
class MonadoOptions:
    link: str = option("", "path of a link to the serial port, with {side} for left or right")
    trigger: str = option("pinch_index", "gesture for the trigger", CONTROLS)
    grip: str = option("grasp", "gesture for the grip", CONTROLS)
    a: str = option("pinch_middle", "gesture for button A", CONTROLS)
    b: str = option("pinch_ring", "gesture for button B", CONTROLS)


@dataclass(frozen=True)
class HapticOptions:
    host: str = option(LOOPBACK, "listening address")
    port: int = option(39571, "port to which VMT's driver sends")
    right: int = option(RIGHT, "number of the right hand's device, 0 to 57")
    left: int = option(LEFT, "number of the left hand's device, 0 to 57")
    fingers: str = option("all", "motors that vibrate: a list such as thumb,index, or all")


def _vmt(options: VmtOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    from extensions.vr.buttons import ButtonGestures
    from extensions.vr.vmt import VmtDevice, VmtPublisher

    index = {"right": options.right, "left": options.left}
    gestures = ButtonGestures(options.trigger, options.grip, options.a, options.b)
    for names in hands:
        device = VmtDevice(index[names.side], options.controller)
        yield VmtPublisher(names, device, gestures, options.host, options.port)


def _opengloves(options: OpenGlovesOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    from extensions.vr.buttons import ButtonGestures
    from extensions.vr.opengloves import PipePublisher

    gestures = ButtonGestures(options.trigger, options.grip, options.a, options.b)
    for names in hands:
        yield PipePublisher(names, gestures, options.pipe)


def _monado(options: MonadoOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    from extensions.vr.buttons import ButtonGestures
    from extensions.vr.opengloves import LinePublisher

    gestures = ButtonGestures(options.trigger, options.grip, options.a, options.b)
    for names in hands:
        yield LinePublisher(names, gestures, options.link)


def _haptics(options: HapticOptions, answer: Answer) -> Door:
    from extensions.vr.haptics import HapticDoor

    sides = {options.right: "right", options.left: "left"}
    return HapticDoor(answer, sides, options.fingers, options.host, options.port)


VMT = StreamKind(name="vmt", title="SteamVR, VRChat (VMT)", options=VmtOptions, make=_vmt, order=22)
OPENGLOVES = StreamKind(
    name="opengloves",
    title="SteamVR (OpenGloves)",
    options=OpenGlovesOptions,
    make=_opengloves,
    order=23,
)
MONADO = StreamKind(
    name="monado",
    title="Monado (serial line)",
    options=MonadoOptions,
    make=_monado,
    order=23,
)
HAPTICS = DoorKind(
    name="vmt",
    title="SteamVR vibration (VMT)",
    options=HapticOptions,
    make=_haptics,
    order=22,
)
