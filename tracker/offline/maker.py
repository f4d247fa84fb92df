"""Builds the runs that track a session's hands, each with its wearer's profile."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import NamedTuple

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.engine.hands import Hands, Sided, is_for
from tracker.engine.pipeline import Pipeline, PipelineSavedState
from tracker.engine.settings import Settings
from tracker.fusion.engine import Engine
from tracker.fusion.wearer_learning import load_wearer, start_with_length
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, CameraImuSample, EngineState, Estimate, Event, ImuSample
from tracker.offline import by_side
from tracker.offline.options import TrackOptions
from tracker.offline.own_colours import OwnColours
from tracker.offline.runs import EventsOnly, Fed, LiveRun, Output, arrival
from tracker.offline.smooth import Message, Shelf, Smoother
from tracker.online.camera_tilt import CameraTilt
from tracker.session.description import SessionInfo
from tracker.session.images import PackedFrame
from tracker.vision.rig import StereoRig


class GivingPipeline(Pipeline):
    """A pipeline of two, which passes its share of each image on, and reports when it restarts."""

    def __init__(
        self,
        smoother: Smoother,
        hand: HandModel,
        glove: GloveModel,
        rig: StereoRig | None,
        settings: Settings,
    ) -> None:
        super().__init__(hand, glove, rig, settings)
        self._smoother = smoother

    def feed_frame(self, frame: BlobFrame) -> None:
        self._smoother.feed(frame)
        super().feed_frame(frame)

    def set_state(self, state: PipelineSavedState) -> None:
        """Restarts the smoother too: its hand was also found where the other hand is."""
        self._smoother.restart()
        super().set_state(state)


class _Smoothed(NamedTuple):
    """A message of a hand, and the estimate of a packet."""

    side: str
    message: Message
    estimate: Estimate | None

    @property
    def order(self) -> tuple[float, bool]:
        """Packets first of what arrives together."""
        return arrival(self.message), not isinstance(self.message, ImuSample)


class SmoothRun:
    """Estimates that know the whole session; all are written at the end.

    A live run may be the ``guide``: where images are searched, it decides the colours of later
    ones. Of two hands it is always there, and its pipelines (`GivingPipeline`) pass their shares of
    each image on to the ``smoothers``; a hand alone is fed directly.
    """

    def __init__(
        self,
        smoothers: Mapping[str, Smoother],
        outputs: Mapping[str, Output],
        main: str,
        camera: CameraTilt,
        guide: LiveRun | None = None,
    ) -> None:
        """All by side; the output of ``main`` receives what belongs to no side."""
        self._smoothers, self._outputs, self._guide = smoothers, outputs, guide
        self._main, self._main_side, self._camera = outputs[main], main, camera
        self._alone = smoothers[main] if len(smoothers) == 1 else None
        self._frames, self._shares = Shelf(), dict.fromkeys(smoothers, 0.0)

    @property
    def engines(self) -> dict[str, Engine]:
        return {side: smoother.engine for side, smoother in self._smoothers.items()}

    def feed(self, message: Fed | Sided) -> None:
        if isinstance(message, Sided):
            self._smoothers[message.side].feed(message.sample)
        elif isinstance(message, BlobFrame):
            self._feed_frame(message)
            return
        else:
            self._main.message(message)
        if isinstance(message, CameraImuSample):
            self._camera.feed(message)
        elif isinstance(message, Event):
            for side, smoother in self._smoothers.items():
                if is_for(message, side):
                    smoother.feed(message)
        if self._guide is not None and not isinstance(message, PackedFrame):
            self._guide.feed(message)

    def _feed_frame(self, frame: BlobFrame) -> None:
        pose = frame.pose or self._camera.pose(frame.t)
        posed = frame if pose is frame.pose else replace(frame, pose=pose)
        if self._alone is not None:
            self._alone.feed(posed)
        else:
            self._frames.put(frame)
        if self._guide is not None:
            self._guide.feed(frame if self._alone is not None else posed)

    def finish(self, progress: Callable[[float], None]) -> None:
        calibrations = {side: s.calibration() for side, s in self._smoothers.items()}
        parts = [self._results(side, progress) for side in self._smoothers]
        frames = 0
        for side, message, estimate in heapq.merge(*parts, key=lambda part: part.order):
            if isinstance(message, ImuSample):
                self._outputs[side].message(message)
                if estimate is not None:
                    self._outputs[side].estimate(message, estimate)
            elif isinstance(message, BlobFrame) and side == self._main_side:
                self._main.message(self._whole(frames, message))
                frames += 1
        for side, output in self._outputs.items():
            if output.report.estimates:
                output.calibration(calibrations[side])

    def _whole(self, number: int, share: BlobFrame) -> BlobFrame:
        """The image that the hands' shares are of, with the pose that they were fed with."""
        if self._alone is not None:
            return share
        frame: BlobFrame = self._frames.get(number)
        return replace(frame, pose=share.pose)

    def _results(self, side: str, progress: Callable[[float], None]) -> Iterator[_Smoothed]:
        def part(share: float) -> None:
            self._shares[side] = share
            progress(sum(self._shares.values()) / len(self._shares))

        for message, estimate in self._smoothers[side].results(part):
            yield _Smoothed(side, message, estimate)


MakePipeline = Callable[[HandModel, GloveModel, StereoRig | None, Settings], Pipeline]
Changes = Sequence[tuple[float, EngineState | StereoRig]]


class Maker:
    """For the hands of ``info``, tracked with ``settings``.

    Raises FileError and ConfigError for a wearer's profile that does not match a hand of the
    session; methods raise them as `tracker.fusion.wearer_learning.load_wearer`.
    """

    def __init__(self, info: SessionInfo, settings: Settings, options: TrackOptions) -> None:
        self._info, self._settings, self._options = info, settings, options
        self._profiles = by_side.wearers(options.wearer, info)

    def live_run(
        self, outputs: Mapping[str, Output], changes: Changes, colours: OwnColours | None
    ) -> LiveRun:
        """As the session was tracked live; see `LiveRun`."""
        engine, info = self._settings.engine, self._info
        return LiveRun(self.hands, engine, info.rig, outputs, info.side, changes, colours)

    def smooth_run(
        self, outputs: Mapping[str, Output], camera: CameraTilt, colours: OwnColours | None
    ) -> SmoothRun:
        """As a whole. Raises ConfigError for an engine that cannot smooth."""
        info = self._info
        smoothers = {
            hand.side: Smoother(replace(hand, rig=info.rig), self._settings) for hand in info.hands
        }
        for side, smoother in smoothers.items():
            self._load_wearer(smoother.engine, side)
        guide: LiveRun | None = None
        build: dict[str, MakePipeline] = {}
        if len(smoothers) > 1:
            build = {side: partial(GivingPipeline, s) for side, s in smoothers.items()}
        if build or colours is not None:
            make = partial(self.hands, build=build)
            events: dict[str, Output] = {side: EventsOnly(o) for side, o in outputs.items()}
            guide = LiveRun(make, self._settings.engine, info.rig, events, info.side, (), colours)
        return SmoothRun(smoothers, outputs, info.side, camera, guide)

    def hands(
        self, engine: str, rig: StereoRig | None, build: Mapping[str, MakePipeline] | None = None
    ) -> Hands:
        """Builds all hands with the engine of that name; ``build``, by side, replaces
        `Pipeline`."""
        build = build or {}
        make = {
            hand.side: partial(self._pipeline, hand, engine, rig, build.get(hand.side, Pipeline))
            for hand in self._info.hands
        }
        return Hands(make)

    def _pipeline(
        self, hand: SessionInfo, engine: str, rig: StereoRig | None, build: MakePipeline
    ) -> Pipeline:
        pipeline = build(hand.hand, hand.glove, rig, replace(self._settings, engine=engine))
        self._load_wearer(pipeline.engine, hand.side)
        return pipeline

    def _load_wearer(self, engine: Engine, side: str) -> None:
        """Begin with a wearer's profile, or with the hand's measured length, if given."""
        if self._options.wearer and self._options.hand_length:
            raise ConfigError(notice("track.hand_length"))
        if side in self._profiles:
            load_wearer(engine, self._profiles[side])
        if self._options.hand_length:
            start_with_length(engine, self._options.hand_length)
