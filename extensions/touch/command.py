"""The command ``touch-test``."""

from __future__ import annotations

from dataclasses import field
from pathlib import Path

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option, json_option


@options
class TouchTestArguments:
    """Arguments of ``glovetrack touch-test``."""

    sessions: tuple[Path, ...] = field(
        metadata=argument(
            "session of a touch test; several of one person, who puts the glove on again for "
            "each, give the repeatability",
            metavar="SESSION",
        )
    )
    output: Path = field(
        metadata=argument(
            "the HTML page; for one session, a PDF file of the same name is written next to it",
            "-o",
            "--output",
            metavar="REPORT.html",
        )
    )
    ruler: float | None = field(
        default=None,
        metadata=argument(
            "length of the printed line of 260 mm, measured with a ruler (default: the length "
            "entered in the window; without it, the camera's scale is assumed to be correct)",
            metavar="MM",
        ),
    )
    side: str = field(default="", metadata=argument("left or right, of a session of both hands"))
    json: str | None = json_option()
    force: bool = force_option()


TOUCH_TEST = Command(
    "touch-test",
    "report how accurate the fingertips of a recorded touch test are",
    deferred("extensions.touch.command_runs:touch_test"),
    options=TouchTestArguments,
)


@options
class EvaluateTouchArguments:
    """Arguments of ``glovetrack evaluate touch``."""

    wearers: int = field(
        default=20, metadata=argument("number of wearers (default: 20)", metavar="N")
    )
    engine: str = field(default="chain", metadata=argument("chain or vist"))
    seed: int = field(default=1, metadata=argument("random seed of the first wearer"))
    processes: int = field(
        default=1, metadata=argument("number of worker processes (default: 1)", metavar="N")
    )
    json: str | None = json_option()
    force: bool = force_option()


EVALUATE = Command(
    "evaluate touch",
    "let simulated wearers take the touch test; compare its figures with the true error",
    deferred("extensions.touch.simulated.command:evaluate_touch"),
    options=EvaluateTouchArguments,
)
