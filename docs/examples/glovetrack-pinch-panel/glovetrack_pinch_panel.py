"""A panel for Glovetrack: how far the tips of thumb and index finger are apart.

It also adds a command to the *Tracking* menu that writes a note into the recording.
"""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QVBoxLayout

from glovetrack.panels import (
    CommandContext,
    Panel,
    PanelKind,
    Snapshot,
    Spot,
    WindowCommand,
)


class PinchPanel(Panel):
    """A distance in mm, refreshed at 10 Hz while the panel is visible."""

    period = 0.1

    def __init__(self) -> None:
        super().__init__()
        self.figure = QLabel("–", alignment=Qt.AlignmentFlag.AlignCenter)
        QVBoxLayout(self).addWidget(self.figure)

    def refresh(self, view: Snapshot | None) -> None:
        if view is None or view.estimate is None:
            self.figure.setText("No hand yet")
            return
        names = view.setup.glove.keypoint_names(view.setup.hand)
        tips = [names.index(name) for name in ("thumb_tip", "index_tip")]
        thumb, index = view.estimate.keypoints[tips]  # m
        self.figure.setText(f"{1000 * np.linalg.norm(thumb - index):.0f} mm")


def add_mark(on: CommandContext) -> None:
    """Add a note at the present time."""
    on.host.notes.add("mark")


def is_recording(on: CommandContext) -> bool:
    return on.host.running and on.host.recording.is_possible


PINCH = PanelKind(
    "pinch", "Pinch", lambda _services: PinchPanel(), {"all": Spot("right", 1)}, over="hand"
)
ADD_MARK = WindowCommand("add-mark", "Add a mar&k", add_mark, after="note", enabled=is_recording)
