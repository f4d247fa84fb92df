"""The add-on in a headless Blender: its armatures show what was recorded or sent.

Blender is the program `blender`, or a Python that has its module `bpy`: this one, or the one in the
variable GLOVETRACK_BLENDER.
"""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
import time
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import glovetrack
from tests.live_recordings import LiveRecordings
from tests.streaming.recorded_hand import RecordedHand, assert_near, assert_parallel
from tracker.streaming.payload import to_json

HERE = Path(__file__).parent
ADDON = HERE.parent / "glovetrack_blender.py"
STATES = {"lost": 0, "inferred": 1, "measured": 2}


def blender() -> list[str]:
    """The command that runs a script in Blender."""
    named = os.environ.get("GLOVETRACK_BLENDER") or shutil.which("blender")
    if named and "python" not in Path(named).name:
        return [named, "--background", "--factory-startup", "--python-exit-code", "1", "--python"]
    if named or find_spec("bpy"):
        return [named or sys.executable]
    pytest.skip("neither blender nor bpy is installed (GLOVETRACK_BLENDER)")


def started(*words: str | Path) -> subprocess.Popen[str]:
    command = [*blender(), str(HERE / "in_blender.py"), "--", *map(str, words), str(ADDON)]
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"  # has glovetrack
    return subprocess.Popen(
        command,
        env=os.environ | {"PATH": path},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


@pytest.mark.timeout(300)
def test_a_recording_of_both_hands_is_imported(
    live_recordings: LiveRecordings, tmp_path: Path
) -> None:
    blender()
    path, out = live_recordings.path("both hands"), tmp_path / "out.json"
    process = started("import", path, out)
    assert process.wait(240) == 0, process.communicate()[0]
    frames = json.loads(out.read_text())
    assert frames[0].keys() == {"Glovetrack left", "Glovetrack right"}
    recording = glovetrack.open(path)
    for side in ("left", "right"):
        hand, shown = recording.hands[side], 0
        t = hand.t - hand.t[0]
        for k, frame in enumerate(frames):
            row = int(np.abs(t - k / 20).argmin())
            for name, bone in frame[f"Glovetrack {side}"].items():
                state = int(hand.valid[name][row]) + int(hand.measured[name][row])
                assert bone["state"] == state
                if state:
                    shown += 1
                    turn = Rotation.from_quat(hand.orientations[name][row])
                    check(bone, hand.keypoints[name][row], turn)
                    assert bone["sd"] == pytest.approx(hand.sd[name][row], rel=1e-5)
        assert shown > 100
    parents = {name: bone["parent"] for name, bone in frames[0]["Glovetrack left"].items()}
    assert parents["wrist"] is None and parents["index_dip"] == "index_pip"
    assert parents["thumb_cmc"] == parents["dorsum"] == "wrist"


def check(bone: dict[str, Any], p: np.ndarray, turn: Rotation) -> None:
    """Its head, and its y and z axes, which are x and z of the segment."""
    assert_near(bone["position"], p)
    y, z = np.array(bone["y"]), np.array(bone["z"])
    axes = np.column_stack([y, np.cross(z, y), z])
    assert_parallel(Rotation.from_matrix(axes), turn)


@pytest.mark.timeout(180)
def test_recorded_hands_are_shown_live(tmp_path: Path, recorded: RecordedHand) -> None:
    port, out = tmp_path / "port", tmp_path / "out.json"
    process = started("live", port, out)
    while not (port.exists() and port.read_text()):
        assert process.poll() is None, process.communicate()[0]
        time.sleep(0.05)
    e = recorded.estimates[-1]
    right = json.loads(to_json(e, recorded.names))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        while process.poll() is None:
            for message in (right, {**right, "side": "left"}, {"schema": 1}):
                sender.sendto(json.dumps(message).encode(), ("127.0.0.1", int(port.read_text())))
            time.sleep(0.1)
    assert process.returncode == 0, process.communicate()[0]
    found = json.loads(out.read_text())
    assert found.pop("refused") > 0, "what is not of the stream is counted"
    assert found.keys() == {"Glovetrack left", "Glovetrack right"}
    points, turns = recorded.points(e), recorded.turns(e)
    for bones in found.values():
        for name in points:
            check(bones[name], points[name], turns[name])
            assert bones[name]["state"] == STATES[right["keypoints"][name]["state"]]
