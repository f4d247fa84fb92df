"""Both hands of a session smoothed as a whole, each by itself; blobs are shared out as live."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple

from tracker.engine.pipeline import Pipeline, PipelineKept
from tracker.engine.settings import Settings
from tracker.engine.two_hands import Sided
from tracker.fusion.engine import Engine
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, CameraImuSample, Estimate, Event, ImuSample
from tracker.offline.runs import Fed, Output, arrival
from tracker.offline.smooth import Message, Shelf, Smoother
from tracker.offline.two_hands import TwoHandsRun
from tracker.online.camera_tilt import CameraTilt
from tracker.session.images import PackedFrame
from tracker.vision.rig import StereoRig


class GivingPipeline(Pipeline):
    """A pipeline of two, which hands its share of each image on, and says when it starts anew."""

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

    def set_state(self, state: PipelineKept) -> None:
        """It was found where the other hand is: so was what is smoothed."""
        self._smoother.begin_anew()
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


class SmoothTwoRun:
    """Estimates of both hands that know the whole session; all are written at the end.

    A live run is the ``guide``: it shares out the blobs of each image, and its pipelines
    (`GivingPipeline`) give the ``smoothers``, by side, theirs. Where images are searched it decides
    the colours of later ones, too.
    """

    def __init__(
        self,
        guide: TwoHandsRun,
        smoothers: Mapping[str, Smoother],
        outputs: Mapping[str, Output],
        main: str,
        camera: CameraTilt,
    ) -> None:
        """``main`` is the side whose output takes what is of no side."""
        self._guide, self._smoothers, self._outputs = guide, smoothers, outputs
        self._main, self._camera, self._frames = outputs[main], camera, Shelf()
        self._main_side, self._shares = main, dict.fromkeys(smoothers, 0.0)

    @property
    def engines(self) -> dict[str, Engine]:
        return {side: smoother.engine for side, smoother in self._smoothers.items()}

    def feed(self, message: Fed | Sided) -> None:
        if isinstance(message, Sided):
            self._smoothers[message.side].feed(message.sample)
        elif isinstance(message, BlobFrame):
            self._frames.put(message)
            if message.pose is None:
                message = replace(message, pose=self._camera.pose(message.t))
        else:
            self._main.message(message)
        if isinstance(message, CameraImuSample):
            self._camera.feed(message)
        elif isinstance(message, Event):
            for side, smoother in self._smoothers.items():
                if message.data.get("hand", side) == side:
                    smoother.feed(message)
        if not isinstance(message, PackedFrame):
            self._guide.feed(message)

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
        """The image that both hands' shares are of, with the pose that they were fed with."""
        frame: BlobFrame = self._frames.get(number)
        return replace(frame, pose=share.pose)

    def _results(self, side: str, progress: Callable[[float], None]) -> Iterator[_Smoothed]:
        def part(share: float) -> None:
            self._shares[side] = share
            progress(sum(self._shares.values()) / len(self._shares))

        for message, estimate in self._smoothers[side].results(part):
            yield _Smoothed(side, message, estimate)
