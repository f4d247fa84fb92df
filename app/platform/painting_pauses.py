"""The window's counterpart of `tracker.live.right_of_way`."""

from __future__ import annotations

from tracker.live.right_of_way import RightOfWay


class PaintingPauses:
    """``to``: callback that pauses painting while a time-critical device follows the hand."""

    def __init__(self) -> None:
        self.to: RightOfWay | None = None

    def give_way(self) -> None:
        """Called between parts of a painting operation."""
        if self.to is not None:
            self.to.give()


PAINTING = PaintingPauses()
"""For the one thread that paints."""
