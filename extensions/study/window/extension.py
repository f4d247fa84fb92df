"""Window command of studies."""

from __future__ import annotations

from app.panels.command_kind import WindowCommand
from app.words import mark
from tracker.base.registry import deferred

COMMAND = WindowCommand(
    "study", mark("St&udy…"), deferred("extensions.study.window.start:open_protocol")
)
