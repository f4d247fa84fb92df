"""Sends drawings between processes: large arrays, such as a mesh's points, once."""

from __future__ import annotations

import io
import pickle
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

LARGE = 2000  # bytes; smaller arrays are sent each time
MOST = 64  # arrays that are remembered; then all are sent again


class Packed(NamedTuple):
    """A pickled object without its large arrays; ``new`` are those that were not sent before, by
    number. ``forget``: those sent before are no longer referred to."""

    data: bytes
    new: Mapping[int, np.ndarray]
    forget: bool


class ArraySender:
    """Packs objects in the order in which they are sent. Their large arrays must not be modified
    in place."""

    def __init__(self) -> None:
        self._sent: dict[int, tuple[int, np.ndarray]] = {}  # by id; kept, so that ids are unique
        self._number = 0

    def pack(self, what: object) -> Packed:
        forget = len(self._sent) > MOST
        if forget:
            self._sent.clear()
        out, new = io.BytesIO(), dict[int, np.ndarray]()
        _Pickler(out, self._numbered, new).dump(what)
        return Packed(out.getvalue(), new, forget)

    def _numbered(self, array: np.ndarray, new: dict[int, np.ndarray]) -> int:
        found = self._sent.get(id(array))
        if found is None:
            self._number += 1
            found = self._sent[id(array)] = self._number, array
            new[self._number] = array
        return found[0]


class ArrayReceiver:
    """Unpacks what a `ArraySender` has packed: everything, in order."""

    def __init__(self) -> None:
        self._known: dict[int, np.ndarray] = {}

    def unpack(self, packed: Packed) -> Any:
        if packed.forget:
            self._known.clear()
        self._known.update(packed.new)
        return _Unpickler(io.BytesIO(packed.data), self._known).load()


class _Pickler(pickle.Pickler):
    def __init__(self, out: io.BytesIO, numbered: Any, new: dict[int, np.ndarray]) -> None:
        super().__init__(out, pickle.HIGHEST_PROTOCOL)
        self._numbered, self._new = numbered, new

    def persistent_id(self, what: object) -> int | None:
        if type(what) is np.ndarray and what.nbytes >= LARGE:
            return int(self._numbered(what, self._new))
        return None


class _Unpickler(pickle.Unpickler):
    def __init__(self, data: io.BytesIO, known: Mapping[int, np.ndarray]) -> None:
        super().__init__(data)
        self._known = known

    def persistent_load(self, number: int) -> np.ndarray:
        return self._known[number]
