"""The demo: a simulated wearer, glove and camera, tracked by the real engine."""

from __future__ import annotations

import time

from app.demo_devices import PacedCamera, PacedGlove, SimulatedClock
from app.engine import EngineSetup, Recorder, RecordingRequest, Truth
from app.tasks import Progress
from tracker import library
from tracker.clock import ClockAnchor
from tracker.config import to_toml
from tracker.messages import Estimate, Message
from tracker.pipeline import Pipeline
from tracker.runner import LiveTracker
from tracker.session.description import SessionInfo
from tracker.session.writer import SessionRecorder
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.colours import ColourProfile, parse_profile
from tracker.vision.detector import Detector

DURATION = 900.0
"""s of motion; the hand then rests where it is."""
HAND, GLOVE = "reference-right", "vist-small"


def demo_setup(progress: Progress, seed: int, fps: float) -> EngineSetup:
    """Build everything and compile what is compiled; takes a few seconds the first time."""
    progress(0.1, "hand and glove")
    hand, glove = library.load(GLOVE, HAND)
    profile = parse_profile(library.text("colours", library.DEFAULT_COLOURS))
    progress(0.3, "a simulated wearer")
    motion = RandomPostures(hand, seed, duration=DURATION)
    simulation = Simulation(hand, glove, motion, seed, fps=fps)
    pipeline = Pipeline(hand, glove, simulation.rig)

    def make_detector(colours: ColourProfile) -> Detector:
        return Detector(colours, float(glove.marker_size.mean()), simulation.rig.fx)

    progress(0.5, "first picture")
    index, t, arrival = next(simulation.exposures())
    picture = simulation.renderer.frame(t, arrival, index)
    make_detector(profile).detect(picture.left)
    progress(0.9, "devices")
    clock = SimulatedClock()
    tracker = LiveTracker(
        pipeline,
        profile,
        make_detector,
        PacedGlove(simulation.imu_samples(), clock),
        PacedCamera(simulation, clock),
    )
    anchor = ClockAnchor(time.time_ns(), time.monotonic_ns())
    info = SessionInfo(
        hand=hand,
        glove=glove,
        hand_text=library.text("hands", HAND),
        glove_text=library.text("gloves", GLOVE),
        anchor=anchor,
        rig=simulation.rig,
        colours_text=library.text("colours", library.DEFAULT_COLOURS),
        settings_text=to_toml(pipeline.settings),
        engine=pipeline.settings.engine,
        simulated=True,
    )

    def truth(t: float) -> Truth:
        true = simulation.truth(min(max(clock.simulated(t), 0.0), DURATION - 0.1))
        return Truth(true.keypoints, true.R_GB, true.p_GB)

    def make_recorder(request: RecordingRequest) -> Recorder:
        from dataclasses import replace

        named = replace(info, participant=request.participant, notes=request.task)
        return TruthfulRecorder(SessionRecorder(request.path, named), simulation, clock)

    return EngineSetup(
        name="demo",
        engine=tracker,
        hand=hand,
        glove=glove,
        rig=simulation.rig,
        profile=profile,
        anchor=anchor,
        close=lambda: None,
        make_recorder=make_recorder,
        truth=truth,
        simulated=True,
    )


class TruthfulRecorder:
    """Writes beside each estimate what the hand truly did."""

    def __init__(
        self, inner: SessionRecorder, simulation: Simulation, clock: SimulatedClock
    ) -> None:
        self._inner, self._simulation, self._clock = inner, simulation, clock

    def write(self, message: Message, overloaded: bool = False) -> None:
        self._inner.write(message, overloaded)
        if isinstance(message, Estimate):
            self._inner.write_truth(self._truth(message))

    def _truth(self, estimate: Estimate) -> Estimate:
        """The estimate's shape with the true values."""
        from dataclasses import replace

        t = min(max(self._clock.simulated(estimate.t), 0.0), DURATION - 0.1)
        true = self._simulation.truth(t)
        return replace(
            estimate,
            keypoints=true.keypoints.copy(),
            angles=true.angles.copy(),
            segment_R=true.R_GB.copy(),
            segment_p=true.p_GB.copy(),
        )

    def close(self) -> None:
        self._inner.close()
