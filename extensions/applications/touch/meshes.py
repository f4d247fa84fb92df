"""Triangle meshes from files: Wavefront OBJ and STL."""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np

from resources import folder
from tracker.base.errors import FileError
from tracker.base.files import read_bounded
from tracker.base.notices import notice
from tracker.geometry.triangles import Triangles, triangles_of
from tracker.messages import Array, IntArray

MOST_BYTES = 50_000_000
STL_HEAD = 84  # bytes before the triangles of a binary STL
STL_ROW = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])


class MeshFile(NamedTuple):
    """points (V, 3) relative to the centre of their box, whose longest side is 1; faces (F, 3)."""

    points: Array
    faces: IntArray


class TouchableSolid(NamedTuple):
    """A mesh with its data for contact computations."""

    file: MeshFile
    triangles: Triangles


def solid(name: str) -> TouchableSolid:
    """Like `load_mesh`, which takes up to half a second, but cached while the file is unchanged.
    Raises FileError."""
    path = Path(name)
    return _solid(name, path.stat().st_mtime_ns if path.is_file() else 0)


@lru_cache(maxsize=4)
def _solid(name: str, _written_ns: int) -> TouchableSolid:
    file = load_mesh(name)
    return TouchableSolid(file, triangles_of(*file))


def load_mesh(name: str) -> MeshFile:
    """Load a mesh by the name of a bundled one or by path.

    Raises FileError if it does not exist or is not a mesh.
    """
    path = Path(name)
    if not path.suffix and len(path.parts) == 1:
        shipped = folder("meshes") / f"{name}.obj"
        if not shipped.is_file():
            raise FileError(notice("mesh.unknown", name=name))
        return _centred(*_obj(shipped.read_text("utf-8").splitlines(), name))
    try:
        data = read_bounded(path, MOST_BYTES, "a mesh that can be read")
    except OSError as error:
        raise FileError(notice("file.not_readable", path=path, why=error.strerror)) from error
    if path.suffix.lower() == ".stl":
        return _centred(*_stl(data, str(path)))
    if path.suffix.lower() == ".obj":
        return _centred(*_obj(data.decode("utf-8", "replace").splitlines(), str(path)))
    raise FileError(notice("mesh.unknown_kind", path=path))


def _obj(lines: list[str], name: str) -> tuple[Array, IntArray]:
    """Points and faces of an OBJ file; polygons become triangle fans."""
    points: list[list[float]] = []
    faces: list[tuple[int, int, int]] = []
    try:
        for words in (line.split() for line in lines):
            if words[:1] == ["v"]:
                points.append([float(w) for w in words[1:4]])
            elif words[:1] == ["f"]:
                rows = [int(w.split("/")[0]) for w in words[1:]]
                rows = [r - 1 if r > 0 else len(points) + r for r in rows]
                faces += [(rows[0], b, c) for b, c in pairwise(rows[1:])]
    except ValueError as error:
        raise FileError(notice("mesh.not_obj", name=name, why=error)) from error
    return _checked(np.array(points, float), np.array(faces, np.int64), name)


def _stl(data: bytes, name: str) -> tuple[Array, IntArray]:
    """Points and faces of an STL file; equal points are merged."""
    count = int.from_bytes(data[STL_HEAD - 4 : STL_HEAD], "little")
    if len(data) == STL_HEAD + count * STL_ROW.itemsize:
        corners = np.frombuffer(data, STL_ROW, count, STL_HEAD)["corners"].astype(float)
    else:
        words = [line.split()[1:4] for line in data.decode("ascii", "replace").splitlines()
                 if line.split()[:1] == ["vertex"]]  # fmt: skip
        try:
            corners = np.array(words, float).reshape(-1, 3, 3)
        except ValueError as error:
            raise FileError(notice("mesh.not_stl", name=name, why=error)) from error
    points, rows = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    return _checked(points, np.asarray(rows).reshape(-1, 3).astype(np.int64), name)


def _checked(points: Array, faces: IntArray, name: str) -> tuple[Array, IntArray]:
    if len(points) < 4 or len(faces) < 4 or points.shape[1:] != (3,):
        raise FileError(notice("mesh.too_few", name=name))
    if not np.isfinite(points).all() or faces.min() < 0 or faces.max() >= len(points):
        raise FileError(notice("mesh.bad_points", name=name))
    return points, faces


def _centred(points: Array, faces: IntArray) -> MeshFile:
    low, high = points.min(axis=0), points.max(axis=0)
    size = float((high - low).max()) or 1.0
    a, b, c = (points[faces[:, k]] for k in range(3))
    if np.einsum("fk,fk->", a - low, np.cross(b - low, c - low)) < 0:
        faces = faces[:, ::-1]  # inside out
    return MeshFile((points - (low + high) / 2) / size, np.ascontiguousarray(faces))
