"""Both ends of an engine in a process of its own, in one process: a thread runs the other end."""

import contextlib
import multiprocessing
import os
import socket
import threading
import time

import pytest

from app.engines.apart import process as process_module
from app.engines.apart.child import Line, run
from app.engines.apart.setup import apart_factory
from app.engines.apart.source import Companions
from app.engines.engine import Built
from app.platform.tasks import JobProgress
from tests.gui.gui_fakes import ScriptedEngine


class Subscribed(ScriptedEngine):
    """An engine whose estimates can be subscribed to; ``looks`` counts how often news were
    collected."""

    looks = 0

    def __init__(self):
        super().__init__()
        self.followers, self.subscribers = [], []

    def follow(self, follower):
        self.followers.append(follower)

    def subscribe(self, subscriber):
        self.subscribers.append(subscriber)
        return lambda: None

    def drain_events(self):
        self.looks += 1
        return super().drain_events()

    def publish(self, estimate, t_arrival=None):
        if t_arrival is not None:
            self.followers[0](estimate, t_arrival)
        self.subscribers[0](estimate)


class Scripted:
    """A source without devices."""

    def __init__(self, setup):
        self.setup = setup

    def build(self, progress):
        progress(0.5, "half")
        if isinstance(self.setup, Exception):
            raise self.setup
        return Built(self.setup)

    def companions(self, opened, send):
        return Companions()


class ThreadAsProcess:
    """In place of the process."""

    pid = 0

    def __init__(self, source):
        self.ours, theirs = multiprocessing.Pipe()
        self._theirs = theirs
        self._thread = threading.Thread(target=self._run, args=(source,), daemon=True)
        self._thread.start()

    def _run(self, source):
        try:
            run(Line(self._theirs), source)
        finally:
            self._theirs.close()

    def kill(self):
        """As the end of a process: nothing more is read or written."""
        with contextlib.suppress(OSError):  # it has ended by itself
            line = socket.socket(fileno=os.dup(self._theirs.fileno()))
            with line:
                line.shutdown(socket.SHUT_RDWR)


@pytest.fixture
def connect(monkeypatch, no_leaks):
    """Makes the window's end of a setup."""
    made = []

    def start(name, serve, source, language, crash, waits, daemon):
        made.append(ThreadAsProcess(source))
        return made[-1].ours, made[-1]

    monkeypatch.setattr(process_module, "start_child", start)

    def opened(setup):
        return apart_factory(Scripted(setup))(JobProgress(lambda *_: None))

    yield opened
    for each in made:
        each.kill()
        each._thread.join(60.0)


def eventually(found) -> None:
    end = time.monotonic() + 60.0
    while not found():
        assert time.monotonic() < end
        time.sleep(0.01)
