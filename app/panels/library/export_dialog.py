"""The export dialog."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Protocol

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QDoubleSpinBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.jobs.export import ExportRequest, free_target
from app.storage.settings import SettingsOf
from app.viewmodels.recording import position_text
from app.widgets.question import question
from app.words import tr
from tracker.session.export.formats import FORMATS, formats
from tracker.session.export.options import (
    AXES_NAMES,
    PERSONAL,
    RATES,
    UNITS,
    DatasetOptions,
    ExportOptions,
)

MAX_RATE_HZ = 2000.0


LONGEST = 60  # maximum number of characters in a name


class ExportSettings(Protocol):
    """The settings of exports."""

    @property
    def export(self) -> dict[str, Any]: ...

    @property
    def export_presets(self) -> dict[str, Any]: ...

    @property
    def export_folder(self) -> str: ...


class Presets(QWidget):
    """A list of presets; ``read`` returns the options in the fields, ``show`` fills the fields."""

    def __init__(
        self,
        store: SettingsOf[ExportSettings],
        read: Callable[[], ExportChoice],
        show: Callable[[ExportChoice], None],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._store, self._read, self._show = store, read, show
        self.box = QComboBox()
        self.box.setAccessibleName(self.tr("Preset"))
        self.box.currentIndexChanged.connect(self._chosen)
        self.box.activated.connect(
            self._chosen
        )  # also selects the same preset again, after the fields were changed
        self.save_button = QPushButton(self.tr("Save as…"))
        self.save_button.clicked.connect(self._ask_name)
        self.remove_button = QPushButton(self.tr("Remove"))
        self.remove_button.clicked.connect(self._remove)
        self._removed: tuple[str, dict[str, object]] | None = None
        self.undo_button = QPushButton(self.tr("Undo"))
        self.undo_button.clicked.connect(self._put_back)
        self.undo_button.hide()
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(QLabel(self.tr("Preset")))
        row.addWidget(self.box, 1)
        row.addWidget(self.save_button)
        row.addWidget(self.remove_button)
        row.addWidget(self.undo_button)
        self._fill("")

    def _fill(self, chosen: str) -> None:
        with QSignalBlocker(self.box):
            self.box.clear()
            self.box.addItem(self.tr("none (options below)"), "")
            for name in sorted(self._store.value.export_presets):
                self.box.addItem(name, name)
            self.box.setCurrentIndex(max(0, self.box.findData(chosen)))
        self.remove_button.setEnabled(bool(self.box.currentData()))

    def _chosen(self) -> None:
        name = self.box.currentData()
        self.remove_button.setEnabled(bool(name))
        if name:
            self._show(choice_from(self._store.value.export_presets.get(name)))

    def _ask_name(self) -> None:
        title, words = self.tr("Save these formats and options"), self.tr("Name of the preset")
        dialog = question(self, title, words, self.box.currentData() or "")
        dialog.textValueSelected.connect(self.save_preset)
        dialog.open()

    def save_preset(self, name: str) -> None:
        """Save the options under this name, replacing an existing preset."""
        name = " ".join(name.split())[:LONGEST]
        if name:
            kept = {**self._store.value.export_presets, name: self._read().as_dict()}
            self._store.update(export_presets=kept)
            self._fill(name)

    def _remove(self) -> None:
        name = self.box.currentData()
        before = self._store.value.export_presets
        self._removed = name, before[name]
        self._store.update(export_presets={k: v for k, v in before.items() if k != name})
        self.undo_button.setToolTip(self.tr("Restore the preset {}").format(name))
        self.undo_button.show()
        self._fill("")

    def _put_back(self) -> None:
        """Restore the preset that was removed last, unless its name is in use again."""
        if self._removed is not None:
            (name, preset), self._removed = self._removed, None
            self._store.update(export_presets={name: preset, **self._store.value.export_presets})
            self._fill(name)
        self.undo_button.hide()


class ExportDialog(QDialog):
    """``wanted`` is emitted for each session and format. ``part`` (s) is the range selected in the
    replay.

    The options and the folder are stored in the settings.
    """

    wanted = Signal(object)  # ExportRequest

    def __init__(
        self,
        sources: Sequence[Path],
        part: tuple[float, float] | None,
        store: SettingsOf[ExportSettings],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._sources, self._part, self._store = tuple(sources), part, store
        names = (
            sources[0].name if len(sources) == 1 else self.tr("{} sessions").format(len(sources))
        )
        self.setWindowTitle(self.tr("Export {}").format(names))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._make_fields()
        self.presets = Presets(store, self.choice, self.show_choice)
        column = QVBoxLayout(self)
        column.addWidget(self.presets)
        column.addLayout(self._form())
        column.addWidget(self._buttons())
        self.setMinimumWidth(480)
        self.show_choice(choice_from(store.value.export))

    def _make_fields(self) -> None:
        self.formats = QListWidget()
        self.formats.setAccessibleName(self.tr("Formats"))
        for kind in formats():
            item = QListWidgetItem(tr(kind.title), self.formats)
            item.setData(Qt.ItemDataRole.UserRole, kind.name)
            item.setCheckState(Qt.CheckState.Unchecked)
        self.formats.itemChanged.connect(lambda _item: self._enable())
        folder = Path(self._store.value.export_folder or self._sources[0].parent)
        self.folder = QLineEdit(str(folder if folder.is_dir() else self._sources[0].parent))
        self.range = QCheckBox(self.tr("the whole session"))
        if self._part is not None:
            start, stop = (position_text(p) for p in self._part)
            self.range.setText(self.tr("only {} to {} (in and out point)").format(start, stop))
        self.range.setEnabled(self._part is not None)
        self.range.setChecked(True)
        self.rate = QDoubleSpinBox()
        self.rate.setRange(0.0, MAX_RATE_HZ)
        self.rate.setSuffix(self.tr(" Hz"))
        self.rate.setSpecialValueText(self.tr("as recorded"))
        self.axes = self._choice(AXES_NAMES)
        self.units = self._choice(tuple(UNITS))
        self.anonymous = QCheckBox(self.tr("without participant and notes"))
        self._make_dataset_fields()

    def _make_dataset_fields(self) -> None:
        """Fields that apply only to data sets of several sessions."""
        self.task = QLineEdit()
        self.task.setPlaceholderText(
            self.tr("One sentence that describes the task; default: the notes")
        )
        self.task.setToolTip(self.tr("The task of a data set's episodes, for robot learning"))
        self.split = QCheckBox(self.tr("one episode per note"))

    def _choice(self, names: Sequence[str]) -> QComboBox:
        box = QComboBox()
        box.addItem(self.tr("default of the format"), "")
        for name in names:
            box.addItem(name, name)
        return box

    def _form(self) -> QFormLayout:
        choose = QPushButton(self.tr("Change…"))
        choose.clicked.connect(self._choose_folder)
        row = QHBoxLayout()
        row.addWidget(self.folder, 1)
        row.addWidget(choose)
        folder = QLabel(self.tr("F&older"))
        folder.setBuddy(self.folder)
        form = QFormLayout()
        form.addRow(self.tr("&Formats"), self.formats)
        form.addRow(folder, row)
        form.addRow(self.tr("&Range"), self.range)
        form.addRow(self.tr("R&ate"), self.rate)
        form.addRow(self.tr("A&xes"), self.axes)
        form.addRow(self.tr("&Units"), self.units)
        form.addRow(self.tr("&Privacy"), self.anonymous)
        form.addRow(self.tr("&Task"), self.task)
        form.addRow(self.tr("&Episodes"), self.split)
        return form

    def _buttons(self) -> QDialogButtonBox:
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.start = buttons.addButton(self.tr("Export"), QDialogButtonBox.ButtonRole.AcceptRole)
        self.start.setProperty("role", "primary")
        buttons.accepted.connect(self._start)
        buttons.rejected.connect(self.close)
        return buttons

    def _enable(self) -> None:
        if hasattr(self, "start"):
            self.start.setEnabled(bool(self._chosen()))
            for field in (self.task, self.split):
                field.setEnabled(self.choice().is_dataset)

    def _choose_folder(self) -> None:
        folder = QFileDialog.getExistingDirectory(
            self, self.tr("Folder for the export"), self.folder.text()
        )
        if folder:
            self.folder.setText(folder)

    # --- the choice

    def _items(self) -> list[QListWidgetItem]:
        return [self.formats.item(i) for i in range(self.formats.count())]

    def _chosen(self) -> tuple[str, ...]:
        checked = Qt.CheckState.Checked
        found = [i for i in self._items() if i.checkState() == checked]
        return tuple(i.data(Qt.ItemDataRole.UserRole) for i in found)

    def choice(self) -> ExportChoice:
        """The options in the fields."""
        return ExportChoice(
            formats=self._chosen(),
            rate=self.rate.value(),
            axes=self.axes.currentData(),
            units=self.units.currentData(),
            anonymous=self.anonymous.isChecked(),
            task=self.task.text(),
            split=self.split.isChecked(),
        )

    def show_choice(self, choice: ExportChoice) -> None:
        """Fill the fields with these options."""
        for item in self._items():
            on = item.data(Qt.ItemDataRole.UserRole) in choice.formats
            item.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
        self.rate.setValue(choice.rate)
        self.axes.setCurrentIndex(self.axes.findData(choice.axes))
        self.units.setCurrentIndex(self.units.findData(choice.units))
        self.anonymous.setChecked(choice.anonymous)
        self.task.setText(choice.task)
        self.split.setChecked(choice.split)

    # --- the export

    def _start(self) -> None:
        choice, folder = self.choice(), self.folder.text().strip()
        self._store.update(export=choice.as_dict(), export_folder=folder)
        taken: set[Path] = set()
        for form in choice.formats:
            together = FORMATS.get(form).dataset is not None
            for source in self._sources[:1] if together else self._sources:
                request = self._request(source, form, choice, taken)
                if together:
                    request = replace(request, also=self._sources[1:])
                taken.add(request.target)
                self.wanted.emit(request)
        self.close()

    def _request(
        self, source: Path, form: str, choice: ExportChoice, taken: set[Path]
    ) -> ExportRequest:
        """The request for one session and format; existing files are never overwritten."""
        target = free_target(Path(self.folder.text()), source, form, taken)
        part = self._part if self.range.isChecked() else None
        return ExportRequest(source, form, target, part, choice.options_of(form))


# ---- export options, as stored in the settings and in presets


@dataclass(frozen=True)
class ExportChoice:
    """``rate`` Hz, 0 as recorded; ``axes`` and ``units`` empty: default of the format; ``task`` and
    ``split`` of data sets: see `DatasetOptions`."""

    formats: tuple[str, ...] = ("csv",)
    rate: float = 0.0
    axes: str = ""
    units: str = ""
    anonymous: bool = False
    task: str = ""
    split: bool = False

    @property
    def is_dataset(self) -> bool:
        """Whether one of the formats contains many sessions."""
        return any(FORMATS.get(form).dataset is not None for form in self.formats)

    def options_of(self, form: str) -> ExportOptions:
        """The options for one of the formats; see `ExportFormat.without_unused`."""
        return FORMATS.get(form).without_unused(self.options)

    @property
    def options(self) -> ExportOptions:
        return ExportOptions(
            rate=self.rate or None,
            axes=self.axes or None,
            units=self.units or None,
            anonymous=PERSONAL if self.anonymous else (),
            dataset=DatasetOptions(self.task.strip(), self.split),
        )

    def as_dict(self) -> dict[str, Any]:
        """As stored in the settings."""
        return {**asdict(self), "formats": list(self.formats)}


def choice_from(data: object) -> ExportChoice:
    """The options from the settings; invalid or unknown entries are replaced by defaults."""
    found = data if isinstance(data, Mapping) else {}
    usual = ExportChoice()
    names = found.get("formats")
    listed = names if isinstance(names, list) else []
    known = [kind.name for kind in formats() if kind.name in listed]
    rate = found.get("rate")
    low, high = RATES
    return ExportChoice(
        formats=tuple(known) or usual.formats,
        rate=float(rate) if isinstance(rate, int | float) and low <= rate <= high else usual.rate,
        axes=_of(found.get("axes"), AXES_NAMES),
        units=_of(found.get("units"), tuple(UNITS)),
        anonymous=found.get("anonymous") is True,
        task=task if isinstance(task := found.get("task"), str) else "",
        split=found.get("split") is True,
    )


def _of(value: object, known: tuple[str, ...]) -> str:
    return value if isinstance(value, str) and value in known else ""
