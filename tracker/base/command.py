"""Commands of ``glovetrack``: what describes one, and the registry of all."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

from tracker.base.arguments import add_options, options_of
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.registry import Deferred, Registry

O = TypeVar("O")  # noqa: E741 (options)


class UsageError(ConfigError):
    """Arguments that contradict each other: exit status 2, with the command's usage."""


@dataclass(frozen=True)
class Command(Generic[O]):
    """A command; the entry point of ``evaluate vist`` is named ``evaluate.vist``.

    Without ``run`` it is a group, whose sub-commands are the entry points below its name; any
    package may declare more of them.
    """

    name: str
    help: str
    """One line of ``glovetrack --help``, without a full stop."""
    run: Callable[[O], int | None] | None = None
    """Runs the command; returns the exit status (None: 0). It receives an instance of ``options``
    or, without these, the ``argparse.Namespace``. A `GlovetrackError` is printed, exit status 1."""
    options: type[O] | Deferred | None = None
    """A dataclass: each field is an argument (`tracker.base.arguments`). A deferred one is imported
    when the command is used."""
    add: Callable[[argparse.ArgumentParser], None] | None = None
    """Adds arguments to the command's parser, instead of or in addition to ``options``."""
    description: str = ""
    """A paragraph for ``glovetrack NAME --help``."""
    epilog: str = ""
    """A paragraph below its options."""
    extra: str = ""
    """The optional dependencies that it needs, as in ``pip install "glovetrack[EXTRA]"``."""
    opens_window: bool = False
    """Whether it runs an event loop that handles signals itself."""

    def fill(self, parser: argparse.ArgumentParser) -> None:
        """Add the command's arguments to its parser."""
        if self.options is not None:
            add_options(parser, self._options())
        if self.add is not None:
            self.add(parser)

    def _options(self) -> type[Any]:
        found: Any = self.options
        return found.load() if isinstance(found, Deferred) else found

    def start(self, args: argparse.Namespace) -> int:
        """Run the command with parsed arguments; returns the exit status."""
        assert self.run is not None, "a group has no run"
        run: Callable[..., int | None] = self.run
        try:
            return run(args if self.options is None else options_of(self._options(), args)) or 0
        except ImportError as error:
            if not self.extra:
                raise
            raise ConfigError(
                notice("command.packages", command=self.name, why=error, extra=self.extra)
            ) from error


COMMANDS: Registry[Command] = Registry("commands", "command", Command)
