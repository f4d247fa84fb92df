"""The page with the verdict: each rule with its figure and limit, and a link to the report."""

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
        self.page_button.setToolTip(self.tr("Report with a plot for each rule"))
        self.page_button.clicked.connect(self.page_wanted)
        self.lay_out(self.page_button)

    def show_waiting(self) -> None:
        """Show that the recording is being judged."""
        self.tell(self.tr("Checking the recording…"), "")
        self.enable(False)

    def show_problem(self, text: str) -> None:
        self.tell(self.tr("The recording cannot be checked"), text)
        self.enable(True)
        self.page_button.setEnabled(False)

    def show_verdict(self, ok: bool, rows: Sequence[FindingRow], take: str) -> None:
        """Show the rules, failed ones first."""
        passed = sum(row.look == GOOD for row in rows)
        order = {BAD: 0, GOOD: 2}
        ordered = sorted(rows, key=lambda row: order.get(row.look, 1))
        self.tell(
            self.tr("All rules passed") if ok else self.tr("Not all rules passed"),
            self.tr("{} of {} rules, on {}").format(passed, len(rows), take),
            [
                (f"{r.look.sign} {tr(r.look.word)}", r.layer, r.rule, r.figure, r.limit)
                for r in ordered
            ],
            [r.look.colour for r in ordered],
        )
        self.enable(True)
