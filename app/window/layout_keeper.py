"""Which layout is shown: of a job, or one stored under a name; each returns as it was left."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMainWindow, QMenu

from app.storage.settings import SettingsStore
from app.widgets.question import answer, choice
from app.window.commands import Commands, MenuCommand
from app.window.docks import DockShares
from app.window.layouts import (
    REPLAY_NEEDS,
    REVIEW,
    Docks,
    Job,
    arrange,
    bring_main_to_front,
    capture,
    job_of,
    place_below,
    restore,
    title_of,
)

EARLY_SHARE = 0.6  # of the window's height, for the library below the start page


class LayoutKeeper(QObject):
    """Switches layouts; ``named`` are those that the user has stored."""

    chosen_early = Signal(str)  # a job, while the start page is shown

    def __init__(
        self, window: QMainWindow, docks: Docks, jobs: Mapping[str, Job], store: SettingsStore
    ) -> None:
        super().__init__(window)
        self.jobs = jobs
        self._window, self._docks, self._store = window, docks, store
        self._actions: dict[str, QAction] = {}
        self.named = NamedLayouts(self, window, store)
        self.shown = False  # docks are shown; before, the start page is
        self._visitors: set[str] = set()  # docks that the program has added to the layout
        self._before_review: tuple[str, dict[str, Any]] | None = None  # a job and its layout
        DockShares(window, docks, lambda: self.shown)

    def list_commands(self, commands: Commands) -> dict[str, QAction]:
        """Add the menu; returns the actions of the jobs, by the names of their icons."""
        menu = self.tr("&Layout")
        for i, job in enumerate(self.jobs.values(), start=1):
            command = MenuCommand(
                f"job_{job.name}", menu, title_of(job), partial(self.choose, job.name), f"Alt+{i}"
            )
            self._actions[job.name] = commands.add(command)
        self.named.list_commands(commands, menu)
        self._tick()
        return {self.jobs[name].icon: action for name, action in self._actions.items()}

    # --- the jobs

    def show_first(self, replay: bool = False) -> None:
        """Show the docks as they were when the program ended; for a replay in its own layout."""
        self.shown = True
        value = self._store.value
        job, layout = value.job, value.layout or value.job_layouts.get(value.job)
        if replay and not job_of(self.jobs, job).shown.issuperset(REPLAY_NEEDS):
            self._before_review = job, layout if isinstance(layout, dict) else {}
            self._store.update(job=REVIEW)
            job, layout = REVIEW, value.job_layouts.get(REVIEW)
        self._apply(job, layout)

    def choose(self, job: str) -> None:
        """Show the layout of a job as the user left it, with its main tabs in front."""
        if not self.shown:
            self._store.update(job=job, layout={})
            self._tick()
            self.chosen_early.emit(job)
            return
        self._leave()
        self._store.update(job=job)
        self._apply(job, self._store.value.job_layouts.get(job))

    def _apply(self, job: str, layout: object) -> None:
        """``layout``: of ``job``, or with a name where that is empty; else the job's default."""
        known = isinstance(layout, dict) and bool(layout)
        if not (isinstance(layout, dict) and known and restore(self._window, self._docks, layout)):
            arrange(self._window, self._docks, job_of(self.jobs, job))
        if job:
            bring_main_to_front(self._docks, job_of(self.jobs, job))
        self._tick()

    def reset(self) -> None:
        """Restore the default layout of the job; nothing while no docks are shown."""
        if not self.shown:
            return
        job = job_of(self.jobs, self._store.value.job)
        others = {k: v for k, v in self._store.value.job_layouts.items() if k != job.name}
        self._store.update(job=job.name, job_layouts=others)
        self._visitors.clear()
        arrange(self._window, self._docks, job)
        self._tick()

    def _leave(self) -> dict[str, Any]:
        """Store the job's layout, without visitors; returns it."""
        for name in self._visitors:
            self._docks[name].hide()
        self._visitors.clear()
        inner = self._window.layout()
        if inner is not None:
            inner.activate()  # sizes are those without visitors, and after the latest change
        self._before_review = None
        job, stored = self._store.value.job, self._store.value.job_layouts
        layout = capture(self._window, self._docks)
        if job:
            self._store.update(job_layouts={**stored, job: layout})
        return layout

    # --- panels that are added to a layout

    def visit(self, name: str) -> None:
        """Show a dock at the program's own initiative: it is hidden again with the layout."""
        dock = self._docks[name]
        if not self.shown and name == "library":
            place_below(self._window, dock, EARLY_SHARE)
        elif self.shown and dock.isHidden():
            self._visitors.add(name)
        dock.show()
        dock.raise_()

    def add_dock(self, name: str) -> None:
        """Add this dock to the layout, as the user requested; it is stored with it."""
        self._visitors.discard(name)

    def show_review(self) -> None:
        """Show the layout for a replay, unless the present one has the docks that it needs."""
        if not any(self._docks[name].isHidden() for name in REPLAY_NEEDS):
            return
        job = self._store.value.job
        before = job, self._leave()
        self.choose(REVIEW)
        if job != REVIEW:
            self._before_review = before

    def leave_review(self) -> None:
        """Return to the layout that `show_review` replaced, if the user has chosen no other."""
        if self._before_review is None:
            return
        job, layout = self._before_review
        self._leave()
        self._store.update(job=job)
        self._apply(job, layout)

    def _tick(self) -> None:
        for name, action in self._actions.items():
            action.setChecked(name == self._store.value.job)

    def current(self) -> dict[str, Any]:
        """The present layout; the stored one while no docks are shown."""
        return capture(self._window, self._docks) if self.shown else self._store.value.layout

    def close(self) -> None:
        """Store which layout the next start begins with: not the one of a replay that ends now."""
        if not self.shown:
            return
        before, layout = self._before_review, self._leave()
        job, layout = before if before is not None else (self._store.value.job, layout)
        self._store.update(job=job, layout=layout)

    def apply_named(self, layout: dict[str, Any]) -> None:
        """Show a stored layout that belongs to no job."""
        self._leave()
        self._store.update(job="")
        self._apply("", layout)


class NamedLayouts(QObject):
    """Layouts that the user has stored under names, and their commands."""

    removed = Signal(str, object)  # a sentence, and a function that undoes it

    def __init__(self, keeper: LayoutKeeper, window: QMainWindow, store: SettingsStore) -> None:
        super().__init__(keeper)
        self._keeper, self._window, self._store = keeper, window, store
        self._changes: dict[str, QAction] = {}
        self._menu: QMenu | None = None

    def list_commands(self, commands: Commands, menu: str) -> None:
        """Add the commands, and a menu of the names, to the ``menu`` of layouts."""
        for key, text, run in (
            ("keep_layout", self.tr("&Save layout…"), self._ask_name),
            ("rename_layout", self.tr("&Rename layout…"), self._ask_rename),
            ("delete_layout", self.tr("&Delete layout…"), self._ask_delete),
        ):
            separator = key == "keep_layout"
            self._changes[key] = commands.add(
                MenuCommand(key, menu, text, run, separator=separator)
            )
        self._menu = commands.menu(menu).addMenu(self.tr("Saved layouts"))
        self._list()

    def save(self, name: str) -> None:
        """Store the present layout under a name; one of that name is replaced."""
        if name and self._keeper.shown:
            layouts = {**self._store.value.layouts, name: self._keeper.current()}
            self._store.update(layouts=layouts)
            self._list()

    def apply(self, name: str) -> None:
        """Show a stored layout."""
        layout = self._store.value.layouts.get(name)
        if self._keeper.shown and isinstance(layout, dict):
            self._keeper.apply_named(layout)

    def rename(self, name: str, other: str) -> None:
        stored = self._store.value.layouts
        if name in stored and other:
            self._store.update(layouts={other if n == name else n: v for n, v in stored.items()})
            self._list()

    def delete(self, name: str) -> None:
        """Delete a stored layout; ``removed`` offers to undo it."""
        stored = self._store.value.layouts
        if name not in stored:
            return
        layout = stored[name]
        self._store.update(layouts={n: v for n, v in stored.items() if n != name})
        self._list()
        text = self.tr("Layout {} deleted.").format(name)
        self.removed.emit(text, lambda: self._put_back(name, layout))

    def _put_back(self, name: str, layout: dict[str, Any]) -> None:
        """Unless another one was stored under its name meanwhile."""
        self._store.update(layouts={name: layout, **self._store.value.layouts})
        self._list()

    def _list(self) -> None:
        assert self._menu is not None
        self._menu.clear()
        for name in self._store.value.layouts:
            self._menu.addAction(name, partial(self.apply, name))
        self._menu.setEnabled(bool(self._store.value.layouts))
        for key in ("rename_layout", "delete_layout"):
            self._changes[key].setEnabled(bool(self._store.value.layouts))

    def _ask_name(self) -> None:
        title = self.tr("Save layout")
        name = answer(self._window, title, self.tr("Name of the layout"))
        if name:
            self.save(name)

    def _ask_which(self, title: str) -> str:
        """One of the stored layouts; empty for none."""
        names = list(self._store.value.layouts)
        if not names:
            return ""
        return choice(self._window, title, self.tr("Layout"), names)

    def _ask_rename(self) -> None:
        name = self._ask_which(self.tr("Rename layout"))
        if name:
            title = self.tr("Rename {}").format(name)
            other = answer(self._window, title, self.tr("Name of the layout"), name)
            if other:
                self.rename(name, other)

    def _ask_delete(self) -> None:
        name = self._ask_which(self.tr("Delete layout"))
        if name:
            self.delete(name)
