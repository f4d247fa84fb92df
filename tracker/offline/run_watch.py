"""What images of a session reveal of its hands, while it is tracked again as live."""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

from tracker.engine.hands import Hands
from tracker.engine.pipeline import ABANDONED, Pipeline
from tracker.engine.side_watch import ExchangeWatch, SideWatch
from tracker.messages import BlobFrame, Event, FrameResult, ImuSample, Tracking
from tracker.online.colour_watch import ColourWatch
from tracker.online.hue_names import hue_names_event


class RunWatch(Protocol):
    """Watches what is fed to the hands, whose names of exchanged hues it corrects."""

    def packet(self, side: str, sample: ImuSample, tracking: Tracking) -> list[tuple[str, Event]]:
        """Takes a packet and the hand's state of tracking after it; returns what to report, with
        the hand's side."""

    def frame(self, frame: BlobFrame) -> None:
        """Takes an image that was fed."""

    def look(self, frame: BlobFrame, tracking: Tracking, results: list[FrameResult]) -> list[Event]:
        """Returns what to report of the colours after an image and the ``results`` that
        followed."""


def run_watch(hands: Hands, corrects: bool) -> RunWatch:
    """Returns a watch of one hand or of two. ``corrects``: names of exchanged hues; those of a live
    run are among its events."""
    if hands.alone:
        (pipeline,) = hands.pipelines.values()
        return AloneWatch(pipeline, corrects)
    return PairWatch(hands, corrects)


class AloneWatch:
    """What images reveal of a hand that is tracked alone: colours that do not fit, or a glove of
    the other hand; a second hand's blobs would suggest both."""

    def __init__(self, pipeline: Pipeline, corrects: bool) -> None:
        self._pipeline, self._corrects = pipeline, corrects
        self._sides = SideWatch(pipeline)
        self._colours = ColourWatch(len(pipeline.glove.markers))

    def packet(self, side: str, sample: ImuSample, tracking: Tracking) -> list[tuple[str, Event]]:
        self._sides.packet(sample, tracking)
        names = self._sides.take_names()
        if names and self._corrects:
            event = hue_names_event(self._pipeline.glove.hues, names, sample.t)
            self._pipeline.feed_event(event)
            return [(side, event)]
        found = self._sides.notices.drain()
        return [(side, Event.of(sample.t, "device", each)) for each in found]

    def frame(self, frame: BlobFrame) -> None:
        self._sides.frame(frame)

    def look(self, frame: BlobFrame, tracking: Tracking, results: list[FrameResult]) -> list[Event]:
        self._colours.look(frame, tracking)
        found = [ABANDONED for r in results if r.another] + self._colours.notices.drain()
        return [Event.of(frame.t, "tracking", each) for each in found]


class PairWatch:
    """Corrects the names of exchanged hues of two hands."""

    def __init__(self, hands: Hands, corrects: bool) -> None:
        self._hands = hands
        self._watch = ExchangeWatch(hands) if corrects else None

    def packet(self, side: str, sample: ImuSample, tracking: Tracking) -> list[tuple[str, Event]]:
        if self._watch is None:
            return []
        self._watch.packet(side, sample, tracking)
        out = []
        for of, names in self._watch.take_names().items():
            event = hue_names_event(self._hands.pipelines[of].glove.hues, names, sample.t)
            event = replace(event, data={**event.data, "hand": of})
            self._hands.feed_event(event)
            out.append((of, event))
        return out

    def frame(self, frame: BlobFrame) -> None:
        if self._watch is not None:
            self._watch.frame(frame)

    def look(self, frame: BlobFrame, tracking: Tracking, results: list[FrameResult]) -> list[Event]:
        return []
