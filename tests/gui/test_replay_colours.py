"""The colours panel on a session whose colours followed the light: those of the displayed time."""

import dataclasses

import pytest

from app.engines.replay.engine import ColoursOfFile, open_replay
from tracker.glove import library
from tracker.live.colours import KIND
from tracker.messages import Event
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.session.reader import SessionReader
from tracker.session.writer import RecorderParams, SessionRecorder
from tracker.vision.colours import ColourProfile, parse_profile, profile_to_toml

FIRST = parse_profile(library.text("colours", library.DEFAULT_COLOURS))


def moved(by: int) -> ColourProfile:
    hues = (dataclasses.replace(h, saturation=(90 + by, 255)) for h in FIRST.hues)
    return dataclasses.replace(FIRST, hues=tuple(hues))


def event_of(t: float, profile: ColourProfile) -> Event:
    return Event(t, KIND, "", {"colours": profile_to_toml(profile)})


def test_colours_at_a_time_are_the_last_reported_before() -> None:
    events = [
        (2.0, event_of(2.0, moved(20))),
        (1.0, event_of(1.0, moved(10))),
        (1.5, Event(1.5, "note", "")),
    ]
    colours = ColoursOfFile(FIRST, events)
    assert colours.at(0.99) is FIRST
    assert (colours.at(1.0), colours.at(1.99), colours.at(7.0)) == (moved(10), moved(10), moved(20))
    colours.tried(moved(33))
    assert colours.at(0.0) == colours.at(7.0) == moved(33)
    colours.tried(moved(10))  # the user has gone back to one of the file's
    assert colours.at(7.0) == moved(20)


def test_unreadable_colours_or_those_of_another_glove_are_ignored() -> None:
    fewer = dataclasses.replace(FIRST, hues=FIRST.hues[:2])
    events = [
        (1.0, event_of(1.0, moved(10))),
        (2.0, Event(2.0, KIND, "", {"colours": "schema = 1\nname = 3\n"})),
        (3.0, event_of(3.0, fewer)),
        (4.0, event_of(4.0, moved(20))),
    ]
    colours = ColoursOfFile(FIRST, events)
    assert [colours.at(t) for t in (3.5, 2.5, 4.5)] == [moved(10), moved(10), moved(20)]


@pytest.fixture
def followed(tmp_path):
    """3 s; from 1 s on another light, from 2 s on yet another."""
    plain, path = tmp_path / "plain.mcap", tmp_path / "followed.mcap"
    simulate(plain, SimulateOptions(seed=3, duration=3.0, fps=10, images=False))
    with SessionReader(plain) as reader:
        info = dataclasses.replace(reader.info, rig=reader.rig(), colours_text="")
        messages = list(reader.messages())
    start = messages[0].t_arrival
    with SessionRecorder(path, info, RecorderParams(sync=False)) as recorder:
        for message in messages:
            recorder.write(message)
        for at in (1, 2):
            recorder.write(event_of(start + at, moved(10 * at)))
    return path


@pytest.mark.long
def test_the_panel_shows_the_colours_of_the_displayed_time_and_keeps_the_users(
    window, followed, qtbot
):
    setup = open_replay(followed, lambda *_: None)
    setup.player.play(False)
    window.host.adopt(setup)
    window.run_command("show_colours")
    row = window.colours.ranges.rows["saturation"]

    def shows(position: float, low: int) -> None:
        setup.player.seek(position)
        qtbot.waitUntil(lambda: row.values()[0] == low)
        assert window.host.setup.profile.hues[0].saturation[0] == low

    for position, low in ((0.5, 90), (1.5, 100), (2.5, 110), (1.5, 100)):
        shows(position, low)
    row.low.setValue(77)  # tried on the whole session
    for position in (0.5, 2.5):
        setup.player.seek(position)
        qtbot.waitUntil(lambda at=position: abs(setup.player.position - at) < 0.2)
        qtbot.wait(200)
        assert row.values()[0] == 77
    window.colours.undo()
    qtbot.waitUntil(lambda: row.values()[0] == 110)
    window.colours.redo()
    assert row.values()[0] == 77
    window.colours.start_again()
    qtbot.waitUntil(lambda: row.values()[0] == 110)
