"""The commands that open the window or control an open one; quick to import, without Qt."""

from __future__ import annotations

import argparse

from tracker.base.arguments import add_options, options_of
from tracker.base.command import Command
from tracker.base.registry import deferred


def _add_window(parser: argparse.ArgumentParser) -> None:
    from app.window.window_options import WindowOptions  # deferred: loads the registries

    add_options(parser, WindowOptions)


def _open(args: argparse.Namespace) -> int:
    from app.window.start import open_window  # deferred: loads Qt
    from app.window.window_options import WindowOptions  # deferred: loads the registries

    return open_window(options_of(WindowOptions, args))


def _demo(args: argparse.Namespace) -> int:
    args.demo = True
    return _open(args)


def _devices(args: argparse.Namespace) -> int:
    args.devices = True
    return _open(args)


def _add_remote(parser: argparse.ArgumentParser) -> None:
    from app.window.remote_command import add_remote  # deferred: loads QtNetwork

    add_remote(parser)


WINDOW = Command(
    "window",
    "open the window (default without a command)",
    _open,
    add=_add_window,
    opens_window=True,
)
DEMO = Command(
    "demo",
    "open the window with a simulated glove and camera",
    _demo,
    add=_add_window,
    opens_window=True,
)
DEVICES = Command(
    "devices",
    "open the window with the connected glove and camera",
    _devices,
    add=_add_window,
    opens_window=True,
)
REMOTE = Command(
    "remote",
    "control the open window",
    deferred("app.window.remote_command:control"),
    add=_add_remote,
    description="Control the open Glovetrack window.",
)
