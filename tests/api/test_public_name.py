"""`import glovetrack`: light, typed, whole, and without effect on the host process."""

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
    if name.endswith("_NUM_THREADS"):
        del os.environ[name]
import cv2, numpy  # OpenCV extends LD_LIBRARY_PATH
from threadpoolctl import threadpool_info
def state():
    pools = [(p["filepath"], p["num_threads"]) for p in threadpool_info()]
    handlers = [signal.getsignal(s) for s in (signal.SIGINT, signal.SIGTERM)]
    return dict(os.environ), pools, handlers, threading.active_count(), sys.excepthook
before = state()
import glovetrack
for name in glovetrack.__all__:
    getattr(glovetrack, name)
rec = glovetrack.simulate(duration=1.0, images=False)
rec.track().keypoints
after = state()
assert before[0] == after[0], "environment"
assert before[2:] == after[2:], (before[2:], after[2:])
known = dict(before[1])
assert all(known.get(path, n) == n for path, n in after[1])
print("unchanged")
"""
    assert output(code) == "unchanged"


def test_every_name_is_there() -> None:
    for name in glovetrack.__all__:
        assert getattr(glovetrack, name) is not None
    assert set(glovetrack.__all__) <= set(dir(glovetrack))
    with pytest.raises(AttributeError, match="no attribute 'Tracker'"):
        glovetrack.Tracker  # noqa: B018


PROGRAM = """
import glovetrack
from glovetrack.applications import HandSample, Step
from glovetrack.cameras import CameraDriver, Pair
from glovetrack.engine import Pipeline, Settings, load
from glovetrack.streams import StreamKind, StreamSettings

rec = glovetrack.open("session.mcap")
reveal_type(rec.keypoints["index_tip"])
reveal_type(rec.imu("dorsum").gyro)
reveal_type(rec.track(engine="vist"))
with glovetrack.LiveTracker.simulated() as live:
    for estimate in live:
        reveal_type(estimate.sd)
"""


def test_a_type_checker_knows_every_name_and_refuses_others(tmp_path: Path) -> None:
    program, wrong = tmp_path / "program.py", tmp_path / "wrong.py"
    program.write_text(PROGRAM)
    wrong.write_text("import glovetrack\nglovetrack.nothing\n")
    mypy = [sys.executable, "-m", "mypy", "--cache-dir", str(ROOT / ".mypy_cache")]
    done = subprocess.run(
        [*mypy, "--strict", "--follow-imports=silent", str(program)],
        cwd=ROOT, capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout
    said = done.stdout
    assert said.count("Revealed type") == 4 and '"Any"' not in said
    assert "glovetrack.recording.Recording" in said
    refused = subprocess.run(
        [*mypy, "--follow-imports=silent", str(wrong)], cwd=ROOT, capture_output=True, text=True
    )
    assert refused.returncode == 1 and "nothing" in refused.stdout
