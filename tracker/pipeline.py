"""The stages joined: packets and blobs in, the hand out. No threads, no clock of its own."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from tracker.errors import ConfigError
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.guided.events import guided_of
from tracker.fusion.chain.inertial import InertialEngine
from tracker.fusion.engine import Engine
from tracker.fusion.hybrid import HybridEngine
from tracker.fusion.vist.engine import VistEngine
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import (
    BlobFrame,
    Calibration,
    CameraImuSample,
    CameraPose,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    Tracking,
)
from tracker.online.camera_tilt import CameraTilt, CameraTiltKept
from tracker.online.frame_timing import FrameTiming, FrameTimingKept
from tracker.online.pair_offset import PairOffset, PairOffsetKept
from tracker.online.rig_watch import RigState, RigWatch
from tracker.online.time_offset import TimeOffset
from tracker.records import record
from tracker.settings import ENGINES, WITHOUT_IMAGES, Settings
from tracker.vision.colours import hue_rows
from tracker.vision.lenses import check_lenses, through
from tracker.vision.region_prediction import RegionPrediction
from tracker.vision.rig import StereoRig, ideal_rig
from tracker.vision.sharing import HandInView
from tracker.vision.visibility import HandShape, MarkerRows, PosedHand


def build_engine(
    hand: HandModel, glove: GloveModel, rig: StereoRig | None, settings: Settings
) -> Engine:
    """The engine that ``settings`` name.

    Raises ConfigError where there is none of that name, or it needs the rig and there is none.
    """
    if settings.engine not in ENGINES:
        raise ConfigError(
            f"There is no engine {settings.engine!r}; there are {', '.join(ENGINES)}."
        )
    if settings.engine in WITHOUT_IMAGES:
        return InertialEngine(hand, glove, settings.chain)
    if rig is None:
        raise ConfigError(
            f"The engine {settings.engine!r} needs a camera with a stereo calibration; without one "
            "the engine 'inertial' shows the hand by its IMUs."
        )
    if settings.engine == "chain":
        return ChainEngine(hand, glove, rig, settings.chain)
    if settings.engine == "vist":
        return VistEngine(hand, glove, rig, settings.vist)
    variant = {"switching": "switching_offset", "madgwick": "madgwick_adaptive"}[settings.engine]
    return HybridEngine(hand, glove, rig, settings.chain, settings.hybrid, variant)


@record("pipeline")
@dataclass(eq=False)
class PipelineKept:
    """All of a pipeline that changes; ``engine`` is what its engine keeps."""

    engine: Any
    timing: FrameTimingKept
    camera: CameraTiltKept
    pair: PairOffsetKept = field(default_factory=PairOffsetKept)


class Pipeline:
    """One hand, one glove, one stereo camera, one engine.

    ``rig`` is None where no camera is calibrated; ``self.rig`` is an ideal one then, which stands
    for it where the window needs one. Raises ConfigError for an unknown engine, and for one that
    needs the rig where there is none.
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
        check_lenses(self.settings.lenses, self.settings.engine, rig)
        self._engine = build_engine(hand, glove, rig, self.settings)
        self._uses_images = self.settings.engine not in WITHOUT_IMAGES
        self.rig = rig = rig or ideal_rig()
        self._watch = RigWatch(rig)
        self._camera = CameraTilt(rig.pose)
        offset = TimeOffset(hand, glove, rig)
        self._timing = FrameTiming(offset, self.settings.timing)
        self._pair = PairOffset(rig)
        self._results: list[FrameResult] = []
        self._words: list[str] = []
        self._told = False
        self._marker_segment, self._shape = glove.marker_segment(hand), HandShape.of(hand)

    @property
    def engine(self) -> Engine:
        """For what only some engines know, such as a wearer's profile."""
        return self._engine

    def with_engine(self, name: str) -> Pipeline:
        """The same hand with another engine, which looks for it anew.

        Raises ConfigError for an unknown name.
        """
        settings = replace(self.settings, engine=name)
        return Pipeline(self.hand, self.glove, self.calibrated_rig, settings)

    @property
    def keypoint_names(self) -> tuple[str, ...]:
        """Rows of ``Estimate.keypoints``."""
        return self.glove.keypoint_names(self.hand)

    def feed_imu(self, sample: ImuSample) -> Estimate:
        """Take a packet; the hand at the packet's instant."""
        self._watch.packet(sample.t)
        self._timing.packet(sample)
        estimate = self._engine.feed_imu(sample)
        self._collect()
        return estimate

    def feed_frame(self, frame: BlobFrame) -> None:
        """Take what was seen in an image; see `take_results`. Swapped images are not used."""
        if not self._uses_images:
            self._engine.feed_frame(frame)
            self._results += self._engine.take_results()
            return
        frame = through(frame, self.settings.lenses)
        self._pair.remember(frame)
        frame = self._in_step(frame)
        if self._watch.usable(frame):
            self._engine.feed_frame(self._posed(self._timing.corrected(frame)))
            self._collect()
        else:
            nothing = FrameResult.nothing(frame.t, Tracking.SEARCHING, len(self.glove.markers))
            self._results.append(nothing)

    def feed_event(self, event: Event) -> None:
        """Take what was said: an engine that learns from guided poses hears of them."""
        said = guided_of(event)
        if said is None:
            return
        if isinstance(said, str):
            self._words.append(said)
        elif not isinstance(self._engine, ChainEngine):
            if not self._told:
                name, self._told = self.settings.engine, True
                self._words.append(f"The engine {name} learns nothing from guided poses.")
        else:
            self._engine.hear(said, event.t)

    def feed_camera_imu(self, sample: CameraImuSample) -> None:
        """Take a sample of the camera's own IMU: images without a pose get one of it."""
        self._camera.feed(sample)

    def camera_pose(self, t: float) -> CameraPose:
        """Where the camera is taken to be in an image of ``t`` that brings no pose."""
        return self._camera.pose(t) or self.rig.pose

    def _posed(self, frame: BlobFrame) -> BlobFrame:
        pose = frame.pose or self._camera.pose(frame.t)
        return frame if pose is frame.pose else replace(frame, pose=pose)

    def _in_step(self, frame: BlobFrame) -> BlobFrame:
        """The image as if both cameras had exposed when the left one did."""
        late, t = self._pair.applied, frame.t - self._timing.applied
        if late == 0.0:
            return frame
        then, after = (self._engine.expected(at) for at in (t, t + late))
        if then is None or after is None:
            return frame
        return self._pair.moved_back(frame, then.p_G, after.p_G)

    def _collect(self) -> None:
        """Learn from results as they come, so that it does not matter when they are taken."""
        for result in self._engine.take_results():
            self._watch.check(result)
            restored = self._timing.restored(result)
            self._pair.learn(restored)
            self._results.append(restored)

    def take_results(self) -> list[FrameResult]:
        """What was made of images since the last call, oldest first."""
        results, self._results = sorted(self._results, key=lambda r: r.t), []
        return results

    @property
    def rig_state(self) -> RigState:
        """Whether the camera is still the one that was calibrated."""
        return self._watch.state

    @property
    def timing(self) -> FrameTiming:
        """How late images are stamped, and what is taken off."""
        return self._timing

    @property
    def pair_offset(self) -> PairOffset:
        """How much later than the left camera the right one exposes, and what is taken off."""
        return self._pair

    def take_words(self) -> list[str]:
        """Sentences about the camera and guided poses since the last call, for the log."""
        words, self._words = self._words, []
        return words + self._watch.take_words()

    def predict(self, t: float) -> Estimate:
        """The hand at any instant near now. Moves nothing."""
        return self._engine.predict(t)

    def calibration(self) -> Calibration:
        """Estimated parameters with their uncertainty."""
        return self._engine.calibration()

    def region_prediction(
        self, t: float, before: RegionPrediction | None = None
    ) -> RegionPrediction | None:
        """Where markers are expected at ``t``, not before the newest packet; None while searching.

        Their speed is taken from where they were expected ``before``.
        """
        markers = self._engine.predicted_markers(t)
        if markers is None:
            return None
        p_G, sd, ids = markers
        return RegionPrediction(
            t=t + self._timing.applied,
            p_G=p_G,
            v_G=np.zeros_like(p_G),
            sd=sd,
            size=self.glove.marker_size[ids],
            hue=self.glove.marker_hue[ids],
            hue_names=self.glove.hues,
            right_late=self._pair.applied,
        ).after(before)

    def in_view(self, frame: BlobFrame) -> HandInView | None:
        """The hand as it is expected in an image that was not fed yet, hues numbered as the
        image's; None while its place is unknown."""
        found = self._engine.expected(frame.t - self._timing.applied)
        if found is None:
            return None
        estimate, glove, ids = found.estimate, self.glove, found.ids
        segment = self._marker_segment[ids]
        turned = np.einsum("mij,mj->mi", estimate.segment_R[segment], glove.marker_normal[ids])
        return HandInView(
            MarkerRows(found.p_G, turned, segment),
            hue_rows(glove.hues, frame.hue_names)[glove.marker_hue[ids]],
            found.sd,
            PosedHand(self._shape, estimate.segment_R, estimate.segment_p),
        )

    def get_state(self) -> PipelineKept:
        """Everything that changes and that estimates depend on; `set_state` goes on identically."""
        timing, camera = self._timing.get_state(), self._camera.get_state()
        return PipelineKept(self._engine.get_state(), timing, camera, self._pair.get_state())

    def set_state(self, state: PipelineKept) -> None:
        """Go on from `get_state`."""
        self._engine.set_state(state.engine)
        self._timing.set_state(state.timing)
        self._camera.set_state(state.camera)
        self._pair.set_state(state.pair)
