"""Layout of the shared memory between the program and the API layer.

`layer/memory.h` declares the same structures. A change of either needs another `VERSION`, which is
part of the memory's name, so a layer never reads a layout that it does not know. All fields are
little-endian and aligned to their size. Instants are nanoseconds of the clock ``clock``.

    0       HEADER
    512     READERS entries of READER, each written by one layer
    4096    RING samples of the left hand, then RING samples of the right hand

Sample number n (from 1) of a hand is in slot (n - 1) % RING. The program sets the slot's
``sequence`` to 0, writes the sample, sets ``sequence`` to n and then the hand's ``count`` to n. A
reader copies slot ``count`` and discards the copy unless ``sequence`` was n before and after.
"""

from __future__ import annotations

from enum import IntEnum

import numpy as np

from tracker.hand.openxr import JOINTS

MAGIC = b"GLVTRKXR"
VERSION = 1
SIDES = ("left", "right")
"""In the order of the rings, which is that of XrHandEXT."""
RING = 32
READERS = 8
READERS_AT = 512
RINGS_AT = 4096

JOINT = np.dtype(
    [
        ("position", "<f4", 3),  # m
        ("orientation", "<f4", 4),  # xyzw
        ("linear", "<f4", 3),  # m/s
        ("angular", "<f4", 3),  # rad/s
        ("radius", "<f4"),  # m
        ("sd", "<f4"),  # m, root of the mean variance of the position's axes; NaN: unknown
        ("linear_sd", "<f4"),  # m/s, likewise
        ("angular_sd", "<f4"),  # rad/s, likewise
        ("state", "<u4"),  # 0 lost, 1 inferred, 2 measured
    ]
)
"""In OpenXR's world of Glovetrack: y up, -z along G's x."""

SAMPLE = np.dtype(
    [
        ("sequence", "<u8"),
        ("t", "<i8"),  # instant of the hand
        ("written", "<i8"),
        ("active", "<u4"),  # 1: every joint has a pose
        ("tracking", "<u4"),  # 0 searching, 1 tracking, 2 coasting, 3 lost
        ("velocity", "<u4"),  # `Velocity`
        ("reserved", "V20"),
        ("joints", JOINT, len(JOINTS)),
    ]
)

HAND = np.dtype([("present", "<u4"), ("reserved", "<u4"), ("count", "<u8")])

HEADER = np.dtype(
    [
        ("magic", "S8"),
        ("version", "<u4"),
        ("size", "<u4"),  # of the whole memory, B
        ("clock", "<u4"),  # `Clock`
        ("process", "<u4"),  # id of the program's process
        ("running", "<u4"),  # 0 once the stream has been closed
        ("ring", "<u4"),
        ("ahead", "<i8"),  # ns beyond the newest sample that a pose is predicted at most
        ("stale", "<i8"),  # ns after which a hand without samples is not active
        ("space", "<u4"),  # `Space` in which ``position`` and ``orientation`` are
        ("position", "<f4", 3),  # m, of Glovetrack's origin
        ("orientation", "<f4", 4),  # xyzw, of Glovetrack's axes
        ("program", "S48"),
        ("hands", HAND, 2),
    ]
)

READER = np.dtype(
    [
        ("process", "<u4"),  # id of the application's process; 0: the entry is free
        ("layer", "<u4"),  # version of the layer
        ("last", "<i8"),  # instant of the latest reading
        ("readings", "<u8"),  # calls that this memory answered
        ("active", "<u8"),  # those of them that returned a hand
        ("name", "S64"),  # of the application, UTF-8
        ("reserved", "V32"),
    ]
)

SIZE = RINGS_AT + len(SIDES) * RING * SAMPLE.itemsize


class Clock(IntEnum):
    """Which clock stamps are from."""

    MONOTONIC = 1  # CLOCK_MONOTONIC
    PERFORMANCE_COUNTER = 2  # of Windows, in ns


class Space(IntEnum):
    """OpenXR's reference spaces, by the numbers of XrReferenceSpaceType."""

    LOCAL = 2
    STAGE = 3


class Velocity(IntEnum):
    """Where the velocities of a sample are from."""

    UNKNOWN = 0
    DIFFERENCE = 1  # of the poses over `publisher.SPAN`
    FILTER = 2  # of the engine's state
