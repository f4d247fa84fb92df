"""A depth camera's sensors through a plug-in, live: images of two sizes, one monochrome."""

from __future__ import annotations

import importlib
import sys
import threading
from collections.abc import Iterator, Sequence
from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.fixtures import RESOURCES
from tests.live.test_runner import Camera, Glove, Stream, Tape, run_to_the_end
from tracker.engine.hands import Hands
from tracker.engine.pipeline import Pipeline
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.live.runner import LiveTracker
from tracker.messages import BlobFrame, Estimate, Event, StereoFrame, Tracking, Validity
from tracker.sensors.camera import CameraParams, StereoCamera
from tracker.sensors.camera_plugins import open_plugin
from tracker.sensors.image_input import CaptureFormat, Image, Pair
from tracker.sensors.stereo_calibration import Intrinsics, rectified_rig
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.simulation.virtual_devices import VirtualCamera
from tracker.vision.colours import load_profile
from tracker.vision.detector import Detector
from tracker.vision.rig import StereoRig

COLOUR = Intrinsics(
    1280, 720, np.array([[640.0, 0, 639.5], [0, 640.0, 359.5], [0, 0, 1]]), np.zeros(5)
)
OTHER = Intrinsics(
    640, 480, np.array([[380.0, 0, 319.5], [0, 380.0, 239.5], [0, 0, 1]]),
    np.array([0.02, -0.03, 0.0, 0.0, 0.0]),
)  # fmt: skip
RIG = rectified_rig(
    COLOUR, OTHER, so3.exp(np.array([0.004, 0.01, -0.003])), np.array([-0.05, 0, 0])
)
PLUGIN = """
class Driver:
    made = None
    def cameras(self):
        return [("1", "Depth camera")]
    def open(self, camera, want):
        return type(self).made
"""
MISFITS = {
    "camera.one_for_two",
    "camera.two_for_one",
    "camera.size_misfit",
    "camera.side_size_misfit",
}
"""Codes of notices about images that the calibration is not for."""


class Sensors:
    """The data of the vendor's package: both sensors' images of an exposure."""

    name, live, fps = "depth camera", True, 30.0

    def __init__(self, scene: VirtualCamera, infrared: bool) -> None:
        self.scene, self._infrared = scene, infrared

    def open(self) -> None:
        self.scene.open()

    def read(self) -> Pair | None:
        pair = self.scene.read()
        if pair is None or pair[1] is None or not self._infrared:
            return pair
        grey: Image = np.asarray(cv2.cvtColor(pair[1], cv2.COLOR_BGR2GRAY), np.uint8)
        return pair[0], grey

    def close(self) -> None:
        self.scene.close()


class Exposures(Stream):
    """The packets, and the exposure times; the plug-in's camera draws the images."""

    def __init__(self, sim: Simulation) -> None:
        self._lock, self._messages = threading.Condition(), sim.feed()
        self._next = next(self._messages, None)


class PluggedIn(Camera):
    """The plug-in's camera, read as by the live tracker, at the simulation's times."""

    def __init__(self, stream: Stream, scene: VirtualCamera, rig: StereoRig) -> None:
        super().__init__(stream)
        self._scene, self._now = scene, 0.0
        self.drained: list[Event] = []
        source = open_plugin("depth://1", CaptureFormat(1280, 720, 30.0))
        self._camera = StereoCamera(
            source, rig, CameraParams(delay=0.0), lambda: self._now, sleep=lambda _dt: None
        )

    def drain_events(self) -> Sequence[Event]:
        self.drained += (events := self._camera.drain_events())
        return events

    def read(self, timeout: float) -> StereoFrame | None:
        exposed = self._stream.take(BlobFrame, timeout)
        if exposed is None:
            return None
        self._scene.t = self._now = exposed.t
        return self._camera.read(timeout)


@pytest.fixture
def plugin(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[type]:
    """The driver's class, as if installed by pip."""
    (tmp_path / "depth_camera_driver.py").write_text(PLUGIN)
    about = tmp_path / "depth_camera_driver-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text(
        "Metadata-Version: 2.1\nName: depth-camera-driver\nVersion: 1.0\n"
    )
    (about / "entry_points.txt").write_text(
        "[glovetrack.cameras]\ndepth = depth_camera_driver:Driver\n"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    importlib.invalidate_caches()
    yield importlib.import_module("depth_camera_driver").Driver
    sys.modules.pop("depth_camera_driver", None)


def tracked(
    hand: HandModel, glove: GloveModel, plugin: type, infrared: bool
) -> tuple[list[Estimate], list[float], list[StereoFrame], list[str]]:
    """Estimates of the last half second, their errors (m), all images, and all messages."""
    sim = Simulation(hand, glove, RandomPostures(hand, 1, duration=2.0), 1, fps=30, rig=RIG)
    scene = VirtualCamera(sim.scene, 30.0)
    plugin.made = Sensors(scene, infrared)  # type: ignore[attr-defined]
    stream, tape = Exposures(sim), Tape()
    camera = PluggedIn(stream, scene, RIG)
    profile = load_profile(RESOURCES / "colours" / "fabric-default.toml")
    tracker = LiveTracker(
        Hands({"right": lambda: Pipeline(hand, glove, RIG)}),
        profile,
        lambda p: Detector(p, fx=RIG.fx),
        {"right": Glove(stream)},
        camera,
        tape,
    )
    run_to_the_end(tracker, stream)
    codes = [event.code for event in tracker.drain_events()]
    tracker.stop()
    late = [m for m in tape.messages if isinstance(m, Estimate) and m.t > sim.duration - 0.5]
    assert all(e.tracking == Tracking.TRACKING for e in late)
    truths = sim.truths(np.array([e.t for e in late]))
    off = [
        float(np.linalg.norm(e.keypoints - true.keypoints, axis=1).mean())
        for e, true in zip(late, truths, strict=True)
    ]
    images = [m for m in tape.messages if isinstance(m, StereoFrame)]
    return late, off, images, codes


def measured_sd(estimate: Estimate) -> float:
    """m, median over the measured keypoints; infinite if there are none."""
    measured = estimate.keypoint_sd[estimate.keypoint_state == Validity.MEASURED]
    return float(np.median(measured)) if len(measured) else float("inf")


def test_images_of_two_sizes_are_tracked_live_as_a_pair(hand, glove, plugin) -> None:
    late, off, images, codes = tracked(hand, glove, plugin, infrared=False)
    assert {(m.left.shape, m.right.shape) for m in images} == {((720, 1280, 3), (480, 640, 3))}
    assert np.mean(off) < 0.012  # m, of a stranger's hand seen for two seconds by two cameras
    # Less than one camera reports; a loaded computer drops images, after which more is true.
    assert np.median([measured_sd(e) for e in late]) < 0.008
    assert not MISFITS & set(codes), "nothing is wrong with the rig"


def test_next_to_an_infrared_camera_the_colour_camera_tracks_alone(hand, glove, plugin) -> None:
    late, off, images, codes = tracked(hand, glove, plugin, infrared=True)
    grey = images[-1].right
    assert grey is not None and grey.shape == (480, 640, 3)
    assert (grey[..., 0] == grey[..., 2]).all()
    assert np.mean(off) < 0.040  # m: 5 % of a stranger's size at 40 cm are 20 mm, two of them
    sure = [float(np.median(e.keypoint_sd)) for e in late]
    assert min(map(measured_sd, late)) > 0.008, "one camera does not know how far away the hand is"
    assert np.mean(np.array(off) < 3 * np.sqrt(3) * np.array(sure)) > 0.95
    assert not MISFITS & set(codes)
