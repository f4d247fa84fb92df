"""A conformance take: cues by the clock, notes in the file, the verdict and its page."""

import dataclasses
import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QObject, Qt, QUrl, Slot
from PySide6.QtGui import QDesktopServices

from app.engines.recording import PausableRecorder
from app.viewmodels.guided_hand import DRAWN, DrawnHand
from extensions.conformance.run import WARM_UP, cues
from extensions.conformance.take import BEAT, BEATS, GRASPS, SCRIPT
from extensions.conformance.window.view_model import CuePhase, ScriptRun
from resources import folder
from tests.gui.gui_fakes import ScriptedEngine, models, scripted_setup, simulation, with_live
from tracker.base.clock import ClockAnchor
from tracker.geometry import so3
from tracker.messages import Estimate, Tracking
from tracker.session.description import SessionInfo
from tracker.session.writer import RecorderParams, SessionRecorder
from tracker.simulation.gestures import Gestures
from tracker.simulation.motion import Poses

HZ = 25


@cache
def poses_of_script(hand, shown) -> Poses:
    """At `HZ`, made once for all tests."""
    motion = Gestures(hand, shown, seed=4)
    return motion.poses(np.arange(0.0, motion.duration, 1 / HZ))


class Clock:
    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


class Follower(ScriptedEngine):
    """A simulated wearer who shows the script from the moment ``began`` (s) on, a metre above the
    floor; ``lazy``: whose hand stays open. Without measurement errors."""

    def __init__(self, clock: Clock) -> None:
        super().__init__()
        hand, self.glove, _ = models()
        shown, _ = cues(hand.side)
        self.hand, self.clock, self.began, self.lazy = hand, clock, np.inf, False
        self.poses = poses_of_script(hand, tuple(shown[len(WARM_UP) :]))
        self.written = 0

    def go_on(self) -> None:
        """Records the estimates up to now."""
        if self.recorder is None:
            return
        while self.began + self.written / HZ <= self.clock.now:
            self.recorder.write(self.estimate(self.written / HZ))
            self.written += 1

    def estimate(self, t: float) -> Estimate:
        row = 0 if self.lazy else min(round(t * HZ), len(self.poses.angles) - 1)
        angles, R, p = (x[row] for x in self.poses)
        R_GB, p_GB = self.hand.forward(angles, R, p + [0.0, 0.0, 1.0])
        names = self.glove.keypoint_names(self.hand)
        points = self.glove.keypoint_positions(self.hand, R_GB, p_GB, np.ones((len(R_GB), 3)))
        q = so3.quat_from_matrix(R_GB[self.glove.keypoint_segments(self.hand)])
        return Estimate(
            self.began + t, Tracking.TRACKING, points, q, np.full(len(names), 2),
            np.full(len(names), 1e-3), angles, np.full(len(angles), 2), R_GB, p_GB,
        )  # fmt: skip


def recorder_of(clock: Clock):
    """Real sessions."""
    hand, glove, _ = models()
    text = {k: folder(k) for k in ("hands", "gloves")}

    def make(request):
        info = SessionInfo(
            hand, glove, (text["hands"] / "reference-right.toml").read_text("utf-8"),
            (text["gloves"] / "vist-small.toml").read_text("utf-8"),
            ClockAnchor(1_760_000_000_000_000_000, round(clock.now * 1e9)),
            rig=simulation().rig, participant=request.participant, notes=request.task,
            simulated=True,
        )  # fmt: skip
        params = RecorderParams(images="none", sync=False)
        return PausableRecorder(SessionRecorder(request.path, info, params))

    return make


@pytest.fixture
def clock(monkeypatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr("extensions.conformance.window.dialog.monotonic", clock)
    return clock


@pytest.fixture
def engine(clock) -> Follower:
    return Follower(clock)


@pytest.fixture
def dialog(window, engine, clock, tmp_path, qtbot):
    """Opened from the menu, on an engine that records into ``tmp_path / "takes"``."""
    setup = with_live(scripted_setup(engine, []), make_recorder=recorder_of(clock))
    assert not window.commands.actions["conformance"].isEnabled()
    window.host.adopt(setup)
    takes = tmp_path / "takes"
    takes.mkdir()
    window.recording.set_folder(takes)
    window.commands.actions["conformance"].trigger()
    dialog = window.set_up.dialogs["conformance"]
    dialog._timer.stop()  # the test is the clock
    return dialog


def through(dialog, clock, engine, until: float = np.inf) -> None:
    """Show the script from its start on."""
    engine.began = clock.now
    while dialog.run.is_running and clock.now < engine.began + until:
        clock.now += 0.8
        engine.go_on()
        dialog.tick()


def verdict(dialog, qtbot) -> dict[str, list[str]]:
    """The cells of each rule's row."""
    qtbot.waitUntil(lambda: dialog.outcome.page_button.isEnabled())
    table = dialog.outcome.table
    rows = [[table.item(i, j).text() for j in range(5)] for i in range(table.rowCount())]
    return {row[2]: row for row in rows}


class Browser(QObject):
    def __init__(self) -> None:
        super().__init__()
        self.urls: list[QUrl] = []

    @Slot(QUrl)
    def show(self, url: QUrl) -> None:
        self.urls.append(url)


@pytest.mark.long
def test_a_wearer_who_follows_the_cues_keeps_every_rule(dialog, clock, engine, tmp_path, qtbot):
    qtbot.mouseClick(dialog.lead.start, Qt.MouseButton.LeftButton)
    through(dialog, clock, engine)
    rows = verdict(dialog, qtbot)
    assert dialog.outcome.heading.text() == "All rules passed", rows
    assert len(rows) > 30 and all(row[0] == "● good" for row in rows.values())
    assert rows["Fist"][3].startswith("straightness 0.") and rows["Fist"][4] == "≤ 0.60"
    (take,) = (tmp_path / "takes").glob("*.mcap")
    labels = json.loads(take.with_name(f"{take.stem}.labels.json").read_text())
    assert [s["label"] for s in labels["steps"]] == list(SCRIPT)
    browser = Browser()
    QDesktopServices.setUrlHandler("file", browser, "show")
    try:
        qtbot.mouseClick(dialog.outcome.page_button, Qt.MouseButton.LeftButton)
    finally:
        QDesktopServices.unsetUrlHandler("file")
    (page,) = [Path(url.toLocalFile()) for url in browser.urls]
    assert page.parent == take.parent and "All rules passed." in page.read_text("utf-8")


@pytest.mark.long
def test_a_hand_that_stays_open_fails_in_the_steps_that_it_did_not_show(
    dialog, clock, engine, qtbot, monkeypatch
):
    engine.lazy = True
    # empty images, because no test reads them; those of a wearer who follows the cues are painted
    monkeypatch.setattr(dialog.lead.stage.view, "render_scene", lambda: None)
    dialog.start()
    through(dialog, clock, engine)
    rows = verdict(dialog, qtbot)
    assert dialog.outcome.heading.text() == "Not all rules passed"
    bad = {rule for rule, row in rows.items() if row[0] == "▲ problem"}
    failed = {"Fist", "Pinch, thumb and index finger", "Wrist turned from side to side"}
    assert failed <= bad and "Hand open, at the start" not in bad
    assert not [rule for rule in rows if "_" in rule], "rules have plain names"
    assert next(iter(rows)) in bad, "what is not kept comes first"


@pytest.mark.long
def test_cues_count_three_beats_and_then_hold(dialog, clock, engine):
    dialog.start()
    seen = []
    for _ in range(14):
        seen.append((dialog.run.cue.phase, dialog.lead.beat.text(), dialog.lead.words.text()))
        clock.now += 0.4
        dialog.tick()
    assert [beat for _, beat, _ in seen[:6]] == ["3", "3", "2", "2", "1", "1"]
    assert seen[7][0] == CuePhase.HOLDING and seen[7][1] == "Hold it"
    assert seen[0][2] == seen[7][2] == "Hand open, fingers straight"
    assert 0.2 < dialog.lead.stage.ring.share < 1.0
    clock.now += 4.0
    dialog.tick()
    assert dialog.run.label == "fist" and dialog.lead.stage.pose == "fist"
    assert "▶ fist" in dialog.lead.chips.text() and "✓ open" in dialog.lead.chips.text()


@pytest.mark.long
def test_the_take_is_a_recording_that_ends_with_the_dialog(dialog, window, clock, engine, tmp_path):
    dialog.start()
    through(dialog, clock, engine, until=8.0)
    assert window.host.recording.request is not None
    dialog.reject()
    window.host.recording.poll()
    assert window.host.recording.request is None
    assert [p.suffix for p in (tmp_path / "takes").iterdir()] == [".mcap"]


def test_another_recording_is_not_disturbed(dialog, window, clock):
    window.commands.actions["record"].trigger()
    other = window.host.recording.request
    said = []
    window.host.error.connect(said.append)
    dialog.start()
    assert window.host.recording.request is other and not dialog.run.is_running
    assert said == ["Stop the current recording first."]
    dialog.close()
    assert window.host.recording.request is other


@pytest.mark.parametrize("side", ["left", "right"])
def test_each_side_gets_its_own_part_of_the_grips(side):
    begun: list[tuple[str, float]] = []
    run = ScriptRun(side, lambda label, t: begun.append((label, t)))
    run.start(7.0)
    written, t = {}, 7.0
    while run.is_running:
        written[run.label] = (run.words(), run.drawn())
        t += 0.2
        run.tick(t)
    assert [label for label, _ in begun] == list(SCRIPT)
    wanted, at = [], 7.0
    for hold in SCRIPT.values():
        wanted.append(at + BEATS * BEAT)
        at = wanted[-1] + hold
    assert [t for _, t in begun] == pytest.approx(wanted)
    for label, whose in GRASPS.items():
        fist = whose == side
        assert written[label][1] == ("fist" if fist else "grip")
        assert written[label][0].startswith("A fist" if fist else "Grip")
    assert {drawn for _, drawn in written.values()} <= DRAWN.keys()


def test_the_drawn_hand_turns_from_side_to_side():
    drawn = DrawnHand(models()[0])
    root = models()[0].root
    ups = [drawn.shown("flat", "turn", 0.9 + t).R[root][:, 2] for t in np.arange(0, 3, 0.05)]
    apart = np.rad2deg(np.arccos(np.clip(np.array(ups) @ np.array(ups).T, -1, 1)))
    assert apart.max() > 120


@pytest.mark.long
@pytest.mark.parametrize(("simulated", "words"), [(True, "do not follow"), (False, "First open")])
def test_a_simulated_wearer_who_does_not_follow_is_reported(window, engine, simulated, words):
    setup = dataclasses.replace(scripted_setup(engine), simulated=simulated)
    window.host.adopt(setup)
    window.commands.actions["conformance"].trigger()
    assert words in window.set_up.dialogs["conformance"].lead.notes.text()
