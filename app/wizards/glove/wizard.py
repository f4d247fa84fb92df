"""The glove set-up: selection of the glove, biases at rest, and position of each IMU."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine_host import EngineHost
from app.platform.tasks import JobProgress, TaskOwner
from app.storage.bound_gloves import bound, with_bound
from app.storage.settings import SettingsStore
from app.storage.wearers import WearerStore
from app.wizards.glove.choice import SESSION, SIMULATED, ChoicePage
from app.wizards.glove.feed import GloveFeed, PortFeed, SessionFeed, simulated_feed
from app.wizards.glove.pages import StillPage, WigglePage
from app.wizards.sizing import fit_to_screen
from app.words import error_text
from tracker.base.callbacks import ignore
from tracker.base.errors import DeviceError
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import ImuSample
from tracker.sensors.discovery import PortReport, find_gloves, serial_ports
from tracker.sensors.protocol import BAUDS

TICK_MS = 80
ENOUGH = 0.5  # s of packets needed to compute their rate


class GloveSetup(QDialog):
    """Not modal. ``chosen``: port, glove and hand were stored for the next start; ``measured``: a
    `StillPose` of the glove in use."""

    chosen = Signal()
    measured = Signal(object)

    def __init__(
        self,
        host: EngineHost,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._host, self._store, self._tasks = host, store, tasks
        self._feed: GloveFeed | None = None
        self._source: tuple[str, str, str, int] | None = None
        setup = host.setup
        real = setup is not None and not setup.simulated and setup.player is None
        in_use = real and setup is not None and setup.connection.present
        self.choice = ChoicePage(
            store.value, WearerStore(store.path.parent / "wearers").names(), in_use
        )
        self.still, self.wiggle = StillPage(), WigglePage()
        self._lay_out()
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._tick)
        self._timer.start(TICK_MS)
        self._connect()
        self._choose()
        self.search()

    def _lay_out(self) -> None:
        self.setWindowTitle(self.tr("Glove set-up"))
        self.setObjectName("glove_setup")
        fit_to_screen(self, 820, 600)
        self.tabs = QTabWidget()
        self.tabs.addTab(self.choice, self.tr("&1 Glove"))
        self.tabs.addTab(self.still, self.tr("&2 At rest"))
        self.tabs.addTab(self.wiggle, self.tr("&3 Wiggle test"))
        self.state = QLabel()
        self.use = QPushButton(self.tr("&Use this glove"))
        self.use.setProperty("role", "primary")
        self.use.setDefault(True)
        self.stop = QPushButton(self.tr("Close"))
        row = QHBoxLayout()
        row.addWidget(self.state, 1)
        row.addWidget(self.stop)
        row.addWidget(self.use)
        column = QVBoxLayout(self)
        column.addWidget(self.tabs, 1)
        column.addLayout(row)

    def _connect(self) -> None:
        self.choice.changed.connect(self._choose)
        self.choice.search.connect(self.search)
        self.use.clicked.connect(self._use)
        self.stop.clicked.connect(self.close)
        for page in (self.still, self.wiggle):
            page.requested.connect(self._ask)
        self.still.measured.connect(self._measured)

    # --- which glove

    def search(self) -> None:
        """Query every port for a glove; a port without a response takes seconds."""
        self.choice.show_searching()
        setup, port = self._host.setup, self.choice.port()
        # a port that is already open cannot be opened again
        busy = {port, self._store.value.port if setup is not None else ""}
        baud = self.choice.baud()
        bauds = (baud,) if baud else BAUDS
        self._tasks.run(
            self.tr("Looking for gloves"),
            lambda progress: _search(progress, busy, bauds),
            self._found,  # a bound method: not called after this window was deleted
        )

    def _found(self, reports: list[PortReport]) -> None:
        self.choice.show_ports(reports, self._store.value.port)

    def _choose(self) -> None:
        """Switch to the selected glove."""
        models, port = self.choice.models(), self.choice.port()
        simulated = port == SIMULATED
        self.use.setText(self.tr("&Use these files") if simulated else self.tr("&Use this glove"))
        if models is None or not port:
            return
        hand, glove = models
        source = (port, hand.name, glove.name, self.choice.baud_of_port())
        if source == self._source:
            return
        self._source = source
        self._leave()
        for page in (self.still, self.wiggle):
            page.set_glove(hand, glove)
        if port == SESSION or self._is_in_use(port):
            self._feed = SessionFeed(self._host)
        elif port == SIMULATED:
            self._feed = self._simulated(hand, glove)
        else:
            self._feed = PortFeed(port, len(glove.imus), baud=self.choice.baud_of_port())

    def _is_in_use(self, port: str) -> bool:
        """Whether the glove at this port is the one of the open session, which cannot be opened
        twice."""
        setup = self._host.setup
        if setup is None or setup.simulated or setup.player is not None or not self._host.running:
            return False
        known = bound(self._store.value, setup.connection.number)
        return setup.connection.present and known is not None and known.port == port

    def _simulated(self, hand: HandModel, glove: GloveModel) -> GloveFeed | None:
        """None, with the reason on the page, on a system without pseudo-terminals."""
        try:
            return simulated_feed(hand, glove)
        except DeviceError as error:
            self.choice.words.setText(error_text(error))
            return None

    def _leave(self, then: Callable[[], None] = ignore) -> None:
        """Call ``then`` once the port has been released."""
        feed, self._feed = self._feed, None
        if feed is not None:
            title = self.tr("Releasing the glove's port")
            self._tasks.run(title, lambda _progress: feed.stop(), ended=then)
        else:
            then()

    def _use(self) -> None:
        port = self.choice.port()
        kept = self._store.value.port if port in (SESSION, SIMULATED) else port
        self._bind(port)
        chosen = self.choice.bound()
        self._store.update(
            port=kept,
            baud=self.choice.baud(),
            glove=chosen.glove,
            hand=chosen.hand,
            wearers={**self._store.value.wearers, chosen.side: chosen.wearer},
        )
        self.use.setEnabled(False)
        self._leave(self._used)

    def _used(self) -> None:
        """The window opens the port immediately, so this dialog must have released it."""
        self.chosen.emit()
        self.close()

    def _bind(self, port: str) -> None:
        """Store side, files and wearer of the selected glove if it has reported its number; and its
        port, if that is not listed by the system."""
        number = self.choice.glove_id()
        if number is None and port != SIMULATED and self._feed is not None:
            number = self._feed.glove_id
        if number is None:
            return
        before = bound(self._store.value, number)
        if port == SESSION:
            place = before.port if before is not None else ""
        else:
            place = "" if port in serial_ports() else port
        chosen = replace(self.choice.bound(), port=place)
        self._store.update(gloves=with_bound(self._store.value, number, chosen))

    # --- actions

    def _tick(self) -> None:
        recent: list[ImuSample] = list(self._feed.recent()) if self._feed is not None else []
        self.state.setText(self._answer(recent))
        page = self.tabs.currentWidget()
        if page is self.still:
            self.still.look(recent)
        elif page is self.wiggle:
            self.wiggle.look(recent)

    def _answer(self, recent: list[ImuSample]) -> str:
        """Show which glove it is, and whether it sends data or why not."""
        if self._feed is None:
            return ""
        if self._feed.problem:
            return self._feed.problem
        name = self.choice.glove_name(self._feed.glove_id)
        if not recent:
            return self.tr("{}: waiting for packets…").format(name)
        span = recent[-1].t - recent[0].t
        if span < ENOUGH:
            return self.tr("{}: packets arrive.").format(name)
        rate = (len(recent) - 1) / span
        return self.tr("{}: {} packets per second.").format(name, round(rate))

    def _ask(self, part: str) -> None:
        if self._feed is not None:
            self._feed.ask(part)

    def _measured(self, pose: object) -> None:
        if isinstance(self._feed, SessionFeed):
            self.measured.emit(pose)

    def done(self, result: int) -> None:
        """Release the port, however the dialog is closed."""
        self._timer.stop()
        self._leave()
        super().done(result)


def _search(progress: JobProgress, busy: set[str], bauds: Sequence[int]) -> list[PortReport]:
    paths = [p for p in serial_ports() if p not in busy]
    reports = []
    for i, path in enumerate(paths):
        progress(i / len(paths), path)
        reports += find_gloves([path], bauds=bauds)
    return reports
