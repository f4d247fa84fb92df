"""Messages between stages cannot be changed once they are built."""

from __future__ import annotations

import json
import pickle

import numpy as np
import pytest

from tracker.messages import Event, ImuSample, Status, Tracking


def test_arrays_are_read_only() -> None:
    zeros = np.zeros((7, 3))
    sample = ImuSample(0.0, 0.0, 0.0, 0, zeros, zeros.copy(), np.ones(7, bool))
    with pytest.raises(ValueError, match="read-only"):
        sample.accel[0] = 1.0


def test_mappings_are_copied_and_cannot_be_changed() -> None:
    values = {"imu_rate": 100.0}
    status = Status(0.0, Tracking.TRACKING, values)
    values["imu_rate"] = 3.0
    assert status.values == {"imu_rate": 100.0}
    event = Event(0.0, "note", "text", {"side": "left"})
    for mapping in (status.values, event.data):
        for change in (
            lambda m: m.__setitem__("a", 1),
            lambda m: m.update(a=1),
            lambda m: m.pop("side", None),
            lambda m: m.setdefault("a", 1),
            lambda m: m.clear(),
        ):
            with pytest.raises(TypeError, match="message"):
                change(mapping)


def test_mappings_travel_between_processes_and_into_files() -> None:
    event = Event(0.0, "note", "text", {"side": "left"})
    again = pickle.loads(pickle.dumps(event))
    assert again == event and json.loads(json.dumps(again.data)) == {"side": "left"}
    with pytest.raises(TypeError):
        again.data["side"] = "right"
