"""The guided touch test: the current cue, and when it has been carried out.

A touch is taken when the fingertip rests on the cross for `HELD` s. The wearer can accept a touch
that is not detected, skip a cue, or repeat the one before.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping, Sequence
from enum import Enum

import numpy as np

from app.words import mark, tr
from extensions.touch.pose import SheetPose
from extensions.touch.protocol import STILL, TouchCue, began, ended, protocol, ruler
from extensions.touch.sheet import BY_NAME
from tracker.messages import Array, Event

HELD = 0.6  # s at rest on a cross
STEADY = 0.006  # m by which a resting tip may move
NEAR, HIGH = 0.035, 0.025  # m from the cross and from its paper
LIFTED = 0.020  # m from the last touch before another counts
PINCHING = 25.0  # s for 20 pinches
AWAY = 5.0  # s out of view
AFTER = 0.15  # s from the touch to the end of its cue
Note = Callable[[str, float, Mapping[str, object]], None]

FINGER_WORDS = {"thumb": mark("thumb"), "index": mark("index finger"),
                "middle": mark("middle finger")}  # fmt: skip
HOW_WORDS = {
    "slow": mark("Approach slowly."),
    "fast": mark("Approach quickly."),
    "turned_left": mark("Turn the hand to the left."),
    "turned_right": mark("Turn the hand to the right."),
    "covered": mark("Hold a finger of the other hand over the back of the hand."),
    "away": mark("First take the hand out of view for five seconds."),
}


class TouchPhase(Enum):
    WAITING = "waiting"
    RUNNING = "running"
    DONE = "done"


class TouchRun:
    """Call ``tick`` with a clock's time in s and the tracked tip of the finger asked for.

    ``note`` records the cues. ``done`` are the numbers of cues that were carried out.
    """

    def __init__(self, note: Note, cues: Sequence[TouchCue] | None = None) -> None:
        self._note = note
        self.cues = tuple(protocol() if cues is None else cues)
        self.phase = TouchPhase.WAITING
        self.number = 0
        self.share = 0.0
        self.done: set[int] = set()
        self._pose: SheetPose | None = None
        self._begun = 0.0
        self._tips: deque[tuple[float, Array]] = deque()
        self._last: Array | None = None
        self._touched = float("inf")

    @property
    def cue(self) -> TouchCue:
        """The current cue; the last one at the end."""
        return self.cues[min(self.number, len(self.cues) - 1)]

    def start(self, t: float, pose: SheetPose, length: float) -> None:
        """Begin with the first cue; ``length`` m of the printed line as measured."""
        self.phase, self.number, self._pose = TouchPhase.RUNNING, 0, pose
        self.done = set()
        self._write(ruler(length, t))
        self._begin(t)

    def tick(self, t: float, tip: Array | None) -> None:
        """``tip`` (3,) m in G; None while it is not tracked."""
        if self.phase != TouchPhase.RUNNING:
            return
        if self.cue.what != "touch":
            self._wait(t)
        elif t >= self._touched + AFTER:
            self._end(t, done=True)
        elif np.isinf(self._touched):
            self._watch(t, tip)

    def accept(self, t: float) -> None:
        """The wearer confirms that the cue was carried out."""
        if self.phase == TouchPhase.RUNNING:
            self._end(t, done=True)

    def skip(self, t: float) -> None:
        """Continues without it."""
        if self.phase == TouchPhase.RUNNING:
            self._end(t, done=False)

    def repeat(self, t: float) -> None:
        """Ask for the cue before again."""
        if self.phase == TouchPhase.RUNNING and self.number:
            self._write(ended(self.cue, t, done=False))
            self.number -= 1
            self.done.discard(self.cue.number)
            self._begin(t)

    def cancel(self, t: float) -> None:
        """Stop; what was carried out remains."""
        if self.phase == TouchPhase.RUNNING:
            self._write(ended(self.cue, t, done=False))
            self.phase = TouchPhase.DONE

    def _wait(self, t: float) -> None:
        """Pinches and the still hand last a fixed time."""
        lasts = PINCHING if self.cue.what == "pinch" else STILL
        self.share = (t - self._begun) / lasts
        if self.share >= 1.0:
            self._end(t, done=True)

    def _watch(self, t: float, tip: Array | None) -> None:
        """Take the touch when the tip has rested on the cross long enough."""
        gone = self.cue.how == "away" and t < self._begun + AWAY
        if tip is None or gone or not self._is_on_cross(tip):
            self._tips.clear()
            self.share = 0.0
            return
        self._tips.append((t, tip))
        middle = np.median([p for _, p in self._tips], axis=0)
        if np.linalg.norm(tip - middle) > STEADY:
            self._tips.clear()
            self._tips.append((t, tip))
        self.share = (t - self._tips[0][0]) / HELD
        if self.share >= 1.0:
            self._touched, self._last = t, tip

    def _is_on_cross(self, tip: Array) -> bool:
        assert self._pose is not None
        if self._last is not None:
            if np.linalg.norm(tip - self._last) < LIFTED:
                return False
            self._last = None
        away = tip - self._pose.target(BY_NAME[self.cue.target].p_S)
        up_G = -self._pose.R_GS[:, 2]
        high = float(away @ up_G)
        return abs(high) < HIGH and float(np.linalg.norm(away - high * up_G)) < NEAR

    def _begin(self, t: float) -> None:
        self._begun, self._touched, self.share = t, float("inf"), 0.0
        self._tips.clear()
        self._write(began(self.cue, t))

    def _end(self, t: float, done: bool) -> None:
        self._write(ended(self.cue, t, done))
        if done:
            self.done.add(self.cue.number)
        self.number += 1
        if self.number >= len(self.cues):
            self.phase = TouchPhase.DONE
        else:
            self._begin(t)

    def _write(self, event: Event) -> None:
        self._note(event.text, event.t, event.data)


def cue_words(cue: TouchCue) -> tuple[str, str]:
    """What to do, and how."""
    if cue.what == "pinch":
        return tr("Pinch thumb and index finger 20 times"), tr("About once a second.")
    if cue.what == "still":
        return tr("Hold the hand still for ten seconds"), tr("Rest it on the table.")
    words = tr("Touch cross {} with the {}").format(cue.target, tr(FINGER_WORDS[cue.finger]))
    return words, tr(HOW_WORDS[cue.how])
