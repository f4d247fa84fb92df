"""A recording that began while the engine was late: its cameras are described after its first
messages, since a description is stamped when it is written."""

from __future__ import annotations

from pathlib import Path

import pytest

from tracker.cli import main
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import TrackOptions, track
from tracker.session import rigs
from tracker.session.compare import compare
from tracker.session.export.mcap import copy_extras
from tracker.session.mcap.container import Copier, McapOutput
from tracker.session.mcap.ordering import ordered
from tracker.session.reader import SessionReader

pytestmark = pytest.mark.long

LATE = 3_000_000_000  # ns
DESCRIBED = ("camera_info", "/tf_static", "extrinsics", "robot_description")


@pytest.fixture(scope="module")
def late(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The descriptions come at 3 s of 4 s."""
    folder = tmp_path_factory.mktemp("late")
    simulated, whole, out = (folder / f"{n}.mcap" for n in ("simulated", "whole", "late"))
    simulate(simulated, SimulateOptions(seed=5, duration=4.0, fps=20, images=False))
    track(simulated, whole, TrackOptions("chain", with_sensors=True))
    with SessionReader(whole) as reader:
        made = McapOutput(out, sync=False)
        copy_extras(reader, made)
        copier = Copier(reader.source, made)
        late = [
            raw._replace(log_time=raw.log_time + LATE) if raw.topic.endswith(DESCRIBED) else raw
            for raw in ordered(reader.source)
        ]
        for raw in sorted(late, key=lambda raw: raw.log_time):
            copier.copy(raw)
        made.finish()
    return out


@pytest.mark.parametrize("span", [("0.5", "1.5"), ("1", "2"), ("2.9", "3.5")])
def test_a_part_before_the_descriptions_is_tracked_again(
    late: Path, span: tuple[str, str], tmp_path: Path
) -> None:
    part, again = tmp_path / "part.mcap", tmp_path / "again.mcap"
    assert main(["crop", str(late), "-o", str(part), "--start", span[0], "--stop", span[1]]) == 0
    with SessionReader(part) as reader:
        described = [raw.topic for raw in ordered(reader.source) if raw.topic.endswith(DESCRIBED)]
    assert len(described) > 3 and len(set(described)) == len(described), "each one once"
    assert main(["track", str(part), "-o", str(again)]) == 0
    assert compare(part, again)["identical"]


def test_the_cameras_are_found_after_any_number_of_transforms(
    late: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With two hands, 3 s before the descriptions contain more transforms than the limit."""
    monkeypatch.setattr(rigs, "_MOST_RIG_MESSAGES", 50)
    again = tmp_path / "again.mcap"
    track(late, again)
    assert compare(late, again)["identical"]
