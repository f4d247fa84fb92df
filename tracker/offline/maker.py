"""Builds what tracks a session's hands, each with what is known of its wearer."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial

from tracker.base.errors import ConfigError
from tracker.engine.hands import Hands
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.engine import Engine
from tracker.fusion.worn import measure, put_on
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import EngineState
from tracker.offline import by_side
from tracker.offline.options import TrackOptions
from tracker.offline.own_colours import OwnColours
from tracker.offline.runs import LiveRun, Output, WordsAlone
from tracker.offline.smooth import Smoother
from tracker.offline.smooth_run import GivingPipeline, SmoothRun
from tracker.online.camera_tilt import CameraTilt
from tracker.session.description import SessionInfo
from tracker.vision.rig import StereoRig

MakePipeline = Callable[[HandModel, GloveModel, StereoRig | None, Settings], Pipeline]
Changes = Sequence[tuple[float, EngineState | StereoRig]]


class Maker:
    """For the hands of ``info``, tracked with ``settings``.

    Raises FileError and ConfigError for a wearer's profile that is of no hand of the session;
    methods raise them as `tracker.fusion.worn.put_on`.
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
            self._put_on(smoother.engine, side)
        guide: LiveRun | None = None
        build: dict[str, MakePipeline] = {}
        if len(smoothers) > 1:
            build = {side: partial(GivingPipeline, s) for side, s in smoothers.items()}
        if build or colours is not None:
            make = partial(self.hands, build=build)
            words: dict[str, Output] = {side: WordsAlone(o) for side, o in outputs.items()}
            guide = LiveRun(make, self._settings.engine, info.rig, words, info.side, (), colours)
        return SmoothRun(smoothers, outputs, info.side, camera, guide)

    def hands(
        self, engine: str, rig: StereoRig | None, build: Mapping[str, MakePipeline] | None = None
    ) -> Hands:
        """All hands with the engine of that name; ``build``, by side, in place of `Pipeline`."""
        build = build or {}
        make = {
            hand.side: partial(self._pipeline, hand, engine, rig, build.get(hand.side, Pipeline))
            for hand in self._info.hands
        }
        return Hands(make)

    def _pipeline(
        self, worn: SessionInfo, engine: str, rig: StereoRig | None, build: MakePipeline
    ) -> Pipeline:
        pipeline = build(worn.hand, worn.glove, rig, replace(self._settings, engine=engine))
        self._put_on(pipeline.engine, worn.side)
        return pipeline

    def _put_on(self, engine: Engine, side: str) -> None:
        """Begin with a wearer's profile, or with the hand's measured length, if given."""
        if self._options.wearer and self._options.hand_length:
            raise ConfigError("A profile knows how long the hand is: leave out --hand-length.")
        if side in self._profiles:
            put_on(engine, self._profiles[side])
        if self._options.hand_length:
            measure(engine, self._options.hand_length)
