"""A substitute for SteamVR, with python-osc's server and SciPy's rotations: what VMT's driver makes
of messages (its source: z and the rotation's z and w change sign), and a skeleton's world poses."""

from __future__ import annotations

import socket
from typing import Any

import numpy as np
from pythonosc.osc_packet import OscPacket
from scipy.spatial.transform import Rotation

Message = list[Any]
ORDER = [(1, 0), *((first + i, first + i - 1 if i else 1) for first, count in
         ((2, 4), (6, 5), (11, 5), (16, 5), (21, 5)) for i in range(count)),
         *((aux, 0) for aux in range(26, 31))]  # fmt: skip
"""(bone, parent), parents first."""


def messages(datagram: bytes) -> list[Message]:
    """[address, arguments...] of a datagram."""
    return [[m.message.address, *m.message.params] for m in OscPacket(datagram).messages]


def received(client: socket.socket) -> list[Message]:
    return messages(client.recv(65536))


def pose(numbers: list[float]) -> tuple[np.ndarray, Rotation]:
    """Position and rotation in OpenVR's axes of x y z qx qy qz qw in Unity's."""
    x, y, z, qx, qy, qz, qw = numbers
    return np.array([x, y, -z]), Rotation.from_quat([qx, qy, -qz, -qw])


def skeleton(found: list[Message], device: int) -> dict[int, tuple[np.ndarray, Rotation]]:
    """World pose of the device (0) and of each bone that was sent, composed from its parents."""
    (room,) = (m for m in found if m[0] == "/VMT/Room/Unity" and m[1] == device)
    local = {m[2]: pose(m[3:]) for m in found if m[0] == "/VMT/Skeleton/Unity" and m[1] == device}
    p, R = pose(room[4:])
    p_root, R_root = local[0]
    world = {0: (p + R.apply(p_root), R * R_root)}
    for bone, parent in ORDER:
        if bone in local and parent in world:
            p, R = world[parent]
            world[bone] = (p + R.apply(local[bone][0]), R * local[bone][1])
    return world
