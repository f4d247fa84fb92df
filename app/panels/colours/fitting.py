"""Fits of the colour profile, in the background."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from app.engines.snapshot import Snapshot
from app.platform.tasks import TaskOwner
from app.storage.image_folder import Image
from app.viewmodels.colours import fit_words
from tracker.calibration.colours_fit import FoundHue, fit_image
from tracker.calibration.colours_fit_markers import MarkerSamples, seen_sides
from tracker.glove.model import GloveModel
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
        self._samples: MarkerSamples | None = None
        self._last = float("-inf")

    def from_image(self, image: Image | None, profile: ColourProfile) -> None:
        if image is None:
            self.failed.emit(self.tr("There is no image yet to fit the colours to."))
            return
        self._run(lambda _progress: fit_image(image, profile))

    def watch(self, view: Snapshot) -> None:
        """Take the markers that are tracked in this exposure, for a fit later on."""
        result, blobs, frame = view.result, view.blobs, view.frame
        if result is None or result.tracking != Tracking.TRACKING or blobs is None or frame is None:
            return
        if self._samples is None or frame.t == self._last:
            return
        self._last = frame.t
        sides = seen_sides(frame.left, frame.right, (blobs.left, blobs.right), result)
        self._samples.take(sides, result.visible)

    def open(self, glove: GloveModel, profile: ColourProfile) -> None:
        """Begin anew, with another glove."""
        self._samples, self._last = MarkerSamples(glove, profile.hue_names), float("-inf")

    def from_markers(self, profile: ColourProfile) -> None:
        """Fit to the markers that were watched lately."""
        samples = self._samples
        if samples is None or len(samples) == 0:
            self.failed.emit(
                self.tr("No markers were tracked yet. Fit from the image alone first.")
            )
            return
        taken = samples.copy()
        self._run(lambda _progress: taken.fit(profile))

    def _run(self, job) -> None:  # type: ignore[no-untyped-def]
        def done(fit: Fit) -> None:
            profile, found = fit
            words = fit_words(found, profile)
            if found:
                self.fitted.emit(profile, words)
            else:
                self.failed.emit(words)

        self._tasks.run(self.tr("Fitting the colours"), job, done)
