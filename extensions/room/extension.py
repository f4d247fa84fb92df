"""Descriptors of the room: poses of trackers of other systems, as remote control."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.reception import Answer
from tracker.streaming.remote.registry import DoorKind

if TYPE_CHECKING:
    from extensions.room.placement import Placement

UPWARDS = ("y", "z")
ALIGNMENT = "file that glovetrack room align has written"
YAW = "degrees by which the room is turned about the vertical"
DELAY = "milliseconds between a measurement and its arrival"


@dataclass(frozen=True)
class OscPoseOptions:
    host: str = option(LOOPBACK, "listening address")
    port: int = option(39539, "listening port; that of a VMC Marionette")
    right: str = option("", "name or serial number of the right hand's tracker; any: every tracker")
    left: str = option("", "name or serial number of the left hand's tracker; any: every tracker")
    alignment: str = option("", ALIGNMENT)
    yaw_deg: float = option(0.0, YAW)
    delay_ms: float = option(0.0, DELAY)
    position_mm: float = option(2.0, "standard deviation of positions, mm")
    rotation_deg: float = option(1.0, "standard deviation of rotations, degrees")


@dataclass(frozen=True)
class NatNetOptions:
    host: str = option(LOOPBACK, "address of this computer in Motive's network")
    port: int = option(1511, "data port")
    server: str = option("", "address of the computer that runs Motive; empty: only listen")
    group: str = option("239.255.42.99", "multicast group; empty: unicast")
    up: str = option("y", "axis of Motive that points up", UPWARDS)
    right: str = option("1", "streaming ID of the right hand's rigid body; any: every body")
    left: str = option("", "streaming ID of the left hand's rigid body; any: every body")
    alignment: str = option("", ALIGNMENT)
    yaw_deg: float = option(0.0, YAW)
    delay_ms: float = option(0.0, DELAY)
    position_mm: float = option(1.0, "standard deviation of positions, mm")
    rotation_deg: float = option(0.5, "standard deviation of rotations, degrees")


@dataclass(frozen=True)
class LslPoseOptions:
    type: str = option("MoCap", "type of the stream: x y z qx qy qz qw, or x y z; m")
    network: bool = option(False, "whether streams of other computers are read")
    up: str = option("z", "axis of the stream that points up", UPWARDS)
    right: str = option("any", "name of the right hand's stream; any: every stream")
    left: str = option("", "name of the left hand's stream; any: every stream")
    alignment: str = option("", ALIGNMENT)
    yaw_deg: float = option(0.0, YAW)
    delay_ms: float = option(0.0, DELAY)
    position_mm: float = option(2.0, "standard deviation of positions, mm")
    rotation_deg: float = option(1.0, "standard deviation of rotations, degrees")


@dataclass(frozen=True)
class VrpnOptions:
    server: str = option(LOOPBACK, "address of the computer that runs the VRPN server")
    port: int = option(3883, "port of the server")
    up: str = option("z", "axis of the server that points up", UPWARDS)
    right: str = option("", "name of the right hand's tracker; any: every tracker")
    left: str = option("", "name of the left hand's tracker; any: every tracker")
    alignment: str = option("", ALIGNMENT)
    yaw_deg: float = option(0.0, YAW)
    delay_ms: float = option(0.0, DELAY)
    position_mm: float = option(2.0, "standard deviation of positions, mm")
    rotation_deg: float = option(1.0, "standard deviation of rotations, degrees")


class _Shared(Protocol):
    """What the options of all have."""

    @property
    def right(self) -> str: ...
    @property
    def left(self) -> str: ...
    @property
    def alignment(self) -> str: ...
    @property
    def yaw_deg(self) -> float: ...
    @property
    def delay_ms(self) -> float: ...
    @property
    def position_mm(self) -> float: ...
    @property
    def rotation_deg(self) -> float: ...


def _placement(options: _Shared) -> Placement:
    from extensions.room.placement import Placement, PoseOptions, with_file

    plain = PoseOptions(
        names={"right": options.right, "left": options.left},
        yaw=math.radians(options.yaw_deg),
        delay=options.delay_ms / 1e3,
        position_sd=max(options.position_mm, 0.01) / 1e3,
        rotation_sd=math.radians(max(options.rotation_deg, 0.01)),
    )
    return Placement(with_file(plain, options.alignment))


def _osc(options: OscPoseOptions, answer: Answer) -> Door:
    from extensions.room.doors import osc_door

    return osc_door(answer, _placement(options), options.host, options.port)


def _natnet(options: NatNetOptions, answer: Answer) -> Door:
    from extensions.room.doors import natnet_door

    where = (options.host, options.port, options.server, options.group, options.up)
    return natnet_door(answer, _placement(options), *where)


def _lsl(options: LslPoseOptions, answer: Answer) -> Door:
    from extensions.room.lsl_poses import LslPoses

    return LslPoses(answer, _placement(options), options.type, options.up, options.network)


def _vrpn(options: VrpnOptions, answer: Answer) -> Door:
    from extensions.room.vrpn_poses import VrpnPoses

    return VrpnPoses(answer, _placement(options), options.server, options.port, options.up)


OSC = DoorKind(
    name="room", title="Wrist pose (VMC, OSC)", options=OscPoseOptions, make=_osc, order=30
)
NATNET = DoorKind(
    name="natnet", title="Wrist pose (OptiTrack)", options=NatNetOptions, make=_natnet, order=31
)
LSL = DoorKind(
    name="lslpose",
    title="Wrist pose (LSL)",
    options=LslPoseOptions,
    make=_lsl,
    extra="glovetrack[streams]",
    order=32,
)
VRPN = DoorKind(name="vrpn", title="Wrist pose (VRPN)", options=VrpnOptions, make=_vrpn, order=33)
