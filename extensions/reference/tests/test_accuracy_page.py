"""Every command of the page runs as written."""

from __future__ import annotations

import re
import shlex
import shutil
from pathlib import Path

import numpy as np
import pytest

from extensions.reference.formats.read import read_reference
from extensions.reference.mapping import read_mapping
from extensions.reference.tests.conftest import Wearer
from extensions.reference.tests.laboratory import FAULTY, RATE, write_c3d
from tracker.cli import main

PAGE = Path(__file__).parents[1] / "docs" / "reference.md"
BLOCKS = re.compile(r"^```(\w+)\n(.*?)^```", re.MULTILINE | re.DOTALL)


@pytest.mark.long
def test_the_commands_of_the_page_run(
    wearer: Wearer, short: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    shutil.copy(short, "tracked.mcap")
    t, x = FAULTY.record(wearer, 19.0)
    names = wearer.info.keypoint_names
    write_c3d(Path("lab.c3d"), names, x)
    blocks = BLOCKS.findall(PAGE.read_text("utf-8"))
    (mapping,) = [text for kind, text in blocks if kind == "toml"]
    points = {"RWRA": "wrist", "RWRB": "wrist", "RIFT": "index_tip", "RTHT": "thumb_tip"}
    more = "".join(f'{p} = ["{p}x", "{p}y", "{p}z"]\n' for p in points if p != "RIFT")
    Path("lab.toml").write_text(mapping + more, "utf-8")
    axes = [f"{p}{a}" if p != "RIFT" else f"i{a}" for p in points for a in "xyz"]
    columns = x[:, [names.index(k) for k in points.values()]].reshape(len(x), -1)
    sync = (np.abs(t - 3.0) < 0.1).astype(float)
    rows = np.column_stack([1e3 * t, sync, 1e3 * columns])
    head = ",".join(["t", "sync", *axes])
    np.savetxt("lab.csv", rows, delimiter=",", header=head, comments="", fmt="%.6f")
    lines = [line for kind, text in blocks if kind == "sh" for line in text.splitlines()]
    assert len(lines) == 4
    for line in lines:
        program, *words = shlex.split(line)
        assert program == "glovetrack" and main(words) == 0, line
    recording = read_reference(Path("lab.csv"), read_mapping(Path("lab.toml")))
    assert [p.t for p in recording.pulses] == [pytest.approx(2.9, abs=1 / RATE)]
    assert "lab.csv" not in Path("study.html").read_text("utf-8")
