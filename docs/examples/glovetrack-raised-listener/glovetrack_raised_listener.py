"""A listener: adds a note to the running recording whenever the hand is raised."""

from __future__ import annotations

import math

from glovetrack.listeners import Estimate, Event, ListenedHand, ListenerKind

HEIGHT, RELEASE = 1.0, 0.95  # m above the origin; the hand must fall below the second one


class RaisedListener:
    """One for each hand; in a replay it has nothing to add a note to."""

    def __init__(self, hand: ListenedHand) -> None:
        self._live = hand.live
        self._row = hand.glove.keypoint_names(hand.hand).index("wrist")
        self._raised = False

    def feed(self, estimate: Estimate, t_arrival: float) -> None:
        height = float(estimate.keypoints[self._row, 2])
        if math.isnan(height):  # lost: neither raised nor lowered
            return
        if not self._raised and height > HEIGHT and self._live is not None:
            self._live.record(Event(estimate.t, "note", "hand raised", {"height_m": height}))
        self._raised = height > (RELEASE if self._raised else HEIGHT)

    def restart(self) -> None:
        self._raised = False

    def close(self) -> None:
        """Nothing is open."""


RAISED = ListenerKind("raised", "Notes when the hand is raised", RaisedListener)
