"""The gaps of the replayed session: where the hand is not measured, why, and filling them."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QDoubleSpinBox,
    QHeaderView,
    QLabel,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.engines.protocols import Player
from app.jobs.derived_sessions import fill_job, list_gaps_job
from app.platform.tasks import LatestJob, TaskOwner
from app.viewmodels.gaps import (
    KINDS,
    METHODS,
    FilledSession,
    Gap,
    GapFilter,
    SessionGaps,
    cause_text,
    filled_text,
    part_text,
    side_text,
    stretches,
    tip_of,
)
from app.viewmodels.recording import position_text
from app.widgets.measures import TIGHT
from app.widgets.one_line import OneLine
from app.widgets.timeline import TimelineSpan
from app.words import local, tr

START, LENGTH, SIDE, PART, KIND, CAUSE = range(6)
SORTED = int(Qt.ItemDataRole.UserRole)  # sort key of a cell
NUMBER = SORTED + 1  # number of the gap
USUAL_LIMIT, USUAL_LONGEST = 0.5, 0.2  # s
MOST_S = 60.0


class _Cell(QTableWidgetItem):
    """Sorted by a number or a word instead of the displayed text."""

    def __init__(self, text: str, sorted_by: float | str) -> None:
        super().__init__(text)
        self.setData(SORTED, sorted_by)

    def __lt__(self, other: QTableWidgetItem) -> bool:
        return bool(self.data(SORTED) < other.data(SORTED))


class GapPage(QWidget):
    """``seek_requested``: a clicked position (s). ``fill_requested``: fill the selected gaps.
    ``limit_changed``: list the gaps again. ``shown_changed``: the intervals for the timeline."""

    seek_requested = Signal(float)
    fill_requested = Signal()
    limit_changed = Signal()
    shown_changed = Signal(object)  # list[Span]

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.found: SessionGaps | None = None
        self._make_table()
        self._make_controls()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, TIGHT, 0, 0)
        self.empty = QLabel()
        self.empty.setWordWrap(True)
        self.empty.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        column.addWidget(self.empty)
        column.addWidget(self.table)
        self.show_gaps(None)

    def _make_table(self) -> None:
        self.table = QTableWidget(0, 6)
        self.table.setHorizontalHeaderLabels(
            [
                self.tr("Start"), self.tr("Length"), self.tr("Hand"), self.tr("Part"),
                self.tr("Kind"), self.tr("Cause"),
            ]
        )  # fmt: skip
        self.table.verticalHeader().hide()
        self.table.setShowGrid(False)
        self.table.setAccessibleName(self.tr("Gaps of the recording"))
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(CAUSE, QHeaderView.ResizeMode.Stretch)
        header.setSortIndicator(START, Qt.SortOrder.AscendingOrder)
        self.table.setSortingEnabled(True)
        self.table.itemSelectionChanged.connect(self._enable)
        self.table.cellClicked.connect(lambda row, _column: self._seek(row))
        self.table.itemActivated.connect(lambda item: self._seek(item.row()))

    def _make_controls(self) -> None:
        self.kind = self._box(self.tr("Kind of gap"))
        self.kind.addItem(self.tr("All kinds"), "")
        for kind, look in KINDS.items():
            self.kind.addItem(f"{look.sign} {tr(look.word)}", kind)
        self.part = self._box(self.tr("Part of the hand"))
        self.unsensed = self._box(self.tr("Parts without a sensor"))
        self.unsensed.addItem(self.tr("With sensor"), False)
        self.unsensed.addItem(self.tr("All parts"), True)
        self.limit = self._seconds(self.tr("Inferred longer than"), USUAL_LIMIT)
        self.limit.valueChanged.connect(lambda _value: self.limit_changed.emit())
        self.method = QComboBox()
        self.method.setAccessibleName(self.tr("Method"))
        for method, word in METHODS.items():
            self.method.addItem(tr(word), method)
        self.longest = self._seconds(self.tr("Longest gap to fill"), USUAL_LONGEST)
        self.longest.valueChanged.connect(lambda _value: self._enable())
        self.fill_button = QPushButton(self.tr("Fill…"))
        self.fill_button.setToolTip(
            self.tr(
                "Interpolate the selected gaps in a new file, in which they are marked; "
                "the original "
                "recording is not changed"
            )
        )
        self.fill_button.clicked.connect(self.fill_requested)
        self.head = OneLine()
        for box in (self.kind, self.part, self.unsensed):
            box.currentIndexChanged.connect(lambda _index: self._list())
        for widget in (
            self.fill_button, self.method, QLabel(self.tr("up to")), self.longest, self.kind,
            self.part, self.unsensed, QLabel(self.tr("inferred over")), self.limit,
        ):  # fmt: skip
            self.head.add(widget)

    @staticmethod
    def _box(name: str) -> QComboBox:
        box = QComboBox()
        box.setAccessibleName(name)
        box.setToolTip(name)
        return box

    @staticmethod
    def _seconds(name: str, value: float) -> QDoubleSpinBox:
        box = QDoubleSpinBox()
        box.setAccessibleName(name)
        box.setToolTip(name)
        box.setSuffix(" s")
        box.setRange(0.02, MOST_S)
        box.setSingleStep(0.1)
        box.setDecimals(2)
        box.setKeyboardTracking(False)
        box.setValue(value)
        return box

    # --- displayed data

    def show_gaps(self, found: SessionGaps | None) -> None:
        """Show the gaps of a session; None without one."""
        self.found = found
        chosen = self.part.currentData() or ""
        self.part.blockSignals(True)
        self.part.clear()
        self.part.addItem(self.tr("All parts of the hand"), "")
        for part in found.parts if found is not None else ():
            self.part.addItem(part_text(part), part)
        self.part.setCurrentIndex(max(0, self.part.findData(chosen)))
        self.part.blockSignals(False)
        self.table.setColumnHidden(SIDE, found is None or len(found.sides) < 2)
        self._list()

    def _list(self) -> None:
        found = self.found
        chosen = GapFilter(
            self.kind.currentData() or "",
            self.part.currentData() or "",
            bool(self.unsensed.currentData()),
        )
        shown = chosen.shown(found.gaps) if found is not None else []
        self.table.setSortingEnabled(False)  # rows would move while the table is filled
        self.table.setRowCount(len(shown))
        for row, gap in enumerate(shown):
            look = KINDS[gap.kind]
            cells = (
                _Cell(position_text(gap.start), gap.start),
                _Cell(f"{local(gap.length):.2f} s", gap.length),
                _Cell(side_text(gap.side), gap.side),
                _Cell(part_text(gap.part), gap.part),
                _Cell(f"{look.sign} {tr(look.word)}", gap.kind),
                _Cell(cause_text(gap), cause_text(gap)),
            )
            for column, cell in enumerate(cells):
                cell.setToolTip(tip_of(gap))
                cell.setData(NUMBER, gap.number)
                self.table.setItem(row, column, cell)
        self.table.setSortingEnabled(True)
        self._explain_empty(bool(shown))
        spans = stretches(found, shown) if found is not None else []
        self.shown_changed.emit([TimelineSpan(s.start, s.stop, s.colour, s.text) for s in spans])
        self._enable()

    def _explain_empty(self, has_rows: bool) -> None:
        """Explain why the table is empty."""
        if self.found is None:
            self.empty.setText(self.tr("Replay a recording to list its gaps."))
        elif self.found.gaps:
            self.empty.setText(self.tr("No gap matches these filters."))
        else:
            self.empty.setText(self.tr("This recording has no gaps."))
        self.table.setVisible(has_rows)
        self.empty.setVisible(not has_rows)

    def _number_of(self, row: int) -> int:
        item = self.table.item(row, START)
        return -1 if item is None else int(item.data(NUMBER))

    def _seek(self, row: int) -> None:
        item = self.table.item(row, START)
        if item is not None:
            self.seek_requested.emit(float(item.data(SORTED)))

    @property
    def selected(self) -> list[int]:
        """Numbers of the selected gaps."""
        rows = {index.row() for index in self.table.selectedIndexes()}
        return sorted(self._number_of(row) for row in rows)

    def fillable(self) -> list[Gap]:
        """The selected gaps that can be filled and do not exceed the maximum length."""
        if self.found is None:
            return []
        wanted, longest = set(self.selected), self.longest.value() + 1e-9
        return [
            gap
            for gap in self.found.gaps
            if gap.number in wanted and gap.fillable and gap.length <= longest
        ]

    def _enable(self) -> None:
        count = len(self.fillable())
        self.fill_button.setEnabled(count > 0)
        text = self.tr("Fill {} gaps").format(count) if count else self.tr("Fill")
        self.fill_button.setText(text)


class Gaps(QObject):
    """``made``: the Path of a filled session and a message. ``counted``: number of listed gaps.
    ``ended`` after filling, also after a failure."""

    made = Signal(object, str)
    counted = Signal(int)
    ended = Signal()

    def __init__(self, tasks: TaskOwner, page: GapPage, parent: QObject) -> None:
        super().__init__(parent)
        self._tasks, self.page = tasks, page
        self._player: Player | None = None
        self._reading = LatestJob(self.tr("Finding gaps"), self)
        page.limit_changed.connect(self._read)
        page.fill_requested.connect(self.fill)
        page.seek_requested.connect(self._seek)
        page.shown_changed.connect(lambda _shown: self.counted.emit(page.table.rowCount()))

    def set_player(self, player: Player | None) -> None:
        """Set the open replay."""
        self._player = player
        self.page.show_gaps(None)
        self._read()

    def _read(self) -> None:
        if self._player is None or not self._player.tracked:
            self._reading.forget()
            return
        job = list_gaps_job(self._player.path, self.page.limit.value())
        self._reading.run(job, self._show)

    def _show(self, found: SessionGaps) -> None:
        if self._player is not None and self._player.path == found.path:
            self.page.show_gaps(found)

    def _seek(self, position: float) -> None:
        if self._player is not None:
            self._player.play(False)
            self._player.seek(position)

    @property
    def is_interpolated(self) -> bool:
        """Whether the replay position is in a filled gap."""
        found, player = self.page.found, self._player
        return found is not None and player is not None and found.is_interpolated(player.position)

    def fill(self) -> None:
        """Fill the selected gaps in a new file."""
        gaps, found = self.page.fillable(), self.page.found
        if found is None or not gaps:
            return
        path, page = found.path, self.page
        lengths = page.longest.value(), page.limit.value()
        job = fill_job(path, gaps, page.method.currentData(), *lengths)
        title = self.tr("Filling gaps in {}").format(path.name)
        self._tasks.run(title, job, lambda made: self._filled(path, made), self.ended.emit)

    def _filled(self, source: Path, made: FilledSession) -> None:
        self.made.emit(made.path, filled_text(made, source.name))

    def shut_down(self) -> None:
        self._reading.shut_down()
