"""Gaps of a recording in the real window: listed, marked on the timeline, filled in a new file."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.panels.library.gap_page import CAUSE, KIND, LENGTH, START
from app.viewmodels.gaps import INTERPOLATED, KINDS
from tests.offline.test_fill import without_estimates
from tracker.base.files import sha256
from tracker.messages import Tracking, Validity
from tracker.session.reader import SessionReader

CUTS = ((1.0, 1.15), (2.0, 2.3))  # s without estimates
PAGE = 2  # of the library


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory, simulated_sessions) -> Path:
    folder = tmp_path_factory.mktemp("gaps")
    return without_estimates(simulated_sessions.tracked(), folder / "cut.mcap", CUTS)


@pytest.fixture
def session(made, tmp_path):
    """Each test fills into its own copy."""
    path = tmp_path / "cut.mcap"
    path.write_bytes(made.read_bytes())
    return path


@pytest.fixture
def review(window, session, qtbot):
    """A paused replay with its gaps listed in the visible panel."""
    window.sources.open_session(session)
    qtbot.waitUntil(lambda: window.host.running)
    window.host.setup.player.play(False)
    window.show_panel("library")
    window.library.pages.bar.setCurrentIndex(PAGE)
    page = window.library.gaps.page
    qtbot.waitUntil(lambda: page.table.rowCount() >= len(CUTS))
    return window


def cells(page, column):
    return [page.table.item(row, column).text() for row in range(page.table.rowCount())]


def holes(page):
    return [row for row, kind in enumerate(cells(page, KIND)) if "hole" in kind]


def choose(page, rows):
    page.table.clearSelection()
    page.table.setSelectionMode(page.table.SelectionMode.MultiSelection)
    for row in rows:
        page.table.selectRow(row)


def test_gaps_are_listed_with_start_length_and_cause(review):
    page = review.library.gaps.page
    rows = holes(page)
    starts = [page.table.item(row, START).text() for row in rows]
    assert [round(float(s.split(":")[1]), 1) for s in starts] == [1.0, 2.0]
    assert {cells(page, CAUSE)[row] for row in rows} == {"no estimate was computed"}
    assert f"({page.table.rowCount()})" in review.library.pages.bar.tabText(PAGE)


def test_the_list_is_sorted_by_the_columns_values(review):
    page = review.library.gaps.page
    page.table.sortItems(LENGTH, Qt.SortOrder.DescendingOrder)
    lengths = [float(text.split()[0]) for text in cells(page, LENGTH)]
    assert lengths == sorted(lengths, reverse=True)


@pytest.mark.long
def test_a_filter_lists_one_kind_and_the_timeline_marks_the_listed_ones(review):
    page, timeline = review.library.gaps.page, review.library.transport.timeline
    everything = page.table.rowCount()
    assert len(timeline.spans) == everything
    page.kind.setCurrentIndex(page.kind.findData("hole"))
    assert len(holes(page)) == page.table.rowCount() == len(CUTS)
    assert {span.colour for span in timeline.spans} == {KINDS["hole"].colour}
    for span, (start, stop) in zip(timeline.spans, CUTS, strict=True):
        assert span.start == pytest.approx(start, abs=0.02)
        assert span.stop == pytest.approx(stop, abs=0.02)
        middle = timeline.x_of((start + stop) / 2)
        assert timeline.span_at(middle) == span
    page.kind.setCurrentIndex(0)
    page.unsensed.setCurrentIndex(1)
    assert page.table.rowCount() > everything, "fingertips that no sensor measures"


def test_a_click_goes_to_the_gap(review, qtbot):
    page, player = review.library.gaps.page, review.host.setup.player
    row = holes(page)[-1]
    item = page.table.item(row, START)
    page.table.scrollToItem(item)
    place = page.table.visualItemRect(item).center()
    QTest.mouseClick(page.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    qtbot.waitUntil(lambda: abs(player.position - CUTS[-1][0]) < 0.03)
    assert not player.playing


def test_only_gaps_up_to_the_chosen_length_can_be_filled(review):
    page = review.library.gaps.page
    choose(page, holes(page))
    page.longest.setValue(0.2)
    assert [gap.start for gap in page.fillable()] == [pytest.approx(CUTS[0][0], abs=0.02)]
    page.longest.setValue(0.05)
    assert not page.fill_button.isEnabled()
    page.longest.setValue(0.5)
    assert len(page.fillable()) == 2 and page.fill_button.isEnabled()


@pytest.mark.long
@pytest.mark.processes
def test_filled_gaps_are_in_a_new_file_and_never_shown_as_measured(review, session, qtbot):
    page, before = review.library.gaps.page, sha256(session)
    choose(page, holes(page))
    page.longest.setValue(0.5)
    page.method.setCurrentIndex(page.method.findData("cubic"))
    QTest.mouseClick(page.fill_button, Qt.MouseButton.LeftButton)
    out = session.with_name("cut_filled.mcap")
    qtbot.waitUntil(lambda: out.name in review.banner.text(), timeout=120_000)
    assert sha256(session) == before
    with SessionReader(out) as reader:
        (edit,) = reader.edits
    assert (edit.method, len(edit.filled)) == ("cubic", 2)
    review.sources.open_session(out)
    qtbot.waitUntil(lambda: opened(review) == out)
    review.host.setup.player.play(False)
    timeline = review.library.transport.timeline
    blue = INTERPOLATED.colour
    qtbot.waitUntil(lambda: sum(s.colour == blue for s in timeline.spans) == 2)
    review.host.setup.player.seek(sum(CUTS[1]) / 2)
    qtbot.waitUntil(lambda: in_gap(review))
    view = review.host.snapshot()
    assert set(view.estimate.keypoint_state) == {Validity.INFERRED}
    coasting = Tracking.COASTING  # the status shown is renewed less often than the estimate
    qtbot.waitUntil(lambda: review.host.snapshot().status.tracking == coasting)
    qtbot.waitUntil(review.library.transport.interpolated.isVisible)
    review.host.setup.player.seek(1.6)
    qtbot.waitUntil(lambda: not review.library.transport.interpolated.isVisible())


def test_a_removed_range_is_restored_by_undo(review):
    transport, player = review.library.transport, review.host.setup.player
    transport.set_range(0.5, 2.5)
    transport.clear_range()
    assert player.range == (0.0, player.duration)
    assert "0:00.50 – 0:02.50" in review.banner.text()
    review.banner.buttons[0].click()
    assert player.range == (0.5, 2.5)


def opened(window):
    setup = window.host.setup
    return setup.player.path if setup is not None and setup.player is not None else None


def in_gap(window):
    view, start = window.host.snapshot(), window.host.setup.engine.start_t
    e = view.estimate
    return e is not None and CUTS[1][0] < e.t - start < CUTS[1][1]


def test_a_list_without_rows_gives_the_reason(review, window):
    page = review.library.gaps.page
    assert not page.empty.isVisible() and page.table.isVisible()
    found = page.found
    page.show_gaps(dataclasses.replace(found, gaps=()))
    assert page.empty.text() == "This recording has no gaps." and not page.table.isVisible()
    page.show_gaps(None)
    assert "Replay a recording" in page.empty.text()
    page.show_gaps(found)
    assert not page.empty.isVisible() and page.table.isVisible()
    page.part.addItem("no part", "no part")
    page.part.setCurrentIndex(page.part.count() - 1)
    assert page.empty.text() == "No gap matches these filters." and page.empty.isVisible()
