"""The verdict: each rule with its figure and its limit, and the way to the page."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QPushButton, QWidget

from app.viewmodels.states import BAD, GOOD
from app.wizards.leading.outcome import OutcomePage
from app.words import tr
from extensions.conformance.window.view_model import FindingRow


class VerdictPage(OutcomePage):
    page_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        first = self.tr("Verdict"), self.tr("Part"), self.tr("Rule")
        names = (*first, self.tr("Figure"), self.tr("Limit"))
        self.name_columns(self.tr("Rules"), names, wide=3)
        self.page_button = QPushButton(self.tr("Open the &page"))
        self.page_button.setToolTip(self.tr("With a plot for each rule, to be kept and sent"))
        self.page_button.clicked.connect(self.page_wanted)
        self.lay_out(self.page_button)

    def show_waiting(self) -> None:
        """Before the verdict is there."""
        self.tell(self.tr("The take is judged…"), "")
        self.enable(False)

    def show_problem(self, text: str) -> None:
        self.tell(self.tr("The take cannot be judged"), text)
        self.enable(True)
        self.page_button.setEnabled(False)

    def show_verdict(self, ok: bool, rows: Sequence[FindingRow], take: str) -> None:
        """What is not kept comes first."""
        kept = sum(row.look == GOOD for row in rows)
        order = {BAD: 0, GOOD: 2}
        told = sorted(rows, key=lambda row: order.get(row.look, 1))
        self.tell(
            self.tr("All rules passed") if ok else self.tr("Not all rules passed"),
            self.tr("{} of {} rules, on {}").format(kept, len(rows), take),
            [
                (f"{r.look.sign} {tr(r.look.word)}", r.layer, r.rule, r.figure, r.limit)
                for r in told
            ],
            [r.look.colour for r in told],
        )
        self.enable(True)
