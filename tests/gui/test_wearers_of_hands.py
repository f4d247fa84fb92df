"""Whose calibration each hand starts with: gloves and the demo, left and right, are never mixed."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from app.engines.engine import EngineSetup
from app.storage.settings import wearer_of
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup, simulation
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.params import ChainParams
from tracker.glove import library

FILES = {"right": ("vist-small", "reference-right"), "left": ("vist-small-left", "reference-left")}


class Worn(ScriptedEngine):
    """An engine whose calibration is a chain filter's, of the hand of ``side``."""

    def __init__(self, side: str) -> None:
        super().__init__()
        self.hand, self.glove = library.load(*FILES[side])
        self.inner = ChainEngine(self.hand, self.glove, simulation().rig, ChainParams())

    def calibration(self):
        return self.inner.calibration()

    def command(self, work, answer=None) -> None:
        result = work(self.inner)
        if answer is not None:
            answer(result)

    def learn(self, scale: float) -> None:
        profile = self.inner.profile()
        learned = dataclasses.replace(profile, scale=np.full_like(profile.scale, scale))
        self.inner.apply_profile(dataclasses.replace(learned, P=profile.P / 16))

    @property
    def scale(self) -> float:
        return float(self.inner.calibration().scale.mean())

    def setup(self, simulated: bool) -> EngineSetup:
        return dataclasses.replace(
            scripted_setup(self),
            hand=self.hand,
            glove=self.glove,
            simulated=simulated,
        )


@pytest.fixture
def open_hand(window, qtbot):
    """Opens the glove of a side, simulated or real, as the window does; the engine."""

    def open_(side: str, simulated: bool = False) -> Worn:
        engine = Worn(side)
        window.host.adopt(engine.setup(simulated))
        assert window.host.setup.side == side
        return engine

    return open_


def save(window, qtbot, engine: Worn, name: str, scale: float) -> str:
    """The name that what the engine has learned is saved under."""
    engine.learn(scale)
    with qtbot.waitSignal(window.calibration.profiles.kept):
        window.calibration.profiles.save(name)
    return window.calibration.wearer.name


def offered(window) -> list[str]:
    choice = window.calibration.wearer.choice
    return [choice.itemText(i) for i in range(1, choice.count())]


@pytest.mark.long
def test_the_demo_has_wearers_of_its_own(window, qtbot, open_hand, store):
    row = window.calibration.wearer
    assert save(window, qtbot, open_hand("right"), "Anna", 1.04) == "Anna"
    demo = open_hand("right", simulated=True)
    assert row.name == "" and offered(window) == [] and demo.scale == pytest.approx(1.0)
    assert save(window, qtbot, demo, "Simulated", 0.97) == "Simulated"
    for _ in range(2):
        real = open_hand("right")
        assert row.name == "Anna" and offered(window) == ["Anna"]
        assert real.scale == pytest.approx(1.04)
        demo = open_hand("right", simulated=True)
        assert row.name == "Simulated" and offered(window) == ["Simulated"]
        assert demo.scale == pytest.approx(0.97)
    window.calibration.profiles.wear("")  # somebody new, in the demo alone
    open_hand("right")
    assert row.name == "Anna" and (
        wearer_of(store.value, "right"),
        wearer_of(store.value, "right", True),
    ) == ("Anna", "")


@pytest.mark.long
def test_left_and_right_gloves_used_in_turn_keep_their_wearers(window, qtbot, open_hand):
    row = window.calibration.wearer
    save(window, qtbot, open_hand("right"), "Anna", 1.04)
    left = open_hand("left")
    assert row.name == "" and offered(window) == [] and left.scale == pytest.approx(1.0)
    stored = save(window, qtbot, left, "Anna", 0.98)
    assert stored == "Anna vist-small-left"  # the right hand's file of that name is not replaced
    for _ in range(2):
        assert open_hand("right").scale == pytest.approx(1.04) and row.name == "Anna"
        assert open_hand("left").scale == pytest.approx(0.98) and row.name == stored
    assert not window.banner.isVisible()


@pytest.mark.long
def test_both_hands_of_the_demo_start_with_their_own_wearers(window, qtbot, open_hand):
    save(window, qtbot, open_hand("right"), "Anna", 1.04)
    save(window, qtbot, open_hand("right", simulated=True), "Simulated", 0.97)
    right, left = Worn("right"), Worn("left")
    both = dataclasses.replace(right.setup(True), others=(left.setup(True),))
    window.host.adopt(both)
    assert (right.scale, left.scale) == (pytest.approx(0.97), pytest.approx(1.0))
    assert not window.banner.isVisible()
    window.host.show_hand("left")
    assert window.calibration.wearer.name == "" and offered(window) == []


def test_a_left_wearer_of_an_earlier_version_comes_back(window, qtbot, open_hand, store):
    save(window, qtbot, open_hand("left"), "Bea", 0.98)
    store.update(wearers={"right": "Bea"})  # one setting served the glove of either side
    assert open_hand("left").scale == pytest.approx(0.98)
    window.calibration.profiles.wear("")
    assert open_hand("left").scale == pytest.approx(1.0)
    assert (wearer_of(store.value, "right"), wearer_of(store.value, "left")) == ("", "")
