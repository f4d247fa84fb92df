"""A user's application: installed as a package, fed, recorded, run again."""

from __future__ import annotations

import importlib
import socket
import subprocess
import sys
import threading
import zipfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from extensions.applications.command_runs import Into, difference, replay, run_into
from extensions.applications.drawing import Line, Points
from extensions.applications.hand import HandReader, predicted
from extensions.applications.registry import APPLICATIONS, kind, make, titles
from extensions.applications.runner import ApplicationRunner
from extensions.applications.sources import from_json, simulated, streamed
from extensions.applications.stage import ApplicationStage
from extensions.applications.tests.hands import GLOVE, HAND, estimates, outcomes, words
from tests.fixtures import ROOT
from tests.notices import raises
from tracker.base.clock import nanoseconds, seconds
from tracker.base.errors import ConfigError, FileError, GlovetrackError
from tracker.cli import main
from tracker.messages import Event, Message, Tracking
from tracker.offline.simulate import SimulateOptions
from tracker.session.decode import Decoded
from tracker.session.reader import SessionReader
from tracker.simulation.scripted import Key
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import Names, StreamError

EXAMPLE = ROOT / "docs" / "examples" / "glovetrack-air-drawing"
HERE, THERE = (0.17, 0.0, 0.1), (0.17, 0.1, 0.1)
LINE = [
    Key(0.0, "open_palm", HERE),
    Key(0.5, "pinch_index", HERE),
    Key(1.0, "pinch_index", HERE),
    Key(1.8, "pinch_index", THERE),
    Key(2.3, "open_palm", THERE),
    Key(2.6, "thumb_up", THERE),
    Key(2.9, "fist", THERE),
    Key(3.3, "fist", THERE),
]


BUILD = "import sys; from setuptools import build_meta; build_meta.build_wheel(sys.argv[1])"
"""What pip has done by the build system that the example names."""


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the wheel of the example unpacked in it, as pip installs one."""
    source, target = tmp_path_factory.mktemp("source"), tmp_path_factory.mktemp("site")
    for file in EXAMPLE.glob("*.*"):
        (source / file.name).write_bytes(file.read_bytes())
    command = [sys.executable, "-c", BUILD, target]
    subprocess.run(command, cwd=source, check=True, timeout=120, capture_output=True)
    (wheel,) = target.glob("*.whl")
    with zipfile.ZipFile(wheel) as packed:
        packed.extractall(target)
    return target


@pytest.fixture
def installed(site: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.syspath_prepend(str(site))
    importlib.invalidate_caches()
    yield
    sys.modules.pop("glovetrack_air_drawing", None)


def test_the_example_is_short_and_listed(installed: None) -> None:
    assert len((EXAMPLE / "glovetrack_air_drawing.py").read_text().splitlines()) < 60
    assert titles()["air-drawing"] == "Drawing in the air"
    assert list(titles())[:4] == ["touch", "arm", "place", "swarm"], "ours first"


def test_built_in_applications_are_listed_without_importing_their_packages(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    described = APPLICATIONS.all().items()
    assert {n: (d.name, d.title) for n, d in described} == {
        n: (kind(n).name, kind(n).title) for n, _ in described
    }
    monkeypatch.setitem(sys.modules, "mujoco", None)  # as where it is not installed
    room = kind("arm").__module__.rpartition(".")[0]
    for name in [n for n in sys.modules if n.startswith(room)]:
        monkeypatch.delitem(sys.modules, name)
    assert titles()["arm"] == "Robot arm"
    with raises(ConfigError, "application.needs_package"):
        kind("arm")


def test_a_pinch_draws_a_line_and_a_fist_erases_it(installed: None) -> None:
    found = outcomes("air-drawing", LINE)
    assert words(found) == ["line", "wiped"]
    drawn = [o.drawing for o in found if any(isinstance(d, Line) for d in o.drawing)]
    (line,) = [d for d in drawn[-1] if isinstance(d, Line)]
    assert np.linalg.norm(line.points[-1] - line.points[0]) == pytest.approx(0.1, abs=0.02)
    assert [type(d) for d in found[-1].drawing] == [Points]


def test_the_same_hands_give_the_same_drawing_bit_for_bit(installed: None) -> None:
    def bits() -> list[bytes]:
        drawn = [d for o in outcomes("air-drawing", LINE) for d in o.drawing]
        return [d.points.tobytes() for d in drawn if isinstance(d, Line | Points)]

    assert bits() == bits()


def test_settings_are_checked_and_a_change_is_an_event(installed: None) -> None:
    with raises(ConfigError, "toml.number", file="air-drawing", key="width"):
        make("air-drawing", {"width": "wide"})
    with raises(ConfigError, "part.unknown"):
        kind("knitting")
    runner = ApplicationRunner("air-drawing", HAND, GLOVE, {"width": 5})
    with raises(ConfigError, "toml.setting", key="height"):
        runner.set("height", 1.0)
    first, second = estimates(LINE)[:2]
    (begun,) = [e for o in runner.feed(first) for e in o.events]
    assert begun.data["settings"]["width"] == 5.0  # type: ignore[index]
    runner.set("width", 7.0)
    (change,) = [e for o in runner.feed(second) for e in o.events]
    assert (change.t, change.data["key"], change.data["value"]) == (second.t, "width", 7.0)
    assert runner.settings.width == 7.0


@pytest.mark.long
def test_a_session_contains_everything_to_repeat_a_run(installed: None, tmp_path: Path) -> None:
    """Tracked from simulated sensors, recorded, read back: the same events to the last bit."""
    options = SimulateOptions(seed=3, motion="show:swarm", duration=6.4, images=False, fps=20.0)
    source = simulated(options, False)
    out = tmp_path / "drawn.mcap"
    report = run_into("air-drawing", source, Into(out), {"width": 2.0})
    assert report.to_json()["events"]["line"] > 0
    with SessionReader(out) as reader:
        reported = [m for m in reader.messages((Event,)) if isinstance(m, Event)]
    assert [(e.t, dict(e.data)) for e in reported[:-1]] == [(e.t, e.data) for e in report.events]
    assert main(["apps", "air-drawing", str(out), "--check"]) == 0


def test_different_events_are_detected(installed: None) -> None:
    found = [e for o in outcomes("air-drawing", LINE) for e in o.events]
    assert difference(found, found) == ""
    forged = [*found[:-1], replace(found[-1], data={**found[-1].data, "lines": 2})]
    assert difference(forged, found).startswith("At ")
    assert difference(found, found[:-1]).endswith("it is nothing.")


def test_a_session_without_an_application_is_an_error(tmp_path: Path) -> None:
    from tracker.offline.simulate import simulate

    simulate(tmp_path / "s.mcap", SimulateOptions(duration=1.0, images=False))
    with raises(FileError, "applications.none_recorded"):
        replay(tmp_path / "s.mcap")


def test_a_failing_application_is_stopped_and_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    from extensions.applications import registry
    from extensions.applications.tests.broken import Broken

    monkeypatch.setattr(registry, "kind", lambda name: Broken)
    reported: list[Event] = []
    stage = ApplicationStage(HAND, GLOVE, reported.append)
    stage.show("broken")
    for estimate in estimates(LINE)[:5]:
        list(stage.feed(estimate))
    assert [e.data["what"] for e in reported] == ["begins", "failed"]
    assert stage.problem == "ZeroDivisionError: division by zero"


def test_a_stage_reports_the_end_and_restarts_for_a_recording(installed: None) -> None:
    reported: list[str] = []
    stage = ApplicationStage(HAND, GLOVE, lambda e: reported.append(str(e.data["what"])))
    frames = estimates(LINE)

    def feed(k: int) -> None:
        for estimate in frames[k : k + 5]:
            list(stage.feed(estimate))

    stage.show("air-drawing")
    feed(0)
    stage.restart()
    feed(5)
    stage.show("")
    feed(10)
    assert reported == ["begins", "begins", "ends"]


def test_each_application_that_began_ends_however_quickly_others_are_shown(installed: None) -> None:
    reported: list[str] = []
    stage = ApplicationStage(HAND, GLOVE, lambda e: reported.append(str(e.data["what"])))
    frames = estimates(LINE)
    stage.show("air-drawing")
    list(stage.feed(frames[0]))
    stage.show("air-drawing")  # never fed: it neither begins nor ends
    stage.show("")
    list(stage.feed(frames[1]))
    assert reported == ["begins", "ends"]


def test_the_hand_is_extrapolated_between_two_samples() -> None:
    reader = HandReader(HAND, GLOVE)
    before, now, after = (reader.read(e) for e in estimates(LINE)[140:143])
    middle = predicted(before, now, 0.005)
    assert middle.t == pytest.approx((now.t + after.t) / 2)
    truth = (now.p + after.p) / 2
    assert np.abs(middle.p - truth).max() < 2e-4  # m: 10 m/s² of acceleration over 5 ms
    assert middle.between
    assert not middle.phases
    late = [replace(hand, t=31148.44 + hand.t) for hand in (before, now)]
    t = predicted(*late, 0.005).t
    assert t == seconds(nanoseconds(t)), "a session would not keep it"


def test_a_lost_hand_has_no_position() -> None:
    lost = replace(estimates(LINE)[0], tracking=Tracking.LOST)
    hand = HandReader(HAND, GLOVE).read(lost)
    assert not hand.located
    assert hand.palm is None


def test_a_stream_read_back_is_the_hand_that_was_sent() -> None:
    hand_names = Names.of(HAND, GLOVE)
    sent = estimates(LINE)[100]
    read = from_json(to_json(sent, hand_names), hand_names, len(HAND.segments))
    assert np.abs(read.keypoints - sent.keypoints).max() < 1e-6
    assert np.abs(read.angles - sent.angles).max() < 1e-6
    assert (read.keypoint_state == sent.keypoint_state).all()
    with raises(GlovetrackError, "stream.not_ours"):
        from_json("{}", hand_names, 1)


@pytest.mark.long
def test_settings_that_are_rows_of_numbers_are_the_same_again(tmp_path: Path) -> None:
    options = SimulateOptions(motion="show:touch", duration=3.0, images=False, fps=20.0)
    out, place = tmp_path / "touched.mcap", {"place": [0.25, 0.0, 0.06]}
    report = run_into("touch", simulated(options, True), Into(out), place)
    assert report.samples > 400
    (again,) = replay(out)
    assert again.differs == ""


@pytest.fixture
def port(monkeypatch: pytest.MonkeyPatch) -> int:
    """A free port, for a stream that is closed soon."""
    monkeypatch.setattr("extensions.applications.sources.SILENCE", 0.2)
    monkeypatch.setattr("extensions.applications.sources.TIMEOUT", 0.3)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])


def test_an_application_runs_on_a_live_stream_until_that_ends(port: int) -> None:
    hand_names, sent = Names.of(HAND, GLOVE), estimates(LINE)[:5]
    messages = streamed(f"udp:{port}").messages
    found: list[Message | Decoded] = []
    enough = threading.Event()

    def listen() -> None:
        for message in messages:
            found.append(message)
            if len(found) == 5:
                enough.set()

    listener = threading.Thread(target=listen)
    listener.start()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
        for k in range(3000):  # the first ones arrive before the client listens
            out.sendto(to_json(sent[k % 5], hand_names).encode(), ("127.0.0.1", port))
            if enough.wait(0.01):
                break
    listener.join()
    assert enough.is_set()
    assert {m.t for m in found} <= {e.t for e in sent}


def test_a_stream_without_a_hand_is_an_error(port: int) -> None:
    with raises(StreamError, "applications.no_hand"):
        list(streamed(f"udp:{port}").messages)
    with raises(ConfigError, "applications.address"):
        streamed("tcp:1")
