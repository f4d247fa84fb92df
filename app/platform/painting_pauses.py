"""Pauses of the window's painting, see `tracker.live.work_priority`."""

from __future__ import annotations

from tracker.live.work_priority import WorkPriority


class PaintingPauses:
    """``priority``: that of an engine whose estimates a time-critical device follows, else None."""

    def __init__(self) -> None:
        self.priority: WorkPriority | None = None

    def pause(self) -> None:
        """Called between parts of a painting operation."""
        if self.priority is not None:
            self.priority.wait()


PAINTING = PaintingPauses()
"""For the one thread that paints."""
