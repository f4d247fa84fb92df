"""Where docks stand: an arrangement for each job, and layouts as shares of the window.

Qt keeps layouts in px. Here the share of the window that each dock has is kept beside that, so that
a layout kept on a small screen is the same layout on a large one.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QByteArray, QCoreApplication, QSize, Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow, QToolBar

Docks = dict[str, QDockWidget]
Shares = dict[str, tuple[float, float]]
"""Of the window's inner width and height, by dock."""
LEFT, RIGHT = Qt.DockWidgetArea.LeftDockWidgetArea, Qt.DockWidgetArea.RightDockWidgetArea
BELOW = Qt.DockWidgetArea.BottomDockWidgetArea


@dataclass(frozen=True)
class Job:
    """What one does, and what is in sight for it.

    Groups of docks in tabs, from the top down in each column and below both; the first of a group
    is in front. ``left``: share of the width; ``top``: of the height that each column's first
    group has; ``below``: that of what is below both columns. ``right_px`` and ``below_px``: what
    their panels need at least, on a small screen or a large scale more than that share.
    """

    name: str
    icon: str
    columns: tuple[tuple[tuple[str, ...], ...], tuple[tuple[str, ...], ...]]
    left: float
    top: tuple[float, float] = (1.0, 1.0)
    across: tuple[str, ...] = ()
    below: float = 0.0
    right_px: int = 0
    below_px: int = 0

    @property
    def shown(self) -> set[str]:
        return {n for column in self.columns for group in column for n in group} | {*self.across}


JOBS = (
    Job(
        "set_up",
        "list-checks",
        ((("cameras",), ("sensors",)), (("checklist", "calibration", "colours"),)),
        0.56,
        (0.58, 1.0),
    ),
    Job("watch", "eye", ((("cameras",),), (("hand",),)), 0.55),
    Job(
        "record",
        "circle-dot",
        ((("cameras",), ("hand",)), (("recording", "log"),)),
        0.70,
        (0.5, 1),
        right_px=320,
    ),
    Job(
        "look",
        "film",
        ((("cameras",),), (("hand",),)),
        0.55,
        across=("library", "motion", "graphs", "log"),
        below=0.48,
        below_px=222,
    ),
    Job(
        "all",
        "panels-top-left",
        (
            (("cameras",), ("sensors", "motion", "graphs", "library", "log")),
            (
                ("hand", "applications", "robot"),
                ("calibration", "checklist", "colours", "recording", "streams", "devices"),
            ),
        ),
        0.58,
        (0.55, 0.55),
        right_px=450,
        below_px=222,
    ),
)
FIRST = "watch"
REVIEW = "look"
"""The job whose layout is for replays."""
REPLAY_NEEDS = ("hand", "library")
"""Docks without which a replay cannot be watched and moved through."""
HALF_AND_MORE = 0.62
"""Of the window at most for a side that needs its room; the images keep the rest."""
BESIDE = {"robot": "hand"}
"""Docks that come to stand beside another one when they are called, where that is in sight."""
OVER = {"applications": "hand", "graphs": "hand", "devices": "hand"}
"""Docks that come to the place of another when they are called: they need its room."""


def title_of(job: Job) -> str:
    """In the user's language."""
    words = {
        "set_up": QCoreApplication.translate("MainWindow", "Set up"),
        "watch": QCoreApplication.translate("MainWindow", "Watch"),
        "record": QCoreApplication.translate("MainWindow", "Capture"),
        "look": QCoreApplication.translate("MainWindow", "Review"),
        "all": QCoreApplication.translate("MainWindow", "All panels"),
    }
    return words[job.name]


def job_of(name: str) -> Job:
    """The job of that name, or the first one's."""
    return next((j for j in JOBS if j.name == name), next(j for j in JOBS if j.name == FIRST))


def arrange(window: QMainWindow, docks: Docks, job: Job) -> None:
    """Put all docks where they stand for ``job``, in front those that it shows."""
    for dock in docks.values():
        window.removeDockWidget(dock)
        dock.setFloating(False)
    for area, column in zip((LEFT, RIGHT), job.columns, strict=True):
        for group in column:
            _add(window, docks, area, group)
    if job.across:
        _add(window, docks, BELOW, job.across)
    beside = {n: at for n, at in BESIDE.items() if n not in job.shown and at in job.shown}
    for name, at in beside.items():
        window.splitDockWidget(docks[at], docks[name], Qt.Orientation.Horizontal)
        docks[name].hide()
    for name in docks.keys() - job.shown - beside.keys():  # where they come to when called
        host = job.across[0] if job.across else job.columns[1][-1][0]
        if name in OVER and OVER[name] in job.shown:
            window.tabifyDockWidget(docks[OVER[name]], docks[name])
        elif host in ("hand", "cameras"):
            window.addDockWidget(BELOW, docks[name])
        else:
            window.tabifyDockWidget(docks[host], docks[name])
        docks[name].hide()
    hidden = [docks[n] for n in docks if n not in job.shown and n not in {*beside, *OVER}]
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
    """What docks have of the window, or of one of ``size``."""
    size = size if size is not None else window.size()
    bars = window.statusBar().height() + window.menuBar().height()
    bars += max((bar.height() for bar in window.findChildren(QToolBar)), default=0)
    return QSize(max(1, size.width()), max(1, size.height() - bars))


def shares_of(window: QMainWindow, docks: Docks, size: QSize | None = None) -> Shares:
    """The share of each dock in front, of a window of ``size`` (None: as it is now)."""
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
    """The layout as it is now, for the settings file."""
    state = bytes(window.saveState().toBase64().data()).decode()
    shares = {name: list(share) for name, share in shares_of(window, docks).items()}
    return {"state": state, "shares": shares}


def restore(window: QMainWindow, docks: Docks, layout: dict[str, Any]) -> bool:
    """Whether ``layout``, of whatever size of window, could be put on."""
    state, shares = layout.get("state"), layout.get("shares")
    if not isinstance(state, str) or not isinstance(shares, dict):
        return False
    if not window.restoreState(QByteArray.fromBase64(state.encode())):
        return False
    resize(window, docks, {n: (float(w), float(h)) for n, (w, h) in shares.items()})
    return True
