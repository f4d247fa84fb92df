"""``glovetrack remote start|stop|note TEXT``: steer the window that is open, from a script."""

from __future__ import annotations

import argparse
import json
from dataclasses import field
from typing import Any

from app.platform.single_instance import ask
from tracker.base.arguments import add_options, argument, options, options_of
from tracker.base.errors import GlovetrackError
from tracker.base.notices import from_json, notice
from tracker.base.terminal import check_json, finish, force_option, json_option
from tracker.hand.names import CHAINS
from tracker.streaming.remote.client import UDP_PORT
from tracker.streaming.remote.client import ask as ask_over_udp
from tracker.streaming.remote.request import USUAL_AMPLITUDE, USUAL_MS, is_reply

_NOT_SENT = ("json", "force", "to", "command", "parser", "log_level", "log_file")


def control(args: argparse.Namespace) -> int:
    """Send the request and print the answer. Raises GlovetrackError if it was not carried out."""
    shared = options_of(RemoteArguments, args)
    check_json(shared)
    request = {k: v for k, v in vars(args).items() if k not in _NOT_SENT}
    answer = _send(request, shared.to)
    if not answer["ok"]:
        raise GlovetrackError(from_json(answer) or str(answer.get("error")))
    finish(shared, answer, [answer["text"], *([answer["file"]] if "file" in answer else [])])
    return 0


def _send(request: dict[str, Any], to: tuple[str, int] | None) -> dict[str, Any]:
    """Return the window's answer. Raises GlovetrackError if there is none."""
    reply = ask_over_udp(request, *to) if to is not None else ask(request)
    if reply is None:
        raise GlovetrackError(notice("window.none"))
    if not is_reply(reply):
        raise GlovetrackError(notice("window.other_program"))
    answer: dict[str, Any] = json.loads(reply)
    return answer


def _address(text: str) -> tuple[str, int]:
    """Raises ValueError, which the parser reports."""
    host, colon, port = text.partition(":")
    if not host or (colon and not 1 <= int(port) <= 65535):
        raise ValueError(text)
    return host, int(port) if colon else UDP_PORT


@options
class RemoteArguments:
    """Arguments of every sub-command; the others are the request itself."""

    to: tuple[str, int] | None = field(
        default=None,
        metadata=argument(
            "control a window on another computer, where remote control over UDP is enabled",
            type=_address,
            nargs=None,
            metavar="HOST[:PORT]",
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


def add_remote(parser: argparse.ArgumentParser) -> None:
    """Its sub-commands and their arguments."""
    common = argparse.ArgumentParser(add_help=False)
    add_options(common, RemoteArguments)
    asked = parser.add_subparsers(dest="do", metavar="WHAT", required=True)
    asked.add_parser("start", parents=[common], help="start recording")
    asked.add_parser("stop", parents=[common], help="stop recording")
    asked.add_parser(
        "status", parents=[common], help="show the status of the devices and the recording"
    )
    note = asked.add_parser("note", parents=[common], help="add a note at the current time")
    note.add_argument("text", metavar="TEXT", help="text of the note")
    vibrate = asked.add_parser(
        "vibrate", parents=[common], help="run a vibration motor of the glove"
    )
    vibrate.add_argument("finger", choices=tuple(CHAINS), help="finger of the motor")
    vibrate.add_argument(
        "--amplitude",
        type=int,
        default=USUAL_AMPLITUDE,
        metavar="0..255",
        help="strength of the vibration",
    )
    vibrate.add_argument(
        "--duration",
        dest="duration_ms",
        type=int,
        default=USUAL_MS,
        metavar="MS",
        help="duration of the vibration",
    )
    contact = asked.add_parser(
        "contact",
        parents=[common],
        help="report contact with an object that another program simulates or measures",
    )
    contact.add_argument("finger", choices=tuple(CHAINS), help="finger that touches the object")
    contact.add_argument(
        "--strength",
        type=float,
        default=1.0,
        metavar="0..1",
        help="strength of the contact; 0 ends it (default: 1)",
    )
    contact.add_argument("--object", default="", metavar="NAME", help="name of the object")
