"""The command ``glovetrack``, also ``python -m app``: the window, or what `tracker.cli` knows."""

from __future__ import annotations

import multiprocessing
import sys
from collections.abc import Sequence

WINDOW = {
    "demo": ["--demo"],
    "--demo": ["--demo"],
    "devices": ["--devices"],
    "--devices": ["--devices"],
}

OF_COMMANDS = ("--help", "--version")


def main(argv: Sequence[str] | None = None) -> int:
    """No word, ``demo``, ``devices``, a session or an option opens the window; others are commands.

    Qt is imported for the window, and for ``remote`` that talks to it, so that ``glovetrack info``
    starts at once.
    """
    words = list(sys.argv[1:] if argv is None else argv)
    if not words or words[0] in WINDOW or _is_windows(words[0]):
        from app.window.start import open_window

        return open_window([*WINDOW.get(words[0], words[:1]), *words[1:]] if words else [])
    if words[0] == "remote":
        from app.window.remote_command import main as remote

        return remote(words[1:])
    from tracker.cli import main as run_command

    return run_command(words)


def _is_windows(word: str) -> bool:
    """A session, or an option that no command has before its name, as ``--remote udp``."""
    return word.endswith(".mcap") or (word.startswith("--") and word not in OF_COMMANDS)


if __name__ == "__main__":
    # In a frozen program the simulated camera's process starts here too, and must not go on.
    multiprocessing.freeze_support()
    sys.exit(main())
