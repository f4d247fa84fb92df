"""An engine whose messages are the simulator's ground truth, so the window's output is known."""

from __future__ import annotations

import threading
import time
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np

from app.engines.engine import CameraPart, EngineSetup, LivePart
from app.engines.protocols import ReferenceHand
from app.engines.recording import PausableRecorder
from resources import folder
from tracker.glove.files import parse_glove
from tracker.hand.files import parse_hand
from tracker.live.history import SearchedImage
from tracker.live.work_priority import WorkPriority
from tracker.messages import (
    Calibration,
    Estimate,
    Event,
    FrameResult,
    Status,
    Tracking,
    Validity,
)
from tracker.sensors.glove_report import GloveReport
from tracker.sensors.serial_line import UsbPort
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.colours import parse_profile


@lru_cache
def models():
    hand = parse_hand((folder("hands") / "reference-right.toml").read_text("utf-8"))
    glove = parse_glove((folder("gloves") / "vist-small.toml").read_text("utf-8"), hand)
    text = (folder("colours") / "fabric-default.toml").read_text("utf-8")
    return hand, glove, parse_profile(text)


SIMULATING = threading.RLock()
"""A simulation's renderer reuses its buffers; engines of several threads share this one."""


@lru_cache
def simulation() -> Simulation:
    hand, glove, _ = models()
    return Simulation(hand, glove, RandomPostures(hand, 4, duration=6.0), 4, fps=30.0)


@lru_cache(maxsize=256)
def truth_at(t: float):
    """The simulated hand; the window requests one time repeatedly."""
    with SIMULATING:
        return simulation().truth(t)


@lru_cache
def frame_and_blobs(i: int):
    """The i-th image pair and its blobs."""
    with SIMULATING:
        sim = simulation()
        index, t, arrival = list(sim.exposures())[i]
        return sim.renderer.frame(t, arrival, index), sim.scene.blobs(t, arrival, index)


@lru_cache(maxsize=64)
def estimate_at(frame: int, tracking: Tracking, lost: tuple[int, ...]) -> Estimate:
    """The true hand at an image: the window asks for it a hundred times a second."""
    hand, glove, _ = models()
    image, _ = frame_and_blobs(frame)
    truth = truth_at(image.t)
    k = len(glove.keypoint_names(hand))
    state = np.full(k, Validity.MEASURED, np.int64)
    state[list(lost)] = Validity.LOST
    angle_state = np.full(len(hand.joint_names), Validity.MEASURED, np.int64)
    for name, column in hand.angle_index.items():
        if name.startswith(("ring", "little")):
            angle_state[column] = Validity.INFERRED
    return Estimate(
        image.t,
        tracking,
        truth.keypoints.copy(),
        np.tile([0.0, 0, 0, 1], (k, 1)),
        state,
        np.full(k, 0.004),
        truth.angles.copy(),
        angle_state,
        truth.R_GB.copy(),
        truth.p_GB.copy(),
    )


class ScriptedEngine:
    """A `LiveEngine` and its hand, without threads, at one time, ``frame``.

    ``commands`` are those sent to the hand, by name.
    """

    _result_of: tuple = (None, None)  # what the last result was made of, and it

    def __init__(self, frame: int = 30, tracking: Tracking = Tracking.TRACKING) -> None:
        self.frame = frame
        self.tracking = tracking
        self.profiles: list = []
        self.followed = None
        self.engines: list[str] = []
        self.kept_states = 0
        self.values: dict[str, float] = {}  # of the status, in addition to the constant ones
        self.recorder = None
        self.started = self.stopped = 0
        self.lost: tuple[int, ...] = ()
        self._looked_at: list[Estimate] = []
        self.work_priority = WorkPriority()
        self.commands: list[str] = []
        self.events = [Event(0.0, "device", "Glove found.")]

    def start(self) -> None:
        self.started += 1

    def stop(self, timeout: float | None = None) -> None:
        self.stopped += 1
        self.set_recorder(None)

    def latest_estimate(self) -> Estimate:
        """Another one each time, as an engine's are."""
        return replace(estimate_at(self.frame, self.tracking, tuple(self.lost)))

    def latest_frame(self, t: float | None = None):
        frame, blobs = frame_and_blobs(self.frame)
        return frame, blobs, self.result(blobs)

    def result(self, blobs) -> FrameResult:
        """Predictions at the true markers; the first blobs of each side matched to the nearest."""
        if type(self).latest_estimate is not ScriptedEngine.latest_estimate:
            return self._matched(self.latest_estimate(), blobs)
        key = (self.frame, self.tracking, tuple(self.lost), id(blobs))
        if key != self._result_of[0]:
            self._result_of = key, self._matched(self.latest_estimate(), blobs), blobs
        return replace(self._result_of[1])

    def _matched(self, estimate: Estimate, blobs) -> FrameResult:
        hand, glove, _ = models()
        rig = simulation().rig
        seg = glove.marker_segment(hand)
        R, p = estimate.segment_R[seg], estimate.segment_p[seg]
        p_G = p + np.einsum("mij,mj->mi", R, glove.marker_position)
        p_C = (p_G - rig.pose.p_GC) @ rig.pose.R_GC
        left, right = rig.project(p_C), rig.project(p_C, right=True)
        m = len(glove.markers)
        match = np.full(m, -1, np.int64)
        for i, uv in enumerate(blobs.left.uv):
            match[np.argmin(np.linalg.norm(left - uv, axis=1))] = i
        visible = np.where(match >= 0, 0.9, 0.1)
        cov = np.tile(np.diag([16.0, 4.0]), (m, 1, 1))
        none = np.full(m, -1, np.int64)
        residual = np.full((m, 4), np.nan)
        return FrameResult(
            blobs.t, self.tracking, left, right, cov, visible, match, none, residual, 5
        )

    def recent_imu(self):
        return [s for s in _imu() if s.t <= frame_and_blobs(self.frame)[0].t]

    def recent_estimates(self):
        """Events of the images shown so far, in order of time."""
        now = frame_and_blobs(self.frame)[0].t
        if not self._looked_at or self._looked_at[-1].t != now:
            earlier = [e for e in self._looked_at if e.t < now]
            self._looked_at = [*earlier, self.latest_estimate()]
        return list(self._looked_at)

    def recent_images(self):
        frame, blobs, result = self.latest_frame()
        return [SearchedImage(frame.t, len(blobs.left), len(blobs.right), result)]

    def calibration(self) -> Calibration:
        names = models()[1].imu_names
        n = len(names)
        nothing = np.full((n, 3), np.nan)
        return Calibration(
            t=1.0,
            segments=names,
            scale=np.full((n, 3), 1.03),
            scale_sd=np.full((n, 3), 0.01),
            mounting=np.full((n, 3), 0.05),
            mounting_sd=np.full((n, 3), np.deg2rad(4.0)),
            gyro_bias=np.full((n, 3), 0.01),
            gyro_bias_sd=np.full((n, 3), np.deg2rad(0.2)),
            accel_bias=nothing,
            accel_bias_sd=nothing.copy(),
            hand_length=0.1874,
            hand_length_sd=0.0015,
        )

    def status(self) -> Status:
        values = {
            "imu_rate_hz": 100.0,
            "frame_rate_hz": 30.0,
            "estimate_rate_hz": 100.0,
            "latency_total_ms": 48.0,
            "imu_lost": 0.0,
            "frames_dropped": 0.0,
        }
        return Status(1.0, self.tracking, values | self.values)

    failure = None

    def drain_events(self) -> list[Event]:
        events, self.events = self.events, []
        return events

    @property
    def profile(self):
        """A test may replace the set colours by ``followed`` ones."""
        set_last = self.profiles[-1] if self.profiles else models()[2]
        return set_last if self.followed is None else self.followed

    def set_profile(self, profile) -> None:
        self.profiles.append(profile)
        self.followed = None

    def set_engine(self, name) -> None:
        self.engines.append(name)

    def set_recorder(self, recorder) -> None:
        if self.recorder is not None:
            self.recorder.close()
        self.recorder = recorder

    def keep_state(self) -> None:
        self.kept_states += 1

    def note(self, text: str, t: float | None = None, data=None) -> None:
        event = Event(1.0 if t is None else t, "note", text, dict(data or {}))
        self.events.append(event)
        if self.recorder is not None:
            self.recorder.write(event)

    # --- the hand's commands

    def command(self, work, answer=None) -> None:
        self.commands.append("command")

    def place(self, pose: object) -> None: ...

    def reset_pose(self) -> None:
        self.commands.append("reset_pose")

    def hold(self, pose: str) -> None:
        self.commands.append(f"hold {pose}")

    def let_go(self, pose: str, held: bool) -> None:
        self.commands.append(f"let_go {pose}")

    def follow(self, follower) -> None:
        self.commands.append("follow")

    def unfollow(self) -> None:
        self.commands.append("unfollow")

    def record(self, message) -> None:
        self.commands.append("record")

    def set_figures(self, figures) -> None:
        self.figures = figures

    def set_reference(self, name: str | None) -> None:
        self.commands.append(f"set_reference {name}")

    def reference_estimate(self) -> Estimate | None:
        return None


GLOVE_REPORT = GloveReport(
    port="/dev/ttyUSB0",
    adapter=UsbPort("/dev/ttyUSB0", 0x0403, 0x6001, "A10K"),
    state="streaming",
    baud=250_000,
    rates_hz=(50, 100, 200),
    requested_rate_hz=100,
    rate_hz=100.02,
    glove_id=1234,
    firmware=(1, 2, 0),
    protocol=1,
    motors=2,
    accel_range_g=16.0,
    gyro_range_dps=2000.0,
    imu_ok=(True,) * 6 + (False,),
    battery_mV=3712,
    temperature_cC=2950,
    latency_ms=16,
    skew_ppm=-12.5,
)


class ScriptedGlove:
    """An open glove; it applies another rate if it ``obeys``; ``vibrated`` are motor commands."""

    def __init__(self) -> None:
        self.now, self.obeys = GLOVE_REPORT, True
        self.vibrated: list[tuple[int, int, int]] = []

    def report(self) -> GloveReport:
        return self.now

    def request_rate(self, rate_hz: int) -> None:
        measured = float(rate_hz) if self.obeys else self.now.rate_hz
        self.now = self.now._replace(requested_rate_hz=rate_hz, rate_hz=measured)

    def vibrate(self, channel: int, amplitude: int, duration_ms: int) -> bool:
        self.vibrated.append((channel, amplitude, duration_ms))
        return True


def with_glove(setup: EngineSetup, device=None, **changes) -> EngineSetup:
    """The same with this open glove, or with other fields of its `GlovePart`."""
    connection = replace(setup.connection, device=device, **changes)
    return replace(setup, connection=connection)


def with_camera(setup: EngineSetup, **changes) -> EngineSetup:
    """The same with another camera: fields of `CameraPart`."""
    return replace(setup, camera=replace(setup.camera, **changes))


def with_live(setup: EngineSetup, **changes) -> EngineSetup:
    """The same with other fields of its `LivePart`."""
    return replace(setup, live=replace(setup.live, **changes))


@lru_cache
def _imu():
    with SIMULATING:
        return tuple(simulation().imu_samples())


class MemoryRecorder:
    """Stores what it receives."""

    def __init__(self, path: Path) -> None:
        self.path, self.messages, self.closed = path, [], False
        path.write_bytes(b"")

    def write(self, message, overloaded: bool = False, side: str = "") -> bool:
        assert not self.closed
        self.messages.append(message)
        return True

    def flush(self) -> None:
        assert not self.closed

    def close(self) -> None:
        self.closed = True


class ScriptedTruth:
    """The simulated hand."""

    is_measured = False

    def at(self, t: float) -> ReferenceHand:
        true = truth_at(t)
        return ReferenceHand(true.keypoints, true.R_GB, true.p_GB)


def scripted_setup(engine: ScriptedEngine, recorders: list | None = None) -> EngineSetup:
    hand, glove, profile = models()
    made = recorders if recorders is not None else []

    def make_recorder(request):
        made.append(MemoryRecorder(request.path))
        return PausableRecorder(made[-1])

    return EngineSetup(
        name="scripted",
        engine=engine,
        tracked=engine,
        hand=hand,
        glove=glove,
        camera=CameraPart(simulation().rig),
        profile=profile,
        close=lambda: None,
        live=LivePart(engine, engine, make_recorder),
        truth=ScriptedTruth(),
        simulated=True,
    )


class SlowJob:
    """A job that reports until it is cancelled."""

    def __init__(self) -> None:
        self.started, self.steps = threading.Event(), 0

    def __call__(self, progress) -> None:
        while True:
            progress(0.5, "working")
            self.steps += 1
            self.started.set()
            time.sleep(0.005)
