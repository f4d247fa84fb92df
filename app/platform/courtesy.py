"""The window's side of `tracker.live.right_of_way`."""

from __future__ import annotations

from tracker.live.right_of_way import RightOfWay


class Courtesy:
    """``to``: what the window gives way to while something follows the hand that cannot wait."""

    def __init__(self) -> None:
        self.to: RightOfWay | None = None

    def give_way(self) -> None:
        """Asked between the pieces of what is painted."""
        if self.to is not None:
            self.to.give()


PAINTING = Courtesy()
"""Of the one thread that paints, as Qt has one application."""
