"""The stored settings of the window."""

import json

import pytest

from app.storage.settings import (
    MIGRATIONS,
    VERSION,
    AppSettings,
    SettingsStore,
    migrated,
    sessions_folder,
    wearer_of,
)
from tracker.hand.names import SIDES


def test_values_are_restored(tmp_path):
    SettingsStore(tmp_path / "w.json").update(theme="dark", participant="Ö")
    again = SettingsStore(tmp_path / "w.json")
    assert (again.value.theme, again.value.participant) == ("dark", "Ö")
    assert again.notice == ""


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("{", ""),
        ("[]", "no version number"),
        ('{"version": 99}', "later version"),
        ('{"version": 1, "theme": 3}', "theme"),
        ('{"version": "1"}', "no version number"),
        ("\x00\xff", ""),
    ],
)
def test_an_unusable_file_is_renamed_reported_and_replaced_by_defaults(tmp_path, text, reason):
    path = tmp_path / "w.json"
    path.write_text(text, "latin-1")
    store = SettingsStore(path)
    assert store.value == AppSettings()
    assert (tmp_path / "w.unreadable.json").read_text("latin-1") == text
    assert "w.unreadable.json" in store.notice and reason in store.notice


def test_a_second_unusable_file_does_not_replace_the_first(tmp_path):
    path = tmp_path / "w.json"
    for text in ("first", "second"):
        path.write_text(text)
        SettingsStore(path)
    assert {p.read_text() for p in tmp_path.glob("w.unreadable*")} == {"first", "second"}


def test_unknown_keys_are_dropped(tmp_path):
    path = tmp_path / "w.json"
    path.write_text(json.dumps({"version": VERSION, "theme": "light", "hologram": True}))
    assert SettingsStore(path).value.theme == "light"


def test_settings_survive_an_upgrade_and_the_old_file_is_preserved(tmp_path):
    path = tmp_path / "w.json"
    old = {"version": 1, "theme": "dark", "participant": "P07", "layout": "AAAA", "port": "/dev/x"}
    path.write_text(json.dumps(old))
    store = SettingsStore(path)
    value = store.value
    assert (value.theme, value.participant, value.port) == ("dark", "P07", "/dev/x")
    assert (value.version, value.layout, store.notice) == (VERSION, {}, "")
    assert json.loads((tmp_path / "w.v1.json").read_text()) == old
    store.update(task="pinch")
    assert json.loads(path.read_text())["version"] == VERSION
    assert SettingsStore(path).value.participant == "P07"


def test_every_earlier_version_can_be_upgraded():
    assert sorted(MIGRATIONS) == list(range(1, VERSION))
    assert migrated({"version": 1}, 1)["version"] == VERSION


def test_the_wearers_of_version_3_are_assigned_to_sides(tmp_path):
    path = tmp_path / "w.json"
    old = {"version": 3, "wearer": "Anna", "left_wearer": "Bea", "demo_left_wearer": "Simulated"}
    path.write_text(json.dumps(old))
    value = SettingsStore(path).value
    assert [wearer_of(value, side) for side in SIDES] == ["Bea", "Anna"]
    assert [wearer_of(value, side, of_demo=True) for side in SIDES] == ["Simulated", ""]


def test_recordings_are_written_to_the_chosen_folder(tmp_path):
    assert sessions_folder(AppSettings(sessions_folder=str(tmp_path))) == tmp_path
    assert sessions_folder(AppSettings()).name == "Glovetrack"
