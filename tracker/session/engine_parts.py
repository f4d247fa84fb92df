"""Registration of every record that a recorded state of tracking can contain.

A record registers itself when its module is imported. A program that only reads a session has not
imported the engines, so reading a state imports them first: by name and not at the top, since the
engines are above this package.
"""

from __future__ import annotations

from importlib import import_module

MODULES = ("..engine.pipeline", "..engine.hands")
"""With the states of all engines they import every module with a ``@record``; a test compares that
with the source. The names are relative because an installed program has these modules in another
package."""


def register_all() -> None:
    """Import `MODULES` and what the states of all engines are made of, those of other packages
    too."""
    for name in MODULES:
        import_module(name, __package__)
    import_module("..engine.kinds", __package__).load_states()
