"""A simulated session: messages in the order of their arrival, and the ground truth for each.

The camera's own IMU is a Bosch BMI055, as in head-mounted stereo cameras. Its data sheet gives a
noise of 0.014 °/s/√Hz and 150 µg/√Hz, and zero offsets of 1 °/s and 70 mg before the camera's own
calibration, which leaves a fraction of them.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import NamedTuple, TypeVar

import numpy as np

from tracker import GRAVITY
from tracker.base.clock import nanoseconds, seconds
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, BlobFrame, CameraImuSample, ImuSample, StereoFrame
from tracker.simulation.desk.renderer import DeskParams, DeskRenderer
from tracker.simulation.flicker import FlickerParams
from tracker.simulation.head import Head, HeadParams
from tracker.simulation.imu import ImuSimulator
from tracker.simulation.imu_errors import ImuParams
from tracker.simulation.motion import SimulatedMotion
from tracker.simulation.render import Renderer, RenderParams
from tracker.simulation.rig_errors import RigErrorParams, true_camera
from tracker.simulation.scene import BlobParams, Extra, SimulatedScene
from tracker.simulation.smooth import rng_for
from tracker.simulation.stamps import JitteredStamps
from tracker.simulation.wearer import Wearer, WearerParams
from tracker.vision.rig import StereoRig, ideal_rig

STEP = 2e-3
"""Step of the differences, s: a head sways with periods of seconds."""


@dataclass(frozen=True)
class CameraImuParams:
    """Biases are standard deviations of one draw per axis."""

    rate_hz: float = 200.0
    gyro_noise_deg: float = 0.014  # °/s/√Hz
    accel_noise_ug: float = 150.0  # µg/√Hz
    gyro_bias_deg: float = 0.3  # °/s
    accel_bias_mg: float = 10.0
    latency: float = 0.003  # s from sampling to arrival


def camera_imu_samples(
    head: Head, seed: int, end: float, params: CameraImuParams | None = None
) -> Iterator[CameraImuSample]:
    """All samples until ``end`` (s), in order."""
    p = params or CameraImuParams()
    rng = rng_for(seed, "camera imu")
    root = np.sqrt(p.rate_hz / 2)  # a density's noise per sample
    gyro_sd = np.deg2rad(p.gyro_noise_deg) * root
    accel_sd = p.accel_noise_ug * 1e-6 * GRAVITY * root
    gyro_bias = np.deg2rad(rng.normal(0, p.gyro_bias_deg, 3))
    accel_bias = rng.normal(0, p.accel_bias_mg * 1e-3 * GRAVITY, 3)
    for k in range(int(end * p.rate_hz)):
        t = seconds(nanoseconds(k / p.rate_hz))
        before, now, after = (head.pose(t + d) for d in (-STEP, 0.0, STEP))
        turn = so3.log(before.R_GC.T @ after.R_GC) / (2 * STEP)
        a_G = (after.p_GC - 2 * now.p_GC + before.p_GC) / STEP**2
        force = now.R_GC.T @ (a_G + np.array([0.0, 0.0, GRAVITY]))
        yield CameraImuSample(
            t=t,
            t_arrival=seconds(nanoseconds(t + p.latency)),
            gyro=turn + gyro_bias + rng.normal(0, gyro_sd, 3),
            accel=force + accel_bias + rng.normal(0, accel_sd, 3),
        )


Message = ImuSample | CameraImuSample | BlobFrame | StereoFrame
MARGIN = 0.01
"""There are no samples in the last 10 ms of a motion, s."""


@dataclass(frozen=True)
class SimulationParams:
    """The person, the sensors and the delays.

    ``person`` is the seed of the person, independent of the fitting of the glove, so that one
    person can have several sessions. Likewise, ``device`` is the seed of the errors of the glove's
    IMUs and ``camera`` that of the errors of the camera's calibration.
    """

    wearer: WearerParams = field(default_factory=WearerParams)
    person: int | None = None
    device: int | None = None
    camera: int | None = None
    imu: ImuParams = field(default_factory=ImuParams)
    blobs: BlobParams = field(default_factory=BlobParams)
    render: RenderParams | DeskParams = field(default_factory=RenderParams)
    head: HeadParams = field(default_factory=HeadParams)
    camera_imu: CameraImuParams = field(default_factory=CameraImuParams)
    delay_least: float = 0.030  # s from the middle of an exposure to its arrival
    delay_most: float = 0.050
    right_late: float = 0.0  # s by which the right camera exposes after the left one
    rig_errors: RigErrorParams = field(default_factory=RigErrorParams)
    stamp_jitter: float = 0.0  # s, standard deviation of an image's time stamp
    flicker: FlickerParams = field(default_factory=FlickerParams)


Frame = TypeVar("Frame", BlobFrame, StereoFrame)


def stamped(frames: Iterator[Frame], jitter: float, seed: int) -> Iterator[Frame]:
    """The frames with a jitter (s, standard deviation) of their time stamps, in order."""
    stamps = JitteredStamps(jitter, seed)
    for frame in frames:
        t = stamps.stamp(frame.t)
        yield frame if t == frame.t else replace(frame, t=t)


class Truth(NamedTuple):
    """The wearer's true hand: keypoints (K, 3) m in G in the order of ``glove.keypoint_names``,
    angles (J,) rad as defined in the hand file, R_GB (S, 3, 3), p_GB (S, 3) m."""

    keypoints: Array
    angles: Array
    R_GB: Array
    p_GB: Array


class Simulation:
    """One wearer, one motion, one rig, one seed.

    ``rig`` is the calibration of the camera; with `SimulationParams.rig_errors`, the camera that
    takes the images (``scene.rig``) differs from it.
    """

    def __init__(
        self,
        hand: HandModel,
        glove: GloveModel,
        motion: SimulatedMotion,
        seed: int,
        params: SimulationParams | None = None,
        fps: float = 60.0,
        rig: StereoRig | None = None,
        extras: Sequence[Extra] = (),
    ) -> None:
        self.hand, self.glove, self.motion, self.seed = hand, glove, motion, seed
        self.params, self.fps, self.rig = params or SimulationParams(), fps, rig or ideal_rig()
        person = seed if self.params.person is None else self.params.person
        self.wearer = Wearer.random(hand, glove, person, self.params.wearer, fitting=seed)
        self.imus = ImuSimulator(self.wearer, motion, seed, self.params.imu, self.params.device)
        head = Head(self.rig.pose, seed, self.params.head)
        of_camera = seed if self.params.camera is None else self.params.camera
        camera = true_camera(self.rig, of_camera, self.params.rig_errors)
        self.scene = SimulatedScene(
            self.wearer, motion, camera, seed, self.params.blobs, extras, head
        )

    @property
    def duration(self) -> float:
        return self.motion.duration

    def imu_samples(self) -> Iterator[ImuSample]:
        """All packets in order."""
        return self.imus.samples(0.0, self.duration - MARGIN)

    def exposures(self) -> Iterator[tuple[int, float, float]]:
        """(index, exposure midpoint, arrival) of each frame, s; whole nanoseconds."""
        rng = rng_for(self.seed, "frames")
        phase, arrival = float(rng.uniform(0, 1 / self.fps)), 0.0
        end = self.duration - MARGIN - self.params.right_late
        for k in range(int((end - phase) * self.fps) + 1):
            t = seconds(nanoseconds(phase + k / self.fps))
            delay = rng.uniform(self.params.delay_least, self.params.delay_most)
            arrival = max(seconds(nanoseconds(t + delay)), arrival)
            yield k, t, arrival

    def frames(self, images: bool = False) -> Iterator[BlobFrame] | Iterator[StereoFrame]:
        """All frames in order: blobs, or images."""
        how = self.params.stamp_jitter, self.seed
        return stamped(self._images(), *how) if images else stamped(self._blob_frames(), *how)

    def _blob_frames(self) -> Iterator[BlobFrame]:
        late = self.params.right_late
        for index, t, arrival in self.exposures():
            frame = self.scene.blobs(t, arrival, index)
            yield replace(frame, right=self.scene.blobs(t + late).right) if late else frame

    @cached_property
    def renderer(self) -> Renderer | DeskRenderer:
        """Created for the first image: it contains ray maps and backgrounds."""
        how = self.params.render
        if isinstance(how, DeskParams):
            return DeskRenderer(self.scene, how, self.params.flicker)
        return Renderer(self.scene, how, self.params.flicker)

    def _images(self) -> Iterator[StereoFrame]:
        late = self.params.right_late
        for index, t, arrival in self.exposures():
            frame = self.renderer.frame(t, arrival, index)
            frame = replace(frame, right=self.renderer.frame(t + late).right) if late else frame
            yield frame

    def feed(self, images: bool = False) -> Iterator[ImuSample | BlobFrame | StereoFrame]:
        """All messages in the order of arrival; IMU packets first of simultaneous ones."""
        return heapq.merge(self.imu_samples(), self.frames(images), key=lambda m: m.t_arrival)

    def messages(self, images: bool = False) -> Iterator[Message]:
        """`feed`, plus the samples of the camera's own IMU if it reports those."""
        feed: Iterator[Message] = self.feed(images)
        if self.params.head.tells != "imu":
            return feed
        end = self.duration - MARGIN
        samples = camera_imu_samples(self.scene.head, self.seed, end, self.params.camera_imu)
        return heapq.merge(samples, feed, key=lambda m: m.t_arrival)

    def truth(self, t: float) -> Truth:
        """The true hand at the time t (s)."""
        return self.truths(np.array([t]))[0]

    def truths(self, t: Array) -> list[Truth]:
        """The true hand at several times."""
        hand = self.wearer.truth(self.motion, t)
        return [
            Truth(self.wearer.keypoints(R, p), angles, R, p)
            for angles, R, p in zip(hand.angles, hand.R_GB, hand.p_GB, strict=True)
        ]
