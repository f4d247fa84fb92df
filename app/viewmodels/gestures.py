"""Which gestures the hand shows, in words, and how much of each."""

from __future__ import annotations

from app.engines.engine import EngineSetup
from app.words import mark, tr
from tracker.gestures.recogniser import GestureRecogniser
from tracker.messages import Estimate

WORDS = {
    "pinch_index": mark("pinch, index finger"),
    "pinch_middle": mark("pinch, middle finger"),
    "pinch_ring": mark("pinch, ring finger"),
    "pinch_little": mark("pinch, little finger"),
    "thumb_up": mark("thumb up"),
    "fist": mark("fist"),
    "point": mark("point"),
    "open_palm": mark("open palm"),
    "grasp": mark("grasp"),
    "poke": mark("poke"),
}
UNSURE = 0.5  # a confidence: below it is said that a gesture is inferred
LONGEST_GAP = 0.5  # s between two estimates after which what was shown is forgotten


class ShownGestures:
    """Of one open engine, as the window sees its hand."""

    def __init__(self, setup: EngineSetup) -> None:
        self._setup = setup
        self._forget()

    def _forget(self) -> None:
        hand, glove = self._setup.hand, self._setup.glove
        self._recogniser = GestureRecogniser(hand, glove.keypoint_names(hand))
        self._t = float("-inf")

    def line(self, estimate: Estimate | None) -> str:
        """Those that are shown with the newest estimate, such as ``fist 100 %``."""
        if estimate is None:
            return ""
        if not 0 <= estimate.t - self._t < LONGEST_GAP:
            self._forget()  # a replay was sent elsewhere
        if estimate.t > self._t:
            self._recogniser.feed(estimate)
            self._t = estimate.t
        values, sure = self._recogniser.values, self._recogniser.confidences
        return ", ".join(_said(n, values[n], sure[n]) for n in self._recogniser.active)


def _said(name: str, value: float, sure: float) -> str:
    if sure < UNSURE:
        return tr("{} (low confidence)").format(tr(WORDS[name]))
    return f"{tr(WORDS[name])} {100 * value:.0f} %"
