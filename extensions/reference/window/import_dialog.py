"""The dialog that adds a motion-capture recording to the open session."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QEvent, QUrl, Signal
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.panels.command_kind import CommandContext
from app.widgets.measures import APART, WIDE
from app.wizards.sizing import fit_to_screen
from app.words import SIDES, notice_text, tr
from extensions.reference.importing import ReferenceImportOptions
from extensions.reference.window.extension import is_replayed
from extensions.reference.window.job_dialog import JobDialog
from extensions.reference.window.jobs import (
    Answer,
    ImportedSession,
    ReferenceFile,
    import_job,
    recognise_job,
    template_job,
)
from extensions.reference.window.row_table import RowTable
from extensions.reference.window.view_model import (
    REGISTRATIONS,
    WAYS,
    recognised_text,
    remark_text,
    residual_rows,
    result_text,
)

SIZE = 760, 680
TABLE_STRETCH = 100


class ImportDialog(JobDialog):
    """Shows what the chosen file contains, imports it, and opens the new session."""

    def __init__(self, on: CommandContext, setup: EngineSetup) -> None:
        super().__init__(on)
        assert setup.player is not None
        self._session = setup.player.path
        self._request_number = 0
        self._read: tuple[ReferenceFile | None, tuple[float, ...]] = None, ()
        self._is_ready = False
        self.cancelled = self.tr("Cancelled. Nothing was imported.")
        self.setObjectName("reference_import")
        self.setWindowTitle(self.tr("Import a reference"))
        self.form = ImportForm(setup, self._session)
        self.form.changed.connect(self._look)
        self.form.template_requested.connect(self._ask_template)
        self._lay_out()
        fit_to_screen(self, *SIZE)
        self.inputs = (self.form,)
        self.show_running(False)
        self.recognise()

    def _lay_out(self) -> None:
        self.table = RowTable(
            [
                self.tr("Keypoint"), self.tr("Residual, rigid (mm)"),
                self.tr("With marker offset (mm)"), self.tr("Marker offset (mm)"),
            ],
            self.tr("Residuals of the registration"),
        )  # fmt: skip
        self.progress.setAccessibleName(self.tr("Progress of the import"))
        column = QVBoxLayout(self)
        column.setContentsMargins(WIDE, APART, WIDE, APART)
        column.setSpacing(APART)
        column.addWidget(self.form)
        column.addWidget(self.words)
        column.addWidget(self.table, TABLE_STRETCH)
        column.addStretch(1)  # while the table is hidden
        column.addWidget(self.progress)
        column.addLayout(self._buttons())
        self.table.hide()

    def _buttons(self) -> QHBoxLayout:
        self.import_button = QPushButton(self.tr("&Import"))
        self.import_button.setProperty("role", "primary")
        self.import_button.setDefault(True)
        self.import_button.clicked.connect(self.start)
        self.cancel_button.setText(self.tr("&Cancel"))
        close = QPushButton(self.tr("Close"))
        close.clicked.connect(self.close)
        row = QHBoxLayout()
        row.addStretch(1)
        for button in (close, self.cancel_button, self.import_button):
            button.setAutoDefault(button is self.import_button)
            row.addWidget(button)
        return row

    # --- the file

    def _look(self) -> None:
        """Read the file again if another one was chosen, or this one has changed."""
        if self._read != (self.form.file(), self._times()):
            self.recognise()

    def recognise(self) -> None:
        """Read the chosen file in the background and show what it contains."""
        file = self.form.file()
        self._request_number += 1
        self._is_ready = False
        self.enable()
        self.form.template_button.setEnabled(file is not None)
        if file is None:
            self._read = None, ()
            self.form.recognised.setText(self.tr("C3D, TRC, Qualisys TSV, OptiTrack, Vicon, BVH"))
            return
        self._read = file, self._times()
        self.form.recognised.setText(self.tr("Reading the file…"))
        title = self.tr("Reading {}").format(file.path.name)
        self.context.tasks.run(title, recognise_job(self._request_number, file), self._recognised)

    def _times(self) -> tuple[float, ...]:
        """When the chosen files were changed."""
        paths = (self.form.path, self.form.mapping_path)
        return tuple(_changed(path) for path in paths if path is not None)

    def _recognised(self, answer: Answer) -> None:
        if answer.number != self._request_number:
            return
        found, label = answer.found, self.form.recognised
        if found is None:
            assert answer.problem is not None
            label.setText(notice_text(answer.problem))
            return
        label.setText(recognised_text(found))
        self.form.show_clock(found.has_clock)
        self._is_ready = found.problem is None
        self.enable()

    def event(self, event: QEvent) -> bool:
        """Read files again that were changed in another program."""
        if event.type() == QEvent.Type.WindowActivate and self.job is None:
            self._look()
        return super().event(event)

    def _ask_template(self) -> None:
        file = self.form.file()
        if file is None:
            return
        name = file.path.with_suffix(".toml")
        path, _ = QFileDialog.getSaveFileName(
            self, self.tr("Save the mapping file"), str(name), "*.toml"
        )
        if path:
            self.write_template(Path(path))

    def write_template(self, path: Path) -> None:
        """Write a mapping file to begin with, use it, and open it in an editor."""
        file = self.form.file()
        if file is not None:
            title = self.tr("Writing {}").format(path.name)
            job = template_job(file, path)
            self.context.tasks.run(title, job, self._template_written, failed=self.show_problem)

    def _template_written(self, path: Path) -> None:
        self.form.mapping.setText(str(path))
        self.recognise()
        QDesktopServices.openUrl(QUrl.fromLocalFile(str(path)))

    # --- the import

    def start(self) -> None:
        """Import in the background."""
        reference = self.form.path
        if reference is None or self.job is not None:
            return
        self.table.hide()
        title = self.tr("Importing {}").format(reference.name)
        job = import_job(reference, self._session, self.form.options())
        self.run_job(title, job, self._done, self.tr("Importing…"))

    def _done(self, made: ImportedSession) -> None:
        """Show the result and open the new session."""
        lines = [self.tr("Imported into {}.").format(made.path.name), result_text(made.about)]
        lines += [remark_text(remark) for remark in made.remarks]
        self.words.setText("\n".join(lines))
        self.table.show_rows(residual_rows(made.about))
        self.table.show()
        self.context.open_session(made.path, None)

    def enable(self) -> None:
        """Enable the buttons that can be used now."""
        self.import_button.setEnabled(self._is_ready and self.job is None)


def _changed(path: Path) -> float:
    try:
        return path.stat().st_mtime
    except OSError:
        return 0.0


def open_dialog(on: CommandContext) -> None:
    """Open the dialog for the open session."""
    setup = on.host.setup
    if setup is not None and setup.player is not None and is_replayed(on):
        on.show_dialog("reference_import", lambda: ImportDialog(on, setup))


# ---- fields of the import dialog: files, time alignment, registration

ENDINGS = ("c3d", "trc", "tsv", "csv", "txt", "bvh")
EXAMPLE = "2026-03-31T14:05:09.120"


class ImportForm(QWidget):
    """``changed``: another file, mapping, hand or channel is to be read. ``template_requested``:
    write a mapping file."""

    changed = Signal()
    template_requested = Signal()

    def __init__(self, setup: EngineSetup, session: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._setup, self._session = setup, session
        self.hand = _choice(
            self.tr("Hand"), {hand.side: SIDES.get(hand.side, hand.side) for hand in setup.hands}
        )
        self.reference, self.mapping = QLineEdit(), QLineEdit()
        self.mapping.setPlaceholderText(self.tr("none: points are found by their names"))
        self.recognised = QLabel()
        self.recognised.setWordWrap(True)
        self.way = _choice(self.tr("Time alignment"), WAYS)
        self.pulse, self.start = QLineEdit(), QLineEdit()
        self.pulse.setPlaceholderText(self.tr("all events; or their name, or a C3D channel"))
        self.drift = QCheckBox(self.tr("Estimate the drift of the clocks"))
        self.drift.setChecked(True)
        self.registration = _choice(self.tr("Registration"), REGISTRATIONS)
        self._lay_out()
        for line in (self.reference, self.mapping, self.pulse):
            line.editingFinished.connect(self.changed)
        self.hand.currentIndexChanged.connect(lambda _i: self.changed.emit())
        self.way.currentIndexChanged.connect(lambda _i: self.show_alignment())
        self.show_alignment()

    def _lay_out(self) -> None:
        choose, choose_mapping = (QPushButton(self.tr("Choose…")) for _ in range(2))
        choose.clicked.connect(self._ask_reference)
        choose_mapping.clicked.connect(self._ask_mapping)
        self.template_button = QPushButton(self.tr("Template…"))
        self.template_button.setToolTip(
            self.tr("Write a mapping file with the points of this reference, and open it")
        )
        self.template_button.clicked.connect(self.template_requested)
        self.form = QFormLayout(self)
        self.form.setContentsMargins(0, 0, 0, 0)
        self.form.setVerticalSpacing(APART // 2)
        self.form.addRow(self.tr("Recording:"), QLabel(self._session.name))
        self._row(self.tr("&Hand:"), self.hand)
        self._row(self.tr("&Reference file:"), self.reference, choose)
        self.form.addRow("", self.recognised)
        self._row(self.tr("&Mapping file:"), self.mapping, choose_mapping, self.template_button)
        self._row(self.tr("&Time alignment:"), self.way)
        self._row(self.tr("&Pulses:"), self.pulse)
        self._row(self.tr("&Start of the reference:"), self.start)
        self.form.addRow("", self.drift)
        self._row(self.tr("Re&gistration:"), self.registration)
        self.form.setRowVisible(self.hand, self.hand.count() > 1)

    def _row(self, text: str, field: QWidget, *buttons: QPushButton) -> None:
        """A label whose mnemonic focuses the field, which its buttons follow."""
        label = QLabel(text)
        label.setBuddy(field)
        field.setAccessibleName(text.replace("&", "").rstrip(":"))
        if not buttons:
            self.form.addRow(label, field)
            return
        row = QHBoxLayout()
        row.addWidget(field, 1)
        for button in buttons:
            row.addWidget(button)
        self.form.addRow(label, row)

    def show_alignment(self) -> None:
        """Show the field of the chosen time alignment."""
        way = self.way.currentData()
        self.form.setRowVisible(self.pulse, way == "pulse")
        self.form.setRowVisible(self.start, way == "clock")
        self.drift.setEnabled(way != "clock")

    def show_clock(self, is_known: bool) -> None:
        """Say whether the file contains its start time."""
        from_file = self.tr("from the file; or {}").format(EXAMPLE)
        self.start.setPlaceholderText(from_file if is_known else EXAMPLE)

    # --- what was chosen

    @property
    def path(self) -> Path | None:
        """The reference file, None without one."""
        return _path(self.reference)

    @property
    def mapping_path(self) -> Path | None:
        return _path(self.mapping)

    def file(self) -> ReferenceFile | None:
        """What is to be recognised, None without a file."""
        if self.path is None:
            return None
        hand = self._setup.seen_from(self.hand.currentData())
        names = tuple(hand.glove.keypoint_names(hand.hand))
        return ReferenceFile(self.path, self.mapping_path, self._pulse, names, hand.side)

    @property
    def _pulse(self) -> str:
        return self.pulse.text().strip() if self.way.currentData() == "pulse" else ""

    def options(self) -> ReferenceImportOptions:
        return ReferenceImportOptions(
            self.mapping_path,
            self.way.currentData(),
            self._pulse,
            self.start.text().strip() if self.way.currentData() == "clock" else "",
            self.hand.currentData() if self.hand.count() > 1 else "",
            self.drift.isChecked(),
            self.registration.currentData(),
        )

    def _ask_reference(self) -> None:
        files = " ".join(f"*.{ending}" for ending in ENDINGS)
        words = self.tr("Motion-capture recordings ({})").format(files)
        self._ask(self.reference, self.tr("Reference file"), words)

    def _ask_mapping(self) -> None:
        words = self.tr("Mapping files ({})").format("*.toml")
        self._ask(self.mapping, self.tr("Mapping file"), words)

    def _ask(self, line: QLineEdit, title: str, kinds: str) -> None:
        folder = (self.path or self._session).parent
        path, _ = QFileDialog.getOpenFileName(
            self, title, str(folder), f"{kinds};;{self.tr('All files')} (*)"
        )
        if path:
            line.setText(path)
            self.changed.emit()


def _choice(name: str, titles: dict[str, str]) -> QComboBox:
    box = QComboBox()
    box.setAccessibleName(name)
    for value, title in titles.items():
        box.addItem(tr(title), value)
    return box


def _path(line: QLineEdit) -> Path | None:
    text = line.text().strip()
    return Path(text).expanduser() if text else None
