"""The add-on in a headless Blender: its armatures show what was recorded or sent.

Blender is the program `blender`, or a Python that has its module `bpy`: this one, or the one in the
variable GLOVETRACK_BLENDER.
"""

from __future__ import annotations

import csv
import json
import os
import shutil
import socket
import subprocess
import sys
import time
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tracker.cli import main
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import Names

HERE = Path(__file__).parent
ADDON = HERE.parent / "glovetrack_blender.py"
STATES = {"lost": 0, "inferred": 1, "measured": 2}
CLOSE = 1e-6  # m, and of a unit vector: Blender has single precision


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


def segment_x(xyzw: list[float]) -> np.ndarray:
    return Rotation.from_quat(xyzw).as_matrix()[:, 0]


def rows_of(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


@pytest.mark.timeout(300)
def test_a_recording_of_both_hands_is_imported(tmp_path: Path) -> None:
    blender()
    raw, tracked, out = (tmp_path / n for n in ("raw.mcap", "tracked.mcap", "out.json"))
    made = ["simulate", "-o", str(raw), "--duration", "1", "--fps", "20", "--blobs-only"]
    assert main([*made, "--hands", "both", "--seed", "5"]) == 0
    assert main(["track", str(raw), "-o", str(tracked)]) == 0
    assert main(["export", str(tracked), "--format", "csv", "-o", str(tmp_path / "h.csv")]) == 0
    process = started("import", tracked, out)
    assert process.wait(240) == 0, process.communicate()[0]
    frames = json.loads(out.read_text())
    assert frames[0].keys() == {"Glovetrack left", "Glovetrack right"}
    for side in ("left", "right"):
        rows = rows_of(tmp_path / f"h_{side}.csv")
        times = np.array([float(row["t"]) for row in rows]) - float(rows[0]["t"])
        shown_states = set()
        for k, frame in enumerate(frames):
            row = rows[int(np.abs(times - k / 20).argmin())]
            for name, bone in frame[f"Glovetrack {side}"].items():
                assert bone["state"] == STATES[row[f"{name}_state"]]
                shown_states.add(bone["state"])
                if not bone["state"]:
                    continue
                position = [float(row[f"{name}_{axis}"]) for axis in "xyz"]
                turn = [float(row[f"{name}_q{axis}"]) for axis in "xyzw"]
                assert np.allclose(bone["position"], position, atol=CLOSE), (k, name)
                assert np.allclose(bone["x"], segment_x(turn), atol=10 * CLOSE), (k, name)
                assert bone["sd"] == pytest.approx(float(row[f"{name}_sd"]), rel=1e-6)
        assert len(shown_states) > 1, "the hand is lost at the beginning, and found later"
    parents = {name: bone["parent"] for name, bone in frames[0]["Glovetrack left"].items()}
    assert parents["wrist"] is None and parents["index_dip"] == "index_pip"
    assert parents["thumb_cmc"] == parents["dorsum"] == "wrist"


@pytest.mark.timeout(180)
def test_hands_are_shown_live(tmp_path: Path, make_estimate, names: Names, hand, glove) -> None:
    port, out = tmp_path / "port", tmp_path / "out.json"
    process = started("live", port, out)
    while not (port.exists() and port.read_text()):
        assert process.poll() is None, process.communicate()[0]
        time.sleep(0.05)
    estimate = make_estimate(2.5, angles={"index_mcp_flexion": 0.7})
    right = json.loads(to_json(estimate, names))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        while process.poll() is None:
            for message in (right, {**right, "side": "left"}, {"schema": 1}):
                sender.sendto(json.dumps(message).encode(), ("127.0.0.1", int(port.read_text())))
            time.sleep(0.1)
    assert process.returncode == 0, process.communicate()[0]
    found = json.loads(out.read_text())
    assert found.pop("refused") > 0, "what is not of the stream is counted"
    assert found.keys() == {"Glovetrack left", "Glovetrack right"}
    for bones in found.values():
        for name, point in right["keypoints"].items():
            assert np.allclose(bones[name]["position"], point["position"], atol=CLOSE)
            turned = segment_x(point["orientation_xyzw"])
            assert np.allclose(bones[name]["x"], turned, atol=10 * CLOSE)
            assert bones[name]["state"] == STATES[point["state"]]
