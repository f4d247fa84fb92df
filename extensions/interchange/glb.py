"""Exports binary glTF 2.0: an animated tree of nodes with one small solid per bone, in m, y up.

A bone whose length was changed by the calibration has an animated translation. While an end of a
bone is lost for longer than `_MOMENT`, its solid has zero size and its nodes do not move.
"""

from __future__ import annotations

import json
import struct
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from extensions.interchange.skeleton import Skeleton, skeleton
from tracker.messages import Validity
from tracker.session.export.load import load_series
from tracker.session.export.options import BONE_AXES, ExportOptions
from tracker.session.export.resample import continuous
from tracker.session.export.series import EstimateSeries
from tracker.session.holes import LONGEST_FILLED, gaps
from tracker.session.reader import SessionReader

_FLOAT, _SHORT = 5126, 5123
_MOMENT = 0.01  # s between a key and the key that ends its value
# A bone of unit length along x: thick near its joint, with a width of a tenth of its length.
_CORNERS = np.array(
    [[0, 0, 0], [0.2, 0.1, 0], [0.2, 0, 0.1], [0.2, -0.1, 0], [0.2, 0, -0.1], [1, 0, 0]], "<f4"
)
_FACES = np.array(
    [[0, 2, 1], [0, 3, 2], [0, 4, 3], [0, 1, 4], [5, 1, 2], [5, 2, 3], [5, 3, 4], [5, 4, 1]], "<u2"
)


def export_glb(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    m = load_series(reader, replace(options, joints=()), axes="y-up", segments=True)
    tree = skeleton(m)
    path.write_bytes(_document(m, tree))
    return replace(m, notes={**m.notes, **tree.notes(m.elapsed)})


class _Buffer:
    """The binary chunk and its accessors."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(self, values: np.ndarray, kind: str, component: int = _FLOAT) -> int:
        """Append an array and return the index of its accessor."""
        raw = values.tobytes()
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(raw)})
        rows = values.reshape(len(values), -1)
        self.accessors.append(
            {
                "bufferView": len(self.views) - 1,
                "componentType": component,
                "count": len(rows),
                "type": kind,
                "min": rows.min(axis=0).tolist(),
                "max": rows.max(axis=0).tolist(),
            }
        )
        self.data += raw + bytes(-len(raw) % 4)
        return len(self.accessors) - 1


def _document(m: EstimateSeries, tree: Skeleton) -> bytes:
    buffer = _Buffer()
    mesh = {
        "attributes": {"POSITION": buffer.add(_CORNERS, "VEC3")},
        "indices": buffer.add(_FACES.reshape(-1), "SCALAR", _SHORT),
    }
    animation = _animation(m, tree, buffer)
    document = {
        "asset": {"version": "2.0", "generator": "Glovetrack", "extras": _extras(m, tree, buffer)},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": _nodes(tree),
        "meshes": [{"name": "bone", "primitives": [mesh]}],
        "animations": [animation],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": len(buffer.data)}],
    }
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    total = 12 + 8 + len(text) + 8 + len(buffer.data)
    head = struct.pack("<4sII", b"glTF", 2, total)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    return head + chunks + struct.pack("<I4s", len(buffer.data), b"BIN\0") + bytes(buffer.data)


def _extras(m: EstimateSeries, tree: Skeleton, buffer: _Buffer) -> dict[str, Any]:
    """Data for programs, ignored by viewers: axes; shares of the time in which each node's position
    was measured, inferred and lost; accessors of all instants ``t`` in s and, per node, ``state``
    (0 lost, 1 inferred, 2 measured) and ``sd`` in m (-1 if lost)."""
    shares, states, sds = {}, {}, {}
    for name in tree.names:
        k = m.keypoint_names.index(name)
        state = m.state[:, k]
        shares[name] = {s.name.lower(): round(float((state == s).mean()), 6) for s in Validity}
        sd = np.where((state == Validity.LOST) | ~np.isfinite(m.sd[:, k]), -1.0, m.sd[:, k])
        states[name] = buffer.add(state.astype("<f4"), "SCALAR")
        sds[name] = buffer.add(sd.astype("<f4"), "SCALAR")
    instants = {"t": buffer.add(m.elapsed.astype("<f4"), "SCALAR"), "state": states, "sd": sds}
    axes = {"axes": m.notes["axes_are"], "bone_axes": BONE_AXES}
    return {**axes, "states": shares, "accessors": instants}


def _nodes(tree: Skeleton) -> list[dict[str, Any]]:
    """The joints, followed by one node per bone with its solid, in the order of the bones' ends."""
    n = len(tree.names)
    nodes: list[dict[str, Any]] = [
        {
            "name": name,
            "translation": (tree.translation[0, 0] if i == 0 else tree.offset[i]).tolist(),
            "rotation": tree.rotation[0, i].tolist(),
        }
        for i, name in enumerate(tree.names)
    ]
    nodes += [_bone(tree.offset[i], tree.names[i]) for i in range(1, n)]
    for i in range(n):
        children = tree.children(i)
        if children:
            nodes[i]["children"] = [*children, *(n - 1 + child for child in children)]
    return nodes


def _bone(offset: np.ndarray, name: str) -> dict[str, Any]:
    length = float(np.linalg.norm(offset))
    turn, _ = Rotation.align_vectors([offset / length], [[1.0, 0, 0]])
    return {
        "name": f"bone_to_{name}",
        "mesh": 0,
        "scale": [length] * 3,
        "rotation": turn.as_quat().tolist(),
    }


class _Tracks:
    """Samplers and channels of an animation."""

    def __init__(self, buffer: _Buffer) -> None:
        self._buffer = buffer
        self.samplers: list[dict[str, Any]] = []
        self.channels: list[dict[str, Any]] = []

    def times(self, t: np.ndarray) -> int:
        return self._buffer.add(t.astype("<f4"), "SCALAR")

    def add(
        self, node: int, path: str, times: int, values: np.ndarray, interpolation: str = "LINEAR"
    ) -> None:
        """Animate ``path`` (translation, rotation or scale) with ``values`` at the keys
        ``times``."""
        kind = "VEC4" if path == "rotation" else "VEC3"
        output = self._buffer.add(values.astype("<f4"), kind)
        self.samplers.append({"input": times, "output": output, "interpolation": interpolation})
        target = {"node": node, "path": path}
        self.channels.append({"sampler": len(self.samplers) - 1, "target": target})


def _animation(m: EstimateSeries, tree: Skeleton, buffer: _Buffer) -> dict[str, Any]:
    tracks = _Tracks(buffer)
    t, rows = _keys(m.elapsed)
    times = tracks.times(t)
    for i in range(len(tree.names)):
        if i == 0 or tree.stretches[i]:
            tracks.add(i, "translation", times, tree.translation[rows, i])
        tracks.add(i, "rotation", times, continuous(tree.rotation[:, i])[rows])
    _hide(m.elapsed, tree, tracks)
    return {"name": "tracked", "samplers": tracks.samplers, "channels": tracks.channels}


def _keys(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Times (s) of the keys and their rows; gaps repeat the last estimate."""
    holes = np.flatnonzero(np.diff(t) > LONGEST_FILLED)
    rows = np.insert(np.arange(len(t)), holes + 1, holes)
    return np.insert(t, holes + 1, t[holes + 1] - _MOMENT), rows


def _hide(t: np.ndarray, tree: Skeleton, tracks: _Tracks) -> None:
    """Give solids zero size while an end of their bone is lost."""
    n = len(tree.names)
    for i in range(1, n):
        lost = gaps(t, tree.known[:, i] & tree.known[:, tree.parent[i]])
        if not lost:
            continue
        keys = {float(t[0]): 1.0}
        for start, stop in lost:
            keys[start if start == t[0] else start + _MOMENT] = 0.0
            if stop < t[-1]:
                keys[stop] = 1.0
        at = np.array(sorted(keys))
        length = float(np.linalg.norm(tree.offset[i]))
        sizes = np.repeat([[length * keys[k]] for k in at], 3, axis=1)
        tracks.add(n - 1 + i, "scale", tracks.times(at), sizes, "STEP")
