"""The state of an engine at one instant, as the compact attachment ``engine_state``.

A recording that begins during tracking can be tracked again bit for bit only from that state.
Layout, little-endian: ``GTES``, u16 version, u32 CRC-32 of all that follows, u64 unpacked size,
then zstd of: u32 length of a JSON text, that text, and the bytes of all arrays one after the other.

The text is ``{"engine": name, "arrays": [[type, shape], …], "state": …}``, where a state is made of
plain values, lists and

    {"record": name, "has": {…}}     of `tracker.base.records`, not the name of a class
    {"enum": name, "value": …}
    {"array": k}                     the k-th array, the same object for each k
    {"number": …, "type": …}         a NumPy scalar
    {"tuple": […]}

Reading creates only registered objects and runs none of their code; arrays do not need more memory
than the file contains, and the text is short.
"""

from __future__ import annotations

import enum
import json
import struct
import zlib
from collections.abc import Sequence
from typing import Any

import numpy as np
import zstandard

from tracker.base.errors import DataError, FileError
from tracker.base.notices import notice
from tracker.base.records import RECORDS, Record, record_of
from tracker.session.mcap.chunks import decompress

NAME = "engine_state"
MEDIA_TYPE = "application/octet-stream"
VERSION = 2
MOST_BYTES = 64 * 2**20
MOST_TEXT = 4 * 2**20  # bytes of JSON: about 100 times as much in memory
_MAGIC = b"GTES"
_HEAD = struct.Struct("<4sHIQ")
_TYPES = ("float64", "int64", "bool", "uint8", "int32", "float32", "complex128")
_PLAIN = (bool, int, float, str, type(None))


def pack(engine: str, state: Any) -> bytes:
    """Packs a ``state`` that `Pipeline.get_state` returned, of the named engine.

    Raises TypeError for objects that are not registered.
    """
    arrays = _Arrays()
    flat = _to_json(state, arrays)
    content = {"engine": engine, "arrays": arrays.described, "state": flat}
    text = json.dumps(content, separators=(",", ":")).encode()
    raw = struct.pack("<I", len(text)) + text + b"".join(arrays.parts)
    packed = struct.pack("<Q", len(raw)) + zstandard.ZstdCompressor().compress(raw)
    return _MAGIC + struct.pack("<HI", VERSION, zlib.crc32(packed)) + packed


def unpack(data: bytes) -> tuple[str, Any]:
    """Returns (engine, state). Raises FileError if the bytes are damaged or of another version."""
    try:
        magic, version, crc, size = _HEAD.unpack_from(data)
        if magic != _MAGIC or zlib.crc32(data[10:]) != crc:
            raise FileError(notice("session.state_damaged"))
        if version != VERSION or size > MOST_BYTES:
            raise FileError(notice("session.state_version"))
        raw = decompress("zstd", data[_HEAD.size :], size)
        (length,) = struct.unpack_from("<I", raw)
        if length > MOST_TEXT:
            raise DataError(notice("data.long_text"))
        content = json.loads(raw[4 : 4 + length])
        arrays = _read_arrays(content["arrays"], raw[4 + length :])
        return str(content["engine"]), _from_json(content["state"], arrays)
    except (
        *(ValueError, KeyError, TypeError, IndexError, AttributeError, RecursionError),
        *(struct.error, zstandard.ZstdError, MemoryError, OverflowError),
    ) as error:
        raise FileError(notice("session.state_invalid", why=error)) from error


# ---- writing


class _Arrays:
    """Arrays in order of occurrence, each object once: shared arrays stay shared."""

    def __init__(self) -> None:
        self._number: dict[int, int] = {}
        self.described: list[tuple[str, tuple[int, ...]]] = []
        self.parts: list[bytes] = []

    def number(self, value: np.ndarray) -> int:
        """Returns the number of an array."""
        if value.dtype.name not in _TYPES:
            raise TypeError(f"arrays of {value.dtype} cannot be recorded")
        if id(value) not in self._number:
            self._number[id(value)] = len(self.parts)
            self.described.append((value.dtype.name, value.shape))
            self.parts.append(np.ascontiguousarray(value).tobytes())
        return self._number[id(value)]


def _to_json(value: Any, arrays: _Arrays) -> Any:
    """Converts ``value`` to JSON."""
    known = record_of(type(value))
    if known is not None:
        return _record_to_json(value, known, arrays)
    if isinstance(value, np.ndarray):
        return {"array": arrays.number(value)}
    if isinstance(value, np.generic):
        if value.dtype.name not in _TYPES[:-1]:
            raise TypeError(f"scalars of {value.dtype} cannot be recorded")
        return {"number": value.item(), "type": value.dtype.name}
    if type(value) in _PLAIN:
        return value
    if type(value) is list:
        return [_to_json(v, arrays) for v in value]
    if type(value) is tuple:
        return {"tuple": [_to_json(v, arrays) for v in value]}
    raise TypeError(f"objects of {type(value).__name__} cannot be recorded")


def _record_to_json(value: Any, known: Record, arrays: _Arrays) -> dict[str, Any]:
    if isinstance(value, enum.Enum):
        return {"enum": known.name, "value": value.value}
    has = {name: _to_json(inside, arrays) for name, inside in known.values(value).items()}
    return {"record": known.name, "has": has}


# ---- reading


def _read_arrays(described: Sequence[Any], blob: bytes) -> list[np.ndarray]:
    """Reads the arrays, stored one after the other in ``blob``; needs no more memory than
    ``blob``."""
    out, at = [], 0
    for name, shape in described:
        if name not in _TYPES or any(type(n) is not int or n < 0 for n in shape):
            raise DataError(notice("data.array_type"))
        dtype, count = np.dtype(name), int(np.prod(shape, dtype=object))
        if at + count * dtype.itemsize > len(blob):
            raise DataError(notice("data.array_size"))
        out.append(np.frombuffer(blob, dtype, count, at).reshape(shape).copy())
        at += count * dtype.itemsize
    return out


def _from_json(value: Any, arrays: list[np.ndarray]) -> Any:
    """The inverse of `_to_json`."""
    if isinstance(value, list):
        return [_from_json(v, arrays) for v in value]
    if not isinstance(value, dict):
        return value
    if "record" in value:
        has = {name: _from_json(v, arrays) for name, v in value["has"].items()}
        return _record_named(value["record"]).make(has)
    if "enum" in value:
        kind: Any = _record_named(value["enum"], enum.Enum).kind
        return kind(value["value"])
    if "array" in value:
        return arrays[_index(value["array"])]
    if "number" in value:
        if value["type"] not in _TYPES[:-1]:
            raise DataError(notice("data.number_type"))
        return np.dtype(value["type"]).type(value["number"])
    return tuple(_from_json(v, arrays) for v in value["tuple"])


def _record_named(name: str, base: type = object) -> Record:
    """The record with a name; an enum only if one is requested."""
    known = RECORDS.get(name)
    if known is None or not issubclass(known.kind, base):
        raise DataError(notice("data.not_record", name=str(name)[:60]))
    if base is object and issubclass(known.kind, enum.Enum):
        raise DataError(notice("data.not_record", name=name))
    return known


def _index(number: Any) -> int:
    if type(number) is not int or number < 0:
        raise DataError(notice("data.no_array"))
    return number
