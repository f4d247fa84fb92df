"""Long jobs and the objects that stand for them."""

import os
import subprocess
import sys
from functools import partial
from pathlib import Path

import pytest

from app.platform.subprocess_job import run_in_subprocess
from app.platform.tasks import JobProgress, TaskOwner
from app.words import notice_text
from tests.damaged_sessions import cut_message, spoilt
from tracker.base.errors import FileError, GlovetrackError
from tracker.base.notices import warning
from tracker.messages import ImuSample
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.session.reader import SessionReader

pytestmark = pytest.mark.processes
ROOT = Path(__file__).resolve().parents[2]

OWNER_GOES_FIRST = """
import weakref
from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QApplication
from app.platform.tasks import TaskOwner

app = QApplication([])
gone = []
for k in range(20):
    owner, results = TaskOwner(), []
    owner.destroyed.connect(lambda: gone.append(k))
    task = owner.run("a job", lambda progress: k, done=results.append)
    task.join()  # that it has ended is on its way
    left = weakref.ref(task)
    del owner, task
    for _ in range(3):
        app.processEvents()
        app.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
    assert results == [k]
    assert left() is None
print(gone == list(range(20)))
"""


def test_an_owner_may_go_before_the_end_of_its_job_has_arrived():
    """In another process: what this is about would end the tests with it."""
    done = subprocess.run(
        [sys.executable, "-c", OWNER_GOES_FIRST], cwd=ROOT, capture_output=True, text=True
    )
    assert (done.returncode, done.stdout.strip()) == (0, "True"), done.stderr


def _share_of_process(progress) -> tuple[int, int]:
    progress(0.5)
    return os.getpid(), os.nice(0)


def _refuse(progress) -> None:
    progress(0.2)
    raise FileError("The disk is full.")


def _crash(progress) -> None:
    raise KeyError("a fault of ours")


def _vanish(progress) -> None:
    progress(0.2)
    os._exit(3)


def test_a_subprocess_has_a_lower_priority_and_reports_its_progress():
    results = []
    pid, nice = run_in_subprocess(
        "work", _share_of_process, JobProgress(lambda share, _text: results.append(share))
    )
    assert pid != os.getpid() and nice > os.nice(0)
    assert results == [0.5]


def test_a_crash_of_the_subprocess_is_reported_by_its_name():
    with pytest.raises(RuntimeError, match="KeyError: 'a fault of ours'"):
        run_in_subprocess("work", _crash, JobProgress(lambda *_: None))


@pytest.mark.long
@pytest.mark.parametrize(
    ("work", "words"), [(_refuse, "disk is full"), (_vanish, "ended unexpectedly")]
)
def test_a_subprocess_that_ends_early_raises(work, words):
    with pytest.raises(GlovetrackError, match=words):
        run_in_subprocess("work", work, JobProgress(lambda *_: None))


def _count_samples(progress, path: Path) -> int:
    with SessionReader(path) as reader:
        return sum(1 for _ in reader.messages((ImuSample,)))


@pytest.mark.long
@pytest.mark.parametrize("in_subprocess", [True, False])
def test_a_job_reports_the_damaged_messages_that_it_skipped(tmp_path, qtbot, in_subprocess):
    simulate(tmp_path / "s.mcap", SimulateOptions(seed=3, duration=1.0, images=False))
    topic = "/glove/right/packets"
    path = spoilt(tmp_path / "s.mcap", tmp_path / "a.mcap", [topic], cut_message)
    work = partial(_count_samples, path=path)
    job = partial(run_in_subprocess, "count", work) if in_subprocess else work
    owner, counts, noted = TaskOwner(), [], []
    owner.noted.connect(noted.append)
    owner.run("count", job, done=counts.append)
    qtbot.waitUntil(lambda: not owner.tasks)
    assert counts == [_count_samples(None, tmp_path / "s.mcap") - 1]
    damaged = warning("session.damaged_topic", count=1, topic=topic)
    reported = warning("session.messages_damaged", file="a.mcap", topics=[damaged])
    assert noted == [notice_text(reported)]
