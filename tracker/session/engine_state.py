"""What an engine knows at one instant, as the compact attachment ``engine_state``.

A recording that begins in the middle of tracking can be tracked again bit for bit only from there.
Layout, little-endian: ``GTES``, u16 version, u32 CRC-32 of all that follows, u64 unpacked size,
then zstd of: u32 length of a JSON text, that text, and the bytes of all arrays one after the other.
Reading makes objects of the engine's own classes and runs none of their code.
"""

from __future__ import annotations

import enum
import json
import struct
import sys
import zlib
from collections import deque
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np
import zstandard

from tracker.errors import FileError
from tracker.session.mcap.chunks import decompress

NAME = "engine_state"
MEDIA_TYPE = "application/octet-stream"
VERSION = 1
MOST_BYTES = 64 * 2**20
_MAGIC = b"GTES"
_HEAD = struct.Struct("<4sHIQ")
_ROOMS = ("tracker.fusion.", "tracker.online.", "tracker.inertial.", "tracker.messages")
_ARRAYS = ("float64", "int64", "bool", "uint8", "int32", "float32")
_PLAIN = (bool, int, float, str, type(None))
_GROUPS: dict[str, Callable[[list[Any]], Any]] = {"tuple": tuple, "deque": deque, "set": set}


def pack(engine: str, state: Any) -> bytes:
    """Bytes of ``state``, as `Pipeline.get_state` gives it, of the named engine."""
    arrays: list[bytes] = []
    known: dict[bytes, int] = {}
    text = json.dumps({"engine": engine, "state": _flat(state, arrays, known)}).encode()
    raw = struct.pack("<I", len(text)) + text + b"".join(arrays)
    packed = struct.pack("<Q", len(raw)) + zstandard.ZstdCompressor().compress(raw)
    return _MAGIC + struct.pack("<HI", VERSION, zlib.crc32(packed)) + packed


def unpack(data: bytes) -> tuple[str, Any]:
    """(engine, state). Raises FileError where the bytes are damaged or of another version."""
    try:
        magic, version, crc, size = _HEAD.unpack_from(data)
        if magic != _MAGIC or zlib.crc32(data[10:]) != crc:
            raise FileError("The state of tracking in the recording is damaged.")
        if version != VERSION or size > MOST_BYTES:
            raise FileError("The state of tracking in the recording is of another version.")
        raw = decompress("zstd", data[_HEAD.size :], size)
        (length,) = struct.unpack_from("<I", raw)
        said = json.loads(raw[4 : 4 + length])
        return str(said["engine"]), _whole(said["state"], raw[4 + length :])
    except (
        *(ValueError, KeyError, TypeError, IndexError, AttributeError, RecursionError),
        *(struct.error, zstandard.ZstdError, MemoryError),
    ) as error:
        raise FileError(f"The state of tracking in the recording is damaged: {error}.") from error


def fits(state: Any, fresh: Any) -> bool:
    """Whether ``state`` has the parts and array shapes of ``fresh``, the same engine's at rest.

    What may come and go (lists, and what is None at rest) is not looked into.
    """
    if fresh is None or isinstance(fresh, list | deque):
        return fresh is None or type(state) is type(fresh)
    if isinstance(fresh, np.ndarray):
        return isinstance(state, np.ndarray) and (state.shape, state.dtype) == (
            fresh.shape,
            fresh.dtype,
        )
    if isinstance(fresh, int | float | complex | np.generic):
        return isinstance(state, int | float | complex | np.generic)
    if type(state) is not type(fresh):
        return False
    if isinstance(fresh, dict):
        return state.keys() == fresh.keys() and all(fits(state[k], fresh[k]) for k in fresh)
    if isinstance(fresh, tuple):
        return len(state) == len(fresh) and all(map(fits, state, fresh))
    if isinstance(fresh, str):
        return True
    return fits(_attributes(state), _attributes(fresh))


def _flat(value: Any, arrays: list[bytes], known: dict[bytes, int]) -> Any:
    """JSON for ``value``; arrays go to ``arrays``, equal ones once."""
    if isinstance(value, enum.Enum):
        return {"enum": _class_name(type(value)), "value": value.value}
    if isinstance(value, np.generic | np.ndarray):
        return _flat_array(np.asarray(value), isinstance(value, np.generic), arrays, known)
    if isinstance(value, _PLAIN):
        return value
    if isinstance(value, complex):
        return {"complex": [value.real, value.imag]}
    if isinstance(value, list):
        return [_flat(v, arrays, known) for v in value]
    if isinstance(value, dict):
        pairs = [[_flat(k, arrays, known), _flat(v, arrays, known)] for k, v in value.items()]
        return {"dict": pairs}
    kind = type(value).__name__
    if kind in _GROUPS and type(value).__module__ in ("builtins", "collections"):
        return {kind: [_flat(v, arrays, known) for v in value]}
    name = _class_name(type(value))
    if isinstance(value, tuple):  # a NamedTuple
        return {"row": name, "has": [_flat(v, arrays, known) for v in value]}
    inside = {k: _flat(v, arrays, known) for k, v in _attributes(value).items()}
    return {"class": name, "has": inside}


def _attributes(value: Any) -> dict[str, Any]:
    if is_dataclass(value):
        return {f.name: getattr(value, f.name) for f in fields(value)}
    return dict(vars(value))


def _flat_array(
    value: np.ndarray, scalar: bool, arrays: list[bytes], known: dict[bytes, int]
) -> dict[str, Any]:
    if value.dtype.name not in _ARRAYS:
        raise TypeError(f"no way to keep an array of {value.dtype}")
    raw = np.ascontiguousarray(value).tobytes()
    if raw not in known:
        known[raw] = sum(map(len, arrays))
        arrays.append(raw)
    return {"array": known[raw], "type": value.dtype.name, "shape": value.shape, "scalar": scalar}


def _class_name(kind: type) -> str:
    if not kind.__module__.startswith(_ROOMS):
        raise TypeError(f"no way to keep a {kind.__name__}")
    return f"{kind.__module__}:{kind.__qualname__}"


def _class(name: str) -> Any:
    """A class of the engine by name; only of modules that are loaded already."""
    module, _, qualname = name.partition(":")
    if not module.startswith(_ROOMS):
        raise ValueError(f"{name[:60]!r} is no part of an engine")
    kind = getattr(sys.modules[module], qualname)
    if not isinstance(kind, type) or kind.__module__ != module:
        raise ValueError(f"{name[:60]!r} is no part of an engine")
    return kind


def _whole(value: Any, blob: bytes) -> Any:
    """The inverse of `_flat`."""
    if isinstance(value, list):
        return [_whole(v, blob) for v in value]
    if not isinstance(value, dict):
        return value
    if "array" in value:
        return _whole_array(value, blob)
    if "dict" in value:
        return {_whole(k, blob): _whole(v, blob) for k, v in value["dict"]}
    if "enum" in value:
        return _class(value["enum"])(value["value"])
    if "complex" in value:
        return complex(*value["complex"])
    if "row" in value:
        return _whole_row(_class(value["row"]), [_whole(v, blob) for v in value["has"]])
    if "class" in value:
        return _whole_object(_class(value["class"]), value["has"], blob)
    ((kind, items),) = value.items()
    return _GROUPS[kind]([_whole(v, blob) for v in items])


def _whole_array(value: dict[str, Any], blob: bytes) -> Any:
    if value["type"] not in _ARRAYS:
        raise ValueError("an array of unknown type")
    shape = tuple(int(n) for n in value["shape"])
    dtype = np.dtype(value["type"])
    at, count = int(value["array"]), int(np.prod(shape, dtype=object))
    if at < 0 or any(n < 0 for n in shape) or at + count * dtype.itemsize > len(blob):
        raise ValueError("an array does not fit")
    array = np.frombuffer(blob, dtype, count, at).reshape(shape).copy()
    return array[()] if value["scalar"] else array


def _whole_row(kind: Any, has: list[Any]) -> Any:
    if not issubclass(kind, tuple) or len(has) != len(kind._fields):
        raise ValueError("an engine's class has other fields now")
    return tuple.__new__(kind, has)


def _whole_object(kind: Any, has: dict[str, Any], blob: bytes) -> Any:
    """An instance without its constructor: it was checked when the state was made."""
    if is_dataclass(kind) and {f.name for f in fields(kind)} != has.keys():
        raise ValueError("an engine's class has other fields now")
    out = object.__new__(kind)
    for name, inside in has.items():
        object.__setattr__(out, name, _whole(inside, blob))
    return out
