"""The positions of docks: an arrangement for each job, and layouts as shares of the window.

Qt stores layouts in px. Each dock's share of the window is stored too, so that a layout saved on
a small screen is the same on a large one.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from PySide6.QtCore import QByteArray, QCoreApplication, QSize, Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow, QToolBar

from app.panels.kind import PanelKind

Docks = dict[str, QDockWidget]
Shares = dict[str, tuple[float, float]]
"""For the window's inner width and height, by dock."""
Groups = tuple[tuple[str, ...], ...]
"""Names of docks in tabs, of each group from the top down."""
LEFT, RIGHT = Qt.DockWidgetArea.LeftDockWidgetArea, Qt.DockWidgetArea.RightDockWidgetArea
BELOW = Qt.DockWidgetArea.BottomDockWidgetArea


@dataclass(frozen=True)
class Job:
    """A task of the user, and the docks that it shows.

    ``left``: share of the width; ``top``: of the height that each column's first group has;
    ``below``: that of the docks below both columns. ``right_px`` and ``below_px``: the minimum
    size of their panels, which on a small screen or at a large scale exceeds that share.
    ``columns`` and ``across``: groups of docks in tabs, from the top down in each column, and the
    one below both; the first of a group is in front. ``next_to`` and ``over``: where other docks
    appear when they are opened: next to a dock, or as a tab of it, by their names.
    """

    name: str
    icon: str
    left: float
    top: tuple[float, float] = (1.0, 1.0)
    below: float = 0.0
    right_px: int = 0
    below_px: int = 0
    columns: tuple[Groups, Groups] = ((), ())
    across: tuple[str, ...] = ()
    next_to: Mapping[str, str] = field(default_factory=dict)
    over: Mapping[str, str] = field(default_factory=dict)

    @property
    def shown(self) -> set[str]:
        return {n for column in self.columns for group in column for n in group} | {*self.across}


FRAMES = (
    Job("set_up", "list-checks", 0.56, (0.58, 1.0)),
    Job("watch", "eye", 0.55),
    Job("record", "circle-dot", 0.70, (0.5, 1), right_px=320),
    Job("look", "film", 0.55, below=0.48, below_px=222),
    Job("all", "panels-top-left", 0.58, (0.55, 0.55), right_px=450, below_px=222),
)
"""The jobs, before the panels that each one shows are added."""
FIRST = "watch"
REVIEW = "look"
"""The job whose layout is for replays."""
REPLAY_NEEDS = ("hand", "library")
"""Docks without which a replay cannot be watched and moved through."""
HALF_AND_MORE = 0.62
"""For the window at most for a side that needs its room; the images keep the rest."""


def title_of(job: Job) -> str:
    """In the user's language."""
    titles = {
        "set_up": QCoreApplication.translate("MainWindow", "Set up"),
        "watch": QCoreApplication.translate("MainWindow", "Live"),
        "record": QCoreApplication.translate("MainWindow", "Capture"),
        "look": QCoreApplication.translate("MainWindow", "Review"),
        "all": QCoreApplication.translate("MainWindow", "All panels"),
    }
    return titles[job.name]


def jobs_for(kinds: Mapping[str, PanelKind]) -> dict[str, Job]:
    """The jobs by name, with panels of these kinds where each kind wants to be shown."""
    next_to = {name: kind.next_to for name, kind in kinds.items() if kind.next_to}
    over = {name: kind.over for name, kind in kinds.items() if kind.over}
    return {
        frame.name: replace(
            frame,
            columns=(_tabs(kinds, frame.name, "left"), _tabs(kinds, frame.name, "right")),
            across=tuple(itertools.chain(*_tabs(kinds, frame.name, "below"))),
            next_to=next_to,
            over=over,
        )
        for frame in FRAMES
    }


def _tabs(kinds: Mapping[str, PanelKind], job: str, area: str) -> Groups:
    """The groups of tabs of one area, from the top."""
    spots = {name: kind.shown[job] for name, kind in kinds.items() if job in kind.shown}
    found = {name: spot for name, spot in spots.items() if spot.area == area}
    return tuple(
        tuple(sorted((n for n, s in found.items() if s.group == i), key=lambda n: found[n].tab))
        for i in sorted({spot.group for spot in found.values()})
    )


def job_of(jobs: Mapping[str, Job], name: str) -> Job:
    """The job of that name, or the first one's."""
    return jobs.get(name, jobs[FIRST])


def arrange(window: QMainWindow, docks: Docks, job: Job) -> None:
    """Put all docks where ``job`` has them, those that it shows in front."""
    layout = window.layout()
    assert layout is not None
    layout.setEnabled(False)  # once for all docks: each would lay out those before it again
    try:
        _arrange(window, docks, job)
    finally:
        layout.setEnabled(True)
        layout.activate()


def _arrange(window: QMainWindow, docks: Docks, job: Job) -> None:
    for dock in docks.values():
        window.removeDockWidget(dock)
        dock.setFloating(False)
    for area, column in zip((LEFT, RIGHT), job.columns, strict=True):
        for group in column:
            _add(window, docks, area, group)
    if job.across:
        _add(window, docks, BELOW, job.across)
    neighbours = {n: at for n, at in job.next_to.items() if n not in job.shown and at in job.shown}
    for name, at in neighbours.items():
        window.splitDockWidget(docks[at], docks[name], Qt.Orientation.Horizontal)
        docks[name].hide()
    for name in docks.keys() - job.shown - neighbours.keys():  # where they appear when opened
        host = job.across[0] if job.across else job.columns[1][-1][0]
        if name in job.over and job.over[name] in job.shown:
            window.tabifyDockWidget(docks[job.over[name]], docks[name])
        elif host in ("hand", "cameras"):
            window.addDockWidget(BELOW, docks[name])
        else:
            window.tabifyDockWidget(docks[host], docks[name])
        docks[name].hide()
    hidden = [docks[n] for n in docks if n not in job.shown and n not in {*neighbours, *job.over}]
    for first, second in itertools.pairwise(hidden):
        window.tabifyDockWidget(first, second)
    for name in docks:
        docks[name].setVisible(name in job.shown)
    for group in _groups(job):
        docks[group[0]].raise_()
    resize(window, docks, _shares(job, inside(window)))


def bring_main_to_front(docks: Docks, job: Job) -> None:
    """Raise the first tab of each group of ``job`` that is shown.

    *All panels* is for no task in particular: its tabs stay as they were.
    """
    for group in _groups(job) if job.name != "all" else ():
        if not docks[group[0]].isHidden():
            docks[group[0]].raise_()


def place_below(window: QMainWindow, dock: QDockWidget, share: float) -> None:
    """Show ``dock`` over the whole width, below, with a ``share`` of the window's height."""
    window.addDockWidget(BELOW, dock)
    dock.show()
    height = round(share * inside(window).height())
    window.resizeDocks([dock], [height], Qt.Orientation.Vertical)


def _groups(job: Job) -> list[tuple[str, ...]]:
    found = [group for column in job.columns for group in column]
    return [*found, job.across] if job.across else found


def _add(window: QMainWindow, docks: Docks, area: Qt.DockWidgetArea, names: Sequence[str]) -> None:
    for name in names:
        window.addDockWidget(area, docks[name])
        docks[name].show()
    for first, second in itertools.pairwise(names):
        window.tabifyDockWidget(docks[first], docks[second])


def _shares(job: Job, room: QSize) -> Shares:
    shares: Shares = {}
    least = min(HALF_AND_MORE, job.below_px / room.height())
    below = max(job.below, least) if job.across else 0.0
    left = min(job.left, max(1 - HALF_AND_MORE, 1 - job.right_px / room.width()))
    above = 1.0 - below
    highest = 1.0 if job.across else 1.0 - least
    for column, width, top in zip(job.columns, (left, 1 - left), job.top, strict=True):
        for i, group in enumerate(column):
            share = min(top, highest) if i == 0 else 1 - min(top, highest)
            shares[group[0]] = (width, above * share)
    if job.across:
        shares[job.across[0]] = (1.0, below)
    return shares


def inside(window: QMainWindow, size: QSize | None = None) -> QSize:
    """The area of the window that docks share, or of a window of ``size``."""
    size = size if size is not None else window.size()
    bars = window.statusBar().height() + window.menuBar().height()
    bars += max((bar.height() for bar in window.findChildren(QToolBar)), default=0)
    return QSize(max(1, size.width()), max(1, size.height() - bars))


def shares_of(window: QMainWindow, docks: Docks, size: QSize | None = None) -> Shares:
    """The share of each dock in front, of a window of ``size`` (None: the current one)."""
    room = inside(window, size)
    return {
        name: (dock.width() / room.width(), dock.height() / room.height())
        for name, dock in docks.items()
        if not dock.isFloating() and not dock.visibleRegion().isEmpty()
    }


def resize(window: QMainWindow, docks: Docks, shares: Shares) -> None:
    """Give each dock its share."""
    room = inside(window)
    known = [name for name in shares if name in docks]
    found = [docks[name] for name in known]
    widths = [max(1, round(shares[name][0] * room.width())) for name in known]
    heights = [max(1, round(shares[name][1] * room.height())) for name in known]
    window.resizeDocks(found, widths, Qt.Orientation.Horizontal)
    window.resizeDocks(found, heights, Qt.Orientation.Vertical)


def capture(window: QMainWindow, docks: Docks) -> dict[str, Any]:
    """The current layout, for the settings file."""
    state = bytes(window.saveState().toBase64().data()).decode()
    shares = {name: list(share) for name, share in shares_of(window, docks).items()}
    return {"state": state, "shares": shares}


def restore(window: QMainWindow, docks: Docks, layout: dict[str, Any]) -> bool:
    """Apply a layout saved at any window size; returns whether that was possible."""
    state, shares = layout.get("state"), layout.get("shares")
    if not isinstance(state, str) or not isinstance(shares, dict):
        return False
    if not window.restoreState(QByteArray.fromBase64(state.encode())):
        return False
    resize(window, docks, {n: (float(w), float(h)) for n, (w, h) in shares.items()})
    return True
