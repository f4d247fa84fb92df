"""Injects random faults of the glove, the camera and the computer, and checks the tracking.

The actual link, camera code, detector and pipeline run on simulated devices and a simulated clock.
One random fault at a time starts and ends; then the hand must be tracked again. Nothing may crash,
and no wrong position may be shown as measured without a report.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from tracker.base.notices import Notice, plain
from tracker.engine.pipeline import Pipeline
from tracker.glove import library
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.live.load import LoadWatch
from tracker.messages import (
    Array,
    Estimate,
    ImuSample,
    StereoFrame,
    Tracking,
    Validity,
)
from tracker.sensors.camera import CameraParams, StereoCamera
from tracker.sensors.glove_link import GloveLink
from tracker.sensors.image_watch import StallWatch
from tracker.sensors.link_params import LinkState
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.simulation.virtual_devices import (
    CAMERA_FAULTS,
    GLOVE_FAULTS,
    VirtualCamera,
    VirtualGlove,
)
from tracker.vision.colours import parse_profile
from tracker.vision.detector import Detector, detect_frame

HOST_FAULTS = ("starved glove", "starved camera", "starved")
"""Faults of the computer: threads wait up to `LONGEST_WAIT` for the processor. Packets then arrive
late and in bursts, and only the newest of several late images is used."""
FAULTS = (*GLOVE_FAULTS, *CAMERA_FAULTS, *HOST_FAULTS)
SHORTEST_WAIT, LONGEST_WAIT = 0.02, 0.3  # s
FPS = 30.0
MOTION_S = 120.0  # per wearer
WARM_UP = 3.0  # s before the first fault
MATCHED = 4  # matched markers for which an image counts as tracked
FRESH = 0.1  # s
POLL_EVERY = 0.05  # s


@dataclass(frozen=True)
class DrillParams:
    """Times in s, lengths in m."""

    fps: float = FPS
    shortest: float = 0.1  # of a fault
    longest: float = 1.2
    rest_shortest: float = 0.2  # between two faults, while tracking
    rest_longest: float = 0.6
    back: float = 0.030  # mean error of the four keypoints at which the hand is tracked again
    wrong: float = 0.050  # error of a keypoint shown as measured that counts as wrong,
    doubt: float = 3.0  # if it also exceeds this many of its standard deviations
    silent_for: float = 0.25  # longest time for which a wrong keypoint may be unreported
    noticed: float = 0.6  # shorter faults without a wrong keypoint need not be reported
    timeout: float = 5.0  # longest wait for tracking


@dataclass(eq=False)
class DrillReport:
    """Result of the drill. ``recovery`` (s) and counts are per kind of fault.

    ``unsaid`` counts longer faults without a notice or a counter; ``silent_wrong`` those in which
    wrong positions were shown and nothing was reported.
    """

    faults: Counter[str] = field(default_factory=Counter)
    recovery: dict[str, list[float]] = field(default_factory=dict)
    unsaid: Counter[str] = field(default_factory=Counter)
    silent_wrong: Counter[str] = field(default_factory=Counter)
    notices: Counter[str] = field(default_factory=Counter)  # by code
    simulated_s: float = 0.0

    def worst_recovery(self) -> float:
        """Longest time from a device's return to a tracked hand, s."""
        return max(max(times) for times in self.recovery.values())

    def to_json(self) -> dict[str, object]:
        return {
            "faults": dict(self.faults),
            "recovery_s": {
                kind: {
                    "median": float(np.median(t)),
                    "worst": max(t),
                    "over_1_s": sum(x > 1.0 for x in t),
                }
                for kind, t in sorted(self.recovery.items())
            },
            "unsaid": dict(self.unsaid),
            "silent_wrong": dict(self.silent_wrong),
            "simulated_s": self.simulated_s,
        }


class Bench:
    """Tracks one wearer on simulated devices; `run` advances the simulated time."""

    def __init__(self, seed: int, fps: float = FPS) -> None:
        hand, glove = library.load(library.DEFAULT_GLOVE, "")
        motion = RandomPostures(hand, seed, duration=MOTION_S + 10.0)
        self._sim = Simulation(hand, glove, motion, seed, fps=fps)
        self.now = self._matched = 0.0
        self._notices: list[Notice] = []
        self.glove = VirtualGlove(self._sim.imu_samples(), len(glove.imus), seed)
        self.camera = VirtualCamera(self._sim.scene, fps, seed)
        self.link = GloveLink(self.glove.open, len(glove.imus), clock=lambda: self.now)
        self.images = StereoCamera(
            self.camera, self._sim.rig, CameraParams(), lambda: self.now, lambda dt: None
        )
        self.pipeline = Pipeline(hand, glove, self._sim.rig)
        profile = parse_profile(library.text("colours", library.DEFAULT_COLOURS))
        self._detector = Detector(profile, float(glove.marker_size.mean()), self._sim.rig.fx)
        names = list(self.pipeline.keypoint_names)
        self._rows = np.array([names.index(k) for k in MARKED_KEYPOINTS])
        self._next_image = 1 / fps
        self._stalls = StallWatch()
        self._load = LoadWatch()
        self._rng = np.random.default_rng(seed)
        self._wake: dict[str, float] = {}  # s at which a starved thread runs next, by device
        self._held: StereoFrame | None = None  # the newest image missed by a starved thread
        self._missed = 0
        self.estimate: Estimate | None = None

    # ---- the computer

    def fail(self, kind: str) -> None:
        """Start one of `FAULTS`."""
        if kind in HOST_FAULTS:
            both = ("glove", "camera")
            self._wake = {d: self.now for d in both if kind in ("starved", f"starved {d}")}
        else:
            (self.glove if kind in GLOVE_FAULTS else self.camera).fail(kind)

    def heal(self) -> None:
        """End the current fault."""
        self._wake = {}
        self.glove.heal()
        self.camera.heal()

    def _runs(self, device: str) -> bool:
        """Whether the thread of a device may run now."""
        if self.now < self._wake.get(device, -np.inf):
            return False
        if device in self._wake:
            self._wake[device] = self.now + float(self._rng.uniform(SHORTEST_WAIT, LONGEST_WAIT))
        return True

    # ---- time

    def run(self, until: Callable[[], bool], longest: float) -> float:
        """Advance the time until ``until()`` is true, at most ``longest`` s; returns the
        duration."""
        start = self.now
        while self.now - start < longest:
            self._step()
            if until():
                break
        return self.now - start

    def _step(self) -> None:
        packet, image = self.glove.next_event(), self._next_image + CameraParams().delay
        if packet <= image:
            self.now = packet
            self.glove.advance(packet)
            if self._runs("glove"):
                self._poll()
            if self._held is not None and self._runs("camera"):
                self._look_at(self._held)
        else:
            self.now = image
            self._take_image()

    def _poll(self) -> None:
        for item in self.link.poll(0.0):
            if isinstance(item, ImuSample):
                self.estimate = self.pipeline.feed_imu(item)
                self._load.packet(self.now, self.now - item.t)
            else:
                self._notices.append(item.notice or plain(item.text))
        self._listen()

    def _take_image(self) -> None:
        self.camera.t = self._next_image
        self._next_image += 1 / self.camera.fps
        frame = self.images.read(0.0) if self.camera.gives else None
        watch, now = self._stalls, self.now
        found = watch.look(now) if frame is None else watch.received(now)
        self._notices += [found] if found is not None else []
        if frame is not None:
            self._missed += self._held is not None
            self._held = frame
            if self._runs("camera"):
                self._look_at(frame)
        self._listen()

    def _look_at(self, frame: StereoFrame) -> None:
        self._load.image(self.now, self.now - frame.t_arrival, self._missed)
        self._held, self._missed = None, 0
        self.pipeline.feed_frame(detect_frame(self._detector, frame))
        if self.link.state != LinkState.STREAMING:
            self.estimate = self.pipeline.predict(frame.t)

    def _listen(self) -> None:
        for result in self.pipeline.take_results():
            if int(np.sum(result.match_left >= 0)) >= MATCHED:
                self._matched = result.t
        self._notices += [e.notice or plain(e.text) for e in self.images.drain_events()]
        self._notices += self.pipeline.drain_notices() + self._load.notices.drain()

    # ---- truth

    def drain_notices(self) -> list[Notice]:
        """The notices of all parts since the last call, oldest first."""
        notices, self._notices = self._notices, []
        return notices

    def losses(self) -> int:
        """Sum of all counters of lost and discarded data."""
        c, p = self.link.decoder.counters, self.pipeline.rig_state
        counted = (c.cobs_errors, c.crc_errors, c.length_errors, c.unknown, c.oversize)
        images = self.images.repeated + self.images.missed + p.refused
        return sum(counted) + self.link.figures.lost + images

    def errors(self) -> Array:
        """Errors (4,) m of the keypoints; NaN where lost or not shown."""
        if self.estimate is None:
            return np.full(len(self._rows), np.nan)
        true = self._sim.truth(self.estimate.t).keypoints[self._rows]
        error: Array = np.linalg.norm(self.estimate.keypoints[self._rows] - true, axis=1)
        return error

    def is_wrong(self, p: DrillParams) -> bool:
        """Whether a keypoint shown as measured has a large error."""
        e = self.estimate
        if e is None:
            return False
        measured = e.keypoint_state[self._rows] == Validity.MEASURED
        sd = np.sqrt(3.0) * e.keypoint_sd[self._rows]  # along three axes together
        error = self.errors()
        return bool(np.any(measured & (error > p.wrong) & (error > p.doubt * sd)))

    def tracked(self, back: float) -> bool:
        """Whether the hand is tracked and both the glove and the camera are connected."""
        e = self.estimate
        if e is None or e.tracking != Tracking.TRACKING:
            return False
        if self.now - e.t > FRESH or self.now - self._matched > FRESH + 1 / self.camera.fps:
            return False
        return bool(np.nanmean(self.errors()) < back)


def drill(
    count: int,
    seed: int = 1,
    params: DrillParams | None = None,
    kinds: tuple[str, ...] = FAULTS,
    progress: Callable[[float], None] = lambda share: None,
) -> DrillReport:
    """Inject ``count`` random faults in sequence. Exceptions of all parts propagate."""
    params, report = params or DrillParams(), DrillReport()
    rng = np.random.default_rng(seed)
    bench = _new_bench(seed, params, report)
    for k in range(count):
        if bench.now > MOTION_S - 10.0:
            report.simulated_s += bench.now
            bench = _new_bench(seed + k + 1, params, report)
        if k % len(kinds) == 0:
            order = rng.permutation(len(kinds))  # all kinds equally often
        _one_fault(bench, kinds[order[k % len(kinds)]], rng, params, report)
        progress((k + 1) / count)
    report.simulated_s += bench.now
    return report


def _new_bench(seed: int, params: DrillParams, report: DrillReport) -> Bench:
    bench = Bench(seed, params.fps)
    bench.run(lambda: False, WARM_UP)
    report.notices.update(n.code for n in bench.drain_notices())
    return bench


def _one_fault(
    bench: Bench, kind: str, rng: np.random.Generator, p: DrillParams, report: DrillReport
) -> None:
    bench.run(lambda: False, float(rng.uniform(p.rest_shortest, p.rest_longest)))
    report.notices.update(n.code for n in bench.drain_notices())
    losses = bench.losses()
    watch = _UnreportedErrors(bench, p)
    lasting = float(rng.uniform(p.shortest, p.longest))
    bench.fail(kind)
    bench.run(watch.look, lasting)
    bench.heal()
    took = bench.run(lambda: watch.look() or bench.tracked(p.back), p.timeout)
    watch.look()
    report.faults[kind] += 1
    report.recovery.setdefault(kind, []).append(took)
    report.notices.update(n.code for n in watch.notices)
    if lasting > p.noticed and not watch.notices and bench.losses() == losses:
        report.unsaid[kind] += 1
    if watch.lied:
        report.silent_wrong[kind] += 1


class _UnreportedErrors:
    """Detects, during one fault, wrong positions shown as measured without a report."""

    def __init__(self, bench: Bench, params: DrillParams) -> None:
        self._bench, self._params = bench, params
        self._wrong_since, self._next_poll = float("inf"), bench.now
        self.notices: list[Notice] = []
        self.lied = False

    def look(self) -> bool:
        """Check now; returns False, so that it can be a condition that does not end a run."""
        bench, p = self._bench, self._params
        self.notices += bench.drain_notices()
        if bench.now < self._next_poll:  # computing the truth is slow
            return False
        self._next_poll = bench.now + POLL_EVERY
        e = bench.estimate
        shown = e is not None and e.tracking == Tracking.TRACKING
        wrong = shown and bench.is_wrong(p)
        self._wrong_since = min(self._wrong_since, bench.now) if wrong else float("inf")
        if bench.now - self._wrong_since > p.silent_for and not self.notices:
            self.lied = True
        return False
