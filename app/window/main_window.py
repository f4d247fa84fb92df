"""The main window: its parts, and how they are connected."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QTimer
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QApplication, QMainWindow, QWidget

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.jobs.drift_learning import DriftLearner
from app.jobs.outputs import Outputs
from app.jobs.pose_reset import PoseReset
from app.jobs.record_key import RecordKey
from app.jobs.remote import RemoteControl
from app.panels.calibration.panel import CalibrationPanel
from app.panels.cameras import CamerasPanel
from app.panels.checklist import ChecklistPanel
from app.panels.colours.panel import ColoursPanel
from app.panels.command_kind import CommandContext
from app.panels.hand.panel import HandPanel
from app.panels.kind import PanelServices
from app.panels.library.panel import LibraryPanel
from app.panels.log import LogPanel
from app.panels.motion.panel import MotionPanel
from app.panels.recording import RecordingPanel
from app.panels.start_page import StartPage
from app.platform.crash import CrashWatch
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore
from app.viewmodels.recording import RecordingPlan
from app.widgets.scrolled import Scrolled
from app.window import theme
from app.window.bug_reports import BugReports, ReportSources
from app.window.commands import Commands, FocusKeys, ToolBar
from app.window.contributions import (
    added_commands,
    make_panels,
    panel_kinds,
    panel_of,
    recording_actions,
)
from app.window.delays import DelayMeter
from app.window.dialogs import Dialogs
from app.window.docks import SMALLEST as SMALLEST
from app.window.docks import fit_to_screen, geometry_of, list_docks, make_docks, restore_geometry
from app.window.layout_keeper import LayoutKeeper
from app.window.layouts import jobs_for
from app.window.message_bar import Announced, ColoursHint, Countdown, MessageBar, MessageRouter
from app.window.recordings import RecentSessions, RecordingChecks
from app.window.set_up_dialogs import SetUpDialogs
from app.window.sources import DEVICES, Drops, Sources
from app.window.status_bar import StatusBar
from app.window.ticker import Ticker
from app.window.udev_rule import show_rule
from app.window.window_commands import Targets, add_commands, add_help, enable_commands

USUAL = (1440, 900)


class MainWindow(QMainWindow):
    """Everything the user sees. Its parts are public, for the tools and tests that drive it."""

    def __init__(
        self, store: SettingsStore | None = None, crashes: CrashWatch | None = None
    ) -> None:
        super().__init__()
        self.store = store or SettingsStore()
        self.tasks = TaskOwner(self)
        self.host = EngineHost(self.tasks, self)
        self.plan = RecordingPlan(self.store)
        self.set_up = SetUpDialogs(self.host, self.store, self.tasks, self)
        self.outputs = Outputs(self.host, self.store, self.tasks, self)
        self.record_key = RecordKey(self.host, self.plan, self)
        self.pose_reset = PoseReset(self.host, self.store, self)
        self.drift = DriftLearner(self.host, self.store, self)
        self.remote = RemoteControl(self.host, self.plan, self.store, self.tasks, self)
        self._make_panels()
        self._make_frame()
        self.docks = make_docks(self, self.panels)
        self.messages.keep_clear(self.library.transport, self.docks["library"])
        self.messages.keep_clear(self.recording.record_button, self.docks["recording"])
        self.layouts = LayoutKeeper(self, self.docks, jobs_for(self.kinds), self.store)
        self.sources = Sources(self.host, self.store, self.messages, self)
        Drops(self, self.sources.take_over)
        self.router = MessageRouter(
            self.messages, self.host, self.sources, self.log, self.calibration
        )
        self._make_countdowns()
        self.checks = RecordingChecks(self.host, self.tasks, self.messages, self.library, self)
        self.reports = bug_reports(self, crashes)
        self.recent = RecentSessions(
            self.start_page, self.host, self.store, self.tasks, self.messages, self.library
        )
        if self.reports.crashed:
            self.recent.explain_crash(self.reports.crashed, self.reports.action)
        self._make_commands()
        self._connect()
        restore_geometry(self, self.store.value.geometry)
        self.set_theme(self.store.value.theme)
        self.ticker = Ticker(self.host, list(self.panels.values()), self.bar, self)
        self.ticker.is_waited_for = lambda: any(
            panel.needs_low_latency for panel in self.panels.values()
        )
        self.ticker.refreshed = DelayMeter(self.host, self.outputs.late).refreshed
        hint = ColoursHint(self.messages, self.colours, self.show_panel)
        self.ticker.colours_unfit.connect(hint.show_unfit)
        self.ticker.no_hand.connect(hint.no_hand)
        self.ticker.start()
        for text in self.not_made:
            self.messages.show_message(text)

    # --- making

    def _make_panels(self) -> None:
        self.context = CommandContext(
            *(self.host, self.store, self.tasks, self, self.set_up.show_once, self.remote),
            lambda path, at: self.sources.open_session(path, at),
        )
        services = PanelServices(
            self.host,
            self.store,
            self.tasks,
            self.plan,
            self.record_key,
            self.outputs,
            self.remote,
            recording_actions(self.context),
        )
        self.kinds = panel_kinds()
        self.not_made: list[str] = []
        self.panels = make_panels(self.kinds, services, self.not_made.append)
        self.kinds = {name: self.kinds[name] for name in self.panels}
        self.cameras = panel_of(self.panels, CamerasPanel)
        self.hand = panel_of(self.panels, HandPanel)
        self.motion = panel_of(self.panels, MotionPanel)
        self.library = panel_of(self.panels, LibraryPanel)
        self.log = panel_of(self.panels, LogPanel)
        self.checklist = panel_of(self.panels, ChecklistPanel)
        self.calibration = panel_of(self.panels, CalibrationPanel)
        self.colours = panel_of(self.panels, ColoursPanel)
        self.recording = panel_of(self.panels, RecordingPanel)

    def _make_frame(self) -> None:
        self.setWindowTitle(self.tr("Glovetrack"))
        fit_to_screen(self, USUAL)
        self.setDockNestingEnabled(True)
        self.start_page = StartPage()
        self.setCentralWidget(self.start_page)
        self.bar = StatusBar(self.tasks)
        self.setStatusBar(self.bar)
        self.messages = MessageBar(self)
        self.banner = self.messages.banner

    def _make_countdowns(self) -> None:
        recording = Announced(
            self.tr("Recording begins in {} s"), lambda: self.plan.countdown_sound
        )
        reset = Announced(
            self.tr("Pose reset in {} s"),
            lambda: self.store.value.pose_reset_sound,
            self.tr("Hold the hand flat, fingers ahead"),
        )
        Countdown(self.record_key, recording, self)
        Countdown(self.pose_reset, reset, self)

    def _make_commands(self) -> None:
        self.commands = Commands(self)
        self._targets = Targets(
            window=self,
            dialogs=Dialogs(self, self.commands),
            checks=self.checks,
            host=self.host,
            sources=self.sources,
            plan=self.plan,
            record_key=self.record_key,
            pose_reset=self.pose_reset,
            set_up=self.set_up,
            layouts=self.layouts,
            reports=self.reports,
            bar=self.bar,
            library=self.library,
            cameras=self.cameras,
            hand=self.hand,
            colours=self.colours,
            calibration=self.calibration,
            added=added_commands(self.context),
        )
        add_commands(self._targets, self.commands)
        numbers = {name: kind.number for name, kind in self.kinds.items()}
        list_docks(self.docks, numbers, self.commands, self.open_panel)
        jobs = self.layouts.list_commands(self.commands)
        add_help(self._targets, self.commands)
        self.tool_bar = ToolBar(self.commands.actions, jobs, self)
        self.addToolBar(self.tool_bar)
        self._keys = FocusKeys(list(self.commands.actions.values()), self)

    def _connect(self) -> None:
        host = self.host
        host.opened.connect(self._opened)
        host.closed.connect(self._closed)
        host.hand_changed.connect(lambda _setup: self._enable())
        host.running_changed.connect(lambda _on: self._enable())
        host.recording.changed.connect(lambda _on: self._enable())
        self.checks.recover.connect(self.recent.recover)
        self.set_up.error.connect(self.router.show_message)
        self.tasks.failed.connect(self.router.show_failed_job)
        self.tasks.noted.connect(self.router.show_message)
        self.set_up.changed.connect(lambda: self.messages.no_longer(DEVICES))
        self.set_up.restart.connect(self.sources.open_devices)
        self.set_up.reopen.connect(self.sources.reopen)
        self.set_up.changed.connect(self._show_set_up)
        self.sources.devices_requested.connect(self._show_set_up)
        self.layouts.chosen_early.connect(self._show_set_up_list)
        self.sources.rule_requested.connect(lambda: show_rule(self.tasks, self))
        self.sources.set_up_requested.connect(lambda: self.show_panel("checklist"))
        self.cameras.set_up_requested.connect(self.set_up.open_camera)
        self.start_page.demo.connect(lambda: self.sources.open_demo())
        self.start_page.connect_devices.connect(self.sources.open_devices)
        self.start_page.open_session.connect(lambda: self.sources.choose_session(self.plan))
        self.start_page.library_requested.connect(lambda: self.show_panel("library"))
        self.library.replay.connect(self.sources.open_session)
        self.library.transport.live_requested.connect(self.sources.go_live)
        self.log.report.connect(self.reports.ask)
        self.library.second_named.connect(self.hand.show_reference)
        self.checklist.action.connect(self.run_command)
        self.calibration.guided_requested.connect(self.set_up.open_guided)
        self.set_up.learned.connect(self.router.offer_to_save_wearer)
        for part in (
            self.calibration.profiles,
            self.colours.image.source,
            self.recording.notes,
            self.layouts.named,
            self.library.files,
            self.library.transport,
            self.motion,
        ):
            part.removed.connect(self.router.show_removed)
        self.set_up.pose_reset_changed.connect(self._pose_reset_set_up)
        self._enable()

    # --- signals of the engine host

    def _opened(self, setup: EngineSetup) -> None:
        live, replay = self.tr("{} – Glovetrack"), self.tr("Replay of {} – Glovetrack")
        self.setWindowTitle((live if setup.player is None else replay).format(setup.name))
        if not self.start_page.isHidden():  # later openings leave panels as the user put them
            self.start_page.hide()
            self.layouts.show_first(replay=setup.player is not None)
        self.library.transport.offer_live(self.sources.can_go_live)
        if setup.player is not None:
            self.layouts.show_review()
            self.show_panel("library", self.library.transport)
        else:
            self.layouts.leave_review()
        self._enable()

    def _closed(self) -> None:
        self.setWindowTitle(self.tr("Glovetrack"))
        self._enable()

    def _enable(self) -> None:
        enable_commands(self._targets, self.commands)

    def _show_set_up(self) -> None:
        """Show the checklist next to the start page, before devices are open."""
        if self.host.setup is None:
            self.checklist.refresh(None)
            self.docks["checklist"].show()

    def _show_set_up_list(self, job: str) -> None:
        """Next to the start page *Set up* is the checklist; other jobs have nothing to show yet."""
        if job == "set_up":
            self._show_set_up()
        else:
            self.docks["checklist"].hide()

    # --- commands

    def run_command(self, key: str) -> None:
        """Trigger a command by its key; ``show_NAME`` brings a panel to the front."""
        if key.startswith("show_"):
            self.show_panel(key.removeprefix("show_"))
        else:
            self.commands.actions[key].trigger()

    def show_panel(self, name: str, part: QWidget | None = None) -> None:
        """Bring a panel to the front; scroll to ``part`` of it where the dock is too small.

        A panel that the layout does not have is hidden again with the layout.
        """
        self.layouts.visit(name)
        area = self.docks[name].widget()
        if part is not None and isinstance(area, Scrolled):
            QTimer.singleShot(0, part, lambda: area.ensureWidgetVisible(part))  # once laid out

    def open_panel(self, name: str) -> None:
        """Show a panel by the user's command: it becomes part of the layout."""
        self.show_panel(name)
        self.layouts.add_dock(name)

    def set_theme(self, name: str) -> None:
        app = QApplication.instance()
        assert isinstance(app, QApplication)
        colours = theme.apply(app, name)
        for panel in self.panels.values():
            panel.show_theme(colours)
        if name != self.store.value.theme:
            self.store.update(theme=name)

    def set_up_pose_reset(self) -> None:
        """Its key, countdown, sound and double tap."""
        self.set_up.open_pose_reset(partial(self.commands.user_of, but="pose_reset"))

    def _pose_reset_set_up(self) -> None:
        self.commands.set_shortcut("pose_reset", self.store.value.pose_reset_key)
        self.pose_reset.listen()

    def set_language(self, code: str) -> None:
        """The language of the next start; texts on the screen do not change."""
        self.store.update(language=code)
        text = self.tr("The language changes after a restart.")
        self.messages.show_message(text, good=True)

    def closeEvent(self, event: QCloseEvent) -> None:
        """End everything in order: timer, jobs, engine and file, GL."""
        self.ticker.stop()
        self.store.update(geometry=geometry_of(self))
        self.layouts.close()
        self.set_up.shut_down()
        self.sources.shut_down()
        self.host.end()
        self.tasks.shut_down()  # last: the end of a recording makes the library scan its folder
        self.outputs.shut_down()
        self.remote.shut_down()
        for panel in self.panels.values():
            panel.shut_down()
        event.accept()


def bug_reports(window: MainWindow, crashes: CrashWatch | None) -> BugReports:
    """Makes the bug reports of this window; shows a notice of its settings, if there is one."""
    if window.store.notice:
        window.messages.show_message(window.store.notice)
    private = [window.docks[name] for name, kind in window.kinds.items() if kind.private]
    sources = ReportSources(window.host, window.store, window.log.model, private)
    return BugReports(sources, window.tasks, window.messages, window, crashes)
