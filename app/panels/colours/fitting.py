"""Colour fits in the background, and the light meter."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QWidget

from app.engines.snapshot import Snapshot
from app.platform.tasks import LatestJob, TaskOwner
from app.viewmodels.colour_fits import Fit, FitWork, fit_text
from app.viewmodels.colour_search import MASK_STEP, ShownImage
from app.viewmodels.colour_tuning import ColourTuning
from app.viewmodels.light import SHORT, LightWatch
from app.widgets.chip import Chip
from app.widgets.image_shapes import Ring
from app.widgets.measures import NEAR, TIGHT
from app.widgets.more_button import MoreButton
from app.words import error_text, tr
from tracker.base.errors import GlovetrackError

WIDTH = 320  # px, width of the advice


class ColoursFitting(QObject):
    """``taken``: the tuning has new colours. ``failed``: why it does not."""

    taken = Signal()
    failed = Signal(str)

    def __init__(self, tasks: TaskOwner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._tasks = tasks
        self._unasked = False  # whether the pending fit was started automatically
        self.tuning: ColourTuning | None = None

    def fit(self, work_of: Callable[[ColourTuning], FitWork]) -> None:
        """Fit in the background."""
        if self.tuning is None:
            return
        try:
            work = work_of(self.tuning)
        except GlovetrackError as error:
            self.failed.emit(error_text(error))
            return
        self._tasks.run(self.tr("Fitting the colours"), lambda _progress: work(), self._fitted)

    def _fitted(self, fit: Fit) -> None:
        """Use a fit, unless it found nothing."""
        profile, hues = fit
        if self.tuning is not None and profile is self.tuning.profile:
            return  # an automatic fit was rejected
        words = fit_text(hues, profile)
        if self.tuning is not None and hues:
            self.tuning.take(profile, words)
            self.taken.emit()
        else:
            self.failed.emit(words)

    def fit_live(self) -> None:
        """Fit to the images and packets of the next or last seconds."""
        if self.tuning is None:
            return
        self._unasked = False
        try:
            self.tuning.live.ask()
        except GlovetrackError as error:
            self.failed.emit(error_text(error))
            return
        if not self.tuning.live.is_enough:
            words = self.tr("Collecting images. Hold the hand in view, or play the replay.")
            self.tuning.message = words

    def fit_by_itself(self) -> None:
        """Start an automatic fit; if it is rejected, nothing changes and no message is shown."""
        tuning = self.tuning
        if tuning is None or tuning.setup.player is not None or not tuning.setup.whole:
            return
        if not tuning.live.wanted:
            tuning.live.ask()
            self._unasked = True

    @property
    def waits(self) -> bool:
        """Whether images are being collected for a fit."""
        return self.tuning is not None and self.tuning.live.wanted

    def gather(self, view: Snapshot) -> None:
        """Collect images for a fit, and start a pending one when there are enough."""
        tuning = self.tuning
        if tuning is None:
            return
        tuning.live.watch(view)
        if tuning.live.wanted and tuning.live.is_enough:
            unasked, self._unasked = self._unasked, False
            if unasked and _is_other_side(view):
                tuning.live.wanted = False  # the colours are not the reason why no hand is found
                return
            self.fit(lambda t: t.live.fit(t.profile, refuse=not unasked))


def _is_other_side(view: Snapshot) -> bool:
    """Whether the glove was found to be for the other hand."""
    return view.status is not None and bool(view.status.values.get("glove_of_other_side"))


class ColoursLight(QWidget):
    """Measures the displayed image once a second in the background. ``changed``: there is a new
    result."""

    changed = Signal()
    failed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.watch = LightWatch()
        self._job = LatestJob(self.tr("Measuring the light"), self)
        self._job.failed.connect(self.failed)
        self.chip = Chip()
        # fixed width: the text changes every second and must not move its neighbours
        text_width = self.fontMetrics().horizontalAdvance("● " + tr(SHORT["missed"]))
        self.chip.setFixedWidth(text_width + 2 * NEAR + TIGHT)
        self.advice = QLabel()
        self.advice.setWordWrap(True)
        self.advice.setFixedWidth(WIDTH)
        self.show_missed = QCheckBox(self.tr("Show missed markers in the image"))
        self.show_missed.setChecked(True)
        self.show_missed.toggled.connect(self.changed)
        button = MoreButton(self.tr("Light"))
        button.setToolTip(self.tr("Lighting problems that hide markers, and how to fix them"))
        button.add(self.advice)
        button.add(self.show_missed)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(button)
        row.addWidget(self.chip)
        self._show()

    def look_at(self, shown: ShownImage, tuning: ColourTuning) -> None:
        """Measure the image if it is time and the last measurement is finished: a newer one would
        discard its result, and a slow computer would never have any."""
        if self._job.is_busy:
            return
        view = shown.view if not shown.frozen else None
        t = view.frame.t if view is not None and view.frame is not None else None
        work = self.watch.work(shown.image, tuning.profile, tuning.setup.camera.rig.fx, t)
        if work is not None:
            self._job.run(lambda _progress: work(), self._took)

    def _took(self, answer: object) -> None:
        self.watch.took(answer)  # type: ignore[arg-type]
        self._show()
        self.changed.emit()

    def shut_down(self) -> None:
        self._job.shut_down()

    def _show(self) -> None:
        look, sentences = self.watch.look, self.watch.sentences()
        self.chip.show_state(look.colour, look.sign, self.watch.line(), " ".join(sentences))
        self.advice.setText("\n\n".join(sentences))

    def rings(self, shown: ShownImage) -> list[Ring]:
        """Rings around missed markers, in pixels of the mask; for a frozen image once it has been
        measured."""
        live = shown.view is not None and not shown.frozen
        if not self.show_missed.isChecked() or not (live or self.watch.is_of(shown.image)):
            return []
        return self.watch.rings(MASK_STEP)
