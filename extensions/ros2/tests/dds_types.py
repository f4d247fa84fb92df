"""Types of ROS 2 on DDS, from the message definitions that rosbags ships."""

from __future__ import annotations

from typing import Any

from cyclonedds.idl import make_idl_struct
from cyclonedds.idl.annotations import final
from cyclonedds.idl.types import array, byte, float64, int8, int32, sequence, uint8, uint32
from rosbags.interfaces import Nodetype
from rosbags.typesys import Stores, get_typestore

STORE = get_typestore(Stores.ROS2_JAZZY)
BASE: dict[str, Any] = {
    "float64": float64, "int32": int32, "uint32": uint32, "int8": int8, "uint8": uint8,
    "octet": byte, "byte": byte, "string": str,
}  # fmt: skip
_MADE: dict[str, Any] = {}


def dds_type(name: str) -> Any:
    """``sensor_msgs/msg/JointState`` as ``sensor_msgs::msg::dds_::JointState_``."""
    if name not in _MADE:
        fields = {field: _field(kind) for field, kind in STORE.fielddefs[name][1]}
        package, _, short = name.split("/")
        full = f"{package}::msg::dds_::{short}_"
        _MADE[name] = final(make_idl_struct(f"{short}_", full, fields))
    return _MADE[name]


def _field(kind: Any) -> Any:
    node, detail = kind
    if node == Nodetype.BASE:
        return BASE[detail[0]]
    if node == Nodetype.NAME:
        return dds_type(detail)
    inner, length = detail
    return array[_field(inner), length] if node == Nodetype.ARRAY else sequence[_field(inner)]


def dds_message(name: str, fields: dict[str, Any]) -> Any:
    """A message of these fields."""
    values = {f: _value(kind, fields[f]) for f, kind in STORE.fielddefs[name][1]}
    return dds_type(name)(**values)


def _value(kind: Any, value: Any) -> Any:
    node, detail = kind
    if node == Nodetype.BASE:
        return value[0] if isinstance(value, bytes) else value
    if node == Nodetype.NAME:
        return dds_message(detail, value)
    return [_value(detail[0], v) for v in value]
