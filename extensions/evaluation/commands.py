"""The command ``evaluate`` and its sub-commands, which are imported when they run."""

from __future__ import annotations

import argparse
from pathlib import Path

from extensions.evaluation.session_names import SESSIONS
from extensions.evaluation.trials import add_trials
from extensions.evaluation.vist.options import VistOptions
from tracker.base.arguments import add_options
from tracker.base.command import Command
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.registry import deferred
from tracker.base.terminal import add_json

EVALUATE = Command[argparse.Namespace](
    "evaluate", "run the papers' evaluation protocols, or simulate device faults"
)


def add_effects(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "--participants", type=int, default=4, metavar="N", help="number of people (default: 4)"
    )
    parser.add_argument(
        "--seconds", type=float, default=20.0, metavar="S", help="duration of each (default: 20)"
    )
    parser.add_argument(
        "--short", action="store_true", help="track only without errors and with all of them"
    )
    add_trials(parser)


EFFECTS = Command(
    "evaluate effects",
    "track hands with the errors of real cameras and IMUs, each alone and all at once",
    deferred("extensions.evaluation.effects.command:evaluate_effects"),
    add=add_effects,
)


def add_faults(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument("--count", type=int, default=1000, help="number of faults (default: 1000)")
    parser.add_argument("--seed", type=int, default=1, help="random seed")
    add_json(parser)


FAULTS = Command(
    "evaluate faults",
    "inject random faults into a simulated glove and camera and check the tracking",
    deferred("extensions.evaluation.faults.command:evaluate_faults"),
    add=add_faults,
)


DURATIONS = (0.2, 0.5, 1.0, 3.0, 10.0)
"""s that the hand is out of view."""


DEVICES = {"ideal": (False,), "real": (True,), "both": (False, True)}
"""By the values of ``--devices``: whether devices have errors, in turn."""


def add_gaps(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "--participants", type=int, default=4, metavar="N", help="number of people (default: 4)"
    )
    parser.add_argument(
        "--gaps",
        type=float,
        nargs="+",
        default=list(DURATIONS),
        metavar="S",
        help="how long the hand is out of view (default: 0.2 0.5 1 3 10)",
    )
    parser.add_argument(
        "--devices",
        choices=list(DEVICES),
        default="both",
        help="without errors, or with those of real devices (default: both in turn)",
    )
    add_trials(parser, images=False)


GAPS = Command(
    "evaluate gaps",
    "track hands that leave the view for a while and return",
    deferred("extensions.evaluation.gaps.command:evaluate_gaps"),
    add=add_gaps,
)


def add_gestures(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "--people", type=int, default=8, metavar="N", help="number of simulated people (default: 8)"
    )
    parser.add_argument(
        "--seconds",
        type=float,
        default=60.0,
        help="duration of free motion per person (default: 60)",
    )
    parser.add_argument("--seed", type=int, default=1, help="random seed of the first person")
    parser.add_argument("--glove", default="", help="glove name or file")
    parser.add_argument(
        "--on-truth", action="store_true", help="use the simulator's truth instead of tracking it"
    )
    parser.add_argument(
        "--motion",
        type=Path,
        nargs="+",
        default=[],
        metavar="FILE",
        help="use recorded hand motion instead of simulated people",
    )
    add_json(parser)


GESTURES = Command(
    "evaluate gestures",
    "score gesture recognition on simulated or recorded hands",
    deferred("extensions.evaluation.gestures.command:evaluate_gestures"),
    add=add_gestures,
)


def add_robot(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "--trials",
        type=int,
        default=10,
        metavar="N",
        help="number of pick-and-place trials (default: 10)",
    )
    parser.add_argument(
        "--people",
        type=int,
        default=4,
        metavar="N",
        help="number of people who move at random (default: 4)",
    )
    parser.add_argument(
        "--seconds",
        type=float,
        default=20.0,
        help="duration of random motion per person (default: 20)",
    )
    parser.add_argument("--seed", type=int, default=1, help="random seed of the first person")
    parser.add_argument(
        "--side", choices=("right", "left"), default="right", help="side of the robot hand"
    )
    parser.add_argument(
        "--model", default="shadow", help="robot hand: a name, or the path of an MJCF file"
    )
    add_json(parser)


def _evaluate_robot(args: argparse.Namespace) -> int:
    """Raises ConfigError if the robot's folder was removed."""
    try:
        from extensions.evaluation.robot.command import evaluate_robot  # deferred: another part
    except ModuleNotFoundError as error:
        if error.name == "mujoco":
            raise
        raise ConfigError(notice("evaluation.no_robot")) from error
    return evaluate_robot(args)


ROBOT = Command(
    "evaluate robot",
    "evaluate a robot hand that follows a wearer and picks up a cube",
    _evaluate_robot,
    add=add_robot,
    extra="robot",
)


SPEEDS = (0.5, 1.0, 2.0)
"""Peak speeds of the hand, m/s."""


TURNING_DEG = 200.0
"""Peak rate of the camera in the last row, °/s; the hand then moves with the first speed."""


def add_shutter(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "--participants", type=int, default=4, metavar="N", help="number of people (default: 4)"
    )
    parser.add_argument(
        "--seconds", type=float, default=20.0, metavar="S", help="duration of each (default: 20)"
    )
    parser.add_argument(
        "--readout-ms",
        type=float,
        default=18.0,
        metavar="MS",
        help="time from the first row's exposure to the last one's (default: 18)",
    )
    parser.add_argument(
        "--speeds",
        type=float,
        nargs="+",
        default=list(SPEEDS),
        metavar="M/S",
        help="peak speeds of the hand (default: 0.5 1 2)",
    )
    parser.add_argument(
        "--turning-deg",
        type=float,
        default=TURNING_DEG,
        metavar="DEG",
        help="peak rate of the camera in the table's last row, °/s (default: 200; 0: no such row)",
    )
    add_trials(parser)


SHUTTER = Command(
    "evaluate shutter",
    "track fast hands, and hands in front of a turning camera, with a rolling shutter",
    deferred("extensions.evaluation.shutter.command:evaluate_shutter"),
    add=add_shutter,
)


def add_inertial(p: argparse.ArgumentParser) -> None:
    """Its arguments."""
    add_json(p)
    p.add_argument(
        "--broad", type=Path, metavar="DIR", help="folder with recordings of the BROAD data set"
    )
    p.add_argument("--seeds", type=_count, metavar="N", help="runs per case (default: 5)")
    p.add_argument(
        "--rates", type=_rate, nargs="+", metavar="HZ", help="sampling rates (default: 100 1000)"
    )
    p.add_argument("--out", type=Path, metavar="DIR", help="folder for figures (PNG)")
    p.add_argument("--quick", action="store_true", help="fewer durations and seeds, 100 Hz only")


def _count(text: str) -> int:
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError("must be at least 1")
    return value


def _rate(text: str) -> float:
    value = float(text)
    if not 20 <= value <= 10000:
        raise argparse.ArgumentTypeError("must be between 20 and 10000 Hz")
    return value


INERTIAL = Command(
    "evaluate inertial",
    "estimate finger angles from IMUs, following the protocol of Lemak et al. 2020",
    deferred("extensions.evaluation.inertial.commands:evaluate_inertial_command"),
    add=add_inertial,
)


def add_hands(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "--pairs", type=int, default=20, metavar="N", help="number of pairs of hands (default: 20)"
    )
    parser.add_argument(
        "--seconds", type=float, default=20.0, metavar="S", help="duration per pair (default: 20)"
    )
    parser.add_argument("--engine", default="chain", help="chain or vist")
    parser.add_argument(
        "--fps", type=float, default=60.0, help="frame rate of the camera, Hz (default: 60)"
    )
    parser.add_argument(
        "--session",
        default="",
        choices=("", *SESSIONS),
        help="other sessions: " + ", ".join(f"{name} ({what})" for name, what in SESSIONS.items()),
    )
    parser.add_argument("--seed", type=int, default=0, help="random seed of the first pair")
    parser.add_argument(
        "--processes",
        type=int,
        default=1,
        metavar="N",
        help="number of worker processes (default: 1)",
    )
    add_json(parser)


HANDS = Command(
    "evaluate hands",
    "track two simulated hands that cross and occlude each other; compare with each hand alone, "
    "and with each hand occluded by a hand without markers",
    deferred("extensions.evaluation.hands.command:evaluate_hands"),
    add=add_hands,
)


def add_vist(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    add_options(parser, VistOptions)
    add_json(parser)
    parser.add_argument(
        "--out", type=Path, metavar="DIR", help="folder for figures and an HTML report"
    )


VIST = Command(
    "evaluate vist",
    "track simulated hands in the three experiments of Lee et al. 2021",
    deferred("extensions.evaluation.vist.command:run"),
    add=add_vist,
)


def add_fingers(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "sessions", nargs="+", metavar="SESSION", help="session with the true hand, as simulated"
    )
    parser.add_argument(
        "--colours",
        default="",
        metavar="PROFILE",
        help="colour profile that includes the glove's cloth (default: the recorded profile)",
    )
    parser.add_argument(
        "--distal",
        nargs="+",
        default=[],
        metavar="SESSION",
        help="sessions of the same motion with a glove with patches on the end segments",
    )
    add_json(parser)


FINGERS = Command(
    "evaluate fingers",
    "track sessions with and without the glove's cloth; compare each fingertip with the true hand",
    deferred("extensions.evaluation.fingers.command:evaluate_fingers"),
    add=add_fingers,
)
