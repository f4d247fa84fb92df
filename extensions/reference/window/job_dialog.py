"""A dialog that runs one job at a time in the background."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide6.QtWidgets import QDialog, QLabel, QProgressBar, QPushButton, QWidget

from app.panels.command_kind import CommandContext
from app.platform.tasks import Job, RunningJob

STEPS = 1000


class JobDialog(QDialog):
    """A subclass lays out ``words``, ``progress`` and ``cancel_button``, sets what is disabled
    meanwhile (``inputs``) and the text for a cancelled job (``cancelled``), and overrides
    `enable`."""

    def __init__(self, on: CommandContext) -> None:
        super().__init__(on.window)
        self.context = on
        self.job: RunningJob | None = None
        self.inputs: Sequence[QWidget] = ()
        self.cancelled = ""
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.progress = QProgressBar()
        self.progress.setMaximum(STEPS)
        self.cancel_button = QPushButton()
        self.cancel_button.clicked.connect(self.cancel)
        self._is_answered = False

    def run_job(self, title: str, job: Job, done: Callable[[Any], None], words: str) -> None:
        """Show ``words`` while ``job`` runs; ``done`` is called with its result."""
        self._is_answered = False
        self.words.setText(words)

        def answered(result: Any) -> None:
            self._is_answered = True
            done(result)

        self.job = self.context.tasks.run(
            title, job, answered, self._ended, self._progressed, self.show_problem
        )
        self.show_running(True)

    def show_problem(self, text: str) -> None:
        self._is_answered = True
        self.words.setText(text)

    def show_running(self, on: bool) -> None:
        """Show the progress of a job, or none."""
        self.progress.setValue(0)
        self.progress.setVisible(on)
        self.cancel_button.setVisible(on)
        for widget in self.inputs:
            widget.setEnabled(not on)
        self.enable()

    def enable(self) -> None:
        """Enable the buttons that can be used now."""

    def cancel(self) -> None:
        """End the job, if any."""
        if self.job is not None:
            self.job.cancel()

    def done(self, result: int) -> None:
        """Close; a job that runs is cancelled."""
        self.cancel()
        super().done(result)

    def _progressed(self, share: float, _text: str) -> None:
        self.progress.setValue(round(STEPS * share))

    def _ended(self) -> None:
        self.job = None
        self.show_running(False)
        if not self._is_answered:
            self.words.setText(self.cancelled)
