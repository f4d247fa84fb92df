"""Tests wait while a job makes progress, and stop if it stalls."""

from __future__ import annotations

import time
from functools import partial

import pytest

from app.platform.subprocess_job import run_in_subprocess
from app.platform.tasks import TaskOwner
from tests.gui import jobs_here, patience
from tracker.base.child import start_child

pytestmark = pytest.mark.long


def work(pipe) -> None:
    """Uses the processor for a second, then answers."""
    end = time.process_time() + 1.0
    while time.process_time() < end:
        pass
    pipe.send("done")


def sleep(pipe) -> None:
    pipe.send("started")
    pipe.recv()


def test_a_job_that_makes_progress_is_waited_for(qtbot) -> None:
    pipe, process = start_child("works", work)
    qtbot.waitUntil(lambda: pipe.poll(), timeout=300)
    assert pipe.recv() == "done"
    process.join()


def counted(progress) -> str:
    """Uses the processor for a second."""
    end = time.thread_time() + 1.0
    while time.thread_time() < end:
        pass
    return "done"


def test_a_job_in_this_process_is_waited_for_too(qtbot) -> None:
    answers = []
    owner = TaskOwner()
    owner.run("a job", partial(run_in_subprocess, "counts", counted), done=answers.append)
    qtbot.waitUntil(lambda: answers == ["done"], timeout=300)
    assert not jobs_here.RUNNING


def test_a_stalled_job_times_out(qtbot, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(patience, "STALLED", 2.0)
    pipe, process = start_child("sleeps", sleep)
    assert pipe.poll(60)  # its start uses the processor
    pipe.recv()
    began = time.monotonic()
    with pytest.raises(qtbot.TimeoutError):
        qtbot.waitUntil(lambda: False, timeout=1000)
    assert 2.0 < time.monotonic() - began < 30
    pipe.send(None)
    process.join()
