"""The start page: what was done lately, what was cut off, and no cards above each other."""

from __future__ import annotations

import itertools
import os
import shutil
from datetime import datetime, timedelta
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame

from app.platform.crash import CrashWatch
from app.viewmodels.recent import age_text, look_back, renamed, with_recent
from app.window.main_window import MainWindow
from tests.gui.patience import settled
from tracker.offline.simulate import SimulateOptions, simulate


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    path = tmp_path_factory.mktemp("start") / "simulated.mcap"
    simulate(path, SimulateOptions(seed=3, duration=1.0, fps=10, images=True))
    return path


@pytest.fixture
def sessions(store, session, tmp_path):
    """A folder with a whole session and one that was cut off."""
    folder = tmp_path / "sessions"
    folder.mkdir()
    shutil.copy(session, folder / "P01_pinch.mcap")
    data = session.read_bytes()
    (folder / "P02_fist.mcap").write_bytes(data[: int(0.7 * len(data))])
    return folder


@pytest.fixture
def started(sessions, store, qtbot, no_leaks):
    """A window that finds these at its start."""
    window = MainWindow(store)
    qtbot.addWidget(window)
    window.resize(1366, 768)
    window.show()
    qtbot.waitUntil(lambda: window.start_page.recent.count() > 0)
    yield window
    window.close()


def texts(window) -> list[str]:
    recent = window.start_page.recent
    return [recent.item(i).text() for i in range(recent.count())]


def test_earlier_sessions_are_on_the_start_page_and_open_by_a_click(started, sessions, qtbot):
    page = started.start_page
    row = next(i for i, text in enumerate(texts(started)) if text.startswith("P01_pinch"))
    item = page.recent.item(row)
    assert item.text().split("\n")[1].startswith("0:0")
    assert not item.icon().isNull()
    place = page.recent.visualItemRect(item).center()
    qtbot.mouseClick(page.recent.viewport(), Qt.MouseButton.LeftButton, pos=place)
    qtbot.waitUntil(lambda: started.host.running)
    assert started.host.setup.player.path == sessions / "P01_pinch.mcap"
    assert started.store.value.recent == [str(sessions / "P01_pinch.mcap")]


def test_a_recording_that_was_cut_off_is_recovered_from_the_start_page(started, sessions, qtbot):
    page = started.start_page
    assert page.unfinished.isVisible() and "P02_fist.mcap" in page.unfinished_text.text()
    qtbot.mouseClick(page.recover_button, Qt.MouseButton.LeftButton)
    made = sessions / "P02_fist_recovered.mcap"
    qtbot.waitUntil(lambda: made.name in started.banner.text())
    qtbot.waitUntil(lambda: not page.unfinished.isVisible())
    assert made.exists() and (sessions / "P02_fist.mcap").exists()
    assert any(text.startswith("P02_fist_recovered") for text in texts(started))


def test_a_first_start_shows_the_three_ways_alone_and_the_library_by_its_button(window, qtbot):
    page = window.start_page
    assert not page.recent.isVisible() and not page.unfinished.isVisible()
    assert window.tasks.tasks == ()
    qtbot.mouseClick(page.library_button, Qt.MouseButton.LeftButton)
    assert window.library.isVisible() and page.isVisible()


@pytest.mark.styled
@pytest.mark.parametrize("width", [650, 700, 830, 1366])
def test_cards_do_not_overlap(started, qtbot, width):
    page = started.start_page
    page.setParent(None)
    page.resize(width, 500)
    page.show()
    cards = [c for c in page.findChildren(QFrame, "card") if c is not page.unfinished]
    assert len(cards) == 3

    def are_beside() -> bool:
        places = sorted((c.geometry() for c in cards), key=lambda g: g.x())
        apart = all(a.right() < b.left() for a, b in itertools.pairwise(places))
        return apart and places[-1].right() <= width

    qtbot.waitUntil(are_beside)
    started.setCentralWidget(page)


def test_what_is_used_last_comes_first_and_once():
    known: list[str] = []
    for name in "abcdefa":
        known = with_recent(known, Path(f"/x/{name}.mcap"))
    assert [p[-6] for p in known] == ["a", "f", "e", "d", "c"]


def test_a_session_with_another_name_stays_where_it_was_among_the_recent_ones():
    known = ["/x/a.mcap", "/x/b.mcap", "/x/c.mcap"]
    after = renamed(known, Path("/x/b.mcap"), Path("/x/d.mcap"))
    assert after == ["/x/a.mcap", "/x/d.mcap", "/x/c.mcap"]
    taken = renamed(known, Path("/x/b.mcap"), Path("/x/c.mcap"))  # one of that name was there once
    assert taken == ["/x/a.mcap", "/x/c.mcap"]
    assert renamed(known, Path("/x/e.mcap"), Path("/x/f.mcap")) == known


def test_a_session_renamed_in_the_library_is_offered_under_its_new_name(started, sessions, qtbot):
    """From a folder that is no longer looked into: nothing else would find it again."""
    other = sessions.parent / "other"
    other.mkdir()
    path = shutil.copy(sessions / "P01_pinch.mcap", other / "P03_point.mcap")
    started.store.update(recent=[str(path)])
    started.library.files.rename(path, "Z9_last")
    qtbot.waitUntil(lambda: any(t.startswith("Z9_last") for t in texts(started)))
    assert started.store.value.recent == [str(other / "Z9_last.mcap")]


def test_a_session_that_is_gone_is_not_offered(tmp_path, sessions):
    gone = str(tmp_path / "gone.mcap")
    found = look_back([gone], sessions, datetime.now(), lambda *_: None)
    assert {r.row.path.name for r in found.recent} == {"P01_pinch.mcap", "P02_fist.mcap"}
    assert [p.name for p in found.unfinished] == ["P02_fist.mcap"]


def test_ages_are_rounded_to_readable_units():
    now = datetime(2026, 5, 20, 15, 0)
    for ago, text in (
        (timedelta(seconds=5), "just now"),
        (timedelta(minutes=1), "1 minute ago"),
        (timedelta(minutes=50), "50 minutes ago"),
        (timedelta(hours=3), "today, 12:00"),
        (timedelta(hours=20), "yesterday, 19:00"),
        (timedelta(days=3), "3 days ago"),
        (timedelta(days=60), "2026-03-21"),
    ):
        assert age_text(now - ago, now) == text


def test_recent_sessions_come_newest_first_and_the_newest_is_among_them(tmp_path, sessions):
    older, newer = sessions / "P01_pinch.mcap", sessions / "P02_fist.mcap"
    os.utime(older, (1e9, 1e9))
    os.utime(newer, (2e9, 2e9))
    found = look_back([str(older)] * 5, sessions, datetime.now(), lambda *_: None)
    assert [r.row.path for r in found.recent] == [newer, older]


def test_a_truncated_session_is_reported_when_it_is_opened(started, sessions, qtbot):
    started.sources.open_session(sessions / "P02_fist.mcap")
    qtbot.waitUntil(lambda: "P02_fist.mcap was cut off" in started.banner.text())
    assert started.banner.buttons[0].text() == "Recover"
    started.sources.open_session(sessions / "P01_pinch.mcap")
    qtbot.waitUntil(lambda: "P01_pinch" in started.windowTitle())
    assert not started.banner.isVisible()
    shutil.copy(sessions / "P01_pinch.mcap", sessions / "P02_fist_recovered.mcap")
    started.sources.open_session(sessions / "P02_fist.mcap")
    qtbot.waitUntil(lambda: "recovered to P02_fist_recovered.mcap" in started.banner.text())
    assert started.banner.buttons[0].text() == "Show", "it has been recovered"


@pytest.mark.styled
def test_the_library_below_the_start_page_is_wide_and_has_its_buttons(started, qtbot):
    qtbot.mouseClick(started.start_page.library_button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: started.library.table.rowCount() > 0)
    settled(started, qtbot)
    assert started.library.width() > 0.95 * started.width()
    assert started.library.table.height() > 3 * started.library.table.rowHeight(0)
    for key in ("replay", "track", "compare", "export"):
        assert not started.library.buttons[key].visibleRegion().isEmpty(), key
    assert started.start_page.isVisible()


def test_a_long_name_in_a_list_keeps_its_end(started):
    for view in (started.start_page.recent, started.library.table):
        assert view.textElideMode() == Qt.TextElideMode.ElideMiddle


CUT_OFF, WHOLE = "P02_fist.mcap", "P01_pinch.mcap"


@pytest.mark.parametrize("name", [WHOLE, CUT_OFF])
def test_a_start_after_a_crash_reports_the_recovered_recording(
    sessions, store, qtbot, no_leaks, tmp_path, name, monkeypatch
):
    monkeypatch.setattr("app.viewmodels.recent.POLLS", 1)
    store.update(recording=str(sessions / name))
    logs = tmp_path / "logs"
    logs.mkdir()
    (logs / "running-1.log").write_text("0.0\nGlovetrack\n")  # of a process that has ended
    watch = CrashWatch(logs)
    window = MainWindow(store, watch)
    qtbot.addWidget(window)
    window.show()
    try:
        end = "P01_pinch is complete." if name == WHOLE else "can be recovered."
        qtbot.waitUntil(lambda: window.banner.text().endswith(end))
        assert window.banner.text().startswith("Glovetrack ended unexpectedly")
        shown = [b.text() for b in window.banner.buttons if b.isVisibleTo(window.banner)]
        first = "Show" if name == WHOLE else "Recover"
        assert shown == [first, "Save a bug report…"]
        assert store.value.recording == ""
    finally:
        window.close()
        watch.end()


def test_the_file_being_recorded_is_remembered_until_it_is_closed(live, store, qtbot):
    live.run_command("record")
    assert store.value.recording == str(live.host.recording.request.path)
    live.run_command("record")
    qtbot.waitUntil(lambda: store.value.recording == "")
