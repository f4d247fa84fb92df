"""Options of `glovetrack evaluate vist`; fast to import."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tracker.base.arguments import argument

ENGINES_OF = {"both": ("chain", "vist"), "one": ("chain",), "none": ("inertial",)}
"""Default engines for these lenses."""


def _names(text: str) -> tuple[str, ...]:
    return tuple(word for word in text.split(",") if word)


def _number(kind: Callable[[str], float], low: float) -> Callable[[str], Any]:
    def read(text: str) -> float:
        try:
            value = kind(text)
        except ValueError:
            raise argparse.ArgumentTypeError(f"{text!r} is not a number") from None
        if not low <= value < float("inf"):
            raise argparse.ArgumentTypeError(f"{text} is too small")
        return value

    return read


_count = _number(int, 1)
_positive = _number(float, 0.1)


def _list(help: str, default: tuple[str, ...], metavar: str = "A,B") -> tuple[str, ...]:
    """A field for an option with a comma-separated list."""
    how = argument(help, type=_names, nargs=None, metavar=metavar)
    return field(default=default, metadata=how)


@dataclass(frozen=True)
class VistOptions:
    """Cases, and the number and length of their trials."""

    participants: int = field(
        default=15,
        metadata=argument(
            "number of simulated participants (default: 15)", type=_count, metavar="N"
        ),
    )
    minutes: float | None = field(
        default=None,
        metadata=argument(
            "duration of each trial (default: 3, 2 and 2)", type=_positive, metavar="M"
        ),
    )
    engines: tuple[str, ...] = _list(
        "engines to evaluate (default: chain and vist; with one lens, chain; without a camera, "
        "inertial)",
        (),
    )
    lenses: str = field(
        default="both",
        metadata=argument(
            "lenses of the camera; without a camera, errors are those of joint angles and of joint "
            "positions relative to the dorsum",
            choices=tuple(ENGINES_OF),
        ),
    )
    measured: bool = field(
        default=False, metadata=argument("the hand lengths are known from a ruler (sd 2 mm)")
    )
    all_keypoints: bool = field(
        default=False,
        metadata=argument(
            "print error, standard deviation and their agreement for each keypoint of the hand"
        ),
    )
    experiments: tuple[str, ...] = _list(
        "free, object, device (from the paper) and head, a camera worn on the head (default: "
        "free,object,device)",
        ("free", "object", "device"),
    )
    level: str = field(
        default="points",
        metadata=argument(
            "simulate marker positions in the images, or whole images",
            choices=("points", "images"),
        ),
    )
    lights: tuple[str, ...] = _list(
        "with --level images: repeat each experiment over a desk in these lights (default: all "
        "four)",
        ("window", "lamp", "led", "dim"),
        "A,B|none",
    )
    ablations: tuple[str, ...] = _list("variants of the engines to evaluate as well", (), "A,B|all")
    guided: bool = field(
        default=False,
        metadata=argument(
            "add free motion after guided poses: not announced, announced, held badly, and from "
            "another session; also with markers on the fingertips"
        ),
    )
    sessions: tuple[str, ...] = _list(
        "add the first experiment with: unusual (people, fit of the glove and cloth vary twice as "
        "much), away (out of view for 5 s of each 15 s), exchanged (red called blue)",
        (),
        "A,B|all",
    )
    smoothed: bool = field(
        default=False,
        metadata=argument("add each row of the engine chain smoothed over the whole trial"),
    )
    wearer: Path | None = field(
        default=None,
        metadata=argument("wearer's profile that every participant starts with", metavar="FILE"),
    )
    fps: float = field(
        default=60.0,
        metadata=argument("frame rate of the camera, Hz (default: 60)", type=_positive),
    )
    distractors: int = field(default=0, metadata=argument("number of coloured balls in the room"))
    seed: int = field(default=0, metadata=argument("random seed"))
    processes: int = field(
        default=1,
        metadata=argument("number of worker processes (default: 1)", type=_count, metavar="N"),
    )
    quick: bool = field(default=False, metadata=argument("two participants, 21 s each"))
    keep: Path | None = field(
        default=None,
        metadata=argument(
            "save finished trials in this folder; an interrupted run resumes from them",
            metavar="DIR",
        ),
    )
    motion: tuple[Path, ...] = field(
        default=(),
        metadata=argument(
            "recorded hand motion to use instead of simulated motion", nargs="+", metavar="FILE"
        ),
    )
