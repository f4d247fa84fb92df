"""Output of commands: lines for people, JSON for programs, progress; and stopping them."""

from __future__ import annotations

import argparse
import contextlib
import json
import math
import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import field
from pathlib import Path
from typing import Any, Protocol

from tracker.base.arguments import argument
from tracker.base.files import check_target, write_whole

_SHOW_EVERY = 0.25  # s


class JsonOutput(Protocol):
    """Arguments with the options ``json`` and ``force``."""

    @property
    def json(self) -> str | None: ...

    @property
    def force(self) -> bool: ...


def json_option() -> Any:
    """The field ``json: str | None``: the option ``--json FILE``."""
    more = argument("write the results as JSON (- for standard output)", metavar="FILE")
    return field(default=None, metadata=more)


def force_option() -> Any:
    """The field ``force: bool``: the option ``--force``."""
    return field(default=False, metadata=argument("overwrite existing files"))


def add_force(command: argparse.ArgumentParser) -> None:
    """``--force`` for a tool with a parser of its own."""
    command.add_argument("--force", action="store_true", help="overwrite existing files")


def check_json(args: JsonOutput, inputs: Sequence[Path] = ()) -> None:
    """Before long work: raises FileError if the JSON asked for may not be written there."""
    if args.json and args.json != "-":
        check_target(Path(args.json), args.force, inputs)


def finish(
    args: JsonOutput,
    result: dict[str, Any],
    lines: Iterable[str],
    inputs: Sequence[Path] = (),
) -> None:
    """Lines for people, and JSON where it was asked for; with ``-`` the JSON alone."""
    if args.json != "-":
        print("\n".join(map(printable, lines)))
    if args.json:
        write_json(result, args.json, args.force, inputs)


def write_json(
    value: object, target: str, force: bool = False, inputs: Sequence[Path] = ()
) -> None:
    """To a file, whole or not at all, or to standard output for ``-``. NaN becomes null.

    Raises FileError where the file exists already, unless ``force``, or is one of ``inputs``.
    """
    text = json.dumps(_plain(value), indent=2) + "\n"
    if target == "-":
        sys.stdout.write(text)
    else:
        write_whole(Path(target), text, force, inputs)


def _plain(value: Any) -> Any:
    """Replaces NaN, which JSON does not have, by null."""
    if isinstance(value, dict):
        return {k: _plain(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(v) for v in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def printable(text: str) -> str:
    """Removes control characters, so that the text of a file cannot control the terminal."""
    return "".join(c for c in text if c.isprintable() or "\ud800" <= c <= "\udfff")


def progress_line(what: str) -> Callable[[float], None]:
    """Shows the share that is done on standard error, four times a second, on a terminal only."""
    if not sys.stderr.isatty():
        return lambda share: None
    shown = [0.0]

    def show(share: float) -> None:
        now = time.monotonic()
        if share >= 1.0 or now - shown[0] > _SHOW_EVERY:
            shown[0] = now
            end = "\n" if share >= 1.0 else ""
            print(f"\r{what} {100 * share:3.0f} %", end=end, file=sys.stderr, flush=True)

    return show


@contextlib.contextmanager
def stopped_by_signals() -> Iterator[None]:
    """SIGTERM and SIGHUP end the block as Ctrl+C does, so that it cleans up.

    A signal that is ignored, as under nohup, stays ignored; a second one does not stop cleaning up.
    """
    before = {}
    if threading.current_thread() is threading.main_thread():
        for name in ("SIGTERM", "SIGHUP"):
            number = getattr(signal, name, None)
            if number is not None and signal.getsignal(number) == signal.SIG_DFL:
                before[number] = signal.signal(number, _stop)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _stop(number: int, frame: object) -> None:
    signal.signal(number, signal.SIG_IGN)
    raise KeyboardInterrupt


@contextlib.contextmanager
def printing() -> Iterator[None]:
    """Escapes characters that standard output cannot show, and flushes it at the end of the block.

    Raises OSError if standard output is closed.
    """
    if hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        yield
        sys.stdout.flush()
    except OSError:
        # buffered text would raise the error again when Python ends
        with contextlib.suppress(OSError, ValueError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise
