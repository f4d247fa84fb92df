"""``glovetrack fit-glove`` on a simulated glove that does not match its file."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tracker.base.clock import ClockAnchor
from tracker.base.errors import FileError
from tracker.cli import main
from tracker.geometry import so3
from tracker.glove import library
from tracker.glove.files import parse_glove
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array
from tracker.offline.fit_glove import Fitted, with_fit
from tracker.session.description import describe
from tracker.session.writer import SessionRecorder
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

pytestmark = pytest.mark.long

SEED, SECONDS = 802, 36.0
MOVED = (26, 27, 29)  # on the middle finger
SHIFT = 0.004  # m
TURNED, TURN = 3, np.deg2rad(25.0)


def true_glove(glove: GloveModel) -> GloveModel:
    """Three markers are 4 mm farther toward the fingertip, and an IMU is rotated by 25°."""
    markers, imus = list(glove.markers), list(glove.imus)
    for k in MOVED:
        markers[k] = replace(markers[k], position=markers[k].position + [SHIFT, 0, 0])
    imus[TURNED] = replace(imus[TURNED], R_BI=imus[TURNED].R_BI @ so3.rx(TURN))
    return replace(glove, markers=tuple(markers), imus=tuple(imus))


@pytest.fixture(scope="module")
def simulation(hand: HandModel, glove: GloveModel) -> Simulation:
    motion = RandomPostures(hand, SEED, duration=SECONDS)
    return Simulation(hand, true_glove(glove), motion, SEED, fps=30)


@pytest.fixture(scope="module")
def session(simulation: Simulation, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording with the glove file that does not match."""
    path = tmp_path_factory.mktemp("fit") / "free.mcap"
    info = describe(*library.texts(), ClockAnchor(10**18, 0), rig=simulation.rig)
    with SessionRecorder(path, info) as recorder:
        for message in simulation.feed():
            recorder.write(message)
    return path


@pytest.fixture
def own_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """The folder of a user's own gloves."""
    monkeypatch.setattr(library, "user_data_path", lambda *_, **__: tmp_path / "own")
    yield tmp_path / "own" / "gloves"


def true_offsets(simulation: Simulation, glove: GloveModel) -> Array:
    """(M, 3) m from the file's positions, the size of the hand removed."""
    wearer = simulation.wearer
    scale = wearer.scale[wearer.marker_segment]
    placed = np.einsum("mki,mk->mi", wearer._tangents, wearer._marker_offset)
    moved = np.array([m.position for m in simulation.glove.markers]) - glove.marker_position
    return np.asarray(placed / scale + moved)


def test_markers_and_imus_are_measured_and_saved_as_an_own_file(
    simulation: Simulation, session: Path, glove: GloveModel, own_files: Path, tmp_path: Path
) -> None:
    out = tmp_path / "fit.json"
    assert main(["fit-glove", str(session), "--name", "mine", "--json", str(out)]) == 0
    report = json.loads(out.read_text())
    seen = np.array([m["seen"] for m in report["markers"]]) >= 3
    offset, sd = (np.array([m[k] for m in report["markers"]]) for k in ("offset", "sd"))
    true = true_offsets(simulation, glove)
    error = (offset - true)[seen]
    # within the standard deviations: 37 markers in common shifts, so not a chi-square of 111
    assert np.mean((error / sd[seen]) ** 2) < 1.3
    assert np.all(np.abs(error) < 4.0 * sd[seen])
    moved = list(MOVED)
    remaining = np.linalg.norm((offset - true)[moved], axis=1)
    assert np.all(remaining < 0.6 * np.linalg.norm(true[moved], axis=1))

    # the file: read again by name, with these values, and everything else unchanged
    assert (own_files / "mine.toml").is_file()
    _, mine = library.load("mine")
    assert np.allclose(
        mine.marker_position[seen], (glove.marker_position + offset)[seen], atol=1e-5
    )
    assert np.array_equal(mine.marker_position[~seen], glove.marker_position[~seen])
    assert [m.normal.tolist() for m in mine.markers] == [m.normal.tolist() for m in glove.markers]
    R_true = simulation.wearer.imu_R_BI
    before, after = (
        np.linalg.norm(so3.log(np.array([i.R_BI for i in g.imus]).swapaxes(1, 2) @ R_true), axis=1)
        for g in (glove, mine)
    )
    assert after[TURNED] < 0.5 * before[TURNED]
    turn_sd = np.array([report["imus"][name]["sd"] for name in glove.imu_names])
    assert np.all(after < 3.0 * np.linalg.norm(turn_sd, axis=1))


def test_an_existing_file_is_not_replaced(
    session: Path, own_files: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    own_files.mkdir(parents=True)
    (own_files / "mine.toml").write_text("the user's own")
    assert main(["fit-glove", str(session), "--name", "mine"]) == 1
    assert "exists" in capsys.readouterr().err
    assert (own_files / "mine.toml").read_text() == "the user's own"


def test_a_short_recording_is_an_error(
    simulation: Simulation, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "short.mcap"
    info = describe(*library.texts(), ClockAnchor(10**18, 0), rig=simulation.rig)
    with SessionRecorder(path, info) as recorder:
        for message in simulation.feed():
            if message.t > 2.0:
                break
            recorder.write(message)
    assert main(["fit-glove", str(path)]) == 1
    assert "postures" in capsys.readouterr().err


def test_only_positions_and_mountings_of_a_file_change(hand: HandModel) -> None:
    text = library.text("gloves", "vist-small-distal")
    before = parse_glove(text, hand)
    turn = so3.rz(0.3)
    changed = with_fit(text, Fitted({4: np.array([0.01, -0.02, 0.03])}, {"dorsum": turn}))
    after = parse_glove(changed, hand)
    assert after.markers[4].position.tolist() == [0.01, -0.02, 0.03]
    assert np.allclose(after.imus[0].R_BI, turn, atol=1e-6)
    differing = [
        (a, b) for a, b in zip(text.splitlines(), changed.splitlines(), strict=True) if a != b
    ]
    assert len(differing) == 2
    assert [i.position.tolist() for i in after.imus] == [i.position.tolist() for i in before.imus]


def test_a_file_without_the_marker_is_an_error() -> None:
    with pytest.raises(FileError):
        with_fit(library.text("gloves", "vist-small"), Fitted({99: np.zeros(3)}, {}))
