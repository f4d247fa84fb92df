"""The real window, off-screen; a test fails if anything outlives it."""

import os

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
os.environ.setdefault("QT_API", "pyside6")
os.environ.setdefault("PYTEST_QT_API", "pyside6")

import threading
import time

import pytest

from app.storage.settings import SettingsStore
from app.window.main_window import MainWindow
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tests.gui.jobs_here import start_here
from tests.gui.patience import USUAL_MS, patient


@pytest.fixture
def qtbot(qtbot, request, qapp, monkeypatch):
    """Waits while jobs make progress; see `patience`. Windows have no style sheet, which takes half
    of the time of making one, unless the test, which measures or looks, is ``styled``. The window's
    jobs run in this process, unless the test, whose subject they are, has ``processes``."""
    if request.node.get_closest_marker("styled") is None:
        qapp.setStyleSheet("")  # of an earlier test
        monkeypatch.setattr("app.window.theme.style_sheet", lambda colours: "")
    if request.node.get_closest_marker("processes") is None:
        monkeypatch.setattr("app.platform.subprocess_job.start_child", start_here)
    return patient(qtbot)


@pytest.fixture
def no_leaks():
    """A test fails if it leaves threads of ours behind."""
    yield
    deadline = time.monotonic() + USUAL_MS / 1000
    while time.monotonic() < deadline and _ours():
        time.sleep(0.02)
    assert _ours() == []


def _ours() -> list[str]:
    return [t.name for t in threading.enumerate() if t.name.startswith("glovetrack")]


@pytest.fixture
def store(tmp_path):
    store = SettingsStore(tmp_path / "window.json")
    store.update(theme="light", job="all", sessions_folder=str(tmp_path / "sessions"))
    return store


@pytest.fixture
def window(qtbot, store, no_leaks):
    """A shown window without an engine."""
    window = MainWindow(store)
    qtbot.addWidget(window)
    window.resize(1366, 768)
    window.show()
    yield window
    window.close()


@pytest.fixture
def engine() -> ScriptedEngine:
    return ScriptedEngine()


@pytest.fixture
def live(window, engine, qtbot):
    """The window on a scripted engine, with the first second shown."""
    window.host.adopt(scripted_setup(engine))
    qtbot.waitUntil(lambda: window.hand._scene is not None)
    return window
