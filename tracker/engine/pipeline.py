"""Tracks one hand from packets and blobs. It has no threads and no clock of its own."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from tracker.base.notices import Notice, Outbox, notice, warning
from tracker.base.records import record
from tracker.engine.ahead import Ahead, GloveOnHand
from tracker.engine.kinds import build_engine, capabilities_of
from tracker.engine.settings import Settings
from tracker.fusion.chain.guided.events import guided_of
from tracker.fusion.chain.pose_reset import is_reset
from tracker.fusion.wearer_learning import learner_of
from tracker.glove.correction import ImuCorrection
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import (
    Array,
    BlobFrame,
    Calibration,
    CameraImuSample,
    CameraPose,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    IntArray,
    Tracking,
    Validity,
    WristPose,
)
from tracker.online.camera_motion import CameraMotionEstimate, TimedPose
from tracker.online.camera_tilt import CameraTilt, CameraTiltSavedState
from tracker.online.frame_timing import FrameTiming, FrameTimingSavedState
from tracker.online.hue_names import HueNames, HueNamesSavedState, hue_names_of
from tracker.online.pair_offset import PairOffset, PairOffsetSavedState
from tracker.online.rig_alignment import RigAlignment, RigAlignmentSavedState
from tracker.online.rig_watch import RigState, RigWatch
from tracker.online.time_offset import TimeOffset
from tracker.sensors.motor_events import MotorRun, motor_of
from tracker.vision.crowding import MOST_BLOBS, BlobLimit
from tracker.vision.lenses import check_lenses, through
from tracker.vision.rig import StereoRig, ideal_rig

SILENCE = 0.2
"""s without packets, at an image's exposure, after which the hand is tracked from images alone.
Most stalls of the computer or the USB line are shorter, and their packets still arrive."""
ABANDONED = warning("tracking.abandoned")


@record("pipeline", shapes={"celsius": "n", "motors": "m 3"})
@dataclass(eq=False)
class PipelineSavedState:
    """The variable state of a pipeline; ``engine`` is that of its engine, ``packet`` when (s) the
    last packet arrived, ``by_images`` whether the hand follows the images alone, ``celsius`` the
    last temperatures of the IMUs, empty before the first, ``motors`` those that ran last."""

    engine: Any
    timing: FrameTimingSavedState
    camera: CameraTiltSavedState
    pair: PairOffsetSavedState = field(default_factory=PairOffsetSavedState)
    packet: float = -np.inf
    by_images: bool = False
    camera_motion: TimedPose | None = None
    celsius: Array = field(default_factory=lambda: np.empty(0))
    alignment: RigAlignmentSavedState = field(default_factory=RigAlignmentSavedState)
    motors: Array = field(default_factory=lambda: np.empty((0, 3)))
    hues: HueNamesSavedState = field(default_factory=HueNamesSavedState)


class Pipeline:
    """One hand, one glove, one stereo camera, one engine.

    ``rig`` is None if no camera is calibrated; ``self.rig`` is then an ideal one, for the window.
    Raises ConfigError for an unknown engine, and for one that needs a missing rig.

    ``engine`` is public for what only some engines have, such as a wearer's profile. ``timing`` is
    the delay of the images' stamps, ``pair_offset`` that of the right camera's exposure, each as
    estimated and as corrected, ``alignment`` likewise the rotation of the right camera since its
    calibration; ``ahead`` is where the hand is expected.
    """

    def __init__(
        self,
        hand: HandModel,
        glove: GloveModel,
        rig: StereoRig | None,
        settings: Settings | None = None,
    ) -> None:
        self.hand, self.glove, self.calibrated_rig = hand, glove, rig
        self.settings = settings or Settings()
        check_lenses(self.settings.lenses, rig)
        self.engine = build_engine(hand, glove, rig, self.settings)
        self._uses_images = capabilities_of(self.settings.engine).images
        self.rig = rig = rig or ideal_rig()
        self._imus, self._motors = ImuCorrection(glove), MotorNoise(glove)
        self._watch = RigWatch(rig)
        self._camera, self._camera_motion = CameraTilt(rig.pose), CameraMotionEstimate()
        offset = TimeOffset(hand, glove, rig)
        self.timing = FrameTiming(offset, self.settings.timing)
        self.pair_offset = PairOffset(rig)
        self.alignment = RigAlignment(rig, self.settings.alignment)
        self._results: list[FrameResult] = []
        self._notices, self._abandoned = Outbox(), False
        self.source_notices = Outbox()
        """About what the hand follows: packets, or images alone."""
        self._reported_guided = self._reported_wrist = False
        self.blob_limit = BlobLimit()
        self._packet = -np.inf  # arrival of the last packet, s
        self._by_images = False
        self.hues = HueNames(glove.hues)
        worn = GloveOnHand(hand, glove, self.hues)
        self.ahead = Ahead(worn, self.engine, self.timing, self.pair_offset)

    def with_engine(self, name: str) -> Pipeline:
        """Returns the same hand with another engine, which starts by searching for it.

        Raises ConfigError for an unknown name.
        """
        settings = replace(self.settings, engine=name)
        return Pipeline(self.hand, self.glove, self.calibrated_rig, settings)

    @property
    def keypoint_names(self) -> tuple[str, ...]:
        """Rows of ``Estimate.keypoints``."""
        return self.glove.keypoint_names(self.hand)

    def feed_imu(self, sample: ImuSample) -> Estimate:
        """Feeds a packet; returns the hand at the packet's instant."""
        sample = self._imus.corrected(sample)
        self._watch.packet(sample.t, sample.t_arrival)
        self._packet = sample.t_arrival
        self._shake()
        self._follow_images(False)
        self.timing.packet(sample)
        estimate = self.engine.feed_imu(sample)
        self._collect()
        return estimate

    def _shake(self) -> None:
        """Raises the noise of the IMUs while motors run."""
        if self._motors.is_known:
            self.engine.set_vibration(*self._motors.at(self._packet))

    def feed_frame(self, frame: BlobFrame) -> None:
        """Feeds the blobs of an image; see `take_results`. Swapped images are not used."""
        if not self._uses_images:
            self.engine.feed_frame(frame)
            self._results += self.engine.take_results()
            return
        frame, is_report_due = self.blob_limit.limit(through(frame, self.settings.lenses))
        if is_report_due:
            ignored = self.blob_limit.ignored
            self.source_notices.post(warning("images.crowded", limit=MOST_BLOBS, ignored=ignored))
        frame = self.hues.corrected(frame)
        self.pair_offset.remember(frame)
        self.alignment.remember(frame)
        frame = self.ahead.synchronised(frame)
        if self._watch.usable(frame, self.alignment.reported):
            self.alignment.start_from(self._watch.shift)
            frame = self.timing.corrected(self.alignment.aligned(frame))
            frame = self._camera.posed(frame)
            is_timed_roughly = self.rig.line_time > 0.0 or frame.stamp_sd > 0.0
            self.engine.feed_frame(self._camera_motion.moved(frame) if is_timed_roughly else frame)
            self._collect()
        else:
            nothing = FrameResult.nothing(frame.t, Tracking.SEARCHING, len(self.glove.markers))
            self._results.append(nothing)

    def without_packets(self, frame: BlobFrame) -> Estimate | None:
        """Returns the hand at the instant of the image that was just fed, if packets have been
        missing for `SILENCE`; None while they arrive, before the first and without a camera.

        It depends only on what was fed, so tracking a session again gives the same. No part of it
        is marked as measured.
        """
        if not self._uses_images or not frame.t - self._packet > SILENCE:
            return None
        if self._packet == -np.inf:
            return None
        self._follow_images(True)
        return inferred(self.engine.predict(frame.t))

    def _follow_images(self, on: bool) -> None:
        if on != self._by_images:
            self._by_images = on
            side = self.glove.side
            missing = warning("glove.packets_missing", side=side)
            self.source_notices.post(missing if on else notice("glove.packets_back", side=side))

    def feed_event(self, event: Event) -> None:
        """Take an event: guided poses, which some engines learn from, pose resets, and commands to
        motors."""
        if (motor := motor_of(event)) is not None:
            self._motors.run(motor, event.t)
            return
        if (names := hue_names_of(event)) is not None:
            self.hues.use(names)
            return
        if is_reset(event):
            unsupported = warning("pose_reset.not_supported", engine=self.settings.engine)
            self._notices.post(self.engine.reset_pose() or unsupported)
            return
        guided = guided_of(event)
        if guided is None:
            return
        if isinstance(guided, Notice):
            self._notices.post(guided)
        elif (learner := learner_of(self.engine)) is not None:
            learner.wearer.take_guided_pose(guided, event.t)
        elif not self._reported_guided:
            self._reported_guided = True
            self._notices.post(warning("guided.not_learned", engine=self.settings.engine))

    def feed_camera_imu(self, sample: CameraImuSample) -> None:
        """Feeds a sample of the camera's own IMU, which gives a pose to images without one."""
        self._camera.feed(sample)

    def feed_wrist(self, pose: WristPose) -> None:
        """Feeds the pose of a tracker on the hand, which gives a glove without a camera a
        position."""
        found = self.engine.feed_wrist(pose)
        if found is not None and not self._reported_wrist:
            self._reported_wrist = True
            self._notices.post(found)

    def camera_pose(self, t: float) -> CameraPose:
        """Returns the assumed pose of the camera in an image of ``t`` that has no pose."""
        return self._camera.pose(t) or self.rig.pose

    def _collect(self) -> None:
        """Learns from results immediately, so that it does not matter when they are read."""
        for result in self.engine.take_results():
            self._watch.check(result)
            if (exchanged := self.hues.learn(result.t, result.hues)) is not None:
                self._notices.post(exchanged)
            if result.another and not self._abandoned:
                self._abandoned = True
                self._notices.post(ABANDONED)
            restored = self.timing.restored(result)
            self.pair_offset.learn(restored)
            restored = self.alignment.restored(restored)
            self.alignment.learn(restored, self._watch.state.moved)
            self._results.append(restored)

    def take_results(self) -> list[FrameResult]:
        """Returns the results of images since the last call, oldest first."""
        results, self._results = sorted(self._results, key=lambda r: r.t), []
        return results

    @property
    def rig_state(self) -> RigState:
        """Whether the camera is still the one that was calibrated."""
        return self._watch.state

    def drain_notices(self) -> list[Notice]:
        """Notices since the last call: about guided poses, packets, the camera and the glove."""
        self._abandoned = False
        parts = (self._notices, self.source_notices, self._watch.notices, self.alignment.notices)
        of_engine = self.engine.drain_notices()
        return [*(found for part in parts for found in part.drain()), *of_engine]

    def predict(self, t: float) -> Estimate:
        """Returns the hand at any instant near now, without changing the state."""
        return self.engine.predict(t)

    def calibration(self) -> Calibration:
        """Returns the estimated parameters with their uncertainty."""
        return self.engine.calibration()

    def get_state(self) -> PipelineSavedState:
        """Returns the state that estimates depend on; after `set_state` they are identical."""
        timing, camera = self.timing.get_state(), self._camera.get_state()
        pair = self.pair_offset.get_state()
        engine = self.engine.get_state()
        return PipelineSavedState(
            engine,
            timing,
            camera,
            pair,
            self._packet,
            self._by_images,
            self._camera_motion.last,
            self._imus.celsius,
            self.alignment.get_state(),
            self._motors.running,
            self.hues.saved,
        )

    def set_state(self, state: PipelineSavedState) -> None:
        """Restores a state that `get_state` returned."""
        self.engine.set_state(state.engine)
        self.timing.set_state(state.timing)
        self._camera.set_state(state.camera)
        self.pair_offset.set_state(state.pair)
        self._packet, self._by_images = state.packet, state.by_images
        self._camera_motion.last = state.camera_motion
        self._imus.celsius = state.celsius
        self.alignment.set_state(state.alignment)
        self._motors.running = state.motors
        self.hues.saved = state.hues
        self._shake()


def inferred(estimate: Estimate) -> Estimate:
    """Returns the estimate with measured values marked as inferred."""
    return replace(
        estimate,
        keypoint_state=_at_most_inferred(estimate.keypoint_state),
        angle_state=_at_most_inferred(estimate.angle_state),
    )


def _at_most_inferred(state: IntArray) -> IntArray:
    return np.where(state == Validity.MEASURED, Validity.INFERRED, state).astype(state.dtype)


# ---- noise of the IMUs while the glove's motors run, by what was measured of this glove

AFTER = 0.15
"""s after the end of a run: the motor spins down, and filters process packets late."""


class MotorNoise:
    """``running`` (m, 3): channel, end (s) and share of the amplitude of the last commands; part of
    the saved state. A glove without measurements has no such noise."""

    def __init__(self, glove: GloveModel) -> None:
        known = [imu.vibration for imu in glove.imus if imu.vibration is not None]
        motors = max((len(v.gyro) for v in known), default=0)
        self._size = np.zeros((motors, 2))  # gyro, accel: of the IMU that is shaken most
        for v in known:
            rows = slice(len(v.gyro))
            self._size[rows] = np.maximum(self._size[rows], np.stack([v.gyro, v.accel], axis=1))
        self.running: Array = np.empty((0, 3))

    @property
    def is_known(self) -> bool:
        """Whether the vibration of a motor was measured."""
        return len(self._size) > 0

    def run(self, command: MotorRun, t: float) -> None:
        """Takes a command of ``t`` (s); it replaces an earlier one of the same motor."""
        if command.channel >= len(self._size):
            return
        keep = (self.running[:, 0] != command.channel) & (self.running[:, 1] > t)
        row = [command.channel, t + command.duration + AFTER, command.share]
        self.running = np.concatenate([self.running[keep], [row]])

    def at(self, t: float) -> tuple[float, float]:
        """rad/s/√Hz and m/s²/√Hz in addition to the noise at rest, at ``t`` (s)."""
        now = self.running[self.running[:, 1] > t]
        size = self._size[now[:, 0].astype(np.int64)] * now[:, 2:]
        gyro, accel = np.sqrt(np.sum(size**2, axis=0))
        return float(gyro), float(accel)
