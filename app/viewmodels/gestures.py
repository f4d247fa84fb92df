"""The gestures that the hand shows, as text with their strengths."""

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
UNSURE = 0.5  # confidence below which a gesture is marked as uncertain
LONGEST_GAP = 0.5  # s between two estimates after which previous gestures are discarded


class ShownGestures:
    """The gestures of one hand of the open engine."""

    def __init__(self, setup: EngineSetup) -> None:
        self._setup = setup
        self._forget()

    def _forget(self) -> None:
        hand, glove = self._setup.hand, self._setup.glove
        self._recogniser = GestureRecogniser(hand, glove.keypoint_names(hand))
        self._t = float("-inf")

    def line(self, estimate: Estimate | None) -> str:
        """Gestures of the newest estimate, such as ``fist 100 %``."""
        if estimate is None:
            return ""
        if not 0 <= estimate.t - self._t < LONGEST_GAP:
            self._forget()  # the replay position has changed
        if estimate.t > self._t:
            self._recogniser.feed(estimate)
            self._t = estimate.t
        values, sure = self._recogniser.values, self._recogniser.confidences
        return ", ".join(_text(n, values[n], sure[n]) for n in self._recogniser.active)


def _text(name: str, value: float, sure: float) -> str:
    if sure < UNSURE:
        return tr("{} (low confidence)").format(tr(WORDS[name]))
    return f"{tr(WORDS[name])} {100 * value:.0f} %"
