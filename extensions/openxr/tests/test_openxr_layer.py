"""The API layer from end to end: what the stream sends is what an OpenXR application reads.

The loader is the Khronos group's (Debian's and the one of pyopenxr), the application's binding is
pyopenxr, the validation layer is Debian's; the headless runtime is our own (`runtime`).
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from extensions.openxr.layout import Space
from extensions.openxr.publisher import OpenXrPublisher, WorldPlacement
from extensions.openxr.readers import read_link
from extensions.openxr.tests.scene import (
    HANDS,
    LOADERS,
    SOURCES,
    TIME,
    Libraries,
    Scene,
    compiled,
    world_in,
)
from tests.fixtures import RESOURCES
from tests.streaming.recorded_hand import RecordedHand, assert_near, assert_parallel
from tracker.geometry import so3
from tracker.hand.files import load_hand
from tracker.hand.openxr import JOINTS, OpenXrHand, to_openxr
from tracker.messages import Array, Estimate, Tracking, Validity
from tracker.streaming.publisher import Names

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="the test runtime is Linux's"),
    pytest.mark.long,
]

PLACED = WorldPlacement(Space.LOCAL, (0.1, -0.4, -0.3), 25.0, 0.05)
STEP = 10_000_000  # ns between estimates
WRIST, TIP = JOINTS.index("wrist"), JOINTS.index("index_tip")
LIMIT = 1e-4  # m and, in degrees, 0.1
INVALID, TIME_INVALID = "XrResult -1", "XrResult -30"


@pytest.fixture(scope="module")
def libraries(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Libraries:
    base = tmp_path_factory.getbasetemp()
    return compiled((base if worker_id == "master" else base.parent) / "openxr")


@pytest.fixture
def scene(tmp_path: Path, libraries: Libraries) -> Iterator[Scene]:
    made = Scene(tmp_path, libraries)
    yield made
    made.close()


@pytest.fixture
def program(scene: Scene) -> Iterator[Callable[..., Program]]:
    """Starts a program that sends one hand or both."""
    started: list[Program] = []

    def start(*sides: str, placement: WorldPlacement = PLACED) -> Program:
        started.append(Program(scene.memory, sides or ("right",), placement))
        return started[-1]

    yield start
    for program in started:
        program.close()


class Program:
    """The stream of a program whose hands move as formulas say: ``t`` is the monotonic clock's."""

    def __init__(self, memory: Path, sides: tuple[str, ...], placement: WorldPlacement) -> None:
        self.names = {side: names_of(side) for side in sides}
        first, *others = self.names.values()
        publisher = OpenXrPublisher(first, placement, str(memory))
        self.publisher = publisher
        self._senders = dict(
            zip(sides, [publisher, *map(publisher.for_other_hand, others)], strict=True)
        )
        self.t0 = time.monotonic_ns()
        self._last = dict.fromkeys(sides, 0)
        self.joints(self.t0, sides[0])  # compiles or loads kernels, which takes long once

    def send(self, t: int, side: str = "right", **changes: object) -> None:
        self._last[side] = t
        self._senders[side].send(self.estimate(t, side, **changes))

    def send_lately(self, side: str = "right", n: int = 6) -> int:
        """Estimates up to now, in order of time, and the instant of the last one, ns."""
        now = time.monotonic_ns()
        for t in range(now - (n - 1) * STEP, now + 1, STEP):
            if t == now or t > self._last[side] + STEP // 2:
                self.send(t, side)
        return now

    def estimate(
        self, t: int, side: str = "right", lost: bool = False, state: int = int(Validity.MEASURED)
    ) -> Estimate:
        """A hand that moves at a constant velocity, turns and bends its fingers."""
        names = self.names[side]
        hand, s = names.model, 1e-9 * (t - self.t0)
        low, high = hand.angle_limits.T
        angles = low + (high - low) * (0.5 + 0.4 * np.sin(2 * s + np.arange(len(low))))
        R, p = hand.forward(angles, so3.exp(TURN * s), START + SPEED * s)
        points, q = hand.keypoints(R, p), so3.quat_from_matrix(R)[list(hand.keypoint_segment)]
        states = np.full(len(points), int(Validity.LOST) if lost else state)
        if lost:
            points, q = np.full_like(points, np.nan), np.full_like(q, np.nan)
        tracking = Tracking.LOST if lost else Tracking.TRACKING
        known = np.full(len(angles), int(Validity.MEASURED))
        sd = np.full(len(points), 0.002)
        return Estimate(1e-9 * t, tracking, points, q, states, sd, angles, known, R, p)

    def joints(self, t: int, side: str = "right") -> OpenXrHand:
        """The truth in Glovetrack's own world."""
        names = self.names[side]
        return to_openxr(self.estimate(t, side), names.keypoints, np.array(names.radii))

    def close(self) -> None:
        self.publisher.close()


START, SPEED, TURN = np.array([0.3, 0.0, 0.2]), np.array([0.3, -0.2, 0.1]), np.array([0.3, 0.5, 1])


def names_of(side: str) -> Names:
    hand = load_hand(RESOURCES / "hands" / f"reference-{side}.toml")
    return Names(side, hand.keypoint_names, hand.joint_names, (), hand).with_openxr()


def in_space(
    hand: OpenXrHand, space: str, t: int, placement: WorldPlacement = PLACED
) -> tuple[Array, Rotation]:
    """Positions (26, 3) m and orientations of a hand in one of the runtime's spaces."""
    R, p = world_in(space, placement, 1e-9 * t)
    return R.apply(hand.position) + p, R * Rotation.from_quat(hand.orientation)


def assert_equal(found: dict, wanted: tuple[Array, Rotation], limit: float = LIMIT) -> None:
    assert found["active"]
    assert np.linalg.norm(found["position"] - wanted[0], axis=1).max() < limit
    turn = Rotation.from_quat(found["orientation"]) * wanted[1].inv()
    assert np.rad2deg(turn.magnitude()).max() < 1000 * limit


# --- poses


@pytest.mark.parametrize("loader", LOADERS)
def test_the_application_reads_the_joints_that_are_sent(scene: Scene, program, loader: str) -> None:
    sent, application = program("left", "right"), scene.application(loader)
    application.start(TIME, hands=("left", "right"))
    for side in ("left", "right"):
        for base in ("local", "stage", "view"):
            t = sent.send_lately(side)
            found, truth = application.locate(side, time=t, base=base), sent.joints(t, side)
            assert_equal(found, in_space(truth, base, t))
            assert (found["flags"] == truth.flags).all()
            assert_allclose(found["radius"], truth.radius, atol=1e-6)
    application.ask("close")


@pytest.mark.parametrize("base", ["local", "stage", "view"])
def test_velocities_are_those_of_the_joints_in_the_base_space(
    scene: Scene, program, base: str
) -> None:
    """Differences of the truth over the 20 ms that the stream's velocities are of; that of a base
    space which moves is the runtime's."""
    sent, application = program(), scene.application()
    application.start(TIME)
    t = sent.send_lately()
    found = application.locate(time=t, base=base)
    R, _ = world_in(base, PLACED, 1e-9 * t)
    before, after = sent.joints(t - 2 * STEP), sent.joints(t)
    linear = R.apply((after.position - before.position) / 0.02)
    turn = Rotation.from_quat(after.orientation) * Rotation.from_quat(before.orientation).inv()
    angular = R.apply(turn.as_rotvec() / 0.02)
    h = 1e-4
    (R0, p0), (R1, p1) = (world_in(base, PLACED, 1e-9 * t + s) for s in (-h, h))
    linear += (R1.apply(after.position) + p1 - R0.apply(after.position) - p0) / (2 * h)
    angular += (R1 * R0.inv()).as_rotvec() / (2 * h)
    assert (found["moving"] == 3).all()
    assert_allclose(found["linear"], linear, atol=2e-3)
    assert_allclose(found["angular"], angular, atol=2e-3)


def test_without_velocities_of_the_runtime_only_spaces_of_the_room_have_some(
    scene: Scene, program
) -> None:
    sent, application = program(), scene.application(runtime="silent")
    application.start(TIME)
    t = sent.send_lately()
    assert (application.locate(time=t, base="stage")["moving"] == 3).all()
    assert (application.locate(time=t, base="view")["moving"] == 0).all()
    assert application.locate(time=t, base="view", velocities=False)["active"]


def test_between_samples_the_pose_is_interpolated(scene: Scene, program) -> None:
    sent, application = program(), scene.application()
    application.start(TIME)
    t = sent.send_lately(n=12) - 10 * STEP - STEP // 3
    assert_equal(application.locate(time=t), in_space(sent.joints(t), "local", t))


def test_beyond_the_newest_sample_the_pose_is_predicted_and_bones_keep_their_length(
    scene: Scene, program
) -> None:
    sent, application = program(), scene.application()
    application.start(TIME)
    last = sent.send_lately()
    t = last + 30_000_000
    found, truth = application.locate(time=t), in_space(sent.joints(t), "local", t)
    unpredicted = in_space(sent.joints(last), "local", t)
    error = np.linalg.norm(found["position"] - truth[0], axis=1)
    assert error.max() < 0.1 * np.linalg.norm(unpredicted[0] - truth[0], axis=1).max()
    index = [p[TIP - 4 : TIP + 1] for p in (found["position"], truth[0])]
    bones = [np.linalg.norm(np.diff(p, axis=0), axis=1) for p in index]
    assert_allclose(*bones, atol=1e-5)
    assert (found["flags"][TIP] & 0b1100) == 0b1100, "still tracked"


def test_prediction_ends_at_its_horizon_and_is_not_called_tracked_then(
    scene: Scene, program
) -> None:
    sent, application = program(), scene.application()
    application.start(TIME)
    last = sent.send_lately()
    at_limit = application.locate(time=last + 50_000_000)
    beyond = application.locate(time=last + 150_000_000)
    assert_allclose(beyond["position"], at_limit["position"], atol=1e-6)
    assert beyond["active"] and (beyond["flags"] == 0b0011).all()


def test_an_instant_before_all_samples_has_the_oldest_pose(scene: Scene, program) -> None:
    sent, application = program(), scene.application()
    application.start(TIME)
    last = sent.send_lately()
    t = last - 10**9
    found, truth = application.locate(time=t), sent.joints(last - 5 * STEP)
    assert_equal(found, in_space(truth, "local", t))
    assert (found["flags"] == 0b0011).all()


def test_an_inferred_joint_is_valid_and_not_tracked(scene: Scene, program) -> None:
    sent, application = program(), scene.application()
    application.start(TIME)
    t = time.monotonic_ns()
    sent.send(t, state=int(Validity.INFERRED))
    assert (application.locate(time=t)["flags"] == 0b0011).all()


def test_a_stage_that_the_runtime_does_not_have_is_replaced_by_local(scene: Scene, program) -> None:
    placed = WorldPlacement(Space.STAGE, (0.0, 0.9, -0.2), 0.0, 0.05)
    sent, stages = program(placement=placed), scene.application()
    stages.start(TIME)
    t = sent.send_lately()
    assert_equal(stages.locate(time=t), in_space(sent.joints(t), "local", t, placed))
    stages.ask("close")
    local = WorldPlacement(Space.LOCAL, placed.position, 0.0, 0.05)
    without = scene.application(runtime="no-stage")
    without.start(TIME)
    t = sent.send_lately()
    assert_equal(without.locate(time=t), in_space(sent.joints(t), "local", t, local))


def test_without_a_conversion_of_time_the_newest_pose_is_given(scene: Scene, program) -> None:
    sent, application = program(), scene.application(runtime="no-time still")
    application.start()
    t = sent.send_lately()
    assert_equal(application.locate(time=7), in_space(sent.joints(t), "local", t))


def test_the_layer_adds_less_than_a_millisecond(scene: Scene, program) -> None:
    """The first call after a sample was written returns it, so nothing waits in between."""
    sent, application = program(), scene.application()
    application.start(TIME)
    sent.send_lately()
    took = []
    for _ in range(100):
        t = time.monotonic_ns()
        sent.send(t)
        found = application.locate(time=t)
        took.append(found["took"][0])
        assert_equal(found, in_space(sent.joints(t), "local", t))
    assert np.median(took) < 1e-3


def test_the_application_reads_a_recording(scene: Scene, program, recorded: RecordedHand) -> None:
    """Each instant of it, sent now as a replay does."""
    sent, application = program(), scene.application()
    application.start(TIME)
    for e in recorded.estimates:
        t = time.monotonic_ns()
        sent.publisher.send(replace(e, t=1e-9 * t))
        found = application.locate(time=t)
        R, p = world_in("local", PLACED, 1e-9 * t)
        for joint, (p_joint, R_joint) in recorded.openxr(e).items():
            row = JOINTS.index(joint)
            assert_near(found["position"][row], R.apply(p_joint) + p)
            assert_parallel(Rotation.from_quat(found["orientation"][row]), R * R_joint)


# --- with and without a program


def test_without_a_program_and_a_runtime_with_hands_the_hand_is_inactive(scene: Scene) -> None:
    application = scene.application()
    application.start(TIME)
    found = application.locate()
    assert not found["active"] and not found["flags"].any() and not found["moving"].any()
    application.ask("untrack", hand="right")


@pytest.mark.parametrize("loader", LOADERS)
def test_a_program_that_starts_and_ends_takes_over_and_gives_back(
    scene: Scene, program, wait_for, loader: str
) -> None:
    application = scene.application(loader, "hands")
    application.start(TIME, hands=("left", "right"))
    assert_of_runtime(application.locate())
    for _ in range(2):
        sent = program()

        def reads_ours(sent: Program = sent) -> bool:
            t = sent.send_lately()
            found = application.locate(time=t)
            return bool(np.allclose(found["position"], in_space(sent.joints(t), "local", t)[0]))

        wait_for(reads_ours)
        assert_of_runtime(application.locate("left"))
        sent.close()
        assert_of_runtime(application.locate())
    application.ask("close")


def assert_of_runtime(found: dict) -> None:
    assert found["active"] and (found["position"] == [1, 2, 3]).all()


def test_a_program_that_hangs_or_was_killed_is_not_running(scene: Scene, program, wait_for) -> None:
    application = scene.application()
    application.start(TIME)
    code = (
        "import sys, time; from pathlib import Path; "
        "from extensions.openxr.tests.test_openxr_layer import PLACED, Program; "
        "p = Program(Path(sys.argv[1]), ('right',), PLACED); print('runs', flush=True)\n"
        "while True: p.send(time.monotonic_ns()); time.sleep(0.01)"
    )
    with subprocess.Popen(
        [sys.executable, "-c", code, str(scene.memory)],
        cwd=Path(__file__).parents[3],
        stdout=subprocess.PIPE,
    ) as other:
        assert other.stdout is not None and other.stdout.readline()
        wait_for(lambda: application.locate()["active"])
        os.kill(other.pid, signal.SIGKILL)
    wait_for(lambda: not application.locate()["active"])
    assert scene.memory.exists(), "left behind"
    sent = program()
    sent.send_lately()
    assert application.locate()["active"], "in the same memory"


def test_a_lost_hand_is_inactive_even_where_the_runtime_has_hands(scene: Scene, program) -> None:
    sent, application = program(), scene.application(runtime="hands")
    application.start(TIME)
    sent.send_lately()
    assert application.locate()["active"]
    sent.send(time.monotonic_ns(), lost=True)
    found = application.locate()
    assert not found["active"] and not found["flags"].any() and not found["moving"].any()


def test_without_the_focus_of_input_the_hand_is_inactive(scene: Scene, program) -> None:
    sent, application = program(), scene.application(runtime="unfocused")
    application.start(TIME)
    sent.send_lately()
    assert not application.locate()["active"]


def test_an_application_without_hand_tracking_is_left_alone(scene: Scene, program) -> None:
    sent, application = program(), scene.application()
    application.ask("open", extensions=[TIME])
    application.ask("begin")
    with pytest.raises(RuntimeError):
        application.ask("track", hand="right")
    sent.send_lately()
    assert sent.publisher.clients == 0
    application.ask("close")


def test_a_user_can_start_an_application_without_the_layer(scene: Scene) -> None:
    application = scene.application(GLOVETRACK_OPENXR_DISABLE="1")
    assert "XR_APILAYER_GLOVETRACK_hands" not in application.ask("layers")
    assert HANDS not in application.ask("extensions")


# --- data sources and wrong calls


def test_the_extensions_are_offered_on_any_runtime(scene: Scene) -> None:
    found = scene.application().ask("extensions")
    assert found[HANDS] == 4 and found[SOURCES] == 1


@pytest.mark.parametrize("runtime", ["", "hands", "hands sources"])
def test_the_source_is_a_hand_without_obstruction(scene: Scene, program, runtime: str) -> None:
    sent, application = program(), scene.application(runtime=runtime)
    application.start(SOURCES, TIME, hands=())
    application.ask("track", hand="right", sources=["controller", "unobstructed"])
    sent.send_lately()
    found = application.locate(state=True)
    assert found["active"] and found["source"].tolist() == [1, 1]
    sent.send(time.monotonic_ns(), lost=True)
    found = application.locate(state=True)
    assert not found["active"] and found["source"][0] == 1, "a source whose hand is lost"
    sent.close()
    found = application.locate(state=True)
    wanted = {"": [0, 1], "hands": [1, 1], "hands sources": [1, 2]}[runtime]
    assert found["source"].tolist() == wanted and found["active"] == bool(runtime)


@pytest.mark.parametrize("runtime", ["", "hands", "hands sources"])
def test_a_tracker_for_controller_hands_does_not_get_the_gloves_hand(
    scene: Scene, program, runtime: str
) -> None:
    sent, application = program(), scene.application(runtime=runtime)
    application.start(SOURCES, TIME, hands=())
    application.ask("track", hand="right", sources=["controller"])
    sent.send_lately()
    found = application.locate(state=True)
    has_controllers = runtime == "hands sources"
    assert found["active"] == has_controllers and found["source"][0] == has_controllers


def test_wrong_calls_are_refused(scene: Scene, program) -> None:
    sent, application = program(), scene.application()
    application.start(SOURCES, TIME)
    sent.send_lately()
    with pytest.raises(RuntimeError, match=INVALID):
        application.locate(joints=25)
    with pytest.raises(RuntimeError, match=INVALID):
        application.locate(state=True)  # of a tracker that was not asked for a source
    with pytest.raises(RuntimeError, match=INVALID):
        application.ask("track", hand="left", sources=["controller", "controller"])
    with pytest.raises(RuntimeError, match=TIME_INVALID):
        application.locate(time=-7_000_000_123)
    application.ask("untrack", hand="right")


@pytest.mark.parametrize("above", [True, False])
def test_the_validation_layer_has_no_complaint(scene: Scene, program, above: bool) -> None:
    """Above ours it sees what the application gets, below ours what we ask of the runtime."""
    sent, application = program("left", "right"), scene.checked(above)
    application.start(TIME, hands=("left", "right"))
    for side in ("left", "right"):
        t = sent.send_lately(side)
        assert_equal(application.locate(side, time=t), in_space(sent.joints(t, side), "local", t))
    application.ask("close")
    assert "VUID" not in scene.complaints() and "rror" not in scene.complaints()


# --- who reads


def test_the_program_learns_which_application_reads_the_hand(
    scene: Scene, program, monkeypatch: pytest.MonkeyPatch
) -> None:
    sent, application = program(), scene.application()
    application.start(TIME)
    assert sent.publisher.clients == 0
    sent.send_lately()
    application.locate(repeat=3)
    sent.send(time.monotonic_ns(), lost=True)
    application.locate()
    assert sent.publisher.clients == 1
    link = read_link(str(scene.memory))
    assert link is not None
    (reader,) = link.readers
    assert (reader.name, reader.process) == ("Test application", application.process.pid)
    assert (reader.readings, reader.active) == (4, 3)
    assert abs(reader.last_ns - link.now_ns) < 5 * 10**9
