"""Sessions of both hands tracked again with all options for one hand."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from resources import folder
from tests.notices import raises
from tests.simulated_sessions import BOTH, SimulatedSessions
from tracker.base.errors import ConfigError, FileError
from tracker.messages import Estimate
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.offline.track_report import TrackReport
from tracker.session.reader import SessionReader
from tracker.session.verify import is_ok, verify

pytestmark = pytest.mark.long

SIDES = ("left", "right")


@pytest.fixture(scope="module")
def session(simulated_sessions: SimulatedSessions) -> Path:
    return simulated_sessions.simulated(BOTH)


@dataclass(frozen=True)
class Plain:
    """A session as tracked live, and a profile of each hand, by side."""

    report: TrackReport
    path: Path
    profiles: dict[str, Path]


@pytest.fixture(scope="module")
def plain(session: Path, tmp_path_factory) -> Plain:
    path = tmp_path_factory.mktemp("plain") / "live.mcap"
    anna = path.with_name("anna.toml")
    report = track(session, path, TrackOptions(with_sensors=True, keep_wearer=str(anna)))
    return Plain(report, path, {side: path.with_name(f"anna_{side}.toml") for side in SIDES})


def angles(path: Path, side: str) -> np.ndarray:
    """(n, J) angles of the estimates of a tracked hand."""
    with SessionReader(path, side=side) as reader:
        found = [e.angles for e in reader.messages((Estimate,)) if isinstance(e, Estimate)]
    return np.array([a for a in found if np.isfinite(a).all()])


def jerk(path: Path, side: str) -> float:
    """The 99th percentile of the second differences of angles, rad."""
    return float(np.quantile(np.abs(np.diff(angles(path, side), n=2, axis=0)), 0.99))


def test_both_hands_are_smoothed(session: Path, plain: Plain, tmp_path: Path) -> None:
    live = plain.report
    out = tmp_path / "smooth.mcap"
    smooth = track(session, out, TrackOptions(smooth=True, with_sensors=True))
    assert is_ok(verify(out)) and smooth.frames == live.frames
    for side in SIDES:
        own = smooth.hands[side]
        assert own.estimates == live.hands[side].estimates
        assert own.lost_s <= live.hands[side].lost_s
        assert own.error_mm["mean"] < 1.1 * live.hands[side].error_mm["mean"]
        assert jerk(out, side) < 0.5 * jerk(plain.path, side)
    again = tmp_path / "again.mcap"
    track(out, again, TrackOptions())
    for side in SIDES:  # the copied part equals the recorded one
        assert np.array_equal(angles(again, side), angles(plain.path, side))


def test_profiles_are_applied_to_their_own_hand(
    session: Path, plain: Plain, tmp_path: Path
) -> None:
    first, (left, right) = plain.report, (plain.profiles[side] for side in SIDES)
    assert 'hand = "reference-left"' in left.read_text() and right.is_file()
    one = track(session, tmp_path / "b.mcap", TrackOptions(wearer=str(right)))
    assert one.hands["left"].error_mm == first.hands["left"].error_mm
    assert one.hands["right"].error_mm != first.hands["right"].error_mm
    worn = TrackOptions(wearer=f"{right},{left}")
    both = track(session, tmp_path / "c.mcap", worn)
    assert both.hands["right"].error_mm == one.hands["right"].error_mm
    assert both.hands["left"].error_mm != first.hands["left"].error_mm
    with raises(ConfigError, "track.same_hand"):
        other = tmp_path / "other.toml"
        other.write_text(left.read_text())
        track(session, tmp_path / "d.mcap", TrackOptions(wearer=f"{left},{other}"))
    other.write_text(left.read_text().replace("reference-left", "large-left"))
    with raises(FileError, "track.other_hand"):
        track(session, tmp_path / "d.mcap", TrackOptions(wearer=str(other)))


def test_replaced_files_are_applied_to_the_given_side(session: Path, tmp_path: Path) -> None:
    longer = tmp_path / "longer.toml"
    text = (folder("hands") / "reference-left.toml").read_text("utf-8")
    longer.write_text(text.replace("length = 0.183", "length = 0.184", 1))
    out = tmp_path / "out.mcap"
    track(session, out, TrackOptions(hand=f"reference-right,{longer}"))
    with SessionReader(out) as reader:
        lengths = {info.side: info.hand.length for info in reader.info.hands}
    assert lengths == {"left": 0.184, "right": 0.183}
    with raises(ConfigError, "track.same_side"):
        track(session, tmp_path / "x.mcap", TrackOptions(hand=f"reference-left,{longer}"))
    nameless = tmp_path / "nameless.toml"
    nameless.write_text("schema = 1\n")
    with raises(FileError, "track.no_side"):
        track(session, tmp_path / "x.mcap", TrackOptions(glove=str(nameless)))


def test_a_measured_length_applies_to_both(session: Path, plain: Plain, tmp_path: Path) -> None:
    measured = track(session, tmp_path / "b.mcap", TrackOptions(hand_length=0.19))
    for side in SIDES:
        assert measured.hands[side].error_mm != plain.report.hands[side].error_mm


def test_a_session_of_one_hand_accepts_one_file(tmp_path: Path) -> None:
    path = tmp_path / "one.mcap"
    simulate(path, SimulateOptions(seed=5, duration=1.0, fps=30, images=False))
    with raises(ConfigError, "track.one_hand"):
        track(path, tmp_path / "x.mcap", TrackOptions(hand="reference-left,reference-right"))
