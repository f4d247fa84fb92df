"""The light meter's line in the panel, its leaf of advice, and whether missed markers are shown."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QWidget

from app.platform.tasks import LatestJob
from app.viewmodels.colour_tuning import MASK_STEP, ColourTuning, ShownImage
from app.viewmodels.light import SHORT, LightWatch
from app.widgets.chip import Chip
from app.widgets.image_shapes import Ring
from app.widgets.measures import NEAR, TIGHT
from app.widgets.more_button import MoreButton
from app.words import tr

WIDTH = 320  # px, of the advice


class ColoursLight(QWidget):
    """Reads the image shown beside the window, once a second. ``changed``: there is a reading."""

    changed = Signal()
    failed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.watch = LightWatch()
        self._job = LatestJob(self.tr("Reading the light"), self)
        self._job.failed.connect(self.failed)
        self.chip = Chip()
        # each second another word, and what stands beside it stays
        said = self.fontMetrics().horizontalAdvance("● " + tr(SHORT["missed"]))
        self.chip.setFixedWidth(said + 2 * NEAR + TIGHT)
        self.advice = QLabel()
        self.advice.setWordWrap(True)
        self.advice.setFixedWidth(WIDTH)
        self.show_missed = QCheckBox(self.tr("Show missed markers in the image"))
        self.show_missed.setChecked(True)
        self.show_missed.toggled.connect(self.changed)
        button = MoreButton(self.tr("Light"))
        button.setToolTip(self.tr("What of the light costs markers, and what to change"))
        button.add(self.advice)
        button.add(self.show_missed)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(button)
        row.addWidget(self.chip)
        self._show()

    def look_at(self, shown: ShownImage, tuning: ColourTuning) -> None:
        """Have the image read if it is time."""
        view = shown.view if not shown.frozen else None
        t = view.frame.t if view is not None and view.frame is not None else None
        work = self.watch.work(shown.image, tuning.profile, tuning.setup.rig.fx, t)
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
        """Round missed markers, in the mask's pixels; of an image that stays once it was read."""
        live = shown.view is not None and not shown.frozen
        if not self.show_missed.isChecked() or not (live or self.watch.is_of(shown.image)):
            return []
        return self.watch.rings(MASK_STEP)
