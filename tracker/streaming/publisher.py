"""The interface of an output, and the names in its messages."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Protocol

from tracker.base.clock import ClockAnchor
from tracker.base.notices import Notice, notice
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.openxr import joint_radii
from tracker.messages import Estimate, Validity
from tracker.streaming.connection import LOOPBACK as LOOPBACK
from tracker.streaming.connection import StreamError as StreamError
from tracker.streaming.shared import Gestures, OutputGestures, SharedGestures

OWN, OPENXR = JOINT_SETS = ("own", "openxr")
"""The content of a message: the hand's keypoints in G, or OpenXR's 26 joints in OpenXR's world."""

STATE_WORDS = {
    Validity.LOST: "lost",
    Validity.INFERRED: "inferred",
    Validity.MEASURED: "measured",
}


Title = str | Notice
"""A name, finished or to be translated."""


class Publisher(Protocol):
    """One output. ``send`` and ``close`` are called from the output's own thread.

    A server also has ``clients``, the number of connected ones, and ``missed()``, the messages that
    slow clients missed by their address ("" for clients that have left). ``probe()``, where there
    is one, finds out whether a program receives and may take a second: a `Notice`, or None to judge
    by ``clients``.
    """

    @property
    def name(self) -> Title:
        """The user's name for it, for messages."""

    def send(self, estimate: Estimate) -> None:
        """Sends one estimate. May raise StreamError or OSError; the next one is sent
        nevertheless."""

    def close(self) -> None:
        """Frees its resources. May be called repeatedly."""


class OtherHand:
    """Sends another hand through the output of one hand: its estimates go to ``send``, and the
    owner of the output closes it."""

    def __init__(self, name: Title, send: Callable[[Estimate], None]) -> None:
        self.name, self._send = name, send

    def send(self, estimate: Estimate) -> None:
        self._send(estimate)

    def close(self) -> None:
        """Does nothing: the owner closes the output."""


@dataclass(frozen=True)
class Names:
    """Names of an Estimate's rows: keypoints (K,), joint angles (J,)."""

    side: str  # "right" or "left"
    keypoints: tuple[str, ...]
    angles: tuple[str, ...]
    radii: tuple[float, ...] = ()  # of OpenXR's joints, m, where messages are to carry these
    hand: HandModel | None = field(default=None, compare=False, repr=False)
    anchor: ClockAnchor | None = field(default=None, compare=False, repr=False)
    glove: GloveModel | None = field(default=None, compare=False, repr=False)
    shared: SharedGestures | None = field(default=None, compare=False, repr=False)

    def wall_ns(self, t: float) -> int | None:
        """ns since 1970 at ``t`` (s) by the session's anchor; None for names without one."""
        return None if self.anchor is None else self.anchor.wall(t)

    @property
    def openxr(self) -> bool:
        """Whether messages carry OpenXR's 26 joints in place of the keypoints."""
        return bool(self.radii)

    def recogniser(self) -> Gestures | None:
        """The gestures of one output, recognized together with those of outputs whose names were
        shared; None for names without a hand."""
        if self.hand is None:
            return None
        return OutputGestures(self.shared or SharedGestures(self.hand, self.keypoints))

    def sharing(self) -> Names:
        """For several outputs of one hand, whose gestures are recognized once."""
        if self.hand is None:
            return self
        return replace(self, shared=SharedGestures(self.hand, self.keypoints))

    @staticmethod
    def of(
        hand: HandModel, glove: GloveModel, joints: str = OWN, anchor: ClockAnchor | None = None
    ) -> Names:
        """The rows of estimates made for this hand and glove; ``joints``: ``own`` or ``openxr``.
        ``anchor`` gives their instants on the wall clock.

        Raises StreamError for other joints.
        """
        if joints not in JOINT_SETS:
            raise StreamError(notice("stream.joints", known=JOINT_SETS, value=joints))
        keypoints = glove.keypoint_names(hand)
        names = Names(hand.side, keypoints, hand.joint_names, (), hand, anchor, glove)
        return names.with_openxr() if joints == OPENXR else names

    def with_openxr(self) -> Names:
        """For messages with OpenXR's joints. Raises ValueError for names without a hand."""
        return replace(self, radii=tuple(joint_radii(self.model).tolist()))

    @property
    def model(self) -> HandModel:
        """The hand. Raises ValueError for names without a hand."""
        if self.hand is None:
            raise ValueError("these names have no hand")
        return self.hand
