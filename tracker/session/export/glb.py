"""Binary glTF 2.0: the hand as an animated tree of nodes, one small solid per bone; m, y up."""

from __future__ import annotations

import json
import struct
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.session.export.load import load_series
from tracker.session.export.options import ExportOptions
from tracker.session.export.resample import continuous
from tracker.session.export.series import EstimateSeries
from tracker.session.export.skeleton import Skeleton, skeleton
from tracker.session.reader import SessionReader

_FLOAT, _SHORT = 5126, 5123
# A bone of unit length along x: thick near its joint, as wide as a tenth of its length.
_CORNERS = np.array(
    [[0, 0, 0], [0.2, 0.1, 0], [0.2, 0, 0.1], [0.2, -0.1, 0], [0.2, 0, -0.1], [1, 0, 0]], "<f4"
)
_FACES = np.array(
    [[0, 2, 1], [0, 3, 2], [0, 4, 3], [0, 1, 4], [5, 1, 2], [5, 2, 3], [5, 3, 4], [5, 4, 1]], "<u2"
)


def export_glb(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    m = load_series(reader, replace(options, joints=()), axes="y-up")
    tree = skeleton(m)
    path.write_bytes(_document(m, tree))
    return replace(m, notes={**m.notes, "held": tree.held})


class _Buffer:
    """The binary part and the accessors that point into it."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(self, values: np.ndarray, kind: str, component: int = _FLOAT) -> int:
        """Append an array; returns the index of its accessor."""
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
        "asset": {"version": "2.0", "generator": "Glovetrack"},
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


def _nodes(tree: Skeleton) -> list[dict[str, Any]]:
    """The joints, then one node per bone that carries its solid."""
    n = len(tree.names)
    nodes: list[dict[str, Any]] = [
        {
            "name": name,
            "translation": (tree.root[0] if i == 0 else tree.offset[i]).tolist(),
            "rotation": tree.rotation[0, i].tolist(),
        }
        for i, name in enumerate(tree.names)
    ]
    for i in range(n):
        children = tree.children(i)
        bones = []
        for child in children:
            bones.append(len(nodes))
            nodes.append(_bone(tree.offset[child], tree.names[child]))
        if children:
            nodes[i]["children"] = [*children, *bones]
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


def _animation(m: EstimateSeries, tree: Skeleton, buffer: _Buffer) -> dict[str, Any]:
    t = buffer.add(m.elapsed.astype("<f4"), "SCALAR")
    outputs = [(0, "translation", buffer.add(tree.root.astype("<f4"), "VEC3"))]
    for i in range(len(tree.names)):
        q = continuous(tree.rotation[:, i]).astype("<f4")
        outputs.append((i, "rotation", buffer.add(q, "VEC4")))
    return {
        "name": "tracked",
        "samplers": [{"input": t, "output": o} for _, _, o in outputs],
        "channels": [
            {"sampler": k, "target": {"node": node, "path": what}}
            for k, (node, what, _) in enumerate(outputs)
        ],
    }
