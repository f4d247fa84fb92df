"""No command replaces or deletes an existing file without --force.

The options are read from the parsers: one that is not listed here fails the first test.
"""

from __future__ import annotations

import argparse
import importlib
import json
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest

import tracker.cli
from app.window import remote_command
from app.window.report_files import check_report, report_paths
from extensions.movement.tests.arm import BODY
from tests.made_once import made_once
from tests.notices import raises
from tracker.base.errors import FileError
from tracker.offline import colours as offline_colours
from tracker.offline.colours_fit import ColourCheck, SessionFit
from tracker.session.export.formats import FORMATS
from tracker.streaming.remote.request import Reply

ROOT = Path(__file__).parents[1]
OWN = b"the user's own\n"

WRITTEN = {"--out", "--output", "--json", "--figure", "--keep-wearer", "--keep", "--name", "folder"}
"""Options and positions of the command line that name what is written."""
NOT_WRITTEN = {
    *("source", "sources", "file", "files", "first", "second", "session", "sessions", "port"),
    *(
        "name",
        "text",
        "--align",
        "--broad",
        "--clutch",
        "--colours",
        "--dask",
        "--distal",
        "--engine",
        "--sessions",
    ),
    *("--engines", "--experiments", "--lights", "--ablations", "--glove", "--hand", "--image"),
    *("--body", "--imu", "--joints", "--left", "--listen", "--live", "--motion", "--object"),
    *("--objects", "--photo", "--right"),
    *("--remote", "--remote-host", "--send", "--set", "--settings", "--stream", "--stream-host"),
    *("words", "--task", "--to", "--views", "--wearer", "--model", "--kinds", "--by", "--gaps"),
    *("--folder", "--only", "reference", "--mapping", "--start", "--pulse", "--side", "model"),
    *("--fingers", "protocol", "--participant", "--variants", "--camera-errors"),
    *("--camera", "--port", "--calibration"),
}
"""Those that name what is read, devices, addresses, and other text."""


class Sessions(NamedTuple):
    """A recording with images, two trackings of it, and a table of raw samples."""

    raw: Path
    tracked: Path
    again: Path
    table: Path
    arm: Path  # the model of one

    @classmethod
    def in_folder(cls, folder: Path) -> Sessions:
        names = ("raw.mcap", "tracked.mcap", "again.mcap", "imu.csv", "arm.osim")
        return cls(*(folder / name for name in names))


@pytest.fixture(scope="module")
def sessions(shared_folder: Path) -> Sessions:
    return Sessions.in_folder(made_once(shared_folder / "existing", make_sessions))


def make_sessions(folder: Path) -> None:
    made = Sessions.in_folder(folder)
    run("simulate", "-o", made.raw, "--duration", 3.6, "--fps", 10)
    run("track", made.raw, "-o", made.tracked, "--with-sensors")
    run("track", made.raw, "-o", made.again, "--engine", "vist")
    run("export", made.tracked, "--format", "imu.csv", "-o", made.table)
    made.arm.write_text(BODY, "utf-8")


def run(*words: object, allowed: tuple[int, ...] = (0,)) -> int:
    """The command's exit status."""
    argv = [str(word) for word in words]
    status = tracker.cli.main(argv)
    assert status in allowed, argv
    return status


Words = Callable[[Sessions, Path], list[object]]
EVALUATE = ["--participants", 1, "--minutes", 0.1, "--engines", "chain", "--experiments", "free"]

CASES: dict[str, Words] = {
    "simulate": lambda s, f: ["-o", f / "o.mcap", "--duration", 1, "--blobs-only"],
    "colours fit": lambda s, f: [s.raw, "-o", f / "c.toml"],
    "colours check": lambda s, f: [s.raw, "--json", f / "j.json"],
    "track": lambda s, f: [
        *(s.raw, "-o", f / "o.mcap", "--keep-wearer", f / "w.toml", "--json", f / "j.json")
    ],
    "light": lambda s, f: [s.raw, "--json", f / "j.json"],
    "crop": lambda s, f: [s.raw, "-o", f / "o.mcap", "--stop", 0.5, "--json", f / "j.json"],
    "retargeting-config": lambda s, f: ["-o", f / "hand.yml"],
    "robot-hand": lambda s, f: ["-o", f / "o.toml", "--json", f / "j.json"],
    "teleop": lambda s, f: [s.tracked, "-o", f / "o.mcap", "--json", f / "j.json"],
    "import": lambda s, f: [s.table, "-o", f / "o.mcap", "--json", f / "j.json"],
    "info": lambda s, f: [s.tracked, "--json", f / "j.json"],
    "latency": lambda s, f: [s.tracked, "--json", f / "j.json"],
    "gaps": lambda s, f: [s.tracked, "--json", f / "j.json"],
    "doctor": lambda s, f: ["--only", "processor", "-o", f / "d.txt", "--json", f / "j.json"],
    "verify": lambda s, f: [s.tracked, "--json", f / "j.json"],
    "recover": lambda s, f: [s.tracked, "-o", f / "o.mcap", "--json", f / "j.json"],
    "opensim-body": lambda s, f: [
        *(s.tracked, "--body", s.arm, "-o", f / "o.osim", "--json", f / "j.json")
    ],
    "report": lambda s, f: [s.tracked, "-o", f / "r.html", "--json", f / "j.json"],
    "compare": lambda s, f: [
        *(s.tracked, s.again, "--figure", f / "d.png", "--json", f / "j.json")
    ],
    "align": lambda s, f: [
        *(s.tracked, s.again, "-o", f / "a.json", "--figure", f / "d.png", "--json", f / "j.json")
    ],
    "evaluate vist": lambda s, f: [
        *(*EVALUATE, "--out", f / "out", "--keep", f / "keep", "--json", f / "j.json")
    ],
    "evaluate inertial": lambda s, f: [
        *("--quick", "--seeds", 1, "--rates", 100, "--out", f / "out", "--json", f / "j.json")
    ],
    "evaluate faults": lambda s, f: ["--count", 1, "--json", f / "j.json"],
    "evaluate gestures": lambda s, f: [
        *("--on-truth", "--people", 1, "--seconds", 1, "--json", f / "j.json")
    ],
    "evaluate hands": lambda s, f: [
        "--pairs",
        1,
        "--seconds",
        4,
        "--fps",
        5,
        "--json",
        f / "j.json",
    ],
    "evaluate robot": lambda s, f: [
        *("--trials", 1, "--people", 1, "--seconds", 1, "--json", f / "j.json")
    ],
    "conformance": lambda s, f: [s.tracked, "-o", f / "p.html", "--json", f / "j.json"],
    "apps": lambda s, f: ["touch", s.tracked, "-o", f / "o.mcap", "--json", f / "j.json"],
    "firmware show": lambda s, f: ["--json", f / "j.json"],
    "print": lambda s, f: ["board", "-o", f / "b.pdf"],
    "export": lambda s, f: [
        *(s.tracked, "--format", "csv", "-o", f / "o.csv", "--json", f / "j.json")
    ],
    **{
        f"remote {what}": lambda s, f, more=more: [*more, "--json", f / "j.json"]
        for what, more in {
            "start": [],
            "stop": [],
            "status": [],
            "note": ["x"],
            "vibrate": ["thumb"],
            "contact": ["thumb"],
        }.items()
    },
}
"""Words of each command that writes, all its outputs in the folder ``f``."""
ELSEWHERE = {("rig", "folder"), ("fill", "--out"), ("fill", "--json")}
ELSEWHERE |= {("line-time", "--set"), ("line-time", "--json")}  # a swung hand
ELSEWHERE |= {
    ("evaluate shutter", "--json"),
    ("evaluate effects", "--json"),
    ("evaluate gaps", "--json"),
    ("evaluate fingers", "--json"),
    ("evaluate touch", "--json"),
}  # minutes
ELSEWHERE |= {("touch-test", "--output"), ("touch-test", "--json"), ("room align", "--out")}
ELSEWHERE |= {("import-reference", "--output"), ("import-reference", "--json")}  # longer movement
ELSEWHERE |= {("accuracy", "--output"), ("accuracy", "--json")}
ELSEWHERE |= {(f"study {name}", "--json") for name in ("check", "status", "tables", "export")}
ELSEWHERE |= {(f"study {name}", "--output") for name in ("report", "tables", "export")}
ELSEWHERE |= {("imu-noise", "--out"), ("imu-noise", "--json")}  # a minute at rest
ELSEWHERE |= {(f"imu-{name}", "--json") for name in ("axes", "drift")}
ELSEWHERE |= {("fit-glove", "--name"), ("fit-glove", "--json")}  # free motion
ELSEWHERE |= {("loop-back", "--json")}  # devices
ELSEWHERE |= {(opens, "--out") for opens in ("window", "demo", "devices")}
"""Options whose tests are of their own, below."""


def parsers() -> Iterator[tuple[str, argparse.ArgumentParser]]:
    """Every command's parser by its name."""
    yield from _below(tracker.cli.build_parser(), "")


def _below(
    parser: argparse.ArgumentParser, name: str
) -> Iterator[tuple[str, argparse.ArgumentParser]]:
    inner = [a for a in parser._actions if isinstance(a, argparse._SubParsersAction)]
    for action in inner:
        for word, below in action.choices.items():
            yield from _below(below, f"{name} {word}".strip())
    if not inner:
        yield name, parser


def text_options() -> set[tuple[str, tuple[str, ...]]]:
    """The names, for each command, of every option and position that takes a free text."""
    found = set()
    for name, parser in parsers():
        for action in parser._actions:
            if "--log-file" in action.option_strings:
                continue  # tests/test_shell_completion.py: every command has it
            if action.nargs != 0 and action.choices is None and _takes_text(action):
                found.add((name, tuple(action.option_strings) or (action.dest,)))
    return found


def _takes_text(action: argparse.Action) -> bool:
    try:
        return action.type is None or bool(action.type("file.json"))  # type: ignore[operator]
    except (ValueError, argparse.ArgumentTypeError):
        return False


def test_every_option_is_known_to_write_or_not_to() -> None:
    unknown = [
        (command, names)
        for command, names in text_options()
        if bool(WRITTEN & set(names)) == bool(NOT_WRITTEN & set(names))
    ]
    assert not unknown, "add them to WRITTEN or NOT_WRITTEN, and what writes to CASES"


def test_every_option_that_writes_is_tried(tmp_path: Path) -> None:
    paths = Sessions(*[tmp_path] * len(Sessions._fields))
    for command, names in text_options():
        if not WRITTEN & set(names) or (command, names[-1]) in ELSEWHERE:
            continue
        assert command in CASES, f"{command} {names} is not tried"
        assert set(names) & set(CASES[command](paths, tmp_path)), f"{command} {names} is not tried"


REPEATED = (
    "extensions.evaluation.trials.run_all",
    "extensions.evaluation.hands.command.run_all",
    "extensions.evaluation.gestures.command.score",
    "extensions.evaluation.inertial.report.run",
)
"""Work of evaluations: the run with --force has the results of the one before."""


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """A window that does what it is asked, colours that fit at once, evaluations that compute their
    results only once."""
    done = Reply(True, "stop", "Done.").as_json()
    monkeypatch.setattr(remote_command, "ask", lambda words: done)

    def fit(messages: object, worn: object, profile: object) -> SessionFit:
        check = ColourCheck(1, 1, (), 1.0)
        return SessionFit(profile, check, check, {})  # type: ignore[arg-type]

    monkeypatch.setattr(offline_colours, "fit_messages", fit)
    for where in REPEATED:
        monkeypatch.setattr(where, remembered(_at(where)))


def remembered(work: Callable[..., object]) -> Callable[..., object]:
    """``work``, of which a call with the same first argument has the same result at once."""
    known: dict[str, object] = {}

    def call(first: object, *others: object) -> object:
        if (key := repr(first)) not in known:
            known[key] = work(first, *others)
        return known[key]

    return call


def _at(where: str) -> Callable[..., object]:
    module, _, name = where.rpartition(".")
    found: Callable[..., object] = getattr(importlib.import_module(module), name)
    return found


def files_in(folder: Path) -> dict[Path, bytes]:
    return {p.relative_to(folder): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


@pytest.mark.long
@pytest.mark.timeout(600)
@pytest.mark.usefixtures("workers_here")
@pytest.mark.parametrize("command", CASES)
def test_what_exists_survives_without_force_and_is_replaced_with_it(
    command: str, sessions: Sessions, tmp_path: Path, quick: None
) -> None:
    if command in ("teleop", "robot-hand", "retargeting-config", "evaluate robot"):
        pytest.importorskip("mujoco")
    made = tmp_path / "made"
    made.mkdir()
    words = [*command.split(), *CASES[command](sessions, made)]
    run(*words, allowed=(0, 1))  # conformance and verify have exit status 1 for a verdict, too
    names = sorted(files_in(made))
    assert names
    for name in {name.suffix: name for name in names}.values():  # one of a kind
        _survives(command, sessions, tmp_path / "exists" / name.as_posix().replace("/", "_"), name)
    keep = {n for n in names if n.parts[0] == "keep"}  # results that a later run continues from
    for name in names:
        if name not in keep:
            (made / name).write_bytes(OWN)
    run(*words, "--force", allowed=(0, 1))
    for name in set(names) - keep:
        assert (made / name).read_bytes() != OWN, f"{name} was not replaced"

    if command in CONTRACTS:
        CONTRACTS[command](json.loads((made / "j.json").read_text()))


def _check_inertial(found: dict[str, Any]) -> None:
    assert all(
        {"series", "rate_hz", "t_m", "estimator", "rms_deg"} <= r.keys() for r in found["rows"]
    )
    assert found["rows"] and {"crossover_s", "cost_us", "broad"} <= found.keys()


def _check_vist(found: dict[str, Any]) -> None:
    (row,) = found["rows"]
    keys = """experiment engine ablation level participants mean_mm sd_mm within_sd_mm
        between_sd_mm
        ci95_mm pck20 pck35 keypoints matched_mean wrong_match_rate nees_per_dof core_s_per_s
        paper"""
    assert set(keys.split()) <= row.keys()


CONTRACTS = {"evaluate inertial": _check_inertial, "evaluate vist": _check_vist}
"""What other programs read in the JSON of commands that are not in test_command_contract.py."""


def _survives(command: str, sessions: Sessions, folder: Path, name: Path) -> None:
    (folder / name).parent.mkdir(parents=True)
    (folder / name).write_bytes(OWN)
    run(*command.split(), *CASES[command](sessions, folder), allowed=(1,))
    assert (folder / name).read_bytes() == OWN


@pytest.mark.long
@pytest.mark.parametrize("form", FORMATS.names())
def test_an_export_replaces_nothing_without_force(
    form: str, sessions: Sessions, tmp_path: Path
) -> None:
    made, taken = tmp_path / "made", tmp_path / "taken"
    for folder in (made, taken):
        folder.mkdir()
    drawn = {"mp4": ["--every", 30], "png": ["--every", 30]}
    more = drawn | {"lerobot": ["--images", "none", "--task", "x"]}
    words = ["export", sessions.tracked, "--format", form, *more.get(form, []), "-o"]
    run(*words, made / f"o.{form}")
    names = [p.name for p in made.iterdir()]
    assert len(names) > 1
    for name in names:
        (taken / name).write_bytes(OWN)
        run(*words, taken / f"o.{form}", allowed=(1,))
        assert files_in(taken) == {Path(name): OWN}
        (taken / name).unlink()
    before = files_in(made)
    for name in names:
        if (made / name).is_file():
            (made / name).write_bytes(OWN)
    run(*words, made / f"o.{form}", "--force", allowed=(1,) if FORMATS.get(form).folder else (0,))
    if FORMATS.get(form).folder:  # nothing is ever added to a folder
        assert files_in(made) == before | {Path(n): OWN for n in names if (made / n).is_file()}
    else:
        assert OWN not in files_in(made).values()


def test_the_record_of_a_simulated_wearer_replaces_nothing(tmp_path: Path) -> None:
    """Refused before the minute of simulation."""
    for name in ("p.html", "p.mcap", "p.labels.json"):
        (tmp_path / name).write_bytes(OWN)
        run("conformance", "--simulated", "-o", tmp_path / "p.html", allowed=(1,))
        assert files_in(tmp_path) == {Path(name): OWN}
        (tmp_path / name).unlink()


def test_a_simulated_rig_replaces_only_its_own_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("pty")
    from tests.simulation.test_rig_device import NoSimulatedCamera
    from tracker.simulation import rig_device

    monkeypatch.setattr(rig_device, "SimulatedCamera", lambda spec: NoSimulatedCamera())
    monkeypatch.setattr("sys.stdin", None)
    words = ["rig", tmp_path, "--duration", "0.2"]
    for name in ("glove", "camera.mjpeg", "camera.yml"):
        (tmp_path / name).write_bytes(OWN)
        run(*words, allowed=(1,))
        assert files_in(tmp_path) == {Path(name): OWN}
        run(*words, "--force")
        assert set(files_in(tmp_path)) == {Path("camera.yml")}
        (tmp_path / "camera.yml").unlink()
    # of a rig that was killed
    run(*words)
    (tmp_path / "glove").symlink_to("/dev/pts/12345")
    os.mkfifo(tmp_path / "camera.mjpeg")
    run(*words)


def test_a_headless_report_replaces_nothing_without_force(
    tmp_path: Path, qapp: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With --force: tests/gui/test_stream_arguments.py, in a process of its own."""
    monkeypatch.setattr("app.window.start.tune_process", lambda: None)
    words = ["--demo", "--lenses", "none", "--headless-report", "1", "--out", str(tmp_path)]
    (tmp_path / "notes.txt").write_bytes(OWN)
    for path in report_paths(tmp_path):
        path.write_bytes(OWN)
        with raises(FileError, "file.exists_force"):
            check_report(tmp_path)
        path.unlink()
    report_paths(tmp_path)[-1].write_bytes(OWN)
    before = files_in(tmp_path)
    run(*words, allowed=(1,))
    assert files_in(tmp_path) == before


@pytest.mark.long
def test_an_empty_file_may_be_written_to(sessions: Sessions, tmp_path: Path) -> None:
    """As mktemp makes it, which others may not read."""
    out = tmp_path / "tmp.abc"
    out.touch(0o600)
    run("info", sessions.tracked, "--json", out)
    assert json.loads(out.read_text())["duration_s"] > 1
    assert out.stat().st_mode & 0o777 == 0o600
    link = tmp_path / "link"
    (tmp_path / "empty").touch()
    link.symlink_to(tmp_path / "empty")
    run("info", sessions.tracked, "--json", link, allowed=(1,))
