"""The window's memory."""

import json

import pytest

from app.settings import Settings, SettingsStore, sessions_folder


def test_values_come_back(tmp_path):
    SettingsStore(tmp_path / "w.json").update(theme="dark", participant="Ö")
    again = SettingsStore(tmp_path / "w.json").value
    assert (again.theme, again.participant) == ("dark", "Ö")


@pytest.mark.parametrize(
    "text", ["{", "[]", '{"version": 99}', '{"version": 1, "theme": 3}', "\x00\xff"]
)
def test_an_unreadable_file_is_kept_aside_and_defaults_serve(tmp_path, text):
    path = tmp_path / "w.json"
    path.write_text(text, "latin-1")
    assert SettingsStore(path).value == Settings()
    assert (tmp_path / "w.unreadable.json").read_text("latin-1") == text


def test_unknown_keys_of_a_later_version_are_dropped(tmp_path):
    path = tmp_path / "w.json"
    path.write_text(json.dumps({"version": 1, "theme": "light", "hologram": True}))
    assert SettingsStore(path).value.theme == "light"


def test_recordings_go_where_the_user_said(tmp_path):
    assert sessions_folder(Settings(sessions_folder=str(tmp_path))) == tmp_path
    assert sessions_folder(Settings()).name == "Glovetrack"
