"""The window: docks, commands, one timer that asks for the latest."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QByteArray, Qt, QTimer
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QFileDialog,
    QInputDialog,
    QMainWindow,
    QToolBar,
)

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost, SetupFactory
from app.engines.snapshot import Snapshot
from app.jobs.outputs import Outputs
from app.panels.calibration.panel import CalibrationPanel
from app.panels.cameras import CamerasPanel
from app.panels.checklist import ChecklistPanel
from app.panels.colours.panel import ColoursPanel
from app.panels.hand.panel import HandPanel
from app.panels.library.panel import LibraryPanel
from app.panels.log import LogPanel
from app.panels.panel import Panel
from app.panels.recording import RecordingPanel
from app.panels.sensors import SensorsPanel
from app.panels.start_page import StartPage
from app.panels.streams import StreamsPanel
from app.platform.crash import CrashWatch
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore
from app.viewmodels.recording import RecordingPlan, duration_text
from app.viewmodels.states import BAD, WARN
from app.widgets.banner import Banner
from app.widgets.command_palette import CommandPalette
from app.widgets.scrolled import Scrolled
from app.window import theme
from app.window.bug_reports import Housekeeping
from app.window.commands import Commands
from app.window.layout import arrange
from app.window.refresher import Refresher
from app.window.set_up_dialogs import SetUpDialogs
from app.window.sources import demo_factory, hardware_factory, replay_factory
from app.window.status_bar import StatusBar
from app.window.window_commands import add_commands, add_help
from tracker.messages import Event
from tracker.simulation.camera_device import SimulatedCamera

TICK_MS = 16
STATUS_PERIOD = 0.25
SMALLEST = (800, 500)


class MainWindow(QMainWindow):
    """Everything the user sees. Panels are refreshed only while in sight."""

    def __init__(
        self, store: SettingsStore | None = None, crashes: CrashWatch | None = None
    ) -> None:
        super().__init__()
        self.store = store or SettingsStore()
        self.tasks = TaskOwner(self)
        self.host = EngineHost(self.tasks, self)
        self.set_up = SetUpDialogs(self.host, self.store, self.tasks, self)
        self.outputs = Outputs(self.host, self.store, self.tasks, self)
        self.plan = RecordingPlan(self.store)
        self._status_due = 0.0
        self._refreshes = 0
        self._make_panels()
        self._refresher = Refresher(self.panels, TICK_MS / 1000, self.host.error.emit)
        self._make_frame()
        self.housekeeping = Housekeeping(self, crashes)
        self._make_docks()
        self.commands = Commands(self)
        add_commands(self, self.commands)
        self._add_dock_commands()
        add_help(self, self.commands)
        self._make_tool_bar()
        self._connect()
        self._restore()
        self.set_theme(self.store.value.theme)
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)
        self._timer.start(TICK_MS)

    # --- making

    def _make_panels(self) -> None:
        self.cameras = CamerasPanel(self.host)
        self.hand = HandPanel(self.host, self.store, self.tasks)
        self.sensors = SensorsPanel(self.host)
        self.library = LibraryPanel(self.host, self.store, self.tasks)
        self.log = LogPanel(self.host)
        self.checklist = ChecklistPanel(self.host, self.store)
        self.calibration = CalibrationPanel(self.host, self.store)
        self.colours = ColoursPanel(self.host, self.store, self.tasks)
        self.recording = RecordingPanel(self.host, self.plan)
        self.streams = StreamsPanel(self.host, self.outputs)
        self.panels: list[Panel] = [
            self.cameras,
            self.hand,
            self.sensors,
            self.library,
            self.log,
            self.checklist,
            self.calibration,
            self.colours,
            self.recording,
            self.streams,
        ]

    def _make_frame(self) -> None:
        self.setWindowTitle(self.tr("Glovetrack"))
        self.setMinimumSize(*SMALLEST)
        self.resize(1440, 900)
        self.setDockNestingEnabled(True)
        self.banner = Banner()
        self._banner_bar = QToolBar(self.tr("Messages"))
        self._banner_bar.setObjectName("messages")
        self._banner_bar.setMovable(False)
        self._banner_bar.toggleViewAction().setVisible(False)
        self._banner_action = self._banner_bar.addWidget(self.banner)
        self._banner_bar.hide()
        self.banner.dismissed.connect(self._banner_bar.hide)
        self.start_page = StartPage()
        self.setCentralWidget(self.start_page)
        self.bar = StatusBar(self.tasks)
        self.setStatusBar(self.bar)

    def _make_docks(self) -> None:
        self.docks: dict[str, QDockWidget] = {}
        for panel in self.panels:
            dock = QDockWidget(panel.title(), self)
            dock.setObjectName(f"dock_{panel.name}")
            dock.setWidget(Scrolled(panel))
            self.docks[panel.name] = dock
        arrange(self, self.docks)
        self._show_docks(False)

    def _add_dock_commands(self) -> None:
        for i, (name, dock) in enumerate(self.docks.items(), start=1):
            action = dock.toggleViewAction()
            action.setShortcut(f"Ctrl+{i}" if i < 10 else f"Ctrl+Alt+{i - 9}")
            self.commands.adopt(f"dock_{name}", self.tr("&View"), action)

    def _make_tool_bar(self) -> None:
        bar = QToolBar(self.tr("Commands"))
        bar.setObjectName("commands")
        bar.setMovable(False)
        bar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
        for key in ("demo", "hardware", "open"):
            bar.addAction(self.commands.actions[key])
        bar.addSeparator()
        for key in ("start", "stop", "record", "note"):
            bar.addAction(self.commands.actions[key])
        bar.addSeparator()
        bar.addAction(self.commands.actions["palette"])
        self.addToolBar(bar)
        self.addToolBarBreak()
        self.addToolBar(self._banner_bar)

    def _connect(self) -> None:
        s = self.host
        s.opened.connect(self._opened)
        s.closed.connect(self._closed)
        s.running_changed.connect(lambda _on: self._enable())
        s.recording.changed.connect(lambda _on: self._enable())
        s.error.connect(lambda text: self.show_error(text))
        s.happened.connect(self._heard)
        self.tasks.failed.connect(lambda text: self.show_error(text))
        self.set_up.error.connect(lambda text: self.show_error(text))
        self.set_up.restart.connect(self.start_hardware)
        self.set_up.changed.connect(self._show_set_up)
        self.cameras.set_up_asked.connect(self.set_up.open_camera)
        self.start_page.demo.connect(lambda: self.start_demo())
        self.start_page.connect_devices.connect(self.start_hardware)
        self.start_page.open_session.connect(self.choose_session)
        self.library.replay.connect(self.open_session)
        self.log.report.connect(self.housekeeping.ask_report)
        self.library.compared.connect(lambda _comparison: self.hand.show_reference())
        self.checklist.action.connect(self.run_command)
        self._enable()

    # --- remembered things

    def _restore(self) -> None:
        settings = self.store.value
        if settings.geometry:
            self.restoreGeometry(QByteArray.fromBase64(settings.geometry.encode()))

    def _remember(self) -> None:
        changes = {"geometry": _base64(self.saveGeometry())}
        if not self.start_page.isVisible():
            changes["layout"] = _base64(self.saveState())
        self.store.update(**changes)

    def reset_layout(self) -> None:
        arrange(self, self.docks)

    def set_theme(self, name: str) -> None:
        app = QApplication.instance()
        assert isinstance(app, QApplication)
        colours = theme.apply(app, name)
        self.hand.view.set_background(colours.scene)
        self.sensors.set_colours(colours.base, colours.text)
        if name != self.store.value.theme:
            self.store.update(theme=name)

    # --- engines

    def start_demo(self, fps: float = 30.0, camera: SimulatedCamera | None = None) -> None:
        self._open(self.tr("Starting the demo"), demo_factory(fps=fps, camera=camera))

    def start_hardware(self) -> None:
        settings = self.store.value
        self._open(self.tr("Looking for glove and camera"), hardware_factory(settings))
        self._show_set_up()

    def _show_set_up(self) -> None:
        """Before devices are open the list stands beside the start page."""
        if self.host.setup is None:
            self.checklist.refresh(None)
            self.docks["checklist"].show()

    def set_engine(self, name: str) -> None:
        """Track with another engine, now and after the next start."""
        self.store.update(engine=name)
        self.host.set_engine(name)

    def choose_session(self) -> None:
        path, _ = QFileDialog.getOpenFileName(
            self, self.tr("Open a session"), str(self.plan.folder), "*.mcap"
        )
        if path:
            self.open_session(Path(path))

    def open_session(self, path: Path) -> None:
        """Replay a file through the same panels."""
        self._open(self.tr("Opening {}").format(path.name), replay_factory(path))

    def take_over(self, path: str) -> None:
        """What a second start of the program was given: a session, or "" to be seen."""
        self.setWindowState(self.windowState() & ~Qt.WindowState.WindowMinimized)
        self.raise_()
        self.activateWindow()
        if path and self.host.recording.request is not None:
            text = self.tr("{} waits: a recording is under way.").format(Path(path).name)
            self.show_error(text, (self.tr("Open it now"), lambda: self.open_session(Path(path))))
        elif path:
            self.open_session(Path(path))

    def _open(self, title: str, factory: SetupFactory) -> None:
        self._banner_bar.hide()
        self.host.open(title, factory)

    def _opened(self, setup: EngineSetup) -> None:
        self.setWindowTitle(self.tr("Glovetrack: {}").format(setup.name))
        setup.engine.set_engine(self.store.value.engine)
        self.start_page.hide()
        self._show_docks(True)
        if self.store.value.layout:
            self.restoreState(QByteArray.fromBase64(self.store.value.layout.encode()))
        self.start_page.hide()
        self._enable()

    def _closed(self) -> None:
        self.setWindowTitle(self.tr("Glovetrack"))
        self._refresher.clear()
        self.bar.show_status(None, False)
        self._enable()

    def _show_docks(self, on: bool) -> None:
        if not on:
            for dock in self.docks.values():
                dock.hide()
            return
        arrange(self, self.docks)

    # --- recording

    def toggle_recording(self) -> None:
        self.host.toggle_recording(self.plan.request)

    def toggle_pause(self) -> None:
        self.host.toggle_pause()

    def ask_note(self) -> None:
        text, ok = QInputDialog.getText(self, self.tr("Note"), self.tr("What happened?"))
        if ok and text.strip():
            self.host.note(text.strip())

    def export_session(self) -> None:
        self.docks["library"].show()
        self.docks["library"].raise_()
        self.library.ask_export()

    # --- other commands

    def fit_images(self) -> None:
        self.cameras.left.fit()
        self.cameras.right.fit()

    def open_palette(self) -> None:
        actions = list(self.commands.actions.values())
        palette = CommandPalette(actions, self)
        palette.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        corner = self.geometry().center() - palette.rect().center()
        palette.move(corner.x(), self.geometry().top() + 90)
        palette.open()

    def toggle_full_screen(self) -> None:
        self.setWindowState(self.windowState() ^ Qt.WindowState.WindowFullScreen)

    def run_command(self, key: str) -> None:
        """Trigger a command by its key."""
        if key.startswith("show_"):
            dock = self.docks[key.removeprefix("show_")]
            dock.show()
            dock.raise_()
            return
        self.commands.actions[key].trigger()

    def show_error(self, text: str, action: tuple[str, Callable[[], object]] | None = None) -> None:
        """Say it in the one place for it, with a button where something can be done."""
        self.banner.show_text(text, action)
        self._banner_bar.show()

    def _heard(self, event: Event) -> None:
        """What went wrong in the engine stands in the banner too; the log has everything."""
        if event.kind == "error":
            self.housekeeping.offer_report(event.text)

    def _enable(self) -> None:
        s = self.host
        opened = s.setup is not None
        recordable = s.setup is not None and s.setup.make_recorder is not None
        recording = s.recording.request is not None
        for key, on in (
            ("start", opened and not s.running),
            ("stop", s.running),
            ("close", opened),
            ("record", s.running and recordable),
            ("pause", recording),
            ("note", opened),
        ):
            self.commands.enable(key, on)
        name = self.tr("Stop &recording") if recording else self.tr("&Record")
        self.commands.actions["record"].setText(name)

    # --- the one timer

    @property
    def refreshes(self) -> int:
        """Ticks since the start, for measuring the window's rate."""
        return self._refreshes

    def _tick(self) -> None:
        self._refreshes += 1
        now = time.monotonic()
        view = self.host.snapshot()
        if view is not None:
            self._refresher.refresh(view)
        if now >= self._status_due:
            self._status_due = now + STATUS_PERIOD
            self._refresh_status(view)

    def _refresh_status(self, view: Snapshot | None) -> None:
        self.bar.show_status(view.status if view else None, self.host.running)
        text = ""
        if self.host.recording.request is not None:
            word = self.tr("Paused") if self.host.recording.paused else self.tr("Recording")
            text = f"{word} {duration_text(self.host.recording.elapsed)}"
        self.bar.show_recording(text, WARN.colour if self.host.recording.paused else BAD.colour)

    def closeEvent(self, event: QCloseEvent) -> None:
        """End everything in order: timer, jobs, engine and file, GL."""
        self._timer.stop()
        self._remember()
        self.set_up.shut_down()
        self.host.end()
        self.tasks.shut_down()  # last: a recording that ends has the library read again
        self.outputs.shut_down()
        for panel in self.panels:
            panel.shut_down()
        event.accept()


def _base64(data: QByteArray) -> str:
    return bytes(data.toBase64().data()).decode()
