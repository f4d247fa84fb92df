"""From the demo to an exported file through the window's own commands, on the real engine."""

import csv
import multiprocessing
import queue
import threading
import time
from unittest.mock import ANY

import numpy as np
import pytest

from app.engines import demo as demo_module
from app.engines.demo_camera import DemoChoice, demo_spec
from app.jobs.export import ExportRequest
from app.window.headless_report import wait_until
from app.words import notice_text
from extensions.conformance.take import BEAT, BEATS, SCRIPT
from extensions.conformance.window.view_model import CuePhase, StepCue
from tests.gui.gui_fakes import models, simulation
from tracker.base.notices import failure
from tracker.hand.names import FINGERS, MARKED_KEYPOINTS
from tracker.messages import Estimate, StereoFrame
from tracker.session.reader import SessionReader
from tracker.session.recover import needs_recovery
from tracker.simulation.gestures import tip_distances
from tracker.simulation.posture_requests import RequestedMotion
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.rig import default_pose

pytestmark = pytest.mark.processes
FPS = 15.0  # images are most of the work, and each is drawn, searched, shown and recorded
WRITTEN = 500  # messages: packets, their estimates, images and others


class Paused:
    """A dialog's clock, which passes only as a test sets it: the demo has as long for what is asked
    of it as the computer needs."""

    def __init__(self) -> None:
        self.t = time.monotonic()

    def __call__(self) -> float:
        return self.t


@pytest.fixture
def demo(window, qtbot):
    """The window with the demo running and the hand found."""
    window.sources.open_demo(DemoChoice(fps=FPS, scene="plain"))
    qtbot.waitUntil(lambda: window.host.running, timeout=100_000)
    qtbot.waitUntil(lambda: _tracked(window))
    return window


def _tracked(window) -> bool:
    view = window.host.snapshot()
    return view is not None and view.estimate is not None and view.estimate.tracking == 1


def test_a_hand_found_once_ends_the_wait(qapp):
    """A hand that is found and lost again at once has been found: the demo did not record one."""
    answers = iter([False, True])
    assert wait_until(lambda: next(answers, False), 10.0)
    assert not wait_until(lambda: False, 0.05)


def _recorded(window, qtbot, tmp_path):
    """A session of `WRITTEN` messages, recorded by the command."""
    window.recording.set_folder(tmp_path)
    window.commands.actions["record"].trigger()
    path = window.host.recording.request.path
    qtbot.waitUntil(lambda: _tracked(window) and window.host.recording.written > WRITTEN)
    window.commands.actions["record"].trigger()
    return path


@pytest.mark.long
@pytest.mark.timeout(600)  # on a stalled computer
def test_a_killed_recorder_and_camera_are_reported_and_what_is_recorded_is_replayed_and_exported(
    demo, qtbot, tmp_path
):
    path = _recorded(demo, qtbot, tmp_path)
    _is_listed_and_exported(demo, qtbot, path, tmp_path / "out.csv")
    incomplete = _kills_its_recorder(demo, qtbot, tmp_path)
    next_one = _recorded(demo, qtbot, tmp_path)
    assert len({path, incomplete, next_one}) == 3
    qtbot.waitUntil(lambda: not needs_recovery(next_one))  # a slow disk continues
    with SessionReader(next_one) as reader:
        assert reader.source.contents.finished
        assert {StereoFrame, Estimate} <= {type(m) for m in reader.messages()}
    _kills_its_camera(demo, qtbot)
    _is_replayed(demo, qtbot, path)


def _kills_its_recorder(demo, qtbot, tmp_path):
    """The recording, which is incomplete."""
    demo.recording.set_folder(tmp_path)
    demo.commands.actions["record"].trigger()
    first = demo.host.recording.request.path
    qtbot.waitUntil(lambda: demo.host.recording.written > 50)
    [recorder] = [p for p in multiprocessing.active_children() if "recorder" in p.name]
    recorder.kill()
    qtbot.waitUntil(lambda: demo.log.model.entries("error", "was ended by signal 9") != [])
    qtbot.waitUntil(lambda: demo.host.recording.request is None)
    assert needs_recovery(first)
    return first


def _kills_its_camera(demo, qtbot):
    [camera] = [p for p in multiprocessing.active_children() if "camera" in p.name]
    camera.kill()
    qtbot.waitUntil(lambda: demo.log.model.entries("device", "camera has ended") != [])
    before = demo.host.snapshot().estimate.t
    qtbot.waitUntil(lambda: demo.host.snapshot().estimate.t > before + 0.5)
    assert demo.host.running


def _is_listed_and_exported(demo, qtbot, path, table):
    def is_whole() -> bool:
        row = demo.library.selected()
        return row is not None and (row.path, row.integrity) == (path, "complete")

    qtbot.waitUntil(is_whole)
    demo.library.exporting.add(ExportRequest(path, "csv", table))
    qtbot.waitUntil(lambda: not demo.tasks.tasks)
    with table.open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) > 50
    assert {f"{k}_x" for k in MARKED_KEYPOINTS} <= set(rows[0])


def _is_replayed(demo, qtbot, path):
    demo.library.replay.emit(path)
    qtbot.waitUntil(lambda: demo.host.setup is not None and demo.host.setup.player is not None)
    qtbot.waitUntil(lambda: _tracked(demo))
    player = demo.host.setup.player
    assert 0.5 < player.duration < 30.0
    player.play(False)
    player.seek(0.5 * player.duration)
    # a paused replay advances to the next image, which a loaded machine may record late
    half = 0.5 * player.duration
    qtbot.waitUntil(lambda: half - 0.01 <= player.position <= player.duration)
    assert not demo.commands.actions["record"].isEnabled()


@pytest.mark.long
@pytest.mark.timeout(600)  # on a stalled computer
def test_the_wearer_follows_a_script_and_the_guidance_and_closing_leaves_a_complete_file(
    demo, qtbot, tmp_path, monkeypatch
):
    demo.recording.set_folder(tmp_path)
    _check_truth(demo.host.setup.truth.at(time.monotonic() + 1.0))
    _follows_a_script(demo, qtbot, monkeypatch)
    _asks_for_its_sheet_before_it_records(demo, qtbot, tmp_path)
    demo.commands.actions["record"].trigger()
    path = demo.host.recording.request.path
    end = _follows_the_guidance(demo, qtbot, monkeypatch)
    demo.close()
    with SessionReader(path) as reader:
        assert reader.source.contents.finished
        assert any(t.startswith("/truth/") for t in reader.topic_names)
        assert {StereoFrame, Estimate} <= {type(m) for m in reader.messages()}
        held = [true for true in reader.truth() if -0.4 < true.t - end < 0.0]
    assert len(held) > 5 and max(map(reach, held)) < FIST


def _follows_a_script(demo, qtbot, monkeypatch):
    clock = Paused()
    monkeypatch.setattr("extensions.conformance.window.dialog.monotonic", clock)
    demo.run_command("conformance")
    dialog = demo.set_up.dialogs["conformance"]
    dialog.start()
    shown = lambda: reach(demo.host.setup.truth.at(time.monotonic()))  # noqa: E731
    for label, is_shown in (
        ("open_hand_open", lambda: shown() > OPEN),
        ("fist", lambda: shown() < FIST),
    ):
        clock.t += BEATS * BEAT + 0.1
        number = dialog.run.steps.index(label)
        qtbot.waitUntil(lambda n=number: dialog.run.cue == StepCue(CuePhase.HOLDING, n, 0, ANY))
        assert dialog.run.label == label
        qtbot.waitUntil(is_shown)
        clock.t += SCRIPT[label] - 0.1  # the next step begins
    dialog.reject()
    qtbot.waitUntil(lambda: shown() > FIST)  # continues the earlier motion
    qtbot.waitUntil(lambda: demo.host.recording.request is None)


def _follows_the_guidance(demo, qtbot, monkeypatch):
    """The time of an estimate after 1.5 s of the pose, which the hand still holds then."""
    monkeypatch.setattr("app.wizards.guided.dialog.monotonic", Paused())  # the pose does not end
    demo.run_command("guided")
    dialog = demo.set_up.dialogs["guided"]
    dialog.run.poses = ("fist",)
    dialog.start()
    qtbot.waitUntil(lambda: reach(demo.host.setup.truth.at(time.monotonic())) < FIST)

    def tracked() -> Estimate:
        return demo.host.snapshot().estimate

    qtbot.waitUntil(lambda: reach(tracked()) < 0.5 * (FIST + OPEN))  # the devices show it too
    end = tracked().t + 1.5
    qtbot.waitUntil(lambda: tracked().t > end)
    return end


def _asks_for_its_sheet_before_it_records(demo, qtbot, tmp_path):
    before = list(tmp_path.glob("*.mcap"))
    demo.run_command("touch_test")
    dialog = demo.set_up.dialogs["touch_test"]
    tracked = demo.host.setup.tracked
    qtbot.waitUntil(lambda: tracked.latest_frame() is not None)
    dialog.start()
    assert dialog.how.text() == notice_text(failure("touch.no_sheet"))
    assert demo.host.recording.request is None and list(tmp_path.glob("*.mcap")) == before
    dialog.reject()


OPEN = 0.16  # m, of `reach`
FIST = 0.08  # m, of `reach`; 0.18 of a flat hand


def reach(hand) -> float:
    """m from the wrist to the middle fingertip."""
    model, glove, _ = models()
    rows = [glove.keypoint_names(model).index(name) for name in ("wrist", "middle_tip")]
    return float(np.linalg.norm(np.subtract(*hand.keypoints[rows])))


def test_a_gesture_does_not_wait_for_pinches_that_are_solved_in_advance(monkeypatch):
    solve, may_solve, shown = demo_module.gesture_angles, threading.Event(), queue.Queue()

    def slow(hand, name, wearer, alone):
        if name.startswith("pinch"):
            assert may_solve.wait(60.0)
        return solve(hand, name, wearer, alone)

    monkeypatch.setattr(demo_module, "gesture_angles", slow)

    def send(asked, gesture):
        shown.put((gesture, asked.angles))

    wearer = demo_module.GuidedWearer(simulation, send, time.monotonic())
    for gesture in ("open", "fist", "pinch_ring"):
        wearer.show_gesture(gesture)
    assert [shown.get(timeout=60.0)[0] for _ in range(2)] == ["open", "fist"]
    assert shown.empty()
    may_solve.set()
    gesture, angles = shown.get(timeout=60.0)
    hand, person = simulation().hand, simulation().wearer
    reach = tip_distances(hand, np.array(angles), person)
    assert gesture == "pinch_ring" and min(reach, key=reach.get) == "ring"
    wearer.close()


def test_a_wearer_bends_one_finger_alone():
    assert demo_spec(1, DemoChoice(independent_fingers=True)).alone and not demo_spec(1).alone
    shown = queue.Queue()
    hand, glove, _ = models()
    motion = RequestedMotion(RandomPostures(hand, 4, duration=6.0), 4)
    scene = Simulation(hand, glove, motion, 4, fps=30.0)
    wearer = demo_module.GuidedWearer(
        lambda: scene, lambda asked, gesture: shown.put(asked), time.monotonic(), alone=True
    )
    person = scene.wearer
    bent = [hand.angle_index[f"{f}_{j}_flexion"] for f in FINGERS for j in ("mcp", "pip")]
    for k, finger in ((2, "ring"), (3, "little")):
        wearer.show_gesture(f"pinch_{finger}")
        asked = shown.get(timeout=60.0)
        angles = np.array(asked.angles)
        others = np.delete(angles[bent], [2 * k, 2 * k + 1])
        assert np.abs(others).max() < 1e-6 and np.abs(angles[bent][2 * k : 2 * k + 2]).min() > 0.3
        reach = tip_distances(hand, angles, person)
        assert reach[finger] < 0.02 and min(d for f, d in reach.items() if f != finger) > 0.05
        # the hand turns its outer side, -y of a right one, to the camera: no palm in between
        R, wrist = np.reshape(asked.place[:9], (3, 3)), np.array(asked.place[9:])
        to_camera = default_pose().p_GC - wrist
        assert hand.side == "right" and -R[:, 1] @ to_camera > 0.5 * np.linalg.norm(to_camera)
    wearer.close()


def test_one_hand_is_over_a_desk_on_a_fast_computer():
    """A desk takes twice as long to draw as a wall: a core and a half at sixty."""
    for fps, cores, desk in ((30.0, 4, True), (30.0, 2, False), (60.0, 8, False)):
        assert DemoChoice(fps=fps).has_desk(cores) == desk
    asked = (
        DemoChoice(scene="desk"),
        DemoChoice(scene="plain"),
        DemoChoice(scene="desk", hands="both"),
    )
    assert [demo_spec(1, choice).light for choice in asked] == ["led", "", ""]


def _check_truth(true):
    """A simulated hand of the demo has the model's keypoints, and bones of about its lengths."""
    hand, glove, _ = models()
    assert true.keypoints.shape == (len(glove.keypoint_names(hand)), 3)
    lengths = np.linalg.norm(np.diff(true.keypoints[5:9], axis=0), axis=1)
    nominal = [hand.segments[hand.index[f"index_{p}"]].length for p in ("proximal", "intermediate")]
    assert lengths[:2] == pytest.approx(nominal, rel=0.2)
