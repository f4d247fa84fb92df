"""The table of fingertips in the panel: it shows what is found, and the user corrects it."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("mujoco")

from PySide6.QtWidgets import QFileDialog

from extensions.robot.finger_map import read_map
from extensions.robot.tests.other_hands import written


@pytest.fixture
def table(window, qtbot, tmp_path: Path):
    """For the hand with numbered links, as it is shown when *Fingers* is pressed."""
    window.show()
    window.show_panel("robot")
    panel = window.panels["robot"]
    panel.link.change(model=str(written(tmp_path, "numbered.urdf")))
    panel.controls.fingers.click()
    qtbot.waitUntil(lambda: links(panel.fingers)["thumb"] != "")
    return panel.fingers


def links(table) -> dict[str, str]:
    return {name: str(box.currentData() or "") for name, box in table.boxes.items()}


def choose(table, name: str, link: str) -> None:
    box = table.boxes[name]
    box.setCurrentIndex(box.findData(link))
    box.activated.emit(box.currentIndex())


def test_the_table_shows_what_was_found_in_the_file(table) -> None:
    shown = links(table)
    assert shown["index"] == "link_3.0_tip" and shown["palm"] == "base_link"
    assert shown["little"] == ""
    cells = [label.text() for label in table._cells["index"].values()]
    assert cells == ["position", "4", "110 mm"]
    assert not table.message.isVisible()


def test_a_correction_is_stored_for_this_hand_and_taken_back(table, window, qtbot) -> None:
    choose(table, "index", "link_11.0_tip")
    qtbot.waitUntil(lambda: links(table)["ring"] == "link_7.0_tip")
    link = window.panels["robot"].link
    model = link.settings.model
    assert link.settings.fingers == "index=link_11.0_tip"
    assert table._cells["index"][2].text() == "your choice"
    link.change(model="shadow")
    assert link.settings.fingers == ""
    link.change(model=model)
    assert link.settings.fingers == "index=link_11.0_tip"
    assert window.store.value.robot_fingers[model] == "index=link_11.0_tip"
    table.automatic.click()
    qtbot.waitUntil(lambda: links(table)["index"] == "link_3.0_tip")


def test_an_unrecognised_hand_can_be_corrected(table, qtbot) -> None:
    choose(table, "thumb", "")
    qtbot.waitUntil(lambda: table.message.isVisible())
    assert "fingertips" in table.message.text()
    choose(table, "thumb", "link_15.0_tip")
    qtbot.waitUntil(lambda: links(table)["index"] == "link_3.0_tip")
    assert not table.message.isVisible()


def test_links_are_saved_and_loaded(table, tmp_path: Path, monkeypatch, qtbot) -> None:
    path = tmp_path / "links.toml"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    table.save.click()
    assert read_map(path).links["ring"] == "link_11.0_tip"
    path.write_text('[fingers]\nring = ""\n')
    table.load.click()
    qtbot.waitUntil(lambda: links(table)["little"] == "link_11.0_tip")
    path.write_text('[fingers]\ntoe = "x"\n')
    errors: list[str] = []
    table.refused.connect(errors.append)
    table.load.click()
    assert "toe" in errors[0]
