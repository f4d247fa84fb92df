"""Threads that fail or hang: reported, logged, and never waited for without a timeout."""

from __future__ import annotations

import logging
import threading
import time

import pytest

from tracker.base.errors import DeviceError
from tracker.base.notices import Notice
from tracker.live.recording import RecordingThread
from tracker.live.threads import ThreadGroup
from tracker.messages import Event, Message

LIMIT = 30.0  # s, for a condition that needs none on an idle computer


def failing(error: Exception):
    def step() -> None:
        raise error

    return step


@pytest.mark.parametrize("error", [ZeroDivisionError("no reason"), DeviceError("It is gone.")])
def test_a_thread_that_fails_is_reported_and_leaves_its_traceback(
    error: Exception, caplog: pytest.LogCaptureFixture
) -> None:
    reports: list[tuple[str, Notice]] = []
    group = ThreadGroup(lambda kind, what: reports.append((kind, what)))
    assert group.failure is None
    with caplog.at_level(logging.ERROR):
        group.start("camera", failing(error))
        assert group.join({}, LIMIT) == []
    assert reports == [("error", group.failure)] and str(error) in str(group.failure)
    assert caplog.records[-1].exc_info is not None, "the traceback is in the log"


def test_a_hanging_thread_is_abandoned_and_freed_when_it_ends() -> None:
    go_on, hangs, freed = threading.Event(), threading.Event(), threading.Event()

    def step() -> None:
        hangs.set()
        go_on.wait(LIMIT)

    group = ThreadGroup(lambda kind, what: None)
    group.start("camera", step)
    group.start("other", lambda: time.sleep(0.01))
    assert hangs.wait(LIMIT)
    group.request_stop()
    begun = time.monotonic()
    late = group.join({"camera": freed.set}, 0.3)
    assert time.monotonic() - begun < LIMIT / 2, "0.3 s, on a loaded computer more"
    assert late == ["camera"] and not freed.is_set(), "a device in use is not freed"
    go_on.set()
    assert freed.wait(LIMIT)


def test_a_device_that_hangs_while_closing_does_not_delay_others() -> None:
    go_on, closed = threading.Event(), threading.Event()
    group = ThreadGroup(lambda kind, what: None)
    late = group.join({"camera": lambda: bool(go_on.wait(LIMIT)), "glove": closed.set}, 0.3)
    assert closed.wait(LIMIT) and "camera" in late
    go_on.set()


class Broken:
    """A recorder with a bug: an unexpected exception."""

    def __init__(self) -> None:
        self.closed = False

    def write(self, message: Message, overloaded: bool = False, side: str = "") -> bool:
        raise ZeroDivisionError("a bug")

    def flush(self) -> None: ...

    def close(self) -> None:
        self.closed = True


def test_a_failing_recorder_closes_its_file_and_is_reported() -> None:
    reports: list[tuple[str, str]] = []
    recorder = Broken()
    thread = RecordingThread(recorder, lambda kind, what: reports.append((kind, what.code)))
    thread.put(Event(1.0, "note", "hello"))
    end = time.monotonic() + LIMIT
    while not reports and time.monotonic() < end:
        time.sleep(0.01)
    assert reports == [("error", "recording.ended")]
    assert thread.finish(LIMIT) and recorder.closed
