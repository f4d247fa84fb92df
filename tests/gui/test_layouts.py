"""Layouts: one for each task, named ones, and proportions for any screen."""

import shutil
from pathlib import Path

import pytest
from PySide6.QtCore import QSize
from PySide6.QtWidgets import QToolButton

from app.window.contributions import panel_kinds
from app.window.layouts import jobs_for, shares_of
from app.window.main_window import MainWindow
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tests.gui.patience import settled

JOB_OF = jobs_for(panel_kinds())
JOBS = list(JOB_OF.values())
SMALL, LARGE = (1366, 768), (1920, 1080)
CLOSE = 0.03
"""Separators and titles have the same px on every screen: two of 5 px are 1.4 % of 720."""


@pytest.fixture
def watched(window, qtbot):
    window.layouts.choose("watch")
    window.host.adopt(scripted_setup(ScriptedEngine()))
    settled(window, qtbot)
    return window


def in_sight(window) -> set[str]:
    return {n for n, d in window.docks.items() if not d.isHidden() and not d.isFloating()}


def size_to(window, size, qtbot) -> None:
    window.resize(*size)
    settled(window, qtbot)


def test_a_task_is_selected_with_one_click_and_shows_its_panels(watched):
    buttons = watched.tool_bar.segments.buttons
    for segment, job in zip(buttons, JOBS, strict=True):
        segment.click()
        assert in_sight(watched) == job.shown
        assert [b.isChecked() for b in buttons] == [j is job for j in JOBS]
        for group in (*job.columns[0], *job.columns[1]):
            assert not watched.docks[group[0]].visibleRegion().isEmpty(), (job.name, group[0])


@pytest.mark.styled
def test_watching_gives_all_space_to_images_and_hand(watched, qtbot):
    size_to(watched, SMALL, qtbot)
    shares = shares_of(watched, watched.docks)
    assert shares.keys() == {"cameras", "hand"}
    assert sum(w for w, _ in shares.values()) > 0.97
    assert min(h for _, h in shares.values()) > 0.85  # the tool bar has the rest


@pytest.mark.styled
def test_review_shows_more_than_one_session_next_to_the_transport(watched, qtbot):
    watched.layouts.choose("look")
    size_to(watched, SMALL, qtbot)
    watched.library.transport.show()
    settled(watched, qtbot)
    table = watched.library.table
    assert table.viewport().height() >= 2 * table.verticalHeader().defaultSectionSize()
    for button in watched.library.buttons.values():
        assert button.isHidden() or not button.visibleRegion().isEmpty(), button.text()


def test_the_start_page_names_the_first_layout(window):
    assert window.layouts._actions["all"].isChecked()


def test_set_up_next_to_the_start_page_is_the_list(window):
    first, second, *_ = window.tool_bar.segments.buttons
    first.click()
    assert window.docks["checklist"].isVisible() and window.start_page.isVisible()
    second.click()
    assert not window.docks["checklist"].isVisible()


@pytest.mark.long
@pytest.mark.parametrize("job", JOBS, ids=lambda job: job.name)
def test_a_layout_saved_on_a_small_screen_is_the_same_on_a_large_one_and_back(watched, qtbot, job):
    watched.layouts.choose(job.name)
    size_to(watched, SMALL, qtbot)
    before = shares_of(watched, watched.docks)
    watched.layouts.named.save("mine")
    watched.layouts.choose("all" if job.name != "all" else "watch")
    for size in (LARGE, SMALL):
        size_to(watched, size, qtbot)
        watched.layouts.named.apply("mine")
        settled(watched, qtbot)
        after = shares_of(watched, watched.docks)
        assert after.keys() == before.keys()
        for name, share in before.items():
            assert after[name] == pytest.approx(share, abs=CLOSE), (name, size)


def test_docks_keep_their_proportions_while_the_window_grows(watched, qtbot):
    watched.layouts.choose("all")
    size_to(watched, SMALL, qtbot)
    before = shares_of(watched, watched.docks)
    size_to(watched, LARGE, qtbot)
    after = shares_of(watched, watched.docks)
    for name, share in before.items():
        assert after[name] == pytest.approx(share, abs=CLOSE), name


def test_a_removed_and_restored_panel_has_its_earlier_share(watched, qtbot):
    size_to(watched, LARGE, qtbot)
    before = shares_of(watched, watched.docks)
    cameras = watched.docks["cameras"]
    cameras.setFloating(True)
    qtbot.waitUntil(lambda: shares_of(watched, watched.docks).keys() == {"hand"})
    cameras.setFloating(False)

    def is_back() -> bool:
        now = shares_of(watched, watched.docks)
        return now.keys() == before.keys() and all(
            now[name] == pytest.approx(before[name], abs=CLOSE) for name in before
        )

    qtbot.waitUntil(is_back)


def test_a_task_is_restored_as_it_was_left_and_can_be_reset(watched):
    watched.docks["hand"].hide()
    watched.layouts.choose("record")
    watched.layouts.choose("watch")
    assert in_sight(watched) == {"cameras"}
    watched.layouts.reset()
    assert in_sight(watched) == JOB_OF["watch"].shown


def test_saved_layouts_are_listed_renamed_deleted_and_survive_a_restart(
    watched, store, qtbot, no_leaks
):
    assert not watched.commands.actions["rename_layout"].isEnabled()
    watched.layouts.choose("look")
    watched.layouts.named.save("lab")
    assert watched.commands.actions["rename_layout"].isEnabled()
    watched.layouts.named.rename("lab", "Lab A")
    assert [a.text() for a in watched.layouts.named._menu.actions()] == ["Lab A"]
    watched.layouts.choose("watch")
    watched.close()
    again = MainWindow(store)
    qtbot.addWidget(again)
    again.resize(*SMALL)
    again.show()
    again.host.adopt(scripted_setup(ScriptedEngine()))
    assert in_sight(again) == JOB_OF["watch"].shown
    again.layouts.named._menu.actions()[0].trigger()
    assert in_sight(again) == JOB_OF["look"].shown
    again.layouts.named.delete("Lab A")
    assert not again.layouts.named._menu.isEnabled() and store.value.layouts == {}
    assert again.banner.text() == "Layout Lab A deleted."
    again.banner.buttons[0].click()
    assert [a.text() for a in again.layouts.named._menu.actions()] == ["Lab A"]
    again.layouts.named._menu.actions()[0].trigger()
    assert in_sight(again) == JOB_OF["look"].shown
    again.close()


def test_a_panel_hidden_in_the_task_appears_when_requested(watched):
    watched.run_command("show_calibration")
    assert not watched.docks["calibration"].visibleRegion().isEmpty()
    assert not watched.docks["cameras"].visibleRegion().isEmpty()


@pytest.mark.styled
def test_the_tool_bar_shows_all_its_commands(watched, qtbot):
    bar = watched.tool_bar
    buttons = [b for b in bar.findChildren(QToolButton) if b.defaultAction() is not None]
    assert len(buttons) == 8 + len(JOBS)
    for width in (1366, 1024, 800):
        size_to(watched, (width, 640), qtbot)
        for button in buttons:
            assert button.isVisible(), (width, button.text())
            assert bar.rect().contains(
                button.geometry().translated(
                    button.parentWidget().mapTo(bar, button.parentWidget().rect().topLeft())
                    if button.parentWidget() is not bar
                    else bar.rect().topLeft()
                )
            ), (width, button.text())
            assert button.toolTip()


@pytest.mark.styled
def test_the_window_is_never_larger_than_its_screen(window):
    room = window.screen().availableSize()
    fresh = QSize(window.minimumSize())
    assert fresh.width() <= room.width() and fresh.height() <= room.height()


@pytest.fixture
def session(simulated_sessions, tmp_path):
    """A recording of three seconds."""
    folder = tmp_path / "sessions"
    folder.mkdir()
    return Path(shutil.copy(simulated_sessions.simulated(), folder / "P01_pinch.mcap"))


def open_replay_of(window, session, qtbot) -> None:
    window.library.replay.emit(session)
    qtbot.waitUntil(lambda: "Replay of" in window.windowTitle())
    settled(window, qtbot)


def front_tabs(window, job) -> list[bool]:
    """Whether the first dock of each group is in front."""
    groups = [g for column in job.columns for g in column] + ([job.across] if job.across else [])
    return [not window.docks[g[0]].visibleRegion().isEmpty() for g in groups]


@pytest.mark.long
@pytest.mark.parametrize("job", ["set_up", "watch", "record"])
def test_a_replay_opens_in_the_review_layout_and_live_returns_to_the_previous_one(
    watched, session, qtbot, job
):
    watched.layouts.choose(job)
    open_replay_of(watched, session, qtbot)
    assert watched.store.value.job == "look"
    for name in ("cameras", "hand", "library"):
        assert not watched.docks[name].visibleRegion().isEmpty(), name
    watched.host.adopt(scripted_setup(ScriptedEngine()))
    settled(watched, qtbot)
    assert watched.store.value.job == job
    assert in_sight(watched) == JOB_OF[job].shown
    assert all(front_tabs(watched, JOB_OF[job]))


def test_after_a_replay_opened_first_the_layout_has_its_default_proportions(
    window, store, session, qtbot
):
    """The layout before it was never shown: there are no sizes to return to."""
    store.update(job="set_up")
    open_replay_of(window, session, qtbot)
    assert store.value.job == "look"
    window.host.adopt(scripted_setup(ScriptedEngine()))
    settled(window, qtbot)
    after = shares_of(window, window.docks)
    window.layouts.reset()
    settled(window, qtbot)
    usual = shares_of(window, window.docks)
    assert store.value.job == "set_up" and after.keys() == usual.keys()
    for name, share in usual.items():
        assert after[name] == pytest.approx(share, abs=CLOSE), name


def test_a_replay_stays_in_a_layout_that_has_all_it_needs(watched, session, qtbot):
    watched.layouts.choose("all")
    open_replay_of(watched, session, qtbot)
    assert watched.store.value.job == "all"
    assert not watched.docks["library"].visibleRegion().isEmpty()


def test_a_layout_selected_during_a_replay_is_preserved(watched, session, qtbot):
    open_replay_of(watched, session, qtbot)
    watched.layouts.choose("record")
    watched.host.adopt(scripted_setup(ScriptedEngine()))
    assert watched.store.value.job == "record"


def test_closing_during_a_replay_does_not_make_review_the_layout_of_the_next_start(
    watched, store, session, qtbot
):
    open_replay_of(watched, session, qtbot)
    watched.close()
    again = MainWindow(store)
    qtbot.addWidget(again)
    again.resize(*SMALL)
    again.show()
    again.host.adopt(scripted_setup(ScriptedEngine()))
    assert store.value.job == "watch" and in_sight(again) == JOB_OF["watch"].shown
    again.close()


@pytest.mark.long
@pytest.mark.parametrize("job", [j for j in JOBS if j.name != "all"], ids=lambda job: job.name)
def test_panels_shown_by_messages_and_commands_do_not_remain_in_the_layout(watched, qtbot, job):
    """*Export…* shows the library, *Show checklist* the list, a failure the log."""
    watched.layouts.choose(job.name)
    size_to(watched, SMALL, qtbot)
    before = shares_of(watched, watched.docks)
    for panel in ("library", "checklist", "log"):
        watched.show_panel(panel)
        settled(watched, qtbot)
        assert not watched.docks[panel].visibleRegion().isEmpty(), panel
    watched.layouts.choose("all")
    watched.layouts.choose(job.name)
    settled(watched, qtbot)
    assert in_sight(watched) == job.shown
    assert all(front_tabs(watched, job))
    after = shares_of(watched, watched.docks)
    assert after.keys() == before.keys()
    for name, share in before.items():
        assert after[name] == pytest.approx(share, abs=CLOSE), name


def test_a_panel_added_by_the_user_remains_in_the_layout(watched):
    watched.run_command("dock_log")
    watched.layouts.choose("record")
    watched.layouts.choose("watch")
    assert "log" in in_sight(watched)


def test_the_tool_bar_names_each_of_its_buttons_differently(watched):
    buttons = [b for b in watched.tool_bar.findChildren(QToolButton) if b.defaultAction()]
    names = [b.defaultAction().iconText().strip() for b in buttons]
    assert len(names) == len(set(names)), names
