"""Fits of the colour profile, in the background."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from app.kept_pictures import Picture
from app.tasks import Progress, TaskOwner
from app.viewmodels.colours import fit_words
from app.viewmodels.snapshot import Snapshot
from tracker.calibration.colours_fit import FoundHue, fit_picture
from tracker.calibration.colours_fit_markers import fit_markers, seen_sides
from tracker.messages import Tracking
from tracker.vision.colours import ColourProfile

Fit = tuple[ColourProfile, tuple[FoundHue, ...]]


class ColoursFitting(QObject):
    """``fitted`` brings a profile and a sentence about it; nothing found changes nothing."""

    fitted = Signal(object, str)
    failed = Signal(str)

    def __init__(self, tasks: TaskOwner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._tasks = tasks

    def from_picture(self, picture: Picture | None, profile: ColourProfile) -> None:
        if picture is None:
            self.failed.emit(self.tr("There is no picture yet to fit the colours to."))
            return
        self._run(lambda _progress: fit_picture(picture, profile))

    def from_markers(self, view: Snapshot | None, profile: ColourProfile) -> None:
        if view is None:
            self.failed.emit(self.tr("Markers are tracked in the live picture: choose that one."))
            return
        result, blobs, frame = view.result, view.blobs, view.frame
        if result is None or result.tracking != Tracking.TRACKING or blobs is None or frame is None:
            self.failed.emit(
                self.tr("No markers are tracked now. Fit from the picture alone first.")
            )
            return
        sides = seen_sides(frame.left, frame.right, (blobs.left, blobs.right), result)
        glove, visible = view.setup.glove, result.visible

        def job(_progress: Progress) -> Fit:
            return fit_markers(sides, visible, glove, profile)

        self._run(job)

    def _run(self, job) -> None:  # type: ignore[no-untyped-def]
        def done(fit: Fit) -> None:
            profile, found = fit
            words = fit_words(found, profile)
            if found:
                self.fitted.emit(profile, words)
            else:
                self.failed.emit(words)

        self._tasks.run(self.tr("Fitting the colours"), job, done)
