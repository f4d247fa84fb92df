"""Loads an engine and compiles missing kernels before devices are opened."""

from __future__ import annotations

import logging

from tracker import kernels
from tracker.engine.pipeline import Pipeline
from tracker.glove import library
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, ImuSample
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.detector import Detector, detect_frame
from tracker.vision.rig import ideal_rig

MOTION = 0.6  # s, in which the hand is found and corrected, which needs every kernel
SEED, FPS = 1, 30.0

_log = logging.getLogger(__name__)


def load_engine(glove: str, hand: str | None = None) -> None:
    """Load the modules and kernels that tracking with these files needs, which takes a second.

    Raises GlovetrackError.
    """
    Pipeline(*library.load(glove, hand), ideal_rig())


def warm_up(hand: HandModel, glove: GloveModel, detector: Detector) -> None:
    """Track simulated motion and search an image; returns at once if all kernels are compiled."""
    if kernels.are_compiled():
        return
    _log.warning(
        "The compiled kernels are missing or older than their source. They are compiled on first "
        "use, and tracking can stop for seconds. To compile them now: make kernels"
    )
    warm_up_view()
    motion = RandomPostures(hand, SEED, duration=MOTION)
    simulation = Simulation(hand, glove, motion, SEED, fps=FPS)
    pipeline = Pipeline(hand, glove, simulation.rig)
    for message in simulation.feed():
        if isinstance(message, ImuSample):
            pipeline.feed_imu(message)
        elif isinstance(message, BlobFrame):
            pipeline.feed_frame(message)
    pipeline.calibration()
    _search(simulation, pipeline, detector)


def warm_up_view() -> None:
    """Render a sphere, so that the kernels of the 3D view are compiled."""
    if not kernels.are_compiled():
        # deferred: the process that tracks has no window
        from app.widgets.view3d.orbit import Orbit
        from app.widgets.view3d.raster.scene import RasterScene
        from app.widgets.view3d.scene import BodyLook
        from app.widgets.view3d.shapes import ball

        scene = RasterScene()
        scene.add(ball(0.01), BodyLook("#FFFFFF"))
        scene.render(Orbit(), 2, 2)


def _search(simulation: Simulation, pipeline: Pipeline, detector: Detector) -> None:
    """A whole image, then the surroundings of the expected markers."""
    index, t, arrival = next(simulation.exposures())
    frame, names = simulation.renderer.frame(t, arrival, index), detector.profile.hue_names
    detect_frame(detector, frame)
    expected, rig = pipeline.ahead.markers(MOTION), simulation.rig
    if expected is not None:
        detect_frame(detector, frame, expected.hints(rig, expected.t, rig.pose, names))
