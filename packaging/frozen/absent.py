"""Stands in for a large module that a library imports at its start and that nothing here uses.

The list is in `glovetrack.spec` (``ABSENT``); each name there is this file. All names can be
imported from it, be a class's base and be asked for in isinstance; whoever calls one is told that
it is not there.
"""

from __future__ import annotations


class Absent:
    """Something of an absent module; what is within it is absent too."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, name: str) -> Absent:
        return _absent(self._name, name)

    def __call__(self, *args: object, **words: object) -> None:
        raise ImportError(f"{self._name} is not part of this bundle")

    def __mro_entries__(self, bases: tuple[object, ...]) -> tuple[type, ...]:
        return (object,)

    def __instancecheck__(self, instance: object) -> bool:
        return False  # nothing is of an absent class


def _absent(where: str, name: str) -> Absent:
    if name.startswith("__"):  # Python's own questions want their usual answers
        raise AttributeError(name)
    return Absent(f"{where}.{name}")


def __getattr__(name: str) -> Absent:
    return _absent(__name__, name)
