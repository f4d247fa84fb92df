"""Sessions of other versions, and sessions without a camera, are tracked without options."""

import functools
import json
from dataclasses import replace
from pathlib import Path

import pytest

from tests.notices import raises, shows
from tracker import CONTINUED, __version__
from tracker.base.config import to_toml
from tracker.base.errors import ConfigError
from tracker.cli import main
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.messages import BlobFrame, EngineState, Event, ImuSample
from tracker.offline.options import USUAL, TrackOptions
from tracker.offline.simulate import SimulateOptions, build, simulate
from tracker.offline.track import track
from tracker.session.compare import compare
from tracker.session.description import SessionInfo
from tracker.session.reader import SessionReader
from tracker.session.writer import SessionRecorder
from tracker.simulation.scenario import Simulation

pytestmark = pytest.mark.long

BEGIN = 0.8  # s
OLD = "[chain.constraint]\nthumb_abduction = 0.3\n[warp]\nspeed = 9\n"


@functools.cache
def simulated() -> tuple[Simulation, SessionInfo, list[ImuSample | BlobFrame]]:
    """Two seconds of a hand, whose messages are the same in each session."""
    sim, info = build(SimulateOptions(seed=5, duration=2.0, fps=30, images=False))
    return sim, info, [m for m in sim.feed() if isinstance(m, ImuSample | BlobFrame)]


def recorded(path: Path, settings: str, version: str = __version__, state: bool = False) -> Path:
    """A session recorded with these settings by that version."""
    sim, info, messages = simulated()
    info = replace(info, settings_text=settings, version=version)
    pipeline = Pipeline(sim.hand, sim.glove, sim.rig)
    begun = False
    with SessionRecorder(path, info) as recorder:
        for m in messages:
            if m.t_arrival >= BEGIN and not begun:
                begun = True
                if state:
                    recorder.write(EngineState(m.t_arrival, "chain", pipeline.get_state()))
            if begun:
                recorder.write(m)
            elif isinstance(m, BlobFrame):
                pipeline.feed_frame(m)
            else:
                pipeline.feed_imu(m)
    return path


def test_obsolete_settings_are_named_and_the_others_used(tmp_path: Path) -> None:
    changed = to_toml(replace(Settings(), engine="vist")) + OLD.replace("[chain.", "[old.")
    old = recorded(tmp_path / "old.mcap", changed)
    now = recorded(tmp_path / "now.mcap", to_toml(replace(Settings(), engine="vist")))
    report = track(old, tmp_path / "a.mcap")
    assert track(now, tmp_path / "b.mcap").notices == []
    (unused,) = report.notices
    assert unused.code == "track.settings_unused" and unused.values["file"] == "old.mcap"
    assert "warp" in str(unused.values["settings"]) and "old" in str(unused.values["settings"])
    with SessionReader(tmp_path / "a.mcap") as reader:
        assert reader.info.engine == "vist"
        found = [m.notice for m in reader.messages() if isinstance(m, Event)]
    assert unused in found, "it is recorded, too"
    assert compare(tmp_path / "a.mcap", tmp_path / "b.mcap")["identical"]


def test_recorded_streams_have_no_effect(tmp_path: Path) -> None:
    """Settings contained the live streams until version 0.1.0."""
    streams = '[streams]\nudp = true\nhost = "10.0.0.2"\nlsl_network = false\njoints = "own"\n'
    settings = to_toml(Settings())
    old = recorded(tmp_path / "old.mcap", f"{settings}\n{streams}", state=True)
    now = recorded(tmp_path / "now.mcap", settings, state=True)
    (tmp_path / "streams.toml").write_text(streams)
    runs = {"a": (old, ""), "b": (now, ""), "c": (old, str(tmp_path / "streams.toml"))}
    for name, (path, file) in runs.items():
        report = track(path, tmp_path / f"{name}.mcap", TrackOptions(settings=file))
        assert "track.settings_unused" not in [n.code for n in report.notices], name
    assert compare(tmp_path / "a.mcap", tmp_path / "b.mcap")["identical"]
    (tmp_path / "wrong.toml").write_text("[chain]\nros = true\n")
    with raises(ConfigError, "toml.setting", key="chain.ros"):
        track(old, tmp_path / "d.mcap", TrackOptions(settings=str(tmp_path / "wrong.toml")))


def test_the_command_line_tracks_them_and_accepts_other_settings(tmp_path: Path, capsys) -> None:
    old = recorded(tmp_path / "old.mcap", OLD)
    assert main(["track", str(old), "-o", str(tmp_path / "a.mcap")]) == 0
    assert "chain.constraint.thumb_abduction, warp" in capsys.readouterr().out
    (tmp_path / "mine.toml").write_text('engine = "switching"\n')
    for name, settings, engine in (("b", "default", "chain"), ("c", "mine.toml", "switching")):
        asked = settings if settings == "default" else str(tmp_path / settings)
        words = ["track", str(old), "-o", str(tmp_path / f"{name}.mcap"), "--settings", asked]
        assert main([*words, "--json", str(tmp_path / f"{name}.json")]) == 0
        assert "words" not in json.loads((tmp_path / f"{name}.json").read_text())
        with SessionReader(tmp_path / f"{name}.mcap") as reader:
            assert reader.info.engine == engine
    assert not shows(capsys.readouterr().out, "track.settings_unused")
    (tmp_path / "bad.toml").write_text("warp = 9\n")
    bad = ["track", str(old), "-o", str(tmp_path / "d.mcap"), "--settings"]
    assert main([*bad, str(tmp_path / "bad.toml")]) == 1
    assert shows(capsys.readouterr().err, "toml.setting")


@pytest.mark.parametrize(
    ("settings", "last", "more"),
    [('engine = "kalman_9"\n', "engine", 0), ("[chain]\nwarp = nan\n", "chain.warp", 0),
     ('engine = "vist"\nlenses = 3\n', "lenses", 0),
     ("".join(f"gone{k} = 1\n" for k in range(50)), "gone7", 42)],
)  # fmt: skip
def test_for_any_settings(tmp_path: Path, settings: str, last: str, more: int) -> None:
    old = recorded(tmp_path / "old.mcap", settings)
    report = track(old, tmp_path / "a.mcap")
    values = report.notices[0].values
    assert report.estimates > 50 and values["settings"][-1] == last
    assert values.get("more", 0) == more


def test_settings_that_are_not_toml_are_rejected_with_the_remedy(tmp_path: Path) -> None:
    old = recorded(tmp_path / "old.mcap", "engine = \n")
    with raises(ConfigError, "track.settings_not_usable"):
        track(old, tmp_path / "a.mcap")
    assert track(old, tmp_path / "a.mcap", TrackOptions(settings=USUAL)).estimates > 50


def test_a_state_of_another_version_is_reported_as_not_used(tmp_path: Path) -> None:
    old = recorded(tmp_path / "old.mcap", to_toml(Settings()), "0.0.9", state=True)
    (found,) = track(old, tmp_path / "a.mcap").notices
    assert (found.code, found.values["version"]) == ("track.state_unused", "0.0.9")
    new = recorded(tmp_path / "new.mcap", to_toml(Settings()), state=True)
    assert track(new, tmp_path / "b.mcap").notices == []


def test_a_state_of_the_last_version_is_continued(tmp_path: Path) -> None:
    """Bit for bit as this version's, with a note that the versions' results may differ."""
    runs = {}
    for version in (*CONTINUED, __version__):
        session = recorded(tmp_path / f"{version}.mcap", to_toml(Settings()), version, state=True)
        runs[version] = track(session, tmp_path / f"again_{version}.mcap")
    for version in CONTINUED:
        (note,) = runs[version].notices
        assert note.code == "track.state_of_version" and note.values["version"] == version
        a, b = tmp_path / f"again_{version}.mcap", tmp_path / f"again_{__version__}.mcap"
        assert compare(a, b)["identical"]
    without = recorded(tmp_path / "without.mcap", to_toml(Settings()), CONTINUED[0])
    assert track(without, tmp_path / "c.mcap").notices == []


def test_a_real_session_of_an_older_version_is_tracked(data_folder: Path, tmp_path: Path) -> None:
    source = data_folder / "overload" / "session.mcap"
    report = track(source, tmp_path / "a.mcap")
    unused = {n.code: n.values for n in report.unused}
    named = str(unused["track.settings_unused"]["settings"])
    assert "chain.constraint.thumb_abduction" in named and "track.state_unused" in unused
    assert report.estimates > 600 and report.error_mm["mean"] < 40


@pytest.mark.parametrize("lenses", ["none", "0"])
def test_a_session_without_a_camera_is_tracked_by_inertial(tmp_path: Path, lenses: str) -> None:
    source = tmp_path / "in.mcap"
    assert main(["simulate", "-o", str(source), "--lenses", lenses, "--duration", "3"]) == 0
    report = track(source, tmp_path / "a.mcap")
    with SessionReader(tmp_path / "a.mcap") as reader:
        assert reader.info.engine == "inertial"
    assert report.error_mm == {}, "its position is not known"
    assert report.error_deg is not None and 0.5 < report.error_deg < 15


def test_angles_are_evaluated_wherever_the_truth_is_known(tmp_path: Path, capsys) -> None:
    simulate(tmp_path / "in.mcap", SimulateOptions(seed=2, duration=3.0, fps=30, images=False))
    done = tmp_path / "a.json"
    words = ["track", str(tmp_path / "in.mcap"), "-o", str(tmp_path / "a.mcap")]
    assert main([*words, "--json", str(done)]) == 0
    output = json.loads(done.read_text())
    assert output["error_mm"]["mean"] > 0 and 0 < output["error_deg"] < 15
    assert "joint angle error" in capsys.readouterr().out


def test_the_help_names_every_engine_and_the_use_of_settings(capsys) -> None:
    with pytest.raises(SystemExit):
        main(["track", "--help"])
    output = capsys.readouterr().out
    assert "inertial" in output and "--settings FILE|default" in output
