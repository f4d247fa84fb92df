"""The guided touch test: which cues are recorded, and when a touch counts."""

from __future__ import annotations

import numpy as np

from extensions.touch.pose import SheetPose
from extensions.touch.protocol import TouchCue, cues_of, ruler_of, touches
from extensions.touch.sheet import BY_NAME
from extensions.touch.window.view_model import AFTER, AWAY, HELD, TouchPhase, TouchRun, cue_words
from tracker.messages import Event

R_GS = np.array([[0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
POSE = SheetPose(R_GS, np.array([0.3, 0.1, 0.0]), 1.0, 1e-3, 1.0, True, 0.1, 0.0, 1)
STEP = 0.05


class Session:
    """Collects the run's notes."""

    def __init__(self) -> None:
        self.events: list[Event] = []

    def note(self, text: str, t: float, data) -> None:
        self.events.append(Event(t, "note", text, data))


def on(name: str) -> np.ndarray:
    return POSE.target(BY_NAME[name].p_S)


def rest(run: TouchRun, t: float, tip, seconds: float) -> float:
    """Tick with a still tip; returns the time afterwards."""
    for _ in range(round(seconds / STEP)):
        run.tick(t, tip)
        t += STEP
    return t


def test_a_touch_counts_after_its_rest_on_the_right_cross() -> None:
    session, cues = Session(), touches()[:2]
    run = TouchRun(session.note, cues)
    run.start(0.0, POSE, 0.2605)
    above = on(cues[0].target) + [0.0, 0.0, 0.05]
    t = rest(run, 0.0, above, 2.0)
    t = rest(run, t, on("8"), 2.0)
    t = rest(run, t, None, 1.0)
    assert run.number == 0 and run.phase == TouchPhase.RUNNING
    t = rest(run, t, on(cues[0].target) + [0.01, 0.0, 0.0], HELD + AFTER + 3 * STEP)
    assert run.number == 1 and run.done == {1}
    t = rest(run, t, on(cues[1].target), HELD + AFTER + 3 * STEP)
    assert run.phase == TouchPhase.DONE
    found = cues_of(session.events)
    assert [c.cue for c in found] == cues and ruler_of(session.events) == 0.2605
    assert found[0].end - found[0].begin > 5.0


def test_one_rest_does_not_count_twice() -> None:
    session = Session()
    cues = [TouchCue(1, "touch", "index", "3", "slow"), TouchCue(2, "touch", "index", "3", "fast")]
    run = TouchRun(session.note, cues)
    run.start(0.0, POSE, 0.26)
    t = rest(run, 0.0, on("3"), 4.0)
    assert run.number == 1
    t = rest(run, t, on("3") + [0.0, 0.0, 0.04], 0.2)
    rest(run, t, on("3"), 2.0)
    assert run.phase == TouchPhase.DONE


def test_away_waits_five_seconds() -> None:
    session = Session()
    run = TouchRun(session.note, [TouchCue(1, "touch", "index", "3", "away")])
    run.start(0.0, POSE, 0.26)
    rest(run, 0.0, on("3"), AWAY - 0.5)
    assert run.number == 0
    rest(run, AWAY, on("3"), 2.0)
    assert run.phase == TouchPhase.DONE


def test_skip_accept_repeat_and_end_are_recorded() -> None:
    session, cues = Session(), touches()[:4]
    run = TouchRun(session.note, cues)
    run.start(0.0, POSE, 0.26)
    run.accept(1.0)
    run.skip(2.0)
    run.accept(3.0)
    run.repeat(4.0)
    assert run.cue.number == 3 and run.done == {1}
    run.accept(5.0)
    run.cancel(6.0)
    assert run.phase == TouchPhase.DONE
    found = cues_of(session.events)
    assert [(c.cue.number, c.begin) for c in found] == [(1, 0.0), (3, 4.0)]


def test_every_cue_has_words() -> None:
    words = {cue_words(cue) for cue in TouchRun(Session().note).cues}
    assert len(words) > 20 and all(a and b for a, b in words)
