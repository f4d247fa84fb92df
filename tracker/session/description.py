"""The description of a session: its models, clock and metadata."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from tracker import __version__
from tracker.base.clock import ClockAnchor
from tracker.glove.files import parse_glove
from tracker.glove.model import GloveModel
from tracker.hand.files import parse_hand
from tracker.hand.model import HandModel
from tracker.session.arithmetic import arithmetic
from tracker.vision.rig import StereoRig

HAND, GLOVE = "hand.toml", "glove.toml"
COLOURS, SETTINGS = "colours.toml", "settings.toml"
METADATA = "glovetrack"
MAIN = "right"
"""The default hand of a session of both."""


def of_side(name: str, side: str) -> str:
    """Returns an attachment's name in a session of both hands: ``hand_left.toml``."""
    stem, _, ending = name.partition(".")
    return f"{stem}_{side}.{ending}"


@dataclass(frozen=True, eq=False)
class SessionInfo:
    """``moving_camera``: frames have their own poses and ``rig.pose`` is not used.

    ``arithmetic`` is that of the computer that made the estimates, empty if unknown. ``hues`` are
    the names that blobs' hues index; by default the glove's. ``extra`` is added to the metadata
    record unchanged (for example a tracked file's ``source``). ``others`` are the session's other
    hands, of which only hand and glove are used.
    """

    hand: HandModel
    glove: GloveModel
    hand_text: str
    glove_text: str
    anchor: ClockAnchor
    rig: StereoRig | None = None
    moving_camera: bool = False
    colours_text: str | None = None
    settings_text: str | None = None
    engine: str = "chain"
    version: str = __version__
    participant: str = ""
    notes: str = ""
    simulated: bool = False
    hues: tuple[str, ...] = ()
    arithmetic: str = field(default_factory=arithmetic)
    extra: dict[str, str] = field(default_factory=dict)
    others: tuple[SessionInfo, ...] = ()

    @property
    def hands(self) -> tuple[SessionInfo, ...]:
        """The descriptions of all hands, the left one first."""
        return tuple(sorted((self, *self.others), key=lambda info: info.side))

    @property
    def side(self) -> str:
        return self.glove.side

    @property
    def hue_names(self) -> tuple[str, ...]:
        return self.hues or self.glove.hues

    @property
    def keypoint_names(self) -> tuple[str, ...]:
        """Rows of ``Estimate.keypoints``."""
        return self.glove.keypoint_names(self.hand)

    def attachments(self) -> dict[str, str]:
        """Returns the text of each attachment by its file name."""
        texts: dict[str, str | None] = {COLOURS: self.colours_text, SETTINGS: self.settings_text}
        for info in self.hands:
            for name, text in ((HAND, info.hand_text), (GLOVE, info.glove_text)):
                texts[of_side(name, info.side) if self.others else name] = text
        return {name: text for name, text in texts.items() if text is not None}

    def metadata(self) -> dict[str, str]:
        """Returns the metadata record ``glovetrack``: all strings."""
        return {
            "version": self.version,
            "engine": self.engine,
            "arithmetic": self.arithmetic,
            "wall_clock_ns": str(self.anchor.wall_ns),
            "monotonic_ns": str(self.anchor.monotonic_ns),
            "participant": self.participant,
            "notes": self.notes,
            "simulated": "true" if self.simulated else "false",
            "hues": ",".join(self.hue_names),
            **self.extra,
        }


def of_hands(infos: Sequence[SessionInfo]) -> SessionInfo:
    """Combines the descriptions of one or both hands; shared values are those of the main one."""
    main = next((info for info in infos if info.side == MAIN), infos[0])
    return replace(main, others=tuple(info for info in infos if info is not main))


def describe(hand_text: str, glove_text: str, anchor: ClockAnchor, **more: object) -> SessionInfo:
    """Returns a SessionInfo with the models read from their texts; ``more``: its other fields."""
    hand = parse_hand(hand_text)
    glove = parse_glove(glove_text, hand)
    return SessionInfo(hand, glove, hand_text, glove_text, anchor, **more)  # type: ignore[arg-type]
