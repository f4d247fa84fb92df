"""The calibration panel with a real filter: reset, freeze, restored wearers, comparison."""

import dataclasses

import numpy as np
import pytest
from PySide6.QtWidgets import QFileDialog

from app.panels.calibration.panel import CalibrationTable
from app.storage.wearers import WearerStore
from app.viewmodels.calibration import calibration_view
from app.window.main_window import MainWindow
from tests.gui.gui_fakes import ScriptedEngine, models, scripted_setup, simulation
from tests.notices import shows
from tracker.base.errors import GlovetrackError
from tracker.base.files import person_file_name
from tracker.base.notices import template_of
from tracker.cli import build_parser
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.calibration.profile_file import WearerFile, write_wearer
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.params import ChainParams
from tracker.messages import Array, Event


def chain() -> ChainEngine:
    hand, glove, _ = models()
    return ChainEngine(hand, glove, simulation().rig, ChainParams())


class Commanded(ScriptedEngine):
    """A scripted engine with a filter's own calibration."""

    def __init__(self, inner=None) -> None:
        super().__init__()
        self.inner = inner or chain()

    def calibration(self):
        return self.inner.calibration()

    def command(self, work, answer=None) -> None:
        try:
            result = work(self.inner)
            if answer is not None:
                answer(result)
        except GlovetrackError as error:
            self.events.append(Event(0.0, "error", str(error)))


def setup_of(engine: Commanded):
    return dataclasses.replace(scripted_setup(engine), simulated=False)


def calibration_covariance(engine: ChainEngine) -> Array:
    """Rows of the filter's covariance that belong to the calibration."""
    return engine.get_state().tracker.filter.state.P[engine.layout.n_dynamic :]


def teach(engine: ChainEngine, length: float) -> None:
    """Sets the filter's estimate of the hand to ``length`` times the file's."""
    profile = engine.profile()
    engine.apply_profile(
        dataclasses.replace(profile, scale=np.full_like(profile.scale, length), P=profile.P / 16)
    )


@pytest.fixture
def engine() -> Commanded:
    return Commanded()


@pytest.fixture
def panel(window, engine, qtbot):
    teach(engine.inner, 1.04)
    window.host.adopt(setup_of(engine))
    window.run_command("show_calibration")
    qtbot.waitUntil(lambda: window.calibration.profiles.current.latest is not None)
    return window.calibration


def action(menu, text: str):
    return next(a for a in menu.actions() if a.text() == text)


def shown(panel, row: int, column: int) -> str:
    panel.refresh(panel.host.snapshot())
    return panel.table.item(row, column).text()


def test_one_segment_is_reset_by_its_menu(panel, engine):
    assert shown(panel, 0, 1).startswith("1.040 ± ")
    action(panel.wearer.reset_button.menu(), "dorsum").trigger()
    assert shown(panel, 0, 1).startswith("1.000 ± ")
    assert shown(panel, 1, 1).startswith("1.040 ± ")
    action(panel.wearer.reset_button.menu(), "Everything").trigger()
    assert engine.inner.calibration().scale == pytest.approx(np.ones((7, 3)))


def test_a_reset_calibration_can_be_compared_with_the_earlier_one(panel):
    action(panel.wearer.reset_button.menu(), "Everything").trigger()
    panel.wearer.comparing.click()
    assert shown(panel, 0, 1) == "Δ -0.040"
    assert "within 2σ of both" in panel.table.item(0, 1).toolTip()
    length = panel.length.text()
    assert length.endswith(f"Δ {-0.04 * 1000 * _nominal_length():+.1f}")


def _nominal_length() -> float:
    return chain().calibration().hand_length


def test_a_change_beyond_both_uncertainties_is_marked():
    engine = chain()
    before = engine.calibration()
    sure = dataclasses.replace(before, scale_sd=before.scale_sd / 50)
    moved = dataclasses.replace(sure, scale=before.scale + 0.04)
    cell = calibration_view(moved, sure).rows[0].cells[0]
    assert cell.text == "▲ Δ +0.040"
    assert "more than 2σ of both" in cell.tip


def test_comparing_with_nothing_is_reported(panel):
    panel.wearer.comparing.click()
    assert "nothing to compare with" in panel.advice.text()


def test_freezing_is_shown_and_applied_to_the_filter(panel, engine):
    panel.wearer.frozen.click()
    panel.refresh(panel.host.snapshot())
    assert panel.advice.text().startswith("Frozen")
    assert not calibration_covariance(engine.inner).any()
    panel.wearer.frozen.click()
    panel.refresh(panel.host.snapshot())
    assert calibration_covariance(engine.inner).any()


def test_a_profile_on_the_command_line_is_used_from_the_start(
    panel, window, store, tmp_path, qtbot
):
    file = tmp_path / "anna.toml"
    panel.profiles.export(file)
    qtbot.waitUntil(file.exists)
    args = build_parser(["window"]).parse_args(["window", "--demo", "--wearer", str(file)])
    window.close()
    again, fresh = MainWindow(store), Commanded()
    qtbot.addWidget(again)
    again.calibration.profiles.begin_with(args.wearer)
    again.host.adopt(setup_of(fresh))
    assert again.calibration.wearer.name == "anna"
    assert fresh.inner.calibration().scale == pytest.approx(np.full((7, 3), 1.04))


def test_a_wearer_is_restored_after_a_restart(panel, store, qtbot, monkeypatch):
    monkeypatch.setattr("app.panels.calibration.wearer_row.answer", lambda *_: "Anna B.")
    action(panel.wearer.save_button.menu(), "Save as…").trigger()
    qtbot.waitUntil(lambda: panel.wearer.name == "Anna B")
    panel.window().close()
    again, fresh = MainWindow(store), Commanded()
    qtbot.addWidget(again)
    again.host.adopt(setup_of(fresh))
    assert again.calibration.wearer.name == "Anna B"
    assert fresh.inner.calibration().scale == pytest.approx(np.full((7, 3), 1.04))
    again.calibration.wearer.choice.setCurrentIndex(0)
    again.calibration.wearer.choice.activated.emit(0)
    assert fresh.inner.calibration().scale == pytest.approx(np.ones((7, 3)))
    assert store.value.wearers.get("right", "") == ""
    again.close()


def test_a_wearer_is_applied_again_when_the_engine_changes(panel, engine, store, qtbot):
    panel.profiles.save("Anna")
    qtbot.waitUntil(lambda: panel.wearer.name == "Anna")
    engine.inner = chain()  # as by a change of the engine
    panel.window().sources.set_engine("chain")
    assert engine.inner.calibration().scale == pytest.approx(np.full((7, 3), 1.04))


def test_a_profile_is_transferred_to_another_computer_as_text(panel, tmp_path, qtbot, monkeypatch):
    file = tmp_path / "Anna.toml"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_, **__: (str(file), ""))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_, **__: (str(file), ""))
    panel.wearer.export_button.click()
    qtbot.waitUntil(file.exists)
    assert 'hand = "reference-right"' in file.read_text("utf-8")
    panel.profiles.reset(None)
    assert shown(panel, 0, 1).startswith("1.000 ± ")
    panel.wearer.import_button.click()
    assert panel.wearer.name == "Anna" and shown(panel, 0, 1).startswith("1.040 ± ")


def test_an_invalid_import_is_rejected(panel, tmp_path, monkeypatch):
    file = tmp_path / "other.toml"
    file.write_text("schema = 1\n", "utf-8")
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_, **__: (str(file), ""))
    panel.wearer.import_button.click()
    assert "other.toml" in panel.window().banner.text() and panel.wearer.name == ""


def test_a_wearer_of_another_glove_is_rejected(panel, store, qtbot):
    panel.profiles.save("Anna")
    qtbot.waitUntil(lambda: panel.wearer.name == "Anna")
    path = WearerStore(store.path.parent / "wearers").path("Anna")
    path.write_bytes(b"damaged")
    panel.profiles.wear("Anna")
    assert shows(panel.window().banner.text(), "wearer.invalid", file="Anna.toml")
    assert panel.wearer.name == ""


def test_an_engine_without_profiles_reports_it(panel, engine, qtbot):
    hand, glove, _ = models()
    engine.inner = Pipeline(hand, glove, simulation().rig, Settings(engine="vist")).engine
    panel.profiles.reset(None)
    window = panel.window()
    qtbot.waitUntil(
        lambda: window.log.model.entries("error", template_of("engine.no_wearer")) != []
    )


def test_removing_a_wearer_removes_the_file(panel, store, qtbot):
    panel.profiles.save("Anna")
    qtbot.waitUntil(lambda: panel.wearer.name == "Anna")
    action(panel.wearer.save_button.menu(), "Remove this profile").trigger()
    assert WearerStore(store.path.parent / "wearers").names() == []
    assert store.value.wearers.get("right", "") == ""


def test_a_removed_wearer_is_restored_by_undo(panel, store, qtbot):
    panel.profiles.save("Anna")
    qtbot.waitUntil(lambda: panel.wearer.name == "Anna")
    path = WearerStore(store.path.parent / "wearers").path("Anna")
    data, banner = path.read_bytes(), panel.window().banner
    remove = action(panel.wearer.save_button.menu(), "Remove this profile")
    remove.trigger()
    assert banner.text() == "The profile Anna was removed." and not path.exists()
    banner.buttons[0].click()
    assert path.read_bytes() == data
    assert panel.wearer.name == store.value.wearers["right"] == "Anna"
    remove.trigger()
    path.write_bytes(b"another")
    banner.buttons[0].click()
    assert path.read_bytes() == b"another" and shows(banner.text(), "window.exists_again")


def test_without_a_live_engine_nothing_can_be_changed(window):
    window.host.adopt(dataclasses.replace(scripted_setup(ScriptedEngine()), live=None))  # a replay
    row = window.calibration.wearer
    assert not any(w.isEnabled() for w in (row.choice, row.reset_button, row.frozen))
    assert row.comparing.isEnabled()


@pytest.mark.parametrize(
    ("name", "file_name"),
    [("Anna B.", "Anna B"), ("../x/y", "x_y"), ("Jürgen", "Jürgen"), ("//", "unnamed")],
)
def test_every_name_gives_a_file_name(name, file_name):
    assert person_file_name(name) == file_name


def test_an_imported_profile_replaces_no_other_one(tmp_path):
    engine = chain()
    layout = engine.layout
    store, elsewhere = WearerStore(tmp_path / "wearers"), tmp_path / f"{'Anna ' * 12}.toml"
    wearer = WearerFile(layout, engine.profile(), engine.calibration())
    write_wearer(elsewhere, wearer)
    first = store.take_in(elsewhere, layout)
    assert store.take_in(elsewhere, layout) == first, "the same profile is stored once"
    content = store.path(first).read_bytes()
    scale = wearer.profile.scale * 1.01
    profile = dataclasses.replace(wearer.profile, scale=scale)
    write_wearer(elsewhere, dataclasses.replace(wearer, profile=profile))
    second = store.take_in(elsewhere, layout)
    assert second != first and store.take_in(elsewhere, layout) == second
    assert store.path(first).read_bytes() == content
    assert store.names() == sorted([first, second])


@pytest.mark.styled
def test_no_heading_of_the_table_is_cut_in_a_narrow_panel(qtbot):
    table = CalibrationTable()
    qtbot.addWidget(table)
    table.resize(320, 200)
    table.show()
    table.show_rows(calibration_view(ScriptedEngine().calibration()).rows)
    header = table.horizontalHeader()
    for column in range(table.columnCount()):
        wanted = max(header.sectionSizeHint(column), table.sizeHintForColumn(column))
        assert header.sectionSize(column) >= wanted
    assert header.length() > table.viewport().width()
    qtbot.waitUntil(lambda: table.horizontalScrollBar().maximum() > 0)
