"""Slopes of biases with the temperature are learned at the end of recordings, for known gloves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from app.storage.bound_gloves import BoundGlove, bound, with_bound
from app.storage.own_gloves import own_path
from tests.gui.gui_fakes import ScriptedEngine, models, scripted_setup, with_glove
from tests.offline.test_imu_values import RATE_HZ, errors, warming
from tracker.base.notices import Notice
from tracker.glove.files import parse_glove
from tracker.messages import ImuSample

NUMBER, OWN = 1234, "vist-small-1234"
SECONDS = 20.0


class WarmingGlove(ScriptedEngine):
    """A glove on a table that warms up by 6 °C; ``sign`` of its slopes."""

    def __init__(self) -> None:
        super().__init__()
        self.packets: list[ImuSample] = []

    def recent_imu(self):
        return list(self.packets)

    def warm_up(self, seed: int, sign: float = 1.0) -> None:
        accel, gyro, celsius = warming(seed, 22.0, SECONDS)
        if sign < 0:
            gyro = gyro - 2 * (celsius - 25)[..., None] * errors().gyro_slope
        self.packets = [
            ImuSample(
                t := 100.0 * seed + k / RATE_HZ, t, t, k, accel[k], gyro[k], np.ones(7, bool),
                celsius[k] if k % RATE_HZ == 0 else None,
            )
            for k in range(len(accel))
        ]  # fmt: skip


@pytest.fixture
def engine(monkeypatch, tmp_path) -> WarmingGlove:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return WarmingGlove()


@pytest.fixture
def reports(window, engine) -> list[Notice]:
    """What the learner reports; the window has a glove with a number."""
    known = BoundGlove("right", "vist-small", "reference-right", "Ada")
    window.store.update(gloves=with_bound(window.store.value, NUMBER, known))
    setup = replace(scripted_setup(engine), simulated=False)
    window.host.adopt(with_glove(setup, number=NUMBER, file="vist-small", own_file=OWN))
    found: list[Notice] = []
    window.host.happened.connect(lambda event: found.append(event.notice))
    return found


def drift_of_file():
    return [i.drift for i in parse_glove(own_path(OWN).read_text(), models()[0]).imus]


def codes(reports: list[Notice]) -> list[str]:
    return [n.code for n in reports if n is not None and n.code.startswith("imu_drift")]


def test_each_run_improves_the_gloves_own_file(window, engine, reports):
    engine.warm_up(1)
    window.host.recording.finished.emit(own_path(OWN))  # a recording ends, tracking continues
    first = drift_of_file()
    known = bound(window.store.value, NUMBER)
    assert (known.glove, known.wearer) == (OWN, "Ada") and window.store.value.glove == OWN
    engine.warm_up(2)
    window.host.stop()
    slopes, sds = (np.array([getattr(d, x) for d in drift_of_file()]) for x in ("gyro", "gyro_sd"))
    assert np.all(np.abs(slopes - errors().gyro_slope) < 4 * sds)
    assert sds.mean() < 0.9 * np.mean([d.gyro_sd for d in first])
    assert codes(reports) == ["imu_drift.learned"] * 2


def test_rests_that_contradict_the_file_are_reported_and_change_nothing(window, engine, reports):
    engine.warm_up(1)
    window.drift.learn()
    before = own_path(OWN).read_text()
    engine.warm_up(2, sign=-1.0)
    window.host.stop()
    assert own_path(OWN).read_text() == before
    assert codes(reports) == ["imu_drift.learned", "imu_drift.contradicted"]


def test_nothing_is_learned_at_one_temperature(window, engine, reports):
    engine.warm_up(1)
    engine.packets = engine.packets[: round(3 * RATE_HZ)]
    window.host.stop()
    assert not own_path(OWN).exists() and codes(reports) == []
