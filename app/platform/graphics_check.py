"""Reports the renderer of the 3D view to ``glovetrack doctor``."""

from __future__ import annotations

import os
from collections.abc import Iterator

from tracker.base.notices import notice, warning
from tracker.doctor.finding import Check, Finding
from tracker.doctor.machine import Machine


def _opengl(machine: Machine) -> Iterator[Finding]:
    # Qt is imported only if this check runs.
    from app.platform.graphics import WITHOUT_SCREEN, is_card, renderer_in_subprocess

    has_screen = not machine.is_linux or any(
        os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY")
    )
    if not has_screen or os.environ.get("QT_QPA_PLATFORM", "") in WITHOUT_SCREEN:
        return
    renderer = renderer_in_subprocess()
    if is_card(renderer):
        yield Finding(notice("doctor.opengl", renderer=renderer))
        return
    what = warning("doctor.opengl_slow", renderer=renderer)
    if not renderer:
        what = warning("doctor.no_opengl")
    yield Finding(what, notice("doctor.opengl_driver"))


OPENGL = Check("opengl", "Graphics card", _opengl, 45)
