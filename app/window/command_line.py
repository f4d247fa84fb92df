"""The commands that open the window or control an open one; quick to import, without Qt."""

from __future__ import annotations

from tracker.base.command import Command
from tracker.base.registry import deferred

WINDOW = Command(
    "window",
    "open the window (default without a command)",
    deferred("app.window.start:open_window"),
    options=deferred("app.window.window_options:WindowOptions"),
    opens_window=True,
)
DEMO = Command(
    "demo",
    "open the window with a simulated glove and camera",
    deferred("app.window.start:open_demo"),
    options=deferred("app.window.window_options:WindowOptions"),
    opens_window=True,
)
DEVICES = Command(
    "devices",
    "open the window with the connected glove and camera",
    deferred("app.window.start:open_devices"),
    options=deferred("app.window.window_options:WindowOptions"),
    opens_window=True,
)
REMOTE = Command(
    "remote",
    "control the open window",
    deferred("app.window.remote_command:control"),
    add=deferred("app.window.remote_command:add_remote"),
    description="Control the open Glovetrack window.",
)
