"""The public live tracker, on simulated devices in real time."""

from __future__ import annotations

import gc
from pathlib import Path

import numpy as np
import pytest

import glovetrack
from glovetrack.devices import ConnectedGlove, Devices, glove_link
from tests.notices import raises
from tracker.glove import library
from tracker.sensors.sources import NoCamera

pytestmark = pytest.mark.timeout(600)
ENOUGH = 60  # estimates


def test_estimates_in_order_and_a_recording_that_is_tracked_again(tmp_path: Path) -> None:
    path = tmp_path / "live.mcap"
    with glovetrack.LiveTracker.simulated(seed=2, fps=20.0) as live:
        for estimate in live:
            if estimate.tracking == "tracking":
                break
        with live.recording(path):
            got = [live.next(10.0) for _ in range(ENOUGH)]
            live.note("half")
            got += [live.next(10.0) for _ in range(ENOUGH)]
        events = live.take_events()
    taken = [e for e in got if e is not None]
    assert len(taken) == 2 * ENOUGH and live.discarded == 0
    assert (np.diff([e.t for e in taken]) > 0).all()
    assert {e.side for e in taken} == {"right"}
    assert any(e.kind == "note" and e.text == "half" for e in events)
    assert "tracking.tracked" in [e.code for e in events]
    recorded = glovetrack.open(path)
    last = taken[-1]
    row = int(np.searchsorted(recorded.t_unix_ns, last.t_unix_ns))
    np.testing.assert_array_equal(recorded.keypoints["index_tip"][row], last.keypoints["index_tip"])
    assert last.state["index_tip"] in {"measured", "inferred", "lost"}
    assert recorded.track().compare(recorded)["identical"]
    assert any(e.text == "half" for e in recorded.events)
    assert "recording.started" in [e.code for e in recorded.events]


@pytest.mark.long
def test_both_hands_without_a_camera_come_in_one_stream() -> None:
    with glovetrack.LiveTracker.simulated(seed=3, hands="both", camera=False) as live:
        sides = set()
        for n, estimate in enumerate(live):
            sides.add(estimate.side)
            if len(sides) == 2 or n > 500:
                break
        assert sides == {"left", "right"}
        with raises(glovetrack.ConfigError, "api.two_hands"):
            live.latest()
        assert live.latest("left") is not None
    live.close()  # again
    with pytest.raises(RuntimeError, match="once"):
        live.__enter__()


def test_devices_end_with_a_tracker_that_was_not_started() -> None:
    """Whether its set-up fails or it is dropped."""
    ended: list[str] = []

    def devices(name: str) -> Devices:
        texts = library.texts(library.DEFAULT_GLOVE)
        glove = ConnectedGlove(*texts, glove_link(texts, "none"))
        return Devices((glove,), NoCamera(), None, end=lambda: ended.append(name))

    with raises(glovetrack.ConfigError, "part.unknown"):
        glovetrack.LiveTracker(devices("unknown engine"), engine="none")
    assert ended == ["unknown engine"]
    dropped = glovetrack.LiveTracker(devices("dropped"))
    del dropped
    gc.collect()
    assert ended == ["unknown engine", "dropped"]


def test_missing_devices_are_reported(tmp_path: Path) -> None:
    with raises(glovetrack.DeviceError, "glove.not_at_port"):
        glovetrack.LiveTracker.from_devices(str(tmp_path / "ttyUSB9"))
    with raises(glovetrack.ConfigError, "option.choice", option="hands", value="three"):
        glovetrack.LiveTracker.simulated(hands="three")
