"""Descriptor of the stream to VMT."""

from __future__ import annotations

from dataclasses import dataclass

from extensions.vr.buttons import CONTROLS
from extensions.vr.haptics import LEFT, RIGHT
from tracker.base.registry import deferred
from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.registry import StreamKind


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


VMT = StreamKind(
    name="vmt",
    title="SteamVR, VRChat (VMT)",
    options=VmtOptions,
    make=deferred("extensions.vr.vmt:open_stream"),
    order=22,
)
