"""Classes that are written into recordings under fixed names.

A `record`'s name and the names of its fields are a contract with every recording made so far.
The class may move and be renamed freely; of its attributes, so that old recordings stay readable:

renamed     give the name in recordings: ``@record("name", attribute="written")``
new         give it a default, for recordings without it
removed     list it in ``gone``: its values in recordings are ignored

Arrays declare their ``shapes`` (`tracker.base.array_shapes`), alone and within lists and tuples. A
recorded state is checked against these declarations, not against the state of a new engine: an
array may be empty before the first hand and grow later. A name in lower case denotes one size
within one instance; one in capitals for a size of the hand or the glove, the same throughout the
nearest record around it that is ``sized`` (one engine's state).
"""

from __future__ import annotations

import dataclasses
import enum
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TypeVar

from tracker.base.array_shapes import ArrayShape

T = TypeVar("T")


@dataclass(frozen=True)
class Record:
    """A class and its ``names``: attribute to the name in recordings; ``shapes`` by the latter."""

    name: str
    kind: type
    names: Mapping[str, str]
    gone: tuple[str, ...]
    shapes: Mapping[str, ArrayShape]
    sized: bool

    def values(self, whole: Any) -> dict[str, Any]:
        """Returns the values of an instance, by the names in recordings."""
        return {written: getattr(whole, name) for name, written in self.names.items()}

    def make(self, values: Mapping[str, Any]) -> Any:
        """An instance, without its constructor: it was checked when it was recorded.

        Raises ValueError where ``values`` are not what the class is made of.
        """
        unknown = values.keys() - set(self.names.values()) - set(self.gone)
        if unknown:
            raise ValueError(f"{self.name} has no {', '.join(sorted(unknown))}")
        found = {
            name: values[written] if written in values else self._default(name)
            for name, written in self.names.items()
        }
        if issubclass(self.kind, tuple):
            return tuple.__new__(self.kind, found.values())
        out = object.__new__(self.kind)
        for name, value in found.items():
            object.__setattr__(out, name, value)
        return out

    def _default(self, name: str) -> Any:
        if issubclass(self.kind, tuple):
            defaults = self.kind._field_defaults  # type: ignore[attr-defined]
            if name in defaults:
                return defaults[name]
        else:
            field = self.kind.__dataclass_fields__[name]  # type: ignore[attr-defined]
            if field.default is not dataclasses.MISSING:
                return field.default
            if field.default_factory is not dataclasses.MISSING:
                return field.default_factory()
        raise ValueError(f"{self.name} lacks {self.names[name]}")


RECORDS: dict[str, Record] = {}
"""By the names in recordings; only those of loaded modules."""
_OF_CLASS: dict[type, Record] = {}


def record(
    name: str,
    gone: tuple[str, ...] = (),
    shapes: Mapping[str, str] | None = None,
    sized: bool = False,
    **written: str,
) -> Callable[[type[T]], type[T]]:
    """Decorator of a dataclass, a NamedTuple or an enum (by its values).

    ``shapes`` are by attribute; ``written`` maps attributes to their names in recordings, where
    these differ. Raises TypeError for a name in use, an unknown attribute or an invalid shape.
    """
    declared = {a: ArrayShape.of(text) for a, text in (shapes or {}).items()}

    def register(kind: type[T]) -> type[T]:
        attributes = _attributes(kind)
        names = {a: written.get(a, a) for a in attributes}
        if name in RECORDS or not names.keys() >= written.keys() | declared.keys():
            raise TypeError(f"{kind.__name__} cannot be recorded as {name!r}")
        by_name = {names[a]: shape for a, shape in declared.items()}
        RECORDS[name] = _OF_CLASS[kind] = Record(name, kind, names, gone, by_name, sized)
        return kind

    return register


def record_of(kind: type) -> Record | None:
    """Returns how a class is recorded; None if it is not."""
    return _OF_CLASS.get(kind)


def _attributes(kind: Any) -> tuple[str, ...]:
    if issubclass(kind, enum.Enum):
        return ()
    if issubclass(kind, tuple):
        return tuple(kind._fields)
    return tuple(field.name for field in dataclasses.fields(kind))
