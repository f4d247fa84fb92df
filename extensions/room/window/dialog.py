"""The dialog *Room tracker*: source, test, and the alignment by a guided movement."""

from __future__ import annotations

from html import escape

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine_host import EngineHost
from app.jobs.remote import RemoteControl
from app.panels.command_kind import CommandContext
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore
from app.viewmodels.streams import TEST_LOOKS, door_row
from app.words import notice_text, tr
from extensions.room.window.align_box import AlignBox
from extensions.room.window.listening import (
    ROOM_KINDS,
    Listened,
    listen_job,
    pose_door,
    tracker_lines,
    verdict,
)
from extensions.room.window.source_form import SourceForm
from tracker.hand.names import SIDES


class RoomDialog(QDialog):
    """Edits the settings of remote control that live tracking uses."""

    def __init__(
        self,
        host: EngineHost,
        remote: RemoteControl,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._host, self._remote, self._tasks = host, remote, tasks
        self.setWindowTitle(self.tr("Room tracker"))
        self.setObjectName("room_tracker")
        self._column = QVBoxLayout(self)
        self._column.addLayout(self._source())
        self.form = SourceForm(remote, self.name)
        self._column.addWidget(self.form)
        self._column.addLayout(self._test())
        self.align = AlignBox(host, remote, store.path.parent / "trackers", tasks)
        self.align.wanted = self._ready_to_align
        self._column.addWidget(self.align)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        self._column.addWidget(buttons)
        remote.changed.connect(self.show_state)
        host.running_changed.connect(self._running_changed)
        self.align.use(self.name)
        self.show_state()

    # --- the source

    def _source(self) -> QFormLayout:
        self.source = QComboBox()
        for name, kind in self._remote.kinds.items():
            if name in ROOM_KINDS:
                self.source.addItem(tr(kind.title), name)
        first = next(
            (n for n in self._remote.kinds if n in ROOM_KINDS and self._remote.is_on(n)), ""
        )
        self.source.setCurrentIndex(max(self.source.findData(first), 0))
        self.source.activated.connect(lambda _i: self._change_source())
        self.on = QCheckBox(self.tr("Receive poses from this source"))
        self.on.toggled.connect(self._switch)
        self.state = QLabel()
        self.state.setWordWrap(True)
        form = QFormLayout()
        form.addRow(self.tr("Source"), self.source)
        form.addRow(self.on)
        form.addRow(self.state)
        return form

    @property
    def name(self) -> str:
        """For the source that is shown."""
        return str(self.source.currentData())

    def _change_source(self) -> None:
        self.form.apply()
        self.align.stop()
        form = SourceForm(self._remote, self.name)
        self._column.replaceWidget(self.form, form)
        self.form.hide()
        self.form.deleteLater()
        self.form = form
        self.outcome.clear()
        self.align.use(self.name)
        self.show_state()

    def _switch(self, on: bool) -> None:
        self.form.apply()
        self._remote.switch(self.name, on)

    def _ready_to_align(self) -> bool:
        """Store the settings; whether the source is on with them."""
        self.form.apply()
        if self._remote.door(self.name) is not None:
            return True
        if self._remote.is_on(self.name):
            self.align.show_result(self.tr("The source is being opened. Start again."))
        else:
            self.align.show_result(self.tr("Switch the source on and test it first."))
        return False

    # --- the test

    def _test(self) -> QHBoxLayout:
        self.test = QPushButton(self.tr("&Test"))
        self.test.setToolTip(self.tr("Whether poses arrive, and of which trackers"))
        self.test.clicked.connect(self._begin_test)
        self.outcome = QLabel()
        self.outcome.setWordWrap(True)
        self.outcome.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        row = QHBoxLayout()
        row.addWidget(self.test, 0, Qt.AlignmentFlag.AlignTop)
        row.addWidget(self.outcome, 1)
        return row

    def _begin_test(self) -> None:
        self.form.apply()
        self.test.setEnabled(False)
        self.outcome.setText(self.tr("Listening…"))
        kind = self._remote.kinds[self.name]
        door = pose_door(self._remote.door(self.name))
        if door is None and self._remote.is_on(self.name):
            self.outcome.setText(self.tr("The source is being opened. Test it again."))
            self.test.setEnabled(True)
            return
        job = listen_job(kind, self.form.options(), door)
        self._tasks.run(
            self.tr("Testing {}").format(tr(kind.title)),
            job,
            done=self._show_test,
            failed=self._test_failed,
            ended=lambda: self.test.setEnabled(True),
        )

    def _show_test(self, found: Listened) -> None:
        self.form.show_names(found.trackers)
        what = verdict(found, {side: self.form.tracker(side) for side in SIDES})
        look = TEST_LOOKS[what.severity]
        lines = "<br>".join(escape(line) for line in (notice_text(what), *tracker_lines(found)))
        self.outcome.setText(f'<span style="color:{look.colour}">{look.sign}</span> {lines}')

    def _test_failed(self, why: str) -> None:
        self.outcome.setText(escape(why))

    # --- the state

    def show_state(self) -> None:
        """Show whether the source is open, and what it received so far."""
        name = self.name
        with QSignalBlocker(self.on):
            self.on.setChecked(self._remote.is_on(name))
        problem = self._remote.problems.get(name, "")
        row = door_row(self._remote.is_on(name), self._remote.counts(name), problem)
        text = f"{row.state}: {problem}" if problem else row.state
        self.state.setText(
            f'<span style="color:{row.look.colour}">{row.look.sign}</span> {escape(text)}'
        )
        self.align.show_hands()

    def _running_changed(self, _on: bool) -> None:
        self.align.stop()
        self.show_state()

    def done(self, result: int) -> None:
        """Close; what was entered is stored."""
        self.form.apply()
        self.align.stop()
        super().done(result)


def open_dialog(on: CommandContext) -> None:
    """Open the dialog."""
    on.show_dialog(
        "room_tracker", lambda: RoomDialog(on.host, on.remote, on.store, on.tasks, on.window)
    )
