"""The laboratory's hand next to the tracked one in a replay."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

from app.engines.replay.hands import known_hand
from app.engines.replay.references import References, ReferenceTrack
from app.window.main_window import MainWindow
from extensions.reference.angles import segment_axes
from extensions.reference.importing import ReferenceImportOptions, import_reference
from extensions.reference.tests.conftest import START, Wearer
from extensions.reference.tests.laboratory import FAULTY, write_c3d
from tracker.geometry import so3
from tracker.session.reader import SessionReader


def test_the_replay_has_the_reference_hand_at_its_time(wearer: Wearer, imported: Path) -> None:
    """Rigidly registered: markers are 5 mm off. A reference sample is at most 1/120 s old, in which
    a hand of 1 m/s moves 8 mm."""
    with SessionReader(imported) as reader:
        assert known_hand(reader) == "reference"
        side = reader.info.side
    references = References(imported, side, "reference")
    truth = references.truth()
    assert truth is not None and truth.is_measured
    references.seek(START + 10.0)
    for t in (10.5, 12.0, 20.25):
        references.advance(START + t)
        hand = truth.at(START + t)
        assert hand is not None
        x, _ = wearer.points(np.array([t]))
        assert np.linalg.norm(hand.keypoints - x[0], axis=1)[:21].max() < 0.02
        assert np.isfinite(hand.R_GB).all()
    references.close()


@pytest.mark.long
def test_points_of_an_incomplete_reference_are_drawn(
    wearer: Wearer, short: Path, tmp_path: Path, window: MainWindow, qtbot
) -> None:
    """Three keypoints as crosses; the whole hand cannot be drawn."""
    names = ("wrist", "index_tip", "little_mcp")
    rows = [wearer.info.keypoint_names.index(n) for n in names]
    lab = write_c3d(tmp_path / "few.c3d", names, FAULTY.record(wearer, 19.0)[1][:, rows])
    out = tmp_path / "out.mcap"
    import_reference(lab, short, out, ReferenceImportOptions(register="rigid"))
    window.sources.open_session(out, 10.0)
    qtbot.waitUntil(lambda: _crosses(window) == 3)
    scene = window.hand._hands[0].scene
    assert scene is not None and scene.reference is None
    known = np.flatnonzero(np.isfinite(scene.reference_points).all(axis=1))
    assert known.tolist() == sorted(rows)
    x, _ = wearer.points(np.array([10.0]))
    away = np.linalg.norm(scene.reference_points - x[0], axis=1)[known]
    assert away.max() < 0.02  # as above
    window.hand.controls.reference.setCurrentIndex(0)
    qtbot.waitUntil(lambda: _crosses(window) == 0)


def _crosses(window: MainWindow) -> int:
    """How many crosses the 3D view shows."""
    if not window.hand._hands or window.hand._hands[0].bodies is None:
        return 0
    crosses = window.hand._hands[0].bodies._points._crosses
    return int(window.hand.view.scene.shown[crosses._rows].sum())


def test_a_session_without_a_reference_has_none(short: Path) -> None:
    with SessionReader(short) as reader:
        assert known_hand(reader) == "" and list(reader.reference()) == []
    track = ReferenceTrack(short, root="reference")
    track.seek(0.0)
    track.advance(5.0)
    assert track.pose(5.0) is None
    track.close()


def test_axes_from_keypoints_are_those_of_the_model(wearer: Wearer) -> None:
    """The bones of fingers exactly, x along them; the hand's axes to its tilt of 8°, and the turn
    of a thumb about its bones not at all."""
    hand = wearer.info.hand
    rng = np.random.default_rng(4)
    for _ in range(10):
        angles = rng.uniform(*(hand.angle_limits.T * 0.5))
        R, p = hand.forward(angles, so3.exp(rng.normal(size=3)), rng.normal(size=3))
        names = hand.keypoint_names
        q = segment_axes(names, hand.keypoints(R, p)[None], "right")[0]
        found = so3.matrix_from_quat(q)
        wanted = R[list(hand.keypoint_segment)]
        for k, name in enumerate(names):
            if name != "wrist":
                assert_allclose(found[k, :, 0], wanted[k, :, 0], atol=1e-9)
            if not name.startswith("thumb"):
                turn = np.linalg.norm(so3.log(found[k].T @ wanted[k]))
                assert np.rad2deg(turn) < 12.0, name
    some = segment_axes(("wrist", "index_tip"), np.zeros((3, 2, 3)), "right")
    assert np.isnan(some).all()
