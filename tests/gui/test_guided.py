"""Guided calibration with the keyboard: poses evaluated from given estimates, events in the file
and for the engine, and whether results are kept or undone."""

import dataclasses

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.viewmodels.guided import GuidedPhase
from app.viewmodels.guided_hand import DrawnHand
from tests.gui.gui_fakes import ScriptedEngine, models, scripted_setup, simulation
from tracker.base.errors import GlovetrackError
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.guided.events import KIND, began, ended
from tracker.fusion.chain.params import ChainParams
from tracker.hand.poses import POSES
from tracker.messages import Event, Tracking, Validity
from tracker.simulation.postures import posture


class Posed(ScriptedEngine):
    """A tracked hand with the given ``angles`` (J,), and a filter that executes commands."""

    def __init__(self) -> None:
        super().__init__()
        hand, glove, _ = models()
        self.inner = ChainEngine(hand, glove, simulation().rig, ChainParams())
        self.drawn = DrawnHand(hand)
        self.angles = posture(hand, {})
        self.reported: list[tuple[str, str, bool]] = []
        self.silent, self._t = False, 0.0
        self.tracking = Tracking.TRACKING
        self.unsensed: tuple[str, ...] = ()  # unmeasured digits

    def latest_estimate(self):
        self._t += 0.0 if self.silent else 0.01
        hand = models()[0]
        R, p = hand.forward(self.angles, np.eye(3), np.array([0.4, 0.0, 0.1]))
        sensed = np.full(len(self.angles), int(Validity.MEASURED), np.int64)
        for name, column in hand.angle_index.items():
            if name.startswith(self.unsensed):
                sensed[column] = int(Validity.INFERRED)
        return dataclasses.replace(
            super().latest_estimate(),
            t=self._t,
            tracking=self.tracking,
            angles=self.angles,
            segment_R=R,
            segment_p=p,
            angle_state=sensed,
        )

    def command(self, work, answer=None) -> None:
        try:
            result = work(self.inner)
            if answer is not None:
                answer(result)
        except GlovetrackError as error:
            self.events.append(Event(0.0, "error", str(error)))

    def hold(self, pose: str) -> None:
        self.reported.append((pose, "begin", False))
        self._write(began(pose, self._t))

    def let_go(self, pose: str, held: bool) -> None:
        self.reported.append((pose, "end", held))
        self._write(ended(pose, self._t, held))

    def _write(self, event: Event) -> None:
        self.events.append(event)
        if self.recorder is not None:
            self.recorder.write(event)

    def take(self, pose: str) -> None:
        """Hold the hand as in the drawing."""
        self.angles = self.drawn.angles(pose)


class Clock:
    """The dialog's clock, which the test advances without waiting."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def engine() -> Posed:
    return Posed()


@pytest.fixture
def clock(monkeypatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr("app.wizards.guided.dialog.monotonic", clock)
    return clock


@pytest.fixture
def recorders() -> list:
    return []


@pytest.fixture
def guided(window, engine, clock, recorders, qtbot, monkeypatch):
    """The dialog, opened by its key."""
    window.host.adopt(scripted_setup(engine, recorders))
    with qtbot.waitActive(window):
        window.activateWindow()
    qtbot.keyClick(window, Qt.Key.Key_F6)
    dialog = window.set_up.dialogs["guided"]
    dialog._timer.stop()  # the test is the clock
    # hundreds of hands that no test looks at; those of conformance and the demo are drawn
    monkeypatch.setattr(dialog.lead.stage, "refresh", lambda *_, **__: None)
    with qtbot.waitActive(dialog):
        dialog.activateWindow()
    return dialog


def pass_time(dialog, clock, seconds: float, step: float = 0.05) -> None:
    for _ in range(round(seconds / step)):
        clock.now += step
        dialog.tick()


def through(dialog, clock, engine) -> None:
    """Hold each pose well as soon as it is requested."""
    while dialog.run.is_running:
        engine.take(dialog.run.pose)
        pass_time(dialog, clock, 0.1, step=0.1)  # half a minute of ticks costs seconds


def test_well_held_poses_begin_and_end_within_half_a_minute(guided, clock, engine, qtbot):
    qtbot.keyClick(guided.lead.start, Qt.Key.Key_Return)
    began_at = clock.now
    through(guided, clock, engine)
    reported = [(pose, phase, phase == "end") for pose in POSES for phase in ("begin", "end")]
    assert engine.reported == reported
    assert 25.0 < clock.now - began_at < 35.0


def test_a_recording_contains_the_poses_as_specified(
    guided, window, clock, engine, recorders, tmp_path
):
    window.recording.set_folder(tmp_path)
    window.commands.actions["record"].trigger()
    guided.start()
    engine.take("flat")
    pass_time(guided, clock, 3.6)
    window.commands.actions["record"].trigger()
    events = [m for m in recorders[0].messages if isinstance(m, Event) and m.kind == KIND]
    assert [e.data for e in events] == [
        {"pose": "flat", "phase": "begin"},
        {"pose": "flat", "phase": "end", "held": True},
    ]
    assert events[0].text and not events[1].text


def test_a_bent_finger_is_named_and_the_ring_remains_empty(guided, clock, engine):
    guided.start()
    engine.angles = posture(models()[0], {"middle_pip_flexion": 45.0})
    pass_time(guided, clock, 4.0)
    assert guided.lead.word.text() == "Straighten the middle finger"
    assert guided.lead.stage.ring.share == 0.0 and engine.reported == []


def test_a_pose_released_too_early_is_not_held_and_requested_again(guided, clock, engine):
    guided.start()
    engine.take("flat")
    pass_time(guided, clock, 2.5)
    assert 0.3 < guided.lead.stage.ring.share < 0.7
    engine.take("fist")
    pass_time(guided, clock, 0.6)
    assert engine.reported == [("flat", "begin", False), ("flat", "end", False)]
    assert guided.run.pose == "flat" and guided.lead.stage.ring.share == 0.0
    assert guided.lead.word.text().startswith("Straighten")


def test_skipping_omits_a_pose_and_records_it(guided, clock, engine, qtbot):
    guided.start()
    pass_time(guided, clock, 0.2)
    qtbot.keyClick(guided, Qt.Key.Key_S)
    assert engine.reported == [("flat", "begin", False), ("flat", "end", False)]
    assert guided.run.pose == "spread"


def test_repeating_returns_to_the_previous_pose(guided, clock, engine, qtbot):
    guided.start()
    engine.take("flat")
    pass_time(guided, clock, 3.7)
    assert guided.run.pose == "spread"
    qtbot.keyClick(guided, Qt.Key.Key_R)
    assert guided.run.pose == "flat"
    pass_time(guided, clock, 3.7)
    assert [t for t in engine.reported if t[0] == "flat"] == 2 * [
        ("flat", "begin", False),
        ("flat", "end", True),
    ]


def test_enter_accepts_a_pose_that_is_not_recognised(guided, clock, engine, qtbot):
    guided.start()
    engine.take("fist")
    pass_time(guided, clock, 2.0)
    qtbot.keyClick(guided.lead.insist, Qt.Key.Key_Return)
    pass_time(guided, clock, 2.1)
    assert engine.reported == [("flat", "begin", False), ("flat", "end", True)]


def test_a_pose_that_is_never_held_is_skipped_after_a_while(guided, clock, engine):
    guided.start()
    engine.take("fist")
    pass_time(guided, clock, 14.0)
    assert guided.run.held["flat"] is False and guided.run.pose == "spread"


def test_a_glove_without_data_is_reported(guided, clock, engine, monkeypatch):
    guided.start()
    engine.take("flat")
    guided.run._judge._clock = clock
    pass_time(guided, clock, 0.5)
    engine.silent = True
    pass_time(guided, clock, 3.0)
    assert guided.lead.word.text() == "No data from the glove"
    assert guided.run.phase == GuidedPhase.REACHING


def test_escape_ends_it_and_ends_the_pose_in_the_engine(guided, clock, engine, qtbot):
    guided.start()
    engine.take("flat")
    pass_time(guided, clock, 2.5)
    qtbot.keyClick(guided, Qt.Key.Key_Escape)
    assert engine.reported == [("flat", "begin", False), ("flat", "end", False)]
    assert not guided.isVisible()


def test_escape_after_held_poses_shows_their_result(guided, clock, engine, qtbot):
    guided.start()
    engine.take("flat")
    pass_time(guided, clock, 3.7)
    qtbot.keyClick(guided, Qt.Key.Key_Escape)
    assert guided.pages.currentWidget() is guided.outcome
    qtbot.waitUntil(lambda: guided.outcome.store_button.isEnabled())
    assert guided.outcome.heading.text() == "1 of 8 poses held"


def teach(engine: ChainEngine, degrees: float, sure: float = 0.5) -> None:
    """As if a pose had shown that the index finger's end joint bends further; the standard
    deviations of its parameters are multiplied by ``sure``."""
    guided = engine.wearer.guided
    own = guided.synergies
    digit = next(k for k, d in enumerate(engine.wearer._distal.digits) if d.name == "index")
    value, P = own.value.copy(), own.P.copy()
    value[digit, 1] += np.deg2rad(degrees)
    P[3 * digit : 3 * digit + 3] *= sure**2  # it is uncorrelated with the others
    guided.saved.synergies = dataclasses.replace(own, value=value, P=P)


def finished(guided, clock, engine, qtbot) -> None:
    guided.start()
    qtbot.waitUntil(lambda: guided._before is not None)
    through(guided, clock, engine)
    teach(engine.inner, 20.0)
    qtbot.waitUntil(lambda: guided.outcome.store_button.isEnabled())


@pytest.mark.long
def test_learned_parameters_are_reported_as_text_and_figures(guided, clock, engine, qtbot):
    finished(guided, clock, engine, qtbot)
    words = guided.outcome.words.text()
    assert "The end joint of your index finger bends 20° more than estimated before." in words
    table = guided.outcome.table
    row = next(
        r for r in range(table.rowCount()) if "index finger, bent" in table.item(r, 0).text()
    )
    (before, sd_before), (after, sd_after) = (
        (float(x) for x in table.item(row, c).text().split("° ± ")) for c in (1, 2)
    )
    assert after - before == pytest.approx(20.0, abs=0.11)  # one decimal of each
    p = ChainParams().synergy
    # The standard deviation between people in a fist, from where they agree best.
    bent = np.hypot(p.ratio * (90.0 - p.middle_deg), p.offset_deg)
    assert sd_before == pytest.approx(bent, abs=0.06)
    assert sd_after == pytest.approx(bent / 2, abs=0.06)
    assert table.item(row, 3).text() == "▲ +20.0°"


@pytest.mark.long
def test_undo_reverts_what_the_poses_have_taught(guided, clock, engine, qtbot):
    before = engine.inner.wearer.synergies[0].copy()
    finished(guided, clock, engine, qtbot)
    assert np.abs(engine.inner.wearer.synergies[0] - before).max() > np.deg2rad(5.0)
    guided.outcome.undo_button.click()
    np.testing.assert_array_equal(engine.inner.wearer.synergies[0], before)
    assert not guided.isVisible()


@pytest.mark.long
def test_kept_results_remain_in_the_engine(guided, clock, engine, qtbot):
    finished(guided, clock, engine, qtbot)
    taught = engine.inner.wearer.synergies[0].copy()
    qtbot.keyClick(guided.outcome.store_button, Qt.Key.Key_Return)
    np.testing.assert_array_equal(engine.inner.wearer.synergies[0], taught)


def test_kept_results_are_saved_in_the_selected_wearers_profile(
    guided, window, clock, engine, qtbot
):
    window.calibration.profiles.save("Anna")
    row = window.calibration.wearer
    qtbot.waitUntil(lambda: row.name == "Anna")
    file = window.calibration.profiles.current._store.path("Anna")
    before = file.read_text("utf-8")
    finished(guided, clock, engine, qtbot)
    guided.outcome.store_button.click()
    qtbot.waitUntil(lambda: file.read_text("utf-8") != before)


@pytest.mark.long
def test_kept_results_of_a_new_wearer_are_offered_to_be_saved(guided, window, clock, engine, qtbot):
    finished(guided, clock, engine, qtbot)
    guided.outcome.store_button.click()
    assert "until this session ends" in window.banner.text()


def test_the_calibration_panel_and_the_set_up_list_lead_to_it(guided, window):
    guided.close()
    window.calibration.wearer.guided_button.click()
    assert window.set_up.dialogs["guided"].isVisible()
    window.set_up.dialogs["guided"].close()
    window.checklist.action.emit("guided")
    assert window.set_up.dialogs["guided"].isVisible()


def test_it_ends_when_tracking_stops(guided, window, clock, engine):
    guided.start()
    engine.take("flat")
    pass_time(guided, clock, 2.0)
    window.host.stop()
    assert engine.reported[-1] == ("flat", "end", False) and not guided.isVisible()


def test_without_a_learning_engine_it_cannot_be_started(window, engine):
    window.store.update(engine="vist")
    window.host.adopt(scripted_setup(engine))
    window.run_command("guided")
    assert "guided" not in window.set_up.dialogs
    assert "chain" in window.banner.text()


def rows_of(dialog) -> dict[str, list[str]]:
    table = dialog.outcome.table
    texts = [[table.item(r, c).text() for c in range(4)] for r in range(table.rowCount())]
    return {what: rest for what, *rest in texts}


@pytest.mark.long
def test_an_insignificant_change_is_not_reported(guided, clock, engine, qtbot):
    guided.start()
    qtbot.waitUntil(lambda: guided._before is not None)
    through(guided, clock, engine)
    teach(engine.inner, 6.0, sure=0.9)  # of 8.2° standard deviation between people in a fist
    qtbot.waitUntil(lambda: guided.outcome.store_button.isEnabled())
    summary = guided.outcome.words.text()
    assert summary == "Your fingers bend as expected."
    assert rows_of(guided)["End joint of the index finger, bent"][2] == "+6.0°"


@pytest.mark.long
def test_no_result_is_reported_for_fingers_without_sensors(guided, clock, engine, qtbot):
    """They bend like index and middle finger, and are not measured."""
    finished(guided, clock, engine, qtbot)
    assert not [what for what in rows_of(guided) if "ring" in what or "little" in what]
    assert "ring" not in guided.outcome.words.text()


def test_an_unmeasured_finger_is_not_reported_as_held_well(guided, clock, engine):
    guided.start()
    engine.unsensed = ("ring",)
    while guided.run.pose != "pinch_ring":
        guided.run.skip(clock.now)
    pass_time(guided, clock, 2.0)
    assert guided.run.phase == GuidedPhase.HOLDING
    assert guided.lead.word.text() == "Hold it: this finger has no sensor"


def test_an_untracked_hand_is_waited_for(guided, clock, engine):
    """Neither an unplugged glove nor a hand out of view is a pose that cannot be held."""
    guided.start()
    engine.silent = True
    pass_time(guided, clock, 60.0, step=0.2)
    assert guided.run.pose == "flat" and guided.run.held == {}
    assert guided.lead.word.text() == "No data from the glove"
    engine.silent, engine.tracking = False, Tracking.SEARCHING
    pass_time(guided, clock, 60.0, step=0.2)
    assert guided.run.held == {}
    assert guided.lead.word.text() == "Show the hand to the camera"
    engine.tracking = Tracking.TRACKING
    engine.take("flat")
    pass_time(guided, clock, 4.0)
    assert guided.run.held == {"flat": True}


def test_accepting_a_pose_requires_a_tracked_hand(guided, clock, engine, qtbot):
    """The engine would learn from nothing: the glove is unplugged, its images continue."""
    engine.take("fist")
    guided.start()
    pass_time(guided, clock, 2.0)
    engine.unsensed = ("thumb", "index", "middle", "ring", "little", "wrist")
    pass_time(guided, clock, 0.2)
    assert guided.lead.word.text() == "No data from the glove"
    qtbot.keyClick(guided, Qt.Key.Key_Return)
    pass_time(guided, clock, 20.0, step=0.2)
    assert engine.reported == [] and guided.run.held == {}
    engine.unsensed = ()
    pass_time(guided, clock, 0.2)
    qtbot.keyClick(guided, Qt.Key.Key_Return)
    pass_time(guided, clock, 1.0)
    engine.unsensed = ("thumb", "index", "middle", "ring", "little", "wrist")
    pass_time(guided, clock, 3.0)  # unplugged in the middle
    assert guided.run.held == {} and engine.reported[-1] == ("flat", "end", False)


def test_it_ends_when_tracking_stops_also_after_held_poses(guided, window, clock, engine):
    """There is no engine any more that could report what they taught."""
    guided.start()
    engine.take("flat")
    pass_time(guided, clock, 6.0)
    assert guided.run.held == {"flat": True}
    window.host.stop()
    assert not guided.isVisible() and "guided" not in window.set_up.dialogs


def test_closing_the_window_during_a_pose_leaves_nothing_behind(guided, window, clock, engine):
    guided.start()
    engine.take("flat")
    pass_time(guided, clock, 6.0)
    window.close()
    assert not guided.isVisible() and window.set_up.dialogs == {}
    assert not guided.run.is_running


def test_another_engine_ends_it(guided, window, clock, engine):
    guided.start()
    engine.take("flat")
    pass_time(guided, clock, 6.0)
    window.host.set_engine("vist")
    assert not guided.isVisible()


def test_a_frozen_calibration_reports_that_poses_have_no_effect(guided, clock, engine, qtbot):
    engine.inner.wearer.freeze(True)
    guided.start()
    qtbot.waitUntil(lambda: guided.pages.currentWidget() is guided.outcome)
    assert "frozen" in guided.outcome.words.text() and not guided.run.is_running
    engine.inner.wearer.freeze(False)
    guided.outcome.again_button.click()
    assert guided.leads and guided.run.is_running
    qtbot.waitUntil(lambda: guided._before is not None)


@pytest.mark.long
def test_repeating_and_ending_at_once_still_shows_the_earlier_result(guided, clock, engine, qtbot):
    finished(guided, clock, engine, qtbot)
    guided.outcome.again_button.click()
    while guided.run.is_running:
        guided.run.skip(clock.now)
    guided.tick()
    qtbot.waitUntil(lambda: guided.outcome.store_button.isEnabled())
    assert guided.outcome.heading.text() == "0 of 8 poses held"
    assert "index finger bends 20° more" in guided.outcome.words.text()


@pytest.fixture
def both(window, clock, qtbot, monkeypatch):
    """The dialog for the right one of two hands, each with its own engine."""
    right, left = Posed(), Posed()
    setups = [scripted_setup(e) for e in (right, left)]
    glove = dataclasses.replace(setups[1].glove, side="left")
    other = dataclasses.replace(setups[1], glove=glove, engine=right)
    window.host.adopt(dataclasses.replace(setups[0], others=(other,)))
    window.run_command("guided")
    dialog = window.set_up.dialogs["guided"]
    dialog._timer.stop()
    monkeypatch.setattr(dialog.lead.stage, "refresh", lambda *_, **__: None)
    return dialog, right, left


@pytest.mark.long
def test_with_two_hands_it_applies_to_the_one_it_was_started_for(both, window, clock, qtbot):
    """Whichever the window shows by the time the poses are held, kept or undone."""
    dialog, right, left = both
    assert dialog.windowTitle() == "Guided calibration, right hand"
    before = right.inner.wearer.synergies[0].copy()
    window.host.show_hand("left")
    finished(dialog, clock, right, qtbot)
    assert "index finger bends 20° more" in dialog.outcome.words.text()
    assert left.reported == []
    dialog.outcome.undo_button.click()
    np.testing.assert_array_equal(right.inner.wearer.synergies[0], before)
