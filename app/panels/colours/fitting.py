"""Fits of the colours, asked for or not: made in the background, kept where they found some."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from app.engines.snapshot import Snapshot
from app.platform.tasks import TaskOwner
from app.viewmodels.colour_fits import Fit, FitWork, fit_words
from app.viewmodels.colour_tuning import ColourTuning
from tracker.base.errors import GlovetrackError


class ColoursFitting(QObject):
    """``taken``: the tuning has other colours now. ``failed``: why it has not."""

    taken = Signal()
    failed = Signal(str)

    def __init__(self, tasks: TaskOwner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._tasks = tasks
        self._unasked = False  # of the fit that waits for images
        self.tuning: ColourTuning | None = None

    def fit(self, work_of: Callable[[ColourTuning], FitWork]) -> None:
        """Fit in the background."""
        if self.tuning is None:
            return
        try:
            work = work_of(self.tuning)
        except GlovetrackError as error:
            self.failed.emit(str(error))
            return
        self._tasks.run(self.tr("Fitting the colours"), lambda _progress: work(), self._fitted)

    def _fitted(self, fit: Fit) -> None:
        """Nothing found changes nothing."""
        profile, hues = fit
        if self.tuning is not None and profile is self.tuning.profile:
            return  # a fit that nobody asked for, refused
        words = fit_words(hues, profile)
        if self.tuning is not None and hues:
            self.tuning.take(profile, words)
            self.taken.emit()
        else:
            self.failed.emit(words)

    def fit_live(self) -> None:
        """Fit to the images of the next or last seconds, with the packets around them."""
        if self.tuning is None:
            return
        self._unasked = False
        try:
            self.tuning.live.ask()
        except GlovetrackError as error:
            self.failed.emit(str(error))
            return
        if not self.tuning.live.is_enough:
            words = self.tr("Images are gathered: hold the hand in view, or let the replay run.")
            self.tuning.last_words = words

    def fit_by_itself(self) -> None:
        """The same where nobody asked: what is refused then changes nothing and is not told."""
        tuning = self.tuning
        if tuning is None or tuning.setup.player is not None or not tuning.setup.whole:
            return
        if not tuning.live.wanted:
            tuning.live.ask()
            self._unasked = True

    @property
    def waits(self) -> bool:
        """Whether images are gathered for a fit."""
        return self.tuning is not None and self.tuning.live.wanted

    def gather(self, view: Snapshot) -> None:
        """Keep images for a fit, and begin one that waits for them."""
        tuning = self.tuning
        if tuning is None:
            return
        tuning.live.watch(view)
        if tuning.live.wanted and tuning.live.is_enough:
            unasked, self._unasked = self._unasked, False
            if unasked and _is_other_side(view):
                tuning.live.wanted = False  # it is not the colours that no hand is found by
                return
            self.fit(lambda t: t.live.fit(t.profile, refuse=not unasked))


def _is_other_side(view: Snapshot) -> bool:
    """Whether the glove was found to be the other hand's."""
    return view.status is not None and bool(view.status.values.get("glove_of_other_side"))
