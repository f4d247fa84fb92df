"""State of the guided conformance script: the current step and its progress."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from itertools import accumulate

from app.viewmodels.states import BAD, GOOD, WARN, StateLook
from app.words import mark, tr
from extensions.conformance.finding import FAIL, PASS, RuleFinding
from extensions.conformance.take import BEAT, BEATS, GRASPS, OPENS, SCRIPT

OPEN = mark("Hand open, fingers straight")
STEP_WORDS = {
    "open_hand_open": OPEN,
    "fist": mark("A firm fist, the thumb over the fingers"),
    "pinch_index": mark("Thumb on the tip of the index finger"),
    "pinch_middle": mark("Thumb on the tip of the middle finger"),
    "pinch_ring": mark("Thumb on the tip of the ring finger"),
    "pinch_little": mark("Thumb on the tip of the little finger"),
    "wrist_rotate": mark("Turn the open hand from side to side about the forearm"),
    "open_hand_close": OPEN,
}
GRIPPED = mark("A fist, in the grip of the other hand")
GRIPPING = mark("Grip the fist of the other hand")
STEP_NAMES = {
    "open_hand_open": mark("open"),
    "fist": mark("fist"),
    "right_grasps_left_fist": mark("right grips left"),
    "left_grasps_right_fist": mark("left grips right"),
    "pinch_index": mark("index"),
    "pinch_middle": mark("middle"),
    "pinch_ring": mark("ring"),
    "pinch_little": mark("little"),
    "wrist_rotate": mark("turn"),
    "open_hand_close": mark("open"),
}
LAYERS = {
    "signal": mark("Signal"),
    "shape": mark("Shape of the hand"),
    "placement": mark("Placement in the room"),
    "steps": mark("Scripted steps"),
}
RULES = {
    "finite": mark("All positions are numbers"),
    "unit quaternions": mark("Rotations have length 1"),
    "a hand in the records": mark("A hand is tracked"),
    "stamps rise": mark("Time never goes back"),
    "available after sampled": mark("No record is earlier than its measurement"),
    "regular intervals": mark("Regular sampling intervals"),
    "no gaps": mark("No gaps"),
    "joint speed": mark("Plausible joint speeds"),
    "all 21 joints": mark("All 21 joints are present"),
    "the same joints all along": mark("The same joints throughout"),
    "radius": mark("Plausible joint radii"),
    "wrist to middle tip": mark("Hand length, wrist to middle fingertip"),
    "rigid bones": mark("Constant bone lengths"),
    "knuckles in order": mark("Knuckles in order"),
    "joints from root to tip": mark("Joints in order, from knuckle to tip"),
    "fingers bend to the palm": mark("Fingers bend towards the palm"),
    "the wrist is in the room": mark("The wrist is away from the origin"),
    "the wrist is not frozen": mark("The wrist position is not frozen"),
    "−z along the bones, xyzw": mark("Rotations: −z along the bones, order xyzw"),
    "wrist and joints turn together": mark("Wrist and joints turn together"),
    "scripted steps": mark("Steps are labelled"),
    "windows in order": mark("Steps are complete and in order"),
    "windows have records": mark("Every step is recorded"),
    "open_hand_open": mark("Hand open, at the start"),
    "fist": mark("Fist"),
    "right_grasps_left_fist": mark("Right hand grips the left fist"),
    "left_grasps_right_fist": mark("Left hand grips the right fist"),
    "pinch_index": mark("Pinch, thumb and index finger"),
    "pinch_middle": mark("Pinch, thumb and middle finger"),
    "pinch_ring": mark("Pinch, thumb and ring finger"),
    "pinch_little": mark("Pinch, thumb and little finger"),
    "wrist_rotate": mark("Wrist turned from side to side"),
    "open_hand_close": mark("Hand open, at the end"),
}
"""The rules' names in the user's language; others unchanged."""
LOOKS: dict[str, StateLook] = {PASS: GOOD, FAIL: BAD}


class CuePhase(Enum):
    WAITING = "waiting"  # not begun
    COUNTING = "counting"  # the beats before a step
    HOLDING = "holding"
    DONE = "done"


@dataclass(frozen=True)
class StepCue:
    """At an instant: ``beat`` 3, 2, 1 while counting; ``share`` 0..1 of the step that is over."""

    phase: CuePhase
    number: int
    beat: int = 0
    share: float = 0.0


class ScriptRun:
    """Steps follow a clock alone: what is shown is judged afterwards, on what was recorded.

    ``begin(label, t)`` is called once for each step, with the time s of the clock at which its
    window begins.
    """

    def __init__(self, side: str, begin: Callable[[str, float], None]) -> None:
        self._side, self._begin = side, begin
        self.steps = tuple(SCRIPT)
        ends = list(accumulate(BEATS * BEAT + hold for hold in SCRIPT.values()))
        self._starts = [e - hold for e, hold in zip(ends, SCRIPT.values(), strict=True)]
        self._end = ends[-1]
        self._zero = 0.0
        self._begun = 0
        self.cue = StepCue(CuePhase.WAITING, 0)

    @property
    def label(self) -> str:
        """The step that is shown; the last one when all are done."""
        return self.steps[min(self.cue.number, len(self.steps) - 1)]

    @property
    def is_running(self) -> bool:
        return self.cue.phase in (CuePhase.COUNTING, CuePhase.HOLDING)

    @property
    def duration(self) -> float:
        """s."""
        return self._end

    def start(self, t: float) -> None:
        """From the first step on."""
        self._zero, self._begun = t, 0
        self.tick(t, restart=True)

    def cancel(self) -> None:
        """No further step."""
        self.cue = StepCue(CuePhase.DONE, self.cue.number)

    def tick(self, t: float, restart: bool = False) -> None:
        """Look at the clock, s."""
        if not (restart or self.is_running):
            return
        since = t - self._zero
        while self._begun < len(self.steps) and since >= self._starts[self._begun]:
            self._begin(self.steps[self._begun], self._zero + self._starts[self._begun])
            self._begun += 1
        self.cue = self._cue(since)

    def _cue(self, since: float) -> StepCue:
        if since >= self._end:
            return StepCue(CuePhase.DONE, len(self.steps))
        holds = list(SCRIPT.values())
        number = next(k for k, s in enumerate(self._starts) if since < s + holds[k])
        left = self._starts[number] - since
        if left > 0:
            return StepCue(CuePhase.COUNTING, number, min(int(left / BEAT - 1e-9) + 1, BEATS))
        return StepCue(CuePhase.HOLDING, number, 0, -left / holds[number])

    # --- what is shown

    def words(self) -> str:
        """What to do, in the user's language."""
        if self.label in GRASPS:
            words = GRIPPED if GRASPS[self.label] == self._side else GRIPPING
            return tr(words)
        return tr(STEP_WORDS[self.label])

    def drawn(self) -> str:
        """The pose that shows it, of `app.viewmodels.guided_hand.DRAWN`."""
        if self.label in GRASPS:
            return "fist" if GRASPS[self.label] == self._side else "grip"
        named = {"open_hand_open": "flat", "open_hand_close": "flat", "wrist_rotate": "turn"}
        return named.get(self.label, self.label)

    def gesture(self) -> str:
        """What a simulated wearer is to show, of `tracker.simulation.gestures`; empty: nothing."""
        if not self.is_running:
            return ""
        return "open" if self.label in OPENS else self.drawn()

    def chips(self) -> list[tuple[str, str]]:
        """(sign, name) of each step: completed, current or pending."""
        out = []
        for k, label in enumerate(self.steps):
            now = self.is_running and k == self.cue.number
            sign = "▶" if now else "✓" if k < self.cue.number else "○"
            out.append((sign, tr(STEP_NAMES[label])))
        return out


@dataclass(frozen=True)
class FindingRow:
    """One rule as a row of a table."""

    look: StateLook
    layer: str
    rule: str
    figure: str
    limit: str


def finding_row(finding: RuleFinding) -> FindingRow:
    """What was not seen, or is advice, is neither good nor bad."""
    look = LOOKS.get(finding.status, WARN)
    rule = tr(RULES[finding.rule]) if finding.rule in RULES else finding.rule
    if finding.advice and look == BAD:
        look = WARN
    return FindingRow(look, tr(LAYERS[finding.layer]), rule, finding.figure, finding.limit)
