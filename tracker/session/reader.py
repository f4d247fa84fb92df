"""Reads a session: its description, and its messages in the order in which they were fed."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from pathlib import Path

from tracker.base.clock import NS
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.glove.files import parse_glove
from tracker.hand.files import parse_hand
from tracker.hand.names import SIDES
from tracker.messages import EYES, Estimate, Message, StereoFrame
from tracker.session import description
from tracker.session.decode import MESSAGE_KINDS, Decoded, MessageDecoder
from tracker.session.decode_estimate import EstimateDecoder
from tracker.session.decode_sensors import Timing, foreign_timing
from tracker.session.description import SessionInfo
from tracker.session.images import PackedFrame
from tracker.session.mcap.input import FOREVER, RawMessage
from tracker.session.mcap.ordering import last_before, ordered
from tracker.session.mcap_session import McapSession
from tracker.session.rigs import first_rig, rig_changes
from tracker.session.ros import topics
from tracker.vision.rig import StereoRig

_WATCH_EVERY = 200  # messages


class SessionReader(McapSession):
    """The hands and the messages of a session file. Raises FileError if it is not a session.

    ``instead`` gives texts for attachments (``hand.toml``, ``glove.toml``, ``colours.toml``) that
    the file lacks or that replace its own; ``origins``, by the same names, is their source in
    errors. ``watch`` is called every `_WATCH_EVERY` messages with the share (0..1) of the file that
    `messages` has read, and may raise to stop it. ``side`` is the hand to read in a session of
    both, the right one by default.
    """

    def __init__(
        self,
        path: Path,
        instead: Mapping[str, str] | None = None,
        watch: Callable[[float], None] = lambda share: None,
        side: str = "",
        origins: Mapping[str, str] | None = None,
    ) -> None:
        super().__init__(path, instead)
        self._asked, self._origins, self._watch = side, dict(origins or {}), watch

    @cached_property
    def sides(self) -> tuple[str, ...]:
        """left and right for a session of both hands; empty for one hand."""
        names = [description.of_side(description.GLOVE, side) for side in SIDES]
        return SIDES if self.attachments.keys() >= set(names) else ()

    @cached_property
    def info(self) -> SessionInfo:
        """The session's description. Raises FileError if hand or glove is missing or invalid."""
        if not self.sides:
            return self._info_of("")
        side = self._asked or description.MAIN
        others = tuple(self._info_of(s) for s in self.sides if s != side)
        return replace(self._info_of(side), others=others)

    def _info_of(self, side: str) -> SessionInfo:
        """The description of one hand of a session of both hands; empty: of the only one."""
        names = (description.HAND, description.GLOVE)
        if side:
            names = tuple(description.of_side(name, side) for name in names)  # type: ignore[assignment]
        hand_text, glove_text = self.attachment(names[0]), self.attachment(names[1])
        hand_from, glove_from = (self._origins.get(n, f"{self.path}, {n}") for n in names)
        hand = parse_hand(hand_text, hand_from)
        glove = parse_glove(glove_text, hand, glove_from)
        if side and glove.side != side:
            raise FileError(notice("session.glove_side", path=glove_from, side=glove.side))
        m = self.metadata
        rig, moving = first_rig(self.source)
        known = description.SessionInfo(hand, glove, "", "", self.anchor).metadata().keys()
        return SessionInfo(
            hand=hand,
            glove=glove,
            hand_text=hand_text,
            glove_text=glove_text,
            anchor=self.anchor,
            rig=rig,
            moving_camera=moving,
            colours_text=self.attachments.get(description.COLOURS),
            settings_text=self.attachments.get(description.SETTINGS),
            engine=m.get("engine", ""),
            version=m.get("version", ""),
            participant=m.get("participant", ""),
            notes=m.get("notes", ""),
            simulated=m.get("simulated") == "true",
            hues=tuple(h for h in m.get("hues", "").split(",") if h),
            arithmetic=m.get("arithmetic", ""),
            extra={k: v for k, v in m.items() if k not in known},
        )

    def rig(self) -> StereoRig:
        """Returns the stereo camera. Raises FileError that lists its missing parts."""
        if self.info.rig is not None:
            return self.info.rig
        missing = [t for t in map(topics.camera_info, EYES) if t not in self.topic_names] or [
            "a transform from world to camera_left"
        ]
        raise FileError(notice("session.no_stereo", path=self.path, missing=missing))

    def rig_changes(self) -> list[tuple[float, StereoRig]]:
        """(arrival in s, rig) of each calibration after the first."""
        moving = self.rig().pose if self.info.moving_camera else None
        found = list(rig_changes(self.source, moving))
        return [(self.anchor.monotonic(log_time), rig) for log_time, rig in found[1:]]

    def messages(
        self,
        kinds: Collection[type] = MESSAGE_KINDS,
        start: float | None = None,
        end: float | None = None,
    ) -> Iterator[Message]:
        """Messages of the given kinds in feed order, with start ≤ arrival < end (s).

        Decoding images takes time; leave StereoFrame out of ``kinds`` if they are not needed.
        Damaged messages and images are left out, and counted in ``source.left_out``.
        """
        for m in self.packed_messages(kinds, start, end):
            message = m.unpack() if isinstance(m, PackedFrame) else m
            if message is not None:
                yield message

    def packed_messages(
        self,
        kinds: Collection[type] = MESSAGE_KINDS,
        start: float | None = None,
        end: float | None = None,
    ) -> Iterator[Decoded]:
        """As `messages`, with a PackedFrame for each StereoFrame: to be unpacked elsewhere."""
        decoder = MessageDecoder(
            self.info,
            topics.packets(self.info.side) in self.topic_names,
            self._timing,
            self.source.left_out,
        )
        first = 0 if start is None else max(self.anchor.wall(start), 0)
        last = FOREVER if end is None else max(self.anchor.wall(end), 0)
        states = topics.hand(self.info.side, "states")
        if first and Estimate in kinds and states in self.topic_names:
            before = last_before(self.source, states, first)
            if before is not None:
                decoder.remember(before)
        wanted = decoder.topics_of(kinds)
        types = {PackedFrame if kind is StereoFrame else kind for kind in kinds}
        for raw in self.raw_messages(wanted, first, last, decoder.rank):
            yield from (m for m in decoder.feed(raw) if type(m) in types)
        yield from (m for m in decoder.finish() if type(m) in types)

    def raw_messages(
        self,
        wanted: frozenset[str],
        first: int = 0,
        last: int = FOREVER,
        rank: Callable[[str], int] = lambda topic: 0,
    ) -> Iterator[RawMessage]:
        """Undecoded messages of the topics ``wanted``, as `ordered` sorts them."""
        for n, raw in enumerate(ordered(self.source, wanted, first, last, rank)):
            if n % _WATCH_EVERY == 0:
                share = (raw.log_time - self.span_ns[0]) / NS / max(self.duration, 1e-9)
                self._watch(min(max(share, 0.0), 1.0))
            yield raw

    def truth(self, start: float | None = None) -> Iterator[Estimate]:
        """The true poses of a simulated hand, with arrival ≥ ``start`` (s); empty if there are
        none."""
        return self._other_hand("truth", start)

    def reference(self, start: float | None = None) -> Iterator[Estimate]:
        """The hand as measured by a laboratory's reference system, with arrival ≥ ``start`` (s);
        empty if there is none."""
        return self._other_hand("reference", start)

    def _other_hand(self, root: str, start: float | None) -> Iterator[Estimate]:
        decoder = EstimateDecoder(self.info, root)
        first = 0 if start is None else max(self.anchor.wall(start), 0)
        for raw in ordered(self.source, frozenset(decoder.topics), first):
            estimate = None
            with self.source.left_out.reading(raw.topic, raw.log_time):
                estimate = decoder.feed(raw)
            if estimate is not None:
                yield estimate

    @cached_property
    def _timing(self) -> Timing:
        """The tolerances for this file; zero for Glovetrack's own."""
        return Timing() if self.metadata else foreign_timing(self.source, self.info)
