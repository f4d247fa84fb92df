"""Registration of every record that a recorded state of tracking can contain.

A record registers itself when its module is imported. A program that only reads a session has not
imported the engines, so reading a state imports them first: by name and not at the top, since the
engines are above this package.
"""

from __future__ import annotations

from functools import cache
from importlib import import_module

MODULES = ("..engine.pipeline", "..engine.hands")
"""They import every module with a ``@record``; a test compares that with the source. The names are
relative because an installed program has these modules in another package."""


@cache
def register_all() -> None:
    """Import `MODULES`, so that every record of a state is known."""
    for name in MODULES:
        import_module(name, __package__)
