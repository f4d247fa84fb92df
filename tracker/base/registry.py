"""Parts that other packages can add to the program: one registry for each kind of part.

A package declares a part as an entry point of the group ``glovetrack.KIND``, which names a module's
attribute: the descriptor. Parts of this program are declared in the same way, in `pyproject.toml`,
so extensions and other packages are attached by the same means. A module with a descriptor is
imported to list it, and should therefore be quick to import: it names the functions that do the
work by `deferred`, which imports their module when they are first called.
"""

from __future__ import annotations

import logging
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from importlib.metadata import EntryPoint, entry_points
from typing import Any, Generic, TypeVar

from tracker.base.errors import ConfigError
from tracker.base.notices import notice

D = TypeVar("D")
OURS = "glovetrack"
"""Name of this program's distribution."""
_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Deferred:
    """A function or class by its name; its module is imported when it is first used.

    ``name`` is ``package.module:function``, with the module's name in the source tree. A wheel has
    other names: `packaging/backend.py` rewrites the argument of every call of `deferred`.
    """

    name: str

    def load(self) -> Any:
        """Imports and returns it."""
        module, _, attribute = self.name.partition(":")
        return getattr(import_module(module), attribute)

    def __call__(self, *args: Any) -> Any:
        return self.load()(*args)


def deferred(name: str) -> Deferred:
    """Names a function of a descriptor: ``deferred("package.module:function")`` calls it, and
    ``deferred("package.module:Class").load`` returns it."""
    return Deferred(name)


class Registry(Generic[D]):
    """The parts of one kind, by name.

    ``kind`` is the last word of the entry-point group, ``noun`` what one part is called in
    messages; every descriptor must be a ``descriptor``. ``adapt`` makes one of something simpler
    that an entry point may name instead, and returns other objects unchanged.
    """

    def __init__(
        self,
        kind: str,
        noun: str,
        descriptor: type[D],
        adapt: Callable[[object], object] = lambda found: found,
    ) -> None:
        self.group = f"glovetrack.{kind}"
        self.noun = noun
        self._descriptor, self._adapt = descriptor, adapt

    def names(self) -> list[str]:
        """The names of all parts, those of this program first; nothing is imported."""
        return list(_entries(self.group, tuple(sys.path)))

    def get(self, name: str) -> D:
        """Returns one part. Raises ConfigError for an unknown name, or if it cannot be loaded."""
        entry = _entries(self.group, tuple(sys.path)).get(name)
        if entry is None:
            known = ", ".join(self.names()) or "none"
            raise ConfigError(notice("part.unknown", kind=self.noun, name=name, known=known))
        try:
            found = self._adapt(entry.load())
        except Exception as error:
            raise ConfigError(
                notice("part.not_loaded", kind=self.noun, name=name, why=error)
            ) from error
        if not isinstance(found, self._descriptor):
            raise ConfigError(
                notice(
                    "part.wrong_type",
                    kind=self.noun,
                    name=name,
                    entry=entry.value,
                    expected=self._descriptor.__name__,
                )
            )
        return found

    def all(self) -> dict[str, D]:
        """All parts that can be loaded; the others are left out and logged."""
        out = {}
        for name in self.names():
            try:
                out[name] = self.get(name)
            except ConfigError as error:
                _log.warning("%s", error)
        return out


def names_of(kind: str) -> list[str]:
    """The names of all parts of a kind, as `Registry.names`; for texts of the command line, which
    must not import what a registry needs."""
    return list(_entries(f"glovetrack.{kind}", tuple(sys.path)))


@lru_cache(maxsize=64)
def _entries(group: str, path: tuple[str, ...]) -> dict[str, EntryPoint]:
    """Returns the entry points of a group while `sys.path` is ``path``, by name.

    If two packages declare the same name, this program's takes precedence, then the first one.
    """
    found = sorted(entry_points(group=group), key=lambda entry: not _is_ours(entry))
    out: dict[str, EntryPoint] = {}
    for entry in found:
        if entry.name in out:
            _log.warning("%s: the name %s is declared twice", group, entry.name)
            continue
        out[entry.name] = entry
    return out


def _is_ours(entry: EntryPoint) -> bool:
    return entry.dist is not None and entry.dist.name == OURS
