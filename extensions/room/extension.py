"""Descriptors of the room: poses of trackers of other systems, as remote control."""

from __future__ import annotations

from dataclasses import dataclass

from tracker.base.registry import deferred
from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.remote.registry import DoorKind

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


OSC = DoorKind(
    name="room",
    title="Wrist pose (VMC, OSC)",
    options=OscPoseOptions,
    make=deferred("extensions.room.doors:open_osc"),
    order=30,
)
NATNET = DoorKind(
    name="natnet",
    title="Wrist pose (OptiTrack)",
    options=NatNetOptions,
    make=deferred("extensions.room.doors:open_natnet"),
    order=31,
)
LSL = DoorKind(
    name="lslpose",
    title="Wrist pose (LSL)",
    options=LslPoseOptions,
    make=deferred("extensions.room.lsl_poses:open_lsl"),
    extra="glovetrack[streams]",
    order=32,
)
VRPN = DoorKind(
    name="vrpn",
    title="Wrist pose (VRPN)",
    options=VrpnOptions,
    make=deferred("extensions.room.vrpn_poses:open_vrpn"),
    order=33,
)
