"""Detection of the OpenGL renderer, in a subprocess since a broken driver may crash."""

from __future__ import annotations

import os
from collections.abc import Iterator
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtGui import QGuiApplication, QOffscreenSurface, QOpenGLContext

from tracker.base.child import start_child
from tracker.base.notices import notice, warning
from tracker.doctor.finding import Finding
from tracker.doctor.machine import Machine

SOFTWARE = (
    "llvmpipe",
    "softpipe",
    "swrast",
    "software",
    "gdi generic",
    "basic render",
    "swiftshader",
)
GL_RENDERER = 0x1F01
PERIOD_MS = 100
TIMEOUT_MS = 20_000
WITHOUT_SCREEN = ("offscreen", "minimal", "vnc", "linuxfb")


def is_card(renderer: str) -> bool:
    """Whether a GL_RENDERER string is that of a graphics card."""
    name = renderer.lower()
    return bool(name) and not any(word in name for word in SOFTWARE)


def gl_renderer() -> str:
    """GL_RENDERER of this process's Qt; empty without OpenGL."""
    surface, context = QOffscreenSurface(), QOpenGLContext()
    surface.create()
    if not context.create() or not context.makeCurrent(surface):
        return ""
    try:
        return str(context.functions().glGetString(GL_RENDERER) or "")
    finally:
        context.doneCurrent()


def _answer(pipe: Connection) -> None:
    """Runs in the subprocess."""
    app = QGuiApplication.instance() or QGuiApplication(["glovetrack-graphics"])
    pipe.send(gl_renderer())
    pipe.close()
    del app


def renderer_in_subprocess() -> str:
    """GL_RENDERER, waiting for the subprocess; empty if there is no OpenGL or it crashes."""
    pipe, process = start_child("glovetrack-graphics", _answer)
    try:
        return str(pipe.recv()) if pipe.poll(TIMEOUT_MS / 1000) else ""
    except (EOFError, OSError):
        return ""
    finally:
        process.terminate()
        process.join()
        pipe.close()


class GraphicsQuery(QObject):
    """Queries once; ``answered``: the renderer's name, empty after a failure."""

    answered = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._poll)
        self._pipe: Connection | None = None
        self._process: BaseProcess | None = None
        self._waited_ms = 0

    def start(self) -> None:
        """Start the query, unless there is no screen."""
        if QGuiApplication.platformName() in WITHOUT_SCREEN:
            return
        self._pipe, self._process = start_child("glovetrack-graphics", _answer)
        self._timer.start(PERIOD_MS)

    def _poll(self) -> None:
        self._waited_ms += PERIOD_MS
        assert self._pipe is not None and self._process is not None
        try:
            if self._pipe.poll():
                self._end(str(self._pipe.recv()))
                return
        except (EOFError, OSError):
            self._end("")
            return
        if not self._process.is_alive() or self._waited_ms > TIMEOUT_MS:
            self._end("")

    def _end(self, renderer: str) -> None:
        self.stop()
        self.answered.emit(renderer)

    def stop(self) -> None:
        """Stop the query. May be called at any time."""
        self._timer.stop()
        if self._process is not None:
            self._process.terminate()
            self._process.join()
            self._process = None
        if self._pipe is not None:
            self._pipe.close()
            self._pipe = None


def opengl_check(machine: Machine) -> Iterator[Finding]:
    """Reports the renderer of the 3D view to ``glovetrack doctor``."""
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
