"""The command line ``glovetrack``: chooses a command of the registry, and runs it.

Exit status: 0 done, 1 the work failed (one message on standard error), 2 wrong usage. Only the
chosen command's modules are imported, so that ``glovetrack info`` starts at once.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence

from tracker import __version__
from tracker.base.command import COMMANDS, Command, UsageError
from tracker.base.damage import gather, reports
from tracker.base.errors import ConfigError, GlovetrackError
from tracker.base.files import disk_error
from tracker.base.logs import add_log_options, logging_to
from tracker.base.notices import notice
from tracker.base.terminal import printable, printing, stopped_by_signals

BEFORE_COMMANDS = ("--help", "--version")
"""Options without a command; any other belongs to the window."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status."""
    words = with_window(sys.argv[1:] if argv is None else argv)
    try:
        if not COMMANDS.names():
            raise ConfigError(notice("command.none"))
        args = build_parser(words).parse_args(words)
        with logging_to(args.log_level, args.log_file):
            return _run(args.command, args)
    except UsageError as error:
        args.parser.error(printable(str(error)))
    except GlovetrackError as error:
        print(f"glovetrack: {printable(str(error))}", file=sys.stderr)
    except KeyboardInterrupt:
        print("glovetrack: stopped", file=sys.stderr)
    except BrokenPipeError:
        return 0
    except OSError as error:
        what = error.filename or "standard output"
        print(f"glovetrack: {disk_error(what, error)}", file=sys.stderr)
    return 1


def _run(command: Command, args: argparse.Namespace) -> int:
    if command.opens_window:
        return command.start(args)
    with stopped_by_signals(), printing(), gather() as left_out:
        status = command.start(args)
        for found in reports(left_out):
            print(f"glovetrack: {printable(str(found))}", file=sys.stderr)
        return status


def with_window(words: Sequence[str]) -> list[str]:
    """``words`` with the command ``window`` where they start with none: with a session, or with an
    option that no command has before its name, as ``--remote udp``."""
    option = bool(words) and words[0].startswith("--") and words[0] not in BEFORE_COMMANDS
    if not words or option or words[0].endswith(".mcap"):
        return ["window", *words]
    return list(words)


def build_parser(words: Sequence[str] | None = None) -> argparse.ArgumentParser:
    """The parser for ``words``, with the arguments of the command that they choose; without
    ``words``, with those of all commands."""
    parser = argparse.ArgumentParser(
        prog="glovetrack",
        description="Track a hand with a sensor glove and a stereo camera. Without a command, or "
        "with a session file, the window opens. 'glovetrack demo' opens it with simulated devices, "
        "'glovetrack devices' with the connected glove and camera; 'glovetrack remote' controls "
        "an open window.",
    )
    parser.add_argument("--version", action="version", version=f"glovetrack {__version__}")
    if words is None or words[:1] != ["--version"]:
        _add_commands(parser, (), words)
    return parser


def _add_commands(
    parser: argparse.ArgumentParser, group: tuple[str, ...], words: Sequence[str] | None
) -> None:
    """Add the commands of a group. Raises ConfigError if the chosen one cannot be loaded."""
    names = _names_in(group)
    chosen = words[0] if words and words[0] in names else None
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for name in names if chosen is None else [chosen]:
        command = _command((*group, name), required=chosen is not None)
        if command is None:
            continue
        child = commands.add_parser(
            name,
            help=command.help,
            description=command.description or None,
            epilog=command.epilog or None,
        )
        if words is not None and chosen is None:
            continue
        child.set_defaults(command=command, parser=child)
        if command.run is None:
            _add_commands(child, (*group, name), words if words is None else words[1:])
            continue
        command.fill(child)
        for leaf in _leaves(child):
            add_log_options(leaf)


def _leaves(parser: argparse.ArgumentParser) -> Iterator[argparse.ArgumentParser]:
    """The parser itself, or those below it if it is a command's own group."""
    inner = subparsers_of(parser)
    if inner is None:
        yield parser
        return
    for below in inner.choices.values():
        yield from _leaves(below)


def subparsers_of(
    parser: argparse.ArgumentParser,
) -> argparse._SubParsersAction[argparse.ArgumentParser] | None:
    """What chooses between the parser's sub-commands, if it has any."""
    found = (a for a in parser._actions if isinstance(a, argparse._SubParsersAction))
    return next(found, None)


def _names_in(group: tuple[str, ...]) -> list[str]:
    """The next word of all commands that begin with ``group``, in alphabetical order."""
    split = (tuple(name.split(".")) for name in COMMANDS.names())
    depth = len(group)
    return sorted({name[depth] for name in split if name[:depth] == group and len(name) > depth})


def _command(path: tuple[str, ...], required: bool) -> Command | None:
    """A command; None if it cannot be loaded, unless it is ``required``: then ConfigError."""
    name = ".".join(path)
    if name not in COMMANDS.names():  # its sub-commands alone are declared
        return Command(" ".join(path), "more commands")
    try:
        return COMMANDS.get(name)
    except ConfigError:
        if required:
            raise
        return None


if __name__ == "__main__":
    sys.exit(main())
