"""Long jobs and the objects that stand for them."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

OWNER_GOES_FIRST = """
import weakref
from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QApplication
from app.platform.tasks import TaskOwner

app = QApplication([])
gone = []
for k in range(20):
    owner, told = TaskOwner(), []
    owner.destroyed.connect(lambda: gone.append(k))
    task = owner.run("a job", lambda progress: k, done=told.append)
    task.join()  # that it has ended is on its way
    left = weakref.ref(task)
    del owner, task
    for _ in range(3):
        app.processEvents()
        app.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
    assert told == [k]
    assert left() is None
print(gone == list(range(20)))
"""


def test_an_owner_may_go_before_the_end_of_its_job_has_arrived():
    """In another process: what this is about would end the tests with it."""
    done = subprocess.run(
        [sys.executable, "-c", OWNER_GOES_FIRST], cwd=ROOT, capture_output=True, text=True
    )
    assert (done.returncode, done.stdout.strip()) == (0, "True"), done.stderr
