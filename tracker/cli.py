"""The commands of ``glovetrack`` that need no window (`app.__main__` adds the two that do).

Exit status: 0 done, 1 the work failed (one message on standard error), 2 wrong usage. Packages
bring their own sub-commands and import what these need inside them, so that ``glovetrack info``
starts at once.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from tracker import __version__
from tracker.base.damage import gather, sentences
from tracker.base.errors import GlovetrackError
from tracker.base.files import disk_error
from tracker.base.terminal import printable, stopped_by_signals, words_on_standard_output


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status."""
    args = _parser().parse_args(argv)
    try:
        with stopped_by_signals(), words_on_standard_output(), gather() as left_out:
            status = int(args.func(args) or 0)
            for text in sentences(left_out):
                print(f"glovetrack: {printable(text)}", file=sys.stderr)
            return status
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


def _parser() -> argparse.ArgumentParser:
    from extensions.applications.command import add_commands as add_apps
    from extensions.conformance.command import add_commands as add_conformance
    from extensions.evaluation.commands import add_commands as add_evaluation
    from extensions.sheets.command import add_commands as add_sheets
    from tracker.firmware.command import add_commands as add_firmware
    from tracker.offline.commands import add_commands as add_offline
    from tracker.session.commands import add_commands as add_session

    parser = argparse.ArgumentParser(
        prog="glovetrack",
        description="Track a hand with a sensor glove and a stereo camera. Without a command, or "
        "with a session file, the window opens. 'glovetrack demo' opens it with simulated devices, "
        "'glovetrack devices' with the connected glove and camera; 'glovetrack remote' controls "
        "an open window.",
    )
    parser.add_argument("--version", action="version", version=f"glovetrack {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    add_offline(commands)
    add_session(commands)
    add_evaluation(commands)
    add_conformance(commands)
    add_apps(commands)
    add_firmware(commands)
    add_sheets(commands)
    return parser


if __name__ == "__main__":
    sys.exit(main())
