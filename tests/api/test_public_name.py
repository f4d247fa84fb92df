"""`import glovetrack`: light, whole, and without effect on the host process.

Its types are checked in `typed_program`.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import glovetrack

ROOT = Path(__file__).resolve().parents[2]


def output(code: str) -> str:
    run = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    return run.stdout.strip()


def test_it_is_light() -> None:
    assert output("import sys, glovetrack; print('numpy' in sys.modules)") == "False"


def test_it_changes_nothing_in_the_host_process() -> None:
    code = """
import os, sys, signal, threading
for name in list(os.environ):
    if name.endswith(("_NUM_THREADS", "_THREADS_NUM")):
        del os.environ[name]
import cv2, numpy  # OpenCV extends LD_LIBRARY_PATH
cv2.setNumThreads(3)
from threadpoolctl import threadpool_info
def state():
    pools = [(p["filepath"], p["num_threads"]) for p in threadpool_info()]
    pools.append(("opencv", cv2.getNumThreads()))
    handlers = [signal.getsignal(s) for s in (signal.SIGINT, signal.SIGTERM)]
    return dict(os.environ), pools, handlers, threading.active_count(), sys.excepthook
before = state()
import glovetrack
for name in glovetrack.__all__:
    getattr(glovetrack, name)
import glovetrack.applications, glovetrack.cameras, glovetrack.commands, glovetrack.engine
import glovetrack.formats, glovetrack.streams
rec = glovetrack.simulate(duration=1.0, images=False)
rec.track().keypoints
after = state()
assert before[0] == after[0], "environment"
assert before[2:] == after[2:], (before[2:], after[2:])
known = dict(before[1])
assert all(known.get(path, n) == n for path, n in after[1])
import glovetrack.panels  # Qt's bindings set variables of their own
assert not [n for n in os.environ if n.endswith(("_NUM_THREADS", "_THREADS_NUM"))]
print("unchanged")
"""
    assert output(code) == "unchanged"


def test_threads_of_the_host_that_overlap_leave_its_settings() -> None:
    """Whichever ends first."""
    code = """
import cv2
from tracker.base.numeric_threads import one_numeric_thread
cv2.setNumThreads(3)
first, second, found = one_numeric_thread(), one_numeric_thread(), []
for step in (first.__enter__, second.__enter__):
    step()
    found.append(cv2.getNumThreads())
for each in (first, second):
    each.__exit__(None, None, None)
    found.append(cv2.getNumThreads())
print(found)
"""
    assert output(code) == "[1, 1, 1, 3]"


def test_opencv_has_one_thread_in_processes_of_our_own() -> None:
    """Also where it was loaded before."""
    for first in ("app.__main__, cv2", "cv2, app.__main__"):
        code = f"""
import os
for name in ("OPENCV_FOR_THREADS_NUM", "OMP_NUM_THREADS"):
    os.environ.pop(name, None)
import {first}
print(cv2.getNumThreads())
"""
        assert output(code) == "1"


def test_every_name_is_there() -> None:
    for name in glovetrack.__all__:
        assert getattr(glovetrack, name) is not None
    assert set(glovetrack.__all__) <= set(dir(glovetrack))
    with pytest.raises(AttributeError, match="no attribute 'Tracker'"):
        glovetrack.Tracker  # noqa: B018
