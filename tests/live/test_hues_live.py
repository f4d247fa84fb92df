"""A live recording during which exchanged names of hues were corrected is tracked again bit for
bit, and the log shows the correction."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.viewmodels.log import EventLog
from tests.engine.test_hands import GLOVES, simulated
from tests.live.test_hands_live import Live, keypoints
from tracker.glove import library
from tracker.messages import BlobFrame, Tracking, Validity
from tracker.offline.track import track
from tracker.session.verify import is_ok, verify
from tracker.simulation.two_hands import SidedMessage, TwoHandsSimulation

pytestmark = pytest.mark.long

RECORDED_FROM = 1.0  # s; names are searched for from 1.5 s on
WRONG = 0.05  # m, of what is reported as measured


def exchanged(sided: SidedMessage, a: str, b: str) -> SidedMessage:
    """A message of colours in which these two names are exchanged."""
    message, other = sided.message, {a: b, b: a}
    if not isinstance(message, BlobFrame):
        return sided
    names = tuple(other.get(name, name) for name in message.hue_names)
    return SidedMessage(sided.side, replace(message, hue_names=names))


def wrong(live: Live, sim: TwoHandsSimulation, side: str) -> int:
    """Number of keypoints of a hand, now, that are called measured and are far off."""
    estimate = live.loop.seen[side].estimate
    if estimate is None or estimate.tracking != Tracking.TRACKING:
        return 0
    off = estimate.keypoints - sim.hands[side].truth(estimate.t).keypoints
    measured = estimate.keypoint_state == Validity.MEASURED
    return int(np.count_nonzero(measured & (np.linalg.norm(off, axis=1) > WRONG)))


@pytest.mark.parametrize(
    ("one", "another", "seconds"),
    [("red", "blue", 3.6), ("blue", "green", 1.5)],
    ids=["no hand is found", "the other hues show the hands"],
)
def test_a_recording_with_a_correction_is_tracked_again_bit_for_bit(
    tmp_path: Path, one: str, another: str, seconds: float
) -> None:
    sim = simulated(5, seconds, 15.0)
    live, path, false_points = Live(sim), tmp_path / "live.mcap", 0
    begin = RECORDED_FROM if one == "red" else 0.0
    for k, message in enumerate(sim.messages()):
        if live.now >= begin and not live.journal.recording:
            live.record(path)
        live.feed(exchanged(message, one, another))
        if k % 20 == 0:
            false_points += sum(wrong(live, sim, side) for side in GLOVES)
    live.loop.set_recorder(None)
    assert false_points == 0
    for side, hand in live.loop.seen.items():
        hues = live.loop.hands.pipelines[side].hues
        swapped = {one: another, another: one}
        right = tuple(swapped.get(h, h) for h in library.load(GLOVES[side], "")[1].hues)
        assert hand.tracking == Tracking.TRACKING and hues.names == right
    assert is_ok(verify(path))
    track(path, tmp_path / "again.mcap")
    for side in GLOVES:
        was, again = (keypoints(file, side) for file in (path, tmp_path / "again.mcap"))
        assert len(was) > 50 and np.isfinite(was[-1]).any()
        np.testing.assert_array_equal(was, again)
    log, shown = EventLog(), live.journal.drain_events()
    for event in shown:
        log.add(event)
    found = [e for e in shown if e.code == "colours.exchanged_here"]
    assert len(found) == 1 and set(found[0].notice.values["hues"]) == {one, another}
    assert len(log.entries(words=f"{one} {another}")) == 1
