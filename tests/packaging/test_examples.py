"""Plug-ins of the documentation, installed with a wheel of the program, not in the source tree."""

from __future__ import annotations

import json
import os
import re
import shutil
import socket
import subprocess
import sys
import threading
from pathlib import Path

import pytest

import tracker.engine.pipeline  # noqa: F401  (its kernels are to be known)
from tracker import __version__
from tracker.kernels import parts
from tracker.kernels.decorator import are_compiled

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "docs" / "examples"
SCRIPTS = ("rerun", "ros2")
"""Examples that are not packages."""
LONGEST = 60
"""Lines of a plug-in that adds one thing."""
STAGE = """
import sys
from pathlib import Path
sys.path.insert(0, "packaging")
import backend
backend.stage(Path.cwd(), Path(sys.argv[1]))
backend.add_compiled(Path.cwd(), Path(sys.argv[1]))
backend.add_metadata(Path(sys.argv[1]))
"""
BUILD = """
import os
import sys
from setuptools import build_meta
out, *projects = sys.argv[1:]  # setuptools changes them
for project in projects:
    os.chdir(project)
    build_meta.build_wheel(out)
"""
"""One process for all wheels: pip would start two for each."""
ALONE = """
import sys
sys.meta_path = [f for f in sys.meta_path if "editable" not in str(f).lower()]
sys.path = [p for p in sys.path if p != {tree!r}]
"""


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What a wheel installs, and the examples."""
    site = tmp_path_factory.mktemp("site")
    subprocess.run([sys.executable, "-c", STAGE, str(site)], cwd=ROOT, check=True)
    sources = []
    for project in sorted(EXAMPLES.glob("*/pyproject.toml")):
        sources.append(site / "sources" / project.parent.name)
        shutil.copytree(project.parent, sources[-1])
    wheels = site / "wheels"
    command = [sys.executable, "-c", BUILD, str(wheels), *map(str, sources)]
    subprocess.run(command, check=True, capture_output=True)
    command = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-index"]
    command += ["--target", str(site), *map(str, wheels.glob("*.whl"))]
    subprocess.run(command, check=True, capture_output=True)
    assert len(list(site.glob("*.dist-info"))) == len(sources) + 1
    for name in SCRIPTS:
        shutil.copytree(EXAMPLES / name, site / "scripts", dirs_exist_ok=True)
    return site


def run(site: Path, code: str, **more: str) -> str:
    """The output of a program with the installed wheel, without the tree."""
    done = subprocess.run(
        [sys.executable, "-P", "-c", ALONE.format(tree=str(ROOT)) + code],
        cwd=site.parent,
        env=os.environ | {"PYTHONPATH": str(site), **more},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_the_tree_is_not_used(site: Path) -> None:
    code = "import importlib.util as u; print([n for n in ('app', 'tracker') if u.find_spec(n)])"
    assert run(site, code) == "[]"


@pytest.fixture(scope="module")
def tracked(site: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three seconds, by the installed commands, which export them, too."""
    folder = tmp_path_factory.mktemp("tracked")
    raw, out, table = str(folder / "raw.mcap"), folder / "s.mcap.t.mcap", folder / "hand.csv"
    code = f"""
from glovetrack.app.__main__ import main
assert main(["simulate", "-o", {raw!r}, "--duration", "3", "--blobs-only"]) == 0
assert main(["track", {raw!r}, "-o", {str(out)!r}]) == 0
assert main(["export", {str(out)!r}, "--format", "csv", "-o", {str(table)!r}]) == 0
"""
    run(site, code)
    assert table.stat().st_size > 1000
    return out


def test_compiled_kernels_are_included(site: Path, tracked: Path) -> None:
    """Found by their installed names, and compiled from the same source: `tracked` was made with
    them."""
    if not parts.built() or not are_compiled():
        pytest.skip("the library of kernels was not built here")
    code = """
import glovetrack.tracker.engine.pipeline
from glovetrack.tracker import kernels
from glovetrack.tracker.kernels import decorator
assert kernels.are_compiled()
print(len(decorator._library()._entries))
"""
    assert int(run(site, code)) > 40
    assert "has_ext_modules" in (site / "setup.py").read_text()


def test_an_application_is_found_and_draws(site: Path, tracked: Path) -> None:
    code = f"""
import json
from glovetrack.app.__main__ import main
assert main(["apps", "air-drawing", {str(tracked)!r}, "--json", "a.json", "--force"]) == 0
print(json.loads(open("a.json").read())["application"])
"""
    assert run(site, code).splitlines()[-1] == "air-drawing"


def test_a_command_is_listed_and_runs(site: Path, tracked: Path) -> None:
    session = str(tracked)
    code = f"""
from glovetrack.app.__main__ import main
assert main(["pinches", {session!r}, "--closer-mm", "0.001"]) == 0
assert main(["pinches", {session!r}, "--closer-mm", "1000"]) == 0
try:
    main(["pinches", "x", "--closer-mm", "0"])
except SystemExit as ended:
    assert ended.code == 2
main(["--help"])
"""
    text = run(site, code)
    assert "s.mcap.t.mcap: 0 pinches, 0.0 s in total" in text
    assert re.search(r"pinches, 2\.[5-9] s", text), "all but the first 0.1 s, when the hand is lost"
    assert re.search(r"pinches\s+count pinches of the thumb and a finger", text)


def test_a_camera_driver_is_found(site: Path, tmp_path: Path) -> None:
    import numpy as np

    np.save(tmp_path / "0001.npy", np.full((2, 48, 64, 3), 7, np.uint8))
    code = f"""
from glovetrack.cameras import CaptureFormat
from glovetrack.tracker.sensors.camera_plugins import all_cameras, open_plugin
address = next(c.path for c in all_cameras() if c.path.startswith("folder:"))
camera = open_plugin(address, CaptureFormat(64, 48, 30.0))
camera.open()
left, right = camera.read()
print(left.shape, int(right.max()), {str(tmp_path)!r} in address)
"""
    found = run(site, code, GLOVETRACK_FOLDER_CAMERAS=str(tmp_path))
    assert found == "(48, 64, 3) 7 True"


PEERS = '''
import dataclasses, faulthandler, importlib, json, math, subprocess, sys, threading, time, types
from unittest.mock import MagicMock

faulthandler.dump_traceback_later(240, exit=True)  # where it hangs

class Config:
    register_subclass = staticmethod(lambda name: lambda kind: kind)

class Teleoperator:
    def __init__(self, config):
        pass

class Error(Exception):
    pass

for name, parts in {
    "lerobot": {}, "lerobot.teleoperators": {}, "lerobot.utils": {},
    "lerobot.teleoperators.config": {"TeleoperatorConfig": Config},
    "lerobot.teleoperators.teleoperator": {"Teleoperator": Teleoperator},
    "lerobot.utils.errors": {"DeviceAlreadyConnectedError": Error,
                             "DeviceNotConnectedError": Error},
}.items():
    sys.modules[name] = types.ModuleType(name)
    vars(sys.modules[name]).update(parts)
for name in ("rclpy", "geometry_msgs", "geometry_msgs.msg", "sensor_msgs", "sensor_msgs.msg",
             "tf2_ros"):
    sys.modules[name] = MagicMock()

def angles_of(action):
    """Of LeRobot's action."""
    return dict((n.removesuffix(".pos"), angle) for n, angle in action.items())


def nearest(angles, estimates):
    """Largest difference (rad) from the estimate that is nearest; of its known angles, at least
    ten."""
    apart = []
    for estimate in estimates:
        known = [n for n, a in estimate.angles.items() if a == a and n in angles]
        if len(known) >= 10:
            apart.append(max(abs(angles[n] - estimate.angles[n]) for n in known))
    return float(min(apart, default=math.inf))


def compare(out, name, angles, estimates):
    """Note angles that are those of an estimate, with the digits of JSON."""
    if nearest(angles, estimates) < 1e-5:
        out[name] = True
'''
"""Stand-ins for LeRobot and rclpy, which are not installed: the tests of each example in
`tests/streaming` compare all that it makes."""


def test_streams_are_found_and_received(site: Path, tmp_path: Path) -> None:
    """From one simulated hand: by a plain socket, LeRobot's teleoperator, the node of ROS 2, DDS
    and Rerun."""
    for needed in ("websockets", "cyclonedds", "rerun"):
        pytest.importorskip(needed)
    with socket.create_server(("127.0.0.1", 0)) as server:
        server.settimeout(60)
        lines: list[str] = []

        def read() -> None:
            connection, _ = server.accept()
            with connection, connection.makefile(encoding="utf-8") as text:
                lines.extend(text)

        reader = threading.Thread(target=read)
        reader.start()
        web, udp = free_ports()
        code = f"""
import glovetrack
if __name__ == "__main__":
    scripts = {str(site / "scripts")!r}
    sys.path.insert(0, scripts)
    import lerobot_teleoperator_glovetrack as robot
    import glovetrack_dds, glovetrack_node
    from cyclonedds.domain import DomainParticipant
    from cyclonedds.sub import DataReader
    from cyclonedds.topic import Topic
    url = "ws://127.0.0.1:{web}/"
    nodes = [threading.Thread(target=m.run, args=(url,)) for m in (glovetrack_dds, glovetrack_node)]
    seen, out = [], dict()
    with glovetrack.LiveTracker.simulated(camera=False) as live:
        live.publish("tcp:{server.getsockname()[1]},websocket:{web},udp:{udp}", joints="openxr",
                     say=print)
        save = [scripts + "/glovetrack_rerun.py", "--port", "{udp}", "--save", "hand.rrd"]
        with open("rerun.txt", "w") as said:
            rerun = subprocess.Popen([sys.executable, *save, "--messages", "3"],
                                     stdout=said, stderr=said)
        topic = Topic(DomainParticipant(78), "rt/hand/right/joint_states",
                      glovetrack_dds.JointState_, qos=glovetrack_dds.QOS)
        listener = DataReader(topic.participant, topic, qos=glovetrack_dds.QOS)
        config = robot.GlovetrackConfig()
        config.url, config.feedback_url = url, ""
        config.patience = config.connect_patience = 60.0  # s, on a loaded computer
        arm = robot.Glovetrack(config)
        connecting = threading.Thread(target=arm.connect)
        for thread in [*nodes, connecting]:
            thread.start()
        begun = time.monotonic()
        for estimate in live:
            seen.append(estimate)
            # a slow reader of `live` misses estimates, and those just sent may not be seen yet
            if not connecting.is_alive() and "robot" not in out:
                compare(out, "robot", angles_of(arm.get_action()), seen[-100:])
            state = next(iter(listener.take(1)), None)
            if state is not None and "dds" not in out:
                compare(out, "dds", dict(zip(state.name, state.position)), seen[-100:])
            done = len(seen) > 100 and len(out) == 2 and rerun.poll() is not None
            if done or time.monotonic() > begun + 120:
                break
        arm.disconnect()
    for node in nodes:
        node.join(10)
        assert not node.is_alive(), "it ends with the stream"
    rerun.kill()
    assert rerun.wait() == 0, (sorted(out), open("rerun.txt").read())
    node = sys.modules["rclpy"].create_node.return_value
    topics = [call.args[1] for call in node.create_publisher.call_args_list]
    print(json.dumps([topics, sorted(out)]))
"""
        ended = run(site, PEERS + code, ROS_DOMAIN_ID="78")
        reader.join(10)
    hands = [json.loads(line) for line in lines]
    assert len(hands) >= 40
    assert {hand["side"] for hand in hands} == {"right"} and len(hands[0]["joints"]) == 26
    stamps = [hand["t"] for hand in hands]
    assert stamps == sorted(set(stamps))
    topics, received = json.loads(ended.splitlines()[-1])
    assert topics == ["/hand/right/joint_states", "/hand/right/openxr"]
    assert received == ["dds", "robot"], "each received one of the estimates"
    assert (site.parent / "hand.rrd").stat().st_size > 1000


def free_ports() -> list[int]:
    """A port of TCP and one of UDP."""
    ports = []
    for kind in (socket.SOCK_STREAM, socket.SOCK_DGRAM):
        with socket.socket(socket.AF_INET, kind) as free:
            free.bind(("127.0.0.1", 0))
            ports.append(free.getsockname()[1])
    return ports


def test_the_notebook_runs_and_shows_the_results_in_its_text(site: Path) -> None:
    code = """
import ast, json
import matplotlib
matplotlib.use("Agg")
space = {}
for cell in json.load(open(NOTEBOOK, encoding="utf-8"))["cells"]:
    if cell["cell_type"] == "code":
        *before, last = ast.parse("".join(cell["source"])).body
        exec(compile(ast.Module(before, []), "cell", "exec"), space)
        if isinstance(last, ast.Expr):
            print(repr(eval(compile(ast.Expression(last.value), "cell", "eval"), space)))
        else:
            exec(compile(ast.Module([last], []), "cell", "exec"), space)
"""
    shown = run(site, f"NOTEBOOK = {str(EXAMPLES / 'first_look.ipynb')!r}\n" + code)
    assert "True False" in shown, "tracked again identical, by another engine not"
    assert (site.parent / "first_look.c3d").stat().st_size > 1000


def test_the_notebook_is_stored_without_outputs() -> None:
    cells = json.loads((EXAMPLES / "first_look.ipynb").read_text("utf-8"))["cells"]
    assert len({c["id"] for c in cells}) == len(cells)
    assert all(c["outputs"] == [] for c in cells if c["cell_type"] == "code")


def test_a_stream_without_its_package_affects_no_others(site: Path) -> None:
    """As after `pip uninstall`, and with an extension's folder removed."""
    code = """
import sys
sys.modules["websockets"] = None
sys.modules["glovetrack.extensions.osc.extension"] = None
from glovetrack.streams import Names, StreamError, StreamSettings, open_streams
from glovetrack.engine import load
hands = [Names.of(*load("vist-small"))]
try:
    open_streams(StreamSettings({"udp": True, "websocket": True}), hands)
except StreamError as error:
    print(error)
print(list(open_streams(StreamSettings({"udp": True, "vmc": True}), hands)))
"""
    sentence, names = run(site, code).splitlines()
    assert sentence.startswith("The websocket stream requires a package that is not installed")
    assert sentence.endswith('Run: pip install "glovetrack[streams]"')
    assert names == "['udp']"


def test_a_panel_and_a_command_are_in_the_window(site: Path, tmp_path: Path) -> None:
    code = """
from pathlib import Path
from PySide6.QtWidgets import QApplication
app = QApplication(["glovetrack"])
from glovetrack.app.storage.settings import SettingsStore
from glovetrack.app.window.main_window import MainWindow
window = MainWindow(SettingsStore(Path("window.json")))
panel = window.panels["pinch"]
panel.refresh(None)
print(window.docks["pinch"].windowTitle(), panel.figure.text())
print(window.commands.actions["add-mark"].isEnabled())
print("pinch" in window.layouts.jobs["all"].columns[1][1])
window.close()
"""
    home = {"HOME": str(tmp_path), "XDG_CONFIG_HOME": str(tmp_path), "QT_QPA_PLATFORM": "offscreen"}
    found = run(site, code, **home).splitlines()
    assert found[-3:] == ["Pinch No hand yet", "False", "True"]


def test_a_check_a_sheet_and_a_scene_are_found(site: Path) -> None:
    code = """
import json
from glovetrack.app.__main__ import main
main(["doctor", "--json", "doctor.json", "--force"])
print([f["what"] for f in json.load(open("doctor.json"))["findings"] if f["check"] == "memory"])
assert main(["print", "labels", "-o", "labels.pdf", "--force"]) == 0
simulate = ["simulate", "--duration", "1", "--fps", "5", "--force", "-o"]
assert main([*simulate, "plain.mcap"]) == main([*simulate, "ball.mcap", "--scene", "ball"]) == 0
import glovetrack
import numpy as np
ball, plain = (next(glovetrack.open(name).images()).rgb for name in ("ball.mcap", "plain.mcap"))
print(int(np.sum(np.any(np.abs(ball.astype(int) - plain) > 12, axis=2))))
"""
    text = run(site, code)
    assert re.search(r"\['\d+ MB of memory are free\.'\]", text)
    assert (site.parent / "labels.pdf").read_bytes().startswith(b"%PDF")
    assert 500 < int(text.splitlines()[-1]) < 200_000, "pixels that the ball covers"


def test_a_listener_and_a_protocol_of_remote_control_are_found(site: Path) -> None:
    code = """
import socket
from concurrent.futures import Future
from types import SimpleNamespace
import numpy as np
from glovetrack.engine import load
from glovetrack.listeners import ListenedHand
from glovetrack.remote import Reply
from glovetrack.tracker.live.listeners import LISTENERS
from glovetrack.tracker.streaming.remote.registry import DOORS, open_door

notes, points = [], np.zeros((22, 3))
live = SimpleNamespace(record=notes.append)
listener = LISTENERS.get("raised").make(ListenedHand(*load("vist-small"), live))
for k, height in enumerate((0.9, 1.1, 0.97, 1.1, float("nan"), 0.9, 1.1)):
    points[:, 2] = height
    listener.feed(SimpleNamespace(t=float(k), keypoints=points.copy()), 0.0)
print([(note.t, note.text) for note in notes])

asked = []
def answer(request):
    asked.append((request.do, request.text))
    done = Future()
    done.set_result(Reply(request.do != "stop", request.do, "text"))
    return done
kind = DOORS.get("button")
door = open_door(kind, kind.options(port=0), answer)
with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
    client.settimeout(10.0)
    replies = []
    for sent in (b"1", b"a", b"0", b"xx"):
        client.sendto(sent, ("127.0.0.1", door.port))
        replies.append(client.recv(16))
door.close()
print(asked, replies)
"""
    notes, requests = run(site, code).splitlines()[-2:]
    assert notes == "[(1.0, 'hand raised'), (6.0, 'hand raised')]"
    asked = "[('start', ''), ('note', 'button a'), ('stop', '')]"
    assert requests == f"{asked} [b'+', b'+', b'-', b'-']"


def test_an_export_format_is_found_and_written(site: Path) -> None:
    """From Python and from the command line, next to the program's own formats."""
    code = """
import glovetrack, numpy as np
from glovetrack.app.__main__ import main
from glovetrack.formats import formats
rec = glovetrack.simulate("f.mcap", seed=1, duration=2.0, images=False, force=True)
tracked = rec.track(out="g.mcap", force=True)
tracked.export("ply", "f.ply", force=True)
print(tracked.keypoints["index_tip"].shape[1], tracked.sides, glovetrack.__version__)
head, _, body = open("f.ply").read().partition("end_header\\n")
table = np.loadtxt(body.splitlines())
tips = table[table[:, 4] == tracked.keypoints.names.index("index_tip")]
known = tracked.keypoints["index_tip"][tracked.valid["index_tip"]]
assert len(known) > 100 and np.allclose(tips[:, :3], known, atol=1e-6)
assert main(["export", "g.mcap", "--format", "ply", "-o", "h.ply", "--units", "mm", "--force"]) == 0
first = [np.loadtxt(open(p).read().partition("end_header\\n")[2].splitlines()) for p in
         ("f.ply", "h.ply")]
assert np.allclose(1000 * first[0][:, :3], first[1][:, :3], atol=1e-3)
print([kind.name for kind in formats()][-1], "c3d" in [kind.name for kind in formats()])
"""
    lines = run(site, code).splitlines()
    assert lines[-1] == "ply True"
    assert f"3 ('right',) {__version__}" in lines, "the public API works from the wheel"


def test_an_engine_tracks_is_recorded_and_resumed(site: Path) -> None:
    code = """
import numpy as np
import glovetrack
from dataclasses import replace
from glovetrack.engine import ENGINES, EngineState, Pipeline, SessionReader, Settings, load
from glovetrack.engine import Estimate, ImuSample, SessionRecorder, settings_text
from glovetrack.app.__main__ import main

assert "tilt" in ENGINES.names()
glovetrack.simulate("e.mcap", seed=1, duration=3.0, images=False, force=True)
tilt = ["track", "e.mcap", "--engine", "tilt", "--force", "-o"]
assert main([*tilt, "whole.mcap"]) == 0

# a recording that begins in the middle of tracking, with a setting of its own
settings = Settings(engine="tilt", engines={"tilt": {"gain": 2.0}})
with SessionReader("e.mcap") as reader:
    info = replace(reader.info, engine="tilt", settings_text=settings_text(settings))
    packets = list(reader.messages((ImuSample,)))
pipeline = Pipeline(info.hand, info.glove, None, settings)
recorder = SessionRecorder("late.mcap", info)
for k, packet in enumerate(packets):
    if k == 100:
        recorder.write(EngineState(packet.t_arrival, "tilt", pipeline.get_state()))
    estimate = pipeline.feed_imu(packet)
    if k >= 100:
        recorder.write(packet)
recorder.close()
assert main(["track", "late.mcap", "--force", "-o", "again.mcap"]) == 0
with SessionReader("again.mcap") as reader:
    again = list(reader.messages((Estimate,)))
    print(reader.info.engine, "gain = 2.0" in reader.info.settings_text)
print(len(again) == len(packets) - 100, np.array_equal(again[-1].keypoints, estimate.keypoints))
with SessionReader("whole.mcap") as reader:
    print(np.array_equal(list(reader.messages((Estimate,)))[-1].keypoints, estimate.keypoints))
"""
    assert run(site, code).splitlines()[-3:] == ["tilt True", "True True", "False"]


def test_only_the_public_name_is_imported() -> None:
    patterns = (EXAMPLES, "*.py"), (EXAMPLES, "*.ipynb"), (EXAMPLES.parent, "*.md")
    for path in (p for folder, pattern in patterns for p in folder.rglob(pattern)):
        text = path.read_text("utf-8")
        for internal in ("from tracker", "import tracker", "from app", "glovetrack.tracker"):
            assert internal not in text, f"{path.name} imports {internal.split()[-1]}"


@pytest.mark.parametrize(
    "folder", [p.parent.name for p in EXAMPLES.glob("glovetrack-*/pyproject.toml")]
)
def test_a_plugin_is_small(folder: str) -> None:
    (path,) = (EXAMPLES / folder).glob("*.py")
    lines = [line for line in path.read_text("utf-8").splitlines() if line.strip()]
    assert len(lines) <= LONGEST
