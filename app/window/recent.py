"""What the start page shows of earlier work, and how a recording that was cut off is recovered."""

from __future__ import annotations

from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.jobs.derived_sessions import recover_job
from app.panels.library.panel import LibraryPanel
from app.panels.start_page import StartPage
from app.platform.tasks import JobProgress, TaskOwner
from app.storage.settings import SettingsStore, sessions_folder
from app.viewmodels.recent import (
    Earlier,
    is_complete,
    look_back,
    newest,
    recovered,
    renamed,
    with_recent,
)
from app.widgets.banner import Action
from app.window.message_bar import MessageBar


class RecentSessions(QObject):
    """Remembers what is opened and recorded; looks back when the window starts."""

    def __init__(
        self,
        page: StartPage,
        host: EngineHost,
        store: SettingsStore,
        tasks: TaskOwner,
        messages: MessageBar,
        library: LibraryPanel,
    ) -> None:
        super().__init__(page)
        self._page, self._store, self._tasks = page, store, tasks
        self._messages, self._library = messages, library
        host.opened.connect(self._opened)
        self._host = host
        self._interrupted = store.value.recording  # by the end of the last run
        host.recording.begun.connect(self._begun)
        host.recording.finished.connect(self._finished)
        page.recover.connect(self.recover)
        page.recent_asked.connect(library.replay)
        library.files.made.connect(self.offer)
        library.files.renamed.connect(self._renamed)
        library.files.changed.connect(self._changed)
        self.look()

    def look(self) -> None:
        """Anew, in the background; a first start has nothing to look at."""
        known, folder = tuple(self._store.value.recent), sessions_folder(self._store.value)
        if not known and not newest(folder):
            return

        def job(progress: JobProgress) -> Earlier:
            return look_back(known, folder, datetime.now(), progress)

        self._tasks.run(self.tr("Looking for earlier sessions"), job, self._page.show_earlier)

    def _opened(self, setup: EngineSetup) -> None:
        if setup.player is None:
            return
        path = setup.player.path
        self._remember(path)
        if setup.player.cut_off:
            self._offer_recovery(path)

    def _begun(self) -> None:
        """A start after a crash asks for the file that was being written."""
        request = self._host.recording.request
        if request is not None:
            self._store.update(recording=str(request.path.absolute()))

    def _finished(self, path: Path) -> None:
        if self._host.recording.request is None:
            self._store.update(recording="")
        self._remember(path)

    def explain_crash(self, sentence: str, report: Action) -> None:
        """After ``sentence``, say what became of the recording that the crash interrupted."""
        path, self._interrupted = Path(self._interrupted), ""
        if not path.is_file():
            return
        self._store.update(recording="")

        def job(progress: JobProgress) -> bool:
            return is_complete(path, progress)

        def done(complete: bool) -> None:
            if not complete:
                self._offer_recovery(path, sentence, report)
                return
            self._remember(path)
            text = self.tr("{} Your recording {} is complete.").format(sentence, path.stem)
            show = (self.tr("Show it"), partial(self._library.replay.emit, path))
            self._messages.say(text, show, report)

        title = self.tr("Checking {}").format(path.name)
        self._tasks.run(title, job, done, self.look)

    def _offer_recovery(self, path: Path, before: str = "", *others: Action) -> None:
        """Of one that was recovered before, the recovered one; ``before``: the sentence before."""
        whole = recovered(path)
        if whole.exists():
            text = self.tr("The recording {} was cut off. What it holds is whole in {}.")
            show = (self.tr("Show it"), partial(self._library.replay.emit, whole))
            text = f"{before} {text.format(path.name, whole.name)}".strip()
            self._messages.say(text, show, *others)
        else:
            text = self.tr("The recording {} was cut off. What it holds can be recovered.")
            help_it = (self.tr("Recover"), partial(self.recover, path))
            self._messages.say(f"{before} {text.format(path.name)}".strip(), help_it, *others)

    def _remember(self, path: Path) -> None:
        self._store.update(recent=with_recent(self._store.value.recent, path))

    def _renamed(self, before: Path, path: Path) -> None:
        self._store.update(recent=renamed(self._store.value.recent, before, path))

    def _changed(self) -> None:
        """The library can stand beside the start page."""
        if not self._page.isHidden():
            self.look()

    def recover(self, path: Path) -> None:
        """Make a whole file of it, in the background; the original stays."""
        title = self.tr("Recovering {}").format(path.name)
        self._tasks.run(title, recover_job(path), self._recovered, self.look)

    def _recovered(self, path: Path) -> None:
        text = self.tr("What could be read of the recording is in {}.").format(path.name)
        self._library.rescan()
        self.offer(path, text)

    def offer(self, path: Path, text: str) -> None:
        """A new session has come to be: what one does with it next."""
        show = (self.tr("Show it"), partial(self._library.replay.emit, path))
        export = (self.tr("Export…"), partial(self._library.ask_export_of, [path]))
        self._messages.say(text, show, export, good=True)
