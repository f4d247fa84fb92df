"""What a command of ``glovetrack`` is made of: a plug-in under ``glovetrack.commands``.

A package declares a `Command` as an entry point of that group. Its options are a dataclass whose
fields have `argument` metadata; its ``run`` receives an instance and returns the exit status.
"""

from tracker.base.arguments import argument
from tracker.base.command import Command, UsageError
from tracker.base.terminal import printable, progress_line, write_json

__all__ = ["Command", "UsageError", "argument", "printable", "progress_line", "write_json"]
