"""The project as a whole: versions, pinned packages, the files it ships, its inner borders."""

from __future__ import annotations

import ast
import functools
import re
import shlex
import shutil
import subprocess
import tomllib
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.testing import assert_allclose
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

import tracker
from tracker.glove.files import glove_hand_name, load_glove
from tracker.glove.model import GloveModel
from tracker.hand.files import load_hand
from tracker.hand.model import HandModel
from tracker.vision.colours import load_profile

ROOT = Path(__file__).parents[1]
RESOURCES = ROOT / "resources"
HANDS = sorted((RESOURCES / "hands").glob("*.toml"))
GLOVES = sorted((RESOURCES / "gloves").glob("*.toml"))
COLOURS = sorted((RESOURCES / "colours").glob("*.toml"))
MIRROR = np.diag([1.0, -1.0, 1.0])  # of a right hand into a left one


def project() -> dict[str, Any]:
    return tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def tracked_files() -> list[Path]:
    if not (ROOT / ".git").exists() or shutil.which("git") is None:
        pytest.skip("needs a git checkout")
    listed = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    return [path for name in listed.stdout.split("\0") if name and (path := ROOT / name).is_file()]


def load_shipped_glove(path: Path) -> tuple[GloveModel, HandModel]:
    hand_name = glove_hand_name(path.read_text(), path.name)
    hand = load_hand(RESOURCES / "hands" / f"{hand_name}.toml")
    return load_glove(path, hand), hand


def test_the_version_is_the_same_everywhere() -> None:
    assert project()["version"] == tracker.__version__ == version("glovetrack")


def locked_hashes(name: str) -> dict[str, tuple[str, set[str]]]:
    """Version and SHA-256 hashes by package, of a lock file without repetitions or other lines."""
    text = "".join(
        line
        for line in (ROOT / name).read_text().splitlines(keepends=True)
        if not line.startswith("#")
    )
    pins = [shlex.split(line) for line in text.replace("\\\n", " ").splitlines()]
    found = {}
    for pin, *hashes in pins:
        package, version = pin.split("==")
        assert hashes and all(re.fullmatch("--hash=sha256:[0-9a-f]{64}", h) for h in hashes), pin
        found[canonicalize_name(package)] = version, set(hashes)
    assert len(found) == len(pins)
    assert list(found) == sorted(found)
    return found


def locked(name: str) -> dict[str, str]:
    """Versions by package, of a lock file."""
    return {package: version for package, (version, _) in locked_hashes(name).items()}


def test_the_locks_pin_what_the_project_asks_for() -> None:
    extras = project()["optional-dependencies"]
    every = [text for name, texts in extras.items() if name != "packaging" for text in texts]
    for_tests = [*project()["dependencies"], *every]
    for lock, texts in [
        ("requirements.lock", project()["dependencies"]),
        ("requirements-test.lock", for_tests),
    ]:
        versions = locked(lock)
        for text in texts:
            asked = Requirement(text)
            assert asked.specifier.contains(versions[canonicalize_name(asked.name)]), text


def test_the_tests_run_with_the_programs_own_versions() -> None:
    program, tests = locked_hashes("requirements.lock"), locked_hashes("requirements-test.lock")
    assert program.items() <= tests.items()


def test_the_locks_have_the_hashes_of_every_platform() -> None:
    for name in ("requirements.lock", "requirements-test.lock"):
        _, hashes = locked_hashes(name)["numpy"]
        # source, and wheels of at least three versions of Python for Linux, Windows and macOS
        assert len(hashes) > 9


def test_what_installs_a_lock_requires_its_hashes() -> None:
    script = (ROOT / "packaging" / "environment.sh").read_text()
    installs = re.findall(r"^.*--requirement.*$", script, re.MULTILINE)
    assert len(installs) == 2, "uv, and pip where uv cannot"
    assert all("--require-hashes" in line for line in installs)


@pytest.mark.parametrize("path", HANDS, ids=lambda p: p.stem)
def test_shipped_hands_load_under_their_file_name(path: Path) -> None:
    assert load_hand(path).name == path.stem


@pytest.mark.parametrize("path", GLOVES, ids=lambda p: p.stem)
def test_shipped_gloves_load_and_fit_their_hands(path: Path) -> None:
    glove, hand = load_shipped_glove(path)
    assert glove.name == path.stem
    assert set(glove.hues) <= {hue.name for hue in load_profile(COLOURS[0]).hues}
    for marker in glove.markers:
        segment = hand.segments[hand.index[marker.segment]]
        assert -0.01 <= marker.position[0] <= segment.length + 0.015
        assert marker.position @ marker.normal > 0, "turned into the hand"


@pytest.mark.parametrize("path", COLOURS, ids=lambda p: p.stem)
def test_shipped_colour_profiles_load(path: Path) -> None:
    assert load_profile(path).name == path.stem


@pytest.mark.parametrize("path", [p for p in HANDS if "left" in p.stem], ids=lambda p: p.stem)
def test_a_left_hand_mirrors_its_right_one(path: Path) -> None:
    left = load_hand(path)
    right = load_hand(path.with_stem(path.stem.replace("left", "right")))
    assert (left.side, right.side) == ("left", "right")
    assert left.segment_names == right.segment_names
    for a, b in zip(left.segments, right.segments, strict=True):
        assert (a.parent, a.length, a.radius, a.width) == (b.parent, b.length, b.radius, b.width)
        assert_allclose(a.origin, MIRROR @ b.origin, atol=1e-9)
        assert_allclose(a.R_rest, MIRROR @ b.R_rest @ MIRROR, atol=1e-7)
    for a, b in zip(left.joints, right.joints, strict=True):
        assert (a.name, a.child, a.axes) == (b.name, b.child, b.axes)
        for axis in a.axes:
            low, high = b.limits[axis]
            assert_allclose(
                a.limits[axis], (low, high) if axis == "flexion" else (-high, -low), atol=1e-9
            )
    assert left.synergies == right.synergies


@pytest.mark.parametrize("path", [p for p in GLOVES if "left" in p.stem], ids=lambda p: p.stem)
def test_a_left_glove_mirrors_its_right_one(path: Path) -> None:
    left, left_hand = load_shipped_glove(path)
    right, right_hand = load_shipped_glove(path.with_stem(path.stem.removesuffix("-left")))
    assert (left.side, left_hand.side) == ("left", "left")
    assert left.hues == right.hues
    assert_allclose(left.marker_position, right.marker_position @ MIRROR, atol=1e-9)
    assert_allclose(left.marker_normal, right.marker_normal @ MIRROR, atol=1e-9)
    assert np.array_equal(left.marker_hue, right.marker_hue)
    assert np.array_equal(left.marker_segment(left_hand), right.marker_segment(right_hand))
    for a, b in zip(left.imus, right.imus, strict=True):
        assert (a.name, a.segment) == (b.name, b.segment)
        assert_allclose(a.position, MIRROR @ b.position, atol=1e-9)
    for a, b in zip(left.keypoints, right.keypoints, strict=True):
        assert (a.name, a.segment) == (b.name, b.segment)
        assert_allclose(a.position, MIRROR @ b.position, atol=1e-9)


THREADS = {
    "app/engines/apart/child.py": "requests and news of the window",
    "app/engines/apart/demo_truth.py": "builds the simulated hands when they are needed",
    "app/engines/apart/process.py": "news of the process that tracks",
    "app/engines/demo.py": "finds how the simulated wearer touches his fingertips",
    "app/engines/replay/engine.py": "plays a session beside the window",
    "tracker/simulation/rig_device.py": "sends images as a device of its own does",
    "app/platform/tasks.py": "jobs of the window",
    "app/wizards/glove/feed.py": "reads the glove that is being set up",
    "app/wizards/stereo/board_watcher.py": "looks for the board beside the window",
    "tracker/base/child.py": "cameras, gloves, recorder, robot and a driver on trial are processes",
    "tracker/kernels/build.py": "compiles parts side by side, ahead of time",
    "extensions/applications/live.py": "an application sees every estimate and holds up none",
    "tracker/live/recording.py": "the disk's own",
    "tracker/live/reference.py": "a second engine, never in the way of the first",
    "tracker/live/threads.py": "devices, vision and engine",
    "tracker/offline/detection.py": "searches images ahead of the filter",
    "extensions/robot/process.py": "hears the robot, which is a process of its own",
    "tracker/session/mcap/container.py": "writing does not wait for the disk",
    "tracker/session/recording/child.py": "reads the pipe, compresses images and writes the file",
    "tracker/simulation/drawn_ahead.py": "packets are made before they are due",
    "extensions/applications/swarm/simulated_vehicles.py": "simulated vehicles fly by themselves",
    "tracker/simulation/glove_device.py": "the simulated glove has a chip of its own",
    "app/tools/stream_readers.py": "reads several streams at once",
    "tracker/streaming/apart.py": "reads what the streams' process answers",
    "tracker/streaming/apart_child.py": "opens and tests streams beside one another",
    "tracker/streaming/attach.py": "looks at the latest estimate",
    "extensions/loopback/measure.py": "commands and packets while images are read",
    "extensions/loopback/window/flash.py": "measures while the window flashes",
    "extensions/lsl/markers.py": "reads markers of other programs",
    "extensions/room/doors.py": "reads poses of other systems",
    "extensions/room/lsl_poses.py": "reads poses of other systems",
    "extensions/room/vrpn_poses.py": "reads poses of other systems",
    "tracker/streaming/remote/doors.py": "stamps requests as they arrive",
    "tracker/streaming/server_thread.py": "the event loop of a server",
    "tracker/streaming/streams.py": "sends to all outputs, and to one that hangs in its own thread",
    "tracker/base/workers.py": "many sessions on all cores",
}
"""Who starts threads or processes, and what for."""

CLOCKS = {
    "tracker/doctor/command_runs.py": "when the report was made",
    "tracker/base/urgency.py": "how much of a processor a real-time thread uses",
    "tracker/doctor/machine.py": "rates of devices and of the disk",
    "tracker/doctor/computer.py": "how long tracking takes",
    "app/engines/demo.py": "begins now",
    "app/engines/apart/news.py": "when a status is due",
    "app/engines/apart/process.py": "how often the window is refreshed",
    "app/engines/engine_host.py": "when tracking was last started again",
    "app/engines/snapshot.py": "when the engine was last looked at",
    "app/engines/hardware.py": "anchors a recording to the wall clock",
    "app/engines/recording.py": "the time recorded",
    "app/engines/replay/engine.py": "how much of the session has passed",
    "app/panels/colours/source.py": "names of kept images",
    "app/panels/recording.py": "how fast the file grows",
    "app/platform/single_instance.py": "how long it waits for an answer",
    "app/tools/paint_profile.py": "measures",
    "app/tools/recording_load.py": "measures",
    "app/tools/screenshots.py": "waits",
    "app/tools/soak.py": "measures",
    "app/viewmodels/log.py": "the time beside a line",
    "app/viewmodels/recording.py": "names of new files",
    "app/window/bug_reports.py": "names of new files",
    "app/window/doctor.py": "names of new files",
    "app/window/headless_report.py": "measures",
    "tracker/offline/fill.py": "the date of an edit",
    "tracker/offline/rig_command.py": "ends in time",
    "tracker/simulation/rig_device.py": "begins now",
    "app/window/message_bar.py": "the time of a line in the log",
    "app/window/recordings.py": "how long ago a session was used",
    "app/window/ticker.py": "when panels and the window were last drawn",
    "app/wizards/glove/feed.py": "waits for packets",
    "app/wizards/stereo/result.py": "the date of a calibration",
    "tracker/base/clock.py": "the host's clock, to be handed over",
    "glovetrack/simulated_devices.py": "begins now",
    "glovetrack/live.py": "anchors a session to the wall clock",
    "extensions/evaluation/fingers/trial.py": "measures",
    "extensions/evaluation/inertial/report.py": "measures",
    "extensions/evaluation/vist/run.py": "how long is left",
    "extensions/evaluation/vist/trial.py": "measures",
    "extensions/conformance/stream.py": "the default of a clock that is handed over",
    "tracker/base/terminal.py": "how often progress is printed",
    "tracker/offline/track.py": "measures",
    "tracker/sensors/discovery.py": "the default of a clock that is handed over",
    "tracker/sensors/glove_link.py": "the default of a clock that is handed over",
    "tracker/simulation/camera_device.py": "a device in real time",
    "tracker/live/threads.py": "how long devices are waited for",
    "tracker/live/work_priority.py": "the default of a clock that is handed over",
    "tracker/simulation/glove_device.py": "a device in real time",
    "extensions/foxglove/live.py": "stamps of the wall clock, which clients want",
    "tracker/streaming/streams.py": "how long an output has been sending; sent per second",
    "extensions/loopback/measure.py": "the default of a clock that is handed over",
    "extensions/lsl/outlet.py": "the default of a clock that is handed over",
    "extensions/landmarks/hts.py": "when it connects again",
    "extensions/study/simulated.py": "when a trial was recorded",
    "extensions/study/window/dialog.py": "when a trial was recorded",
    "extensions/ros2/glovetrack_ros/glovetrack_ros/convert.py": "stamps of schema 1",
    "extensions/vr/opengloves.py": "when it opens the pipe again",
    "extensions/vr/vmt.py": "how long it waits for the driver",
    "extensions/openxr/publisher.py": "the default of a clock that is handed over",
    "extensions/openxr/window/panel.py": "how long a test took",
    "extensions/openxr/readers.py": "when an application last read the hand",
    "tracker/base/workers.py": "how long is left",
}
"""Who reads a clock, and what for. Filters never do: a session read back gives the same states."""

STARTS = {"Thread", "Timer", "Process", "ThreadPoolExecutor", "ProcessPoolExecutor", "QThread"}
TIMES = {"time", "monotonic", "perf_counter", "process_time", "thread_time"}


class FileFacts(NamedTuple):
    """Of one file of the product, which three tests ask for: it is parsed once."""

    names: set[str]
    deferred: list[tuple[int, bool]]
    methods: dict[str, int]  # by class


@functools.cache
def product() -> dict[str, FileFacts]:
    """By the file's name below the tree."""
    folders = [ROOT / name for name in ("app", "extensions", "glovetrack", "tracker")]
    files = [p for f in folders for p in sorted(f.rglob("*.py")) if "tests" not in p.parts]
    return {p.relative_to(ROOT).as_posix(): file_facts(p.read_text("utf-8")) for p in files}


def file_facts(text: str) -> FileFacts:
    nodes = list(ast.walk(ast.parse(text)))
    classes = [n for n in nodes if isinstance(n, ast.ClassDef)]
    return FileFacts(
        names_used(nodes),
        deferred_imports(nodes, text.splitlines()),
        {c.name: sum(isinstance(n, ast.FunctionDef) for n in c.body) for c in classes},
    )


def names_used(nodes: list[ast.AST]) -> set[str]:
    """``module.name`` of what a file takes from modules, however it imports them."""
    whole: dict[str, str] = {}
    parts: dict[str, str] = {}
    for node in nodes:
        if isinstance(node, ast.Import):
            whole |= {a.asname or a.name: a.name for a in node.names}
        elif isinstance(node, ast.ImportFrom):
            parts |= {a.asname or a.name: f"{node.module}.{a.name}" for a in node.names}
    used = {parts[n.id] for n in nodes if isinstance(n, ast.Name) and n.id in parts}
    for node in nodes:
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            owner = node.value.id
            used.add(f"{whole.get(owner, parts.get(owner, owner))}.{node.attr}")
    return used


def starts_threads(names: set[str]) -> bool:
    return any(n.rsplit(".", 1)[-1] in STARTS and not n.startswith("psutil.") for n in names)


def reads_clocks(names: set[str]) -> bool:
    clocks = {f"time.{name}{ns}" for name in TIMES for ns in ("", "_ns")}
    return bool(names & (clocks | {"datetime.datetime.now", "datetime.date.today"}))


@pytest.mark.parametrize(("does", "known"), [(starts_threads, THREADS), (reads_clocks, CLOCKS)])
def test_only_listed_modules_use_threads_and_clocks(
    does: Callable[[set[str]], bool], known: dict[str, str]
) -> None:
    assert {name for name, found in product().items() if does(found.names)} == set(known)


def test_no_file_contains_paths_of_its_authors_machine() -> None:
    homes = rb"/root|/home/\w+|/Users/\w+|" + re.escape(str(ROOT)).encode()
    somewhere = re.compile(rb"(?<![\w.}])(" + homes + rb")/")
    guilty = [
        f"{path.relative_to(ROOT)}: {line.decode(errors='replace').strip()}"
        for path in tracked_files()
        if path.suffix not in {".png", ".svg"}
        for line in path.read_bytes().splitlines()
        if somewhere.search(line)
    ]
    assert not guilty


def test_scripts_parse_and_can_be_run() -> None:
    scripts = [p for p in tracked_files() if p.suffix == ".sh" or p.parent.name == ".ci"]
    assert len(scripts) >= 4
    for script in scripts:
        assert script.stat().st_mode & 0o100, f"{script.name} is not executable"
        subprocess.run(["bash", "-n", script], check=True)


@pytest.mark.parametrize("name", ["README.md", "resources/firmware/README.md"])
def test_links_of_a_readme_lead_somewhere(name: str) -> None:
    page = ROOT / name
    links = re.findall(r"\]\(([^)#]+)", page.read_text())
    for link in links:
        assert link.startswith("https://") or (page.parent / link).exists(), link


def test_the_architecture_page_names_every_part() -> None:
    """Each folder and module directly below the packages, and each path on the page exists."""
    page = (ROOT / "docs" / "architecture.md").read_text("utf-8")
    named = set(re.findall(r"`((?:app|extensions|glovetrack|tracker)/[\w/.]*?)/?`", page))
    for package in ("app", "extensions", "tracker"):
        for path in sorted((ROOT / package).iterdir()):
            left = path.is_dir() and not any(path.rglob("*.py"))  # bytecode of a moved package
            if left or path.name in {"__init__.py", "py.typed"}:
                continue
            assert f"{package}/{path.name}" in named, f"{package}/{path.name} is not described"
    missing = [name for name in named if not (ROOT / name).exists()]
    assert not missing, "the page describes what is not there"


MOST_DEFERRED_IMPORTS = 100


def deferred_imports(nodes: list[ast.AST], lines: list[str]) -> list[tuple[int, bool]]:
    """Line of each import in a function, and whether a comment ``# deferred: why`` is on a line of
    its block of imports or on the line above."""
    found: dict[int, bool] = {}
    for function in nodes:
        if not isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef):
            continue
        last, marked = 0, False
        for node in ast.walk(function):
            if not isinstance(node, ast.Import | ast.ImportFrom):
                continue
            if node.lineno != last + 1:
                marked = "# deferred: " in lines[node.lineno - 2]
            last = node.end_lineno or node.lineno
            marked = marked or "# deferred: " in "\n".join(lines[node.lineno - 1 : last])
            found[node.lineno] = marked
    return list(found.items())


def test_imports_in_functions_are_few_and_have_a_reason() -> None:
    """Descriptors name their functions by `tracker.base.registry.deferred` instead."""
    count = 0
    for path, found in product().items():
        for line, marked in found.deferred:
            assert marked, f"{path}:{line}: write '# deferred: why'"
            count += 1
    assert count <= MOST_DEFERRED_IMPORTS


MOST_METHODS = 20


def test_no_class_has_more_methods_than_a_reader_can_follow() -> None:
    for path, found in product().items():
        for name, count in found.methods.items():
            assert count <= MOST_METHODS, f"{path}: {name}"
