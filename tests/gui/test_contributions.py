"""Panels and commands that packages add to the window."""

import inspect
import sys
from importlib.metadata import EntryPoint

import pytest
from PySide6.QtWidgets import QDialog

from app.panels.command_kind import CommandContext, WindowCommand
from app.panels.kind import PanelKind, Spot
from app.panels.panel import Panel
from app.storage.settings import SettingsStore
from app.window.main_window import MainWindow
from tracker.base import registry

ours = registry._entries


class Plain(Panel):
    """Shows nothing."""


def fail(_services) -> Panel:
    raise ImportError("No module named 'mujoco'")


def run(on: CommandContext) -> None:
    on.show_dialog("greeting", lambda: QDialog(on.window))


def count(on: CommandContext) -> None:
    raise ValueError(f"{len(on.recordings)} of 0")


PLAIN = PanelKind("plain", "Plain", lambda s: Plain(), {"watch": Spot("right", 0)})
BROKEN = PanelKind("broken", "Broken", fail, extra="glovetrack[robot]")
SAME_KEY = PanelKind("same-key", "Same key", lambda s: Plain(), number=1)
GREET = WindowCommand("greet", "&Greet…", run, after="note", shortcut="Ctrl+Alt+G")
NEVER = WindowCommand("never", "Never", run, enabled=lambda _on: False)
COUNT = WindowCommand("count", "Count", count, on_recordings=True)
ADDED = {
    "glovetrack.panels": {"plain": "PLAIN", "broken": "BROKEN", "same-key": "SAME_KEY"},
    "glovetrack.window_commands": {"greet": "GREET", "never": "NEVER", "count": "COUNT"},
}


@pytest.fixture
def window(qtbot, monkeypatch, tmp_path):
    def entries(group: str, path: tuple[str, ...]) -> dict[str, EntryPoint]:
        added = ADDED.get(group, {})
        here = {n: EntryPoint(n, f"{__name__}:{at}", group) for n, at in added.items()}
        return {**ours(group, path), **here}

    monkeypatch.setattr(registry, "_entries", entries)
    window = MainWindow(SettingsStore(tmp_path / "window.json"))
    qtbot.addWidget(window)
    yield window
    window.close()


def menu_of(window: MainWindow, key: str) -> list[str]:
    """The texts of the menu that has this command."""
    wanted = window.commands.actions[key]
    (menu,) = (menu for menu in window.commands.menus() if wanted in menu.actions())
    return [menu.title(), *(action.text() for action in menu.actions() if action.text())]


def test_a_panel_has_a_dock_a_command_and_a_tab(window):
    assert window.docks["plain"].objectName() == "dock_plain"
    assert window.layouts.jobs["watch"].columns[1] == (("hand", "plain"),)
    window.run_command("dock_plain")
    assert not window.docks["plain"].isHidden()
    assert window.commands.actions["dock_plain"].shortcut().isEmpty()


def test_a_key_stays_with_the_first_panel_that_has_it(window):
    assert window.commands.actions["dock_cameras"].shortcut().toString() == "Ctrl+1"
    assert window.commands.actions["dock_same-key"].shortcut().isEmpty()


def test_a_panel_that_fails_is_reported_with_what_to_install(window):
    assert "broken" not in window.docks and "broken" not in window.panels
    log_text = window.log.model
    assert log_text.ends_with(
        "The panel Broken cannot be shown: No module named 'mujoco'. "
        "Install it with pip install 'glovetrack[robot]'."
    )


def test_a_command_follows_another_one_in_its_menu(window):
    texts = menu_of(window, "greet")
    assert texts[texts.index("Add a &note…") + 1] == "&Greet…"
    window.run_command("greet")
    first = window.set_up.dialogs["greeting"]
    window.run_command("greet")
    assert window.set_up.dialogs["greeting"] is first


def test_other_commands_have_a_menu_of_their_own(window):
    title, *texts = menu_of(window, "never")
    assert title == "E&xtensions" and "Never" in texts
    assert not window.commands.actions["never"].isEnabled()


def test_a_command_on_recordings_that_fails_is_reported(window, tmp_path):
    added = list(window.library.page.actions_of)[1:4]
    assert sorted(added) == ["count", "reference_accuracy_of", "report"]
    window.library._actions["count"].run([tmp_path / "a.mcap", tmp_path / "b.mcap"])
    assert window.log.model.ends_with("Count failed: 2 of 0.")


def test_panels_receive_the_parts_of_the_host_that_they_use(window) -> None:
    used = {}
    for name, panel in window.panels.items():
        parameters = inspect.signature(type(panel).__init__).parameters
        if "host" in parameters:
            part = getattr(sys.modules[type(panel).__module__], parameters["host"].annotation)
            assert getattr(part, "_is_protocol", False), name
            used[name] = {m for kind in part.__mro__ for m in vars(kind) if m[0] != "_"}
    assert len(used) >= 13
    assert used["cameras"] == {"opened", "closed", "hand_changed"}
    assert used["log"] == {"error", "happened"}
    assert not [name for name, members in used.items() if {"open", "adopt", "stop"} & members]
