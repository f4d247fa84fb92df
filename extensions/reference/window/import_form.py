"""Fields of the import dialog: files, time alignment, registration."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.widgets.measures import APART
from app.words import SIDES, tr
from extensions.reference.importing import ReferenceImportOptions
from extensions.reference.window.jobs import ReferenceFile
from extensions.reference.window.view_model import REGISTRATIONS, WAYS

ENDINGS = ("c3d", "trc", "tsv", "csv", "txt", "bvh")
EXAMPLE = "2026-03-31T14:05:09.120"


class ImportForm(QWidget):
    """``changed``: another file, mapping, hand or channel is to be read. ``template_asked``: write
    a mapping file."""

    changed = Signal()
    template_asked = Signal()

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
        self.way.currentIndexChanged.connect(lambda _i: self.show_way())
        self.show_way()

    def _lay_out(self) -> None:
        choose, choose_mapping = (QPushButton(self.tr("Choose…")) for _ in range(2))
        choose.clicked.connect(self._ask_reference)
        choose_mapping.clicked.connect(self._ask_mapping)
        self.template_button = QPushButton(self.tr("Template…"))
        self.template_button.setToolTip(
            self.tr("Write a mapping file with the points of this reference, and open it")
        )
        self.template_button.clicked.connect(self.template_asked)
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

    def show_way(self) -> None:
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
