"""The command ``evaluate`` and its sub-commands, which are imported when they run."""

from __future__ import annotations

import argparse
from dataclasses import field
from pathlib import Path

from extensions.evaluation.session_names import SESSIONS
from extensions.evaluation.vist.options import VistOptions
from tracker.base.arguments import INCLUDED, argument, options
from tracker.base.command import Command
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.registry import deferred
from tracker.base.terminal import force_option, json_option

EVALUATE = Command[argparse.Namespace](
    "evaluate", "run the papers' evaluation protocols, or simulate device faults"
)


@options
class Trials:
    """Arguments: how people are tracked, by blobs or also by images, how many at once, and the file
    for the figures."""

    engine: str = field(default="chain", metadata=argument("chain or vist"))
    images: bool = field(default=False, metadata=argument("render images and detect blobs"))
    fps: float = field(
        default=60.0, metadata=argument("frame rate of the camera, Hz (default: 60)")
    )
    seed: int = field(default=0, metadata=argument("random seed of the first person"))
    processes: int = field(
        default=1, metadata=argument("worker processes (default: 1)", metavar="N")
    )
    json: str | None = json_option()
    force: bool = force_option()


@options
class BlobTrials(Trials):
    """The same without images."""

    images: bool = False


@options
class EvaluateEffectsArguments:
    """Arguments of ``glovetrack evaluate effects``."""

    participants: int = field(
        default=4, metadata=argument("number of people (default: 4)", metavar="N")
    )
    seconds: float = field(
        default=20.0, metadata=argument("duration of each (default: 20)", metavar="S")
    )
    short: bool = field(
        default=False, metadata=argument("track only without errors and with all of them")
    )
    trials: Trials = field(metadata=INCLUDED)


EFFECTS = Command(
    "evaluate effects",
    "track hands with the errors of real cameras and IMUs, each alone and all at once",
    deferred("extensions.evaluation.effects.command:evaluate_effects"),
    options=EvaluateEffectsArguments,
)


@options
class EvaluateFaultsArguments:
    """Arguments of ``glovetrack evaluate faults``."""

    count: int = field(default=1000, metadata=argument("number of faults (default: 1000)"))
    seed: int = field(default=1, metadata=argument("random seed"))
    json: str | None = json_option()
    force: bool = force_option()


FAULTS = Command(
    "evaluate faults",
    "inject random faults into a simulated glove and camera and check the tracking",
    deferred("extensions.evaluation.faults.command:evaluate_faults"),
    options=EvaluateFaultsArguments,
)

DURATIONS = (0.2, 0.5, 1.0, 3.0, 10.0)
"""s that the hand is out of view."""


DEVICES = {"ideal": (False,), "real": (True,), "both": (False, True)}
"""By the values of ``--devices``: whether devices have errors, in turn."""


@options
class EvaluateGapsArguments:
    """Arguments of ``glovetrack evaluate gaps``."""

    participants: int = field(
        default=4, metadata=argument("number of people (default: 4)", metavar="N")
    )
    gaps: tuple[float, ...] = field(
        default=DURATIONS,
        metadata=argument(
            "how long the hand is out of view (default: 0.2 0.5 1 3 10)", nargs="+", metavar="S"
        ),
    )
    devices: str = field(
        default="both",
        metadata=argument(
            "without errors, or with those of real devices (default: both in turn)",
            choices=list(DEVICES),
        ),
    )
    trials: BlobTrials = field(metadata=INCLUDED)


GAPS = Command(
    "evaluate gaps",
    "track hands that leave the view for a while and return",
    deferred("extensions.evaluation.gaps.command:evaluate_gaps"),
    options=EvaluateGapsArguments,
)


@options
class EvaluateGesturesArguments:
    """Arguments of ``glovetrack evaluate gestures``."""

    people: int = field(
        default=8, metadata=argument("number of simulated people (default: 8)", metavar="N")
    )
    seconds: float = field(
        default=60.0, metadata=argument("duration of free motion per person (default: 60)")
    )
    seed: int = field(default=1, metadata=argument("random seed of the first person"))
    glove: str = field(default="", metadata=argument("glove name or file"))
    on_truth: bool = field(
        default=False, metadata=argument("use the simulator's truth instead of tracking it")
    )
    motion: tuple[Path, ...] = field(
        default=(),
        metadata=argument(
            "use recorded hand motion instead of simulated people", nargs="+", metavar="FILE"
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


GESTURES = Command(
    "evaluate gestures",
    "score gesture recognition on simulated or recorded hands",
    deferred("extensions.evaluation.gestures.command:evaluate_gestures"),
    options=EvaluateGesturesArguments,
)


def _evaluate_robot(args: EvaluateRobotArguments) -> int:
    """Raises ConfigError if the robot's folder was removed."""
    try:
        from extensions.evaluation.robot.command import evaluate_robot  # deferred: another part
    except ModuleNotFoundError as error:
        if error.name == "mujoco":
            raise
        raise ConfigError(notice("evaluation.no_robot")) from error
    return evaluate_robot(args)


@options
class EvaluateRobotArguments:
    """Arguments of ``glovetrack evaluate robot``."""

    trials: int = field(
        default=10, metadata=argument("number of pick-and-place trials (default: 10)", metavar="N")
    )
    people: int = field(
        default=4,
        metadata=argument("number of people who move at random (default: 4)", metavar="N"),
    )
    seconds: float = field(
        default=20.0, metadata=argument("duration of random motion per person (default: 20)")
    )
    seed: int = field(default=1, metadata=argument("random seed of the first person"))
    side: str = field(
        default="right", metadata=argument("side of the robot hand", choices=("right", "left"))
    )
    model: str = field(
        default="shadow", metadata=argument("robot hand: a name, or the path of an MJCF file")
    )
    json: str | None = json_option()
    force: bool = force_option()


ROBOT = Command(
    "evaluate robot",
    "evaluate a robot hand that follows a wearer and picks up a cube",
    _evaluate_robot,
    options=EvaluateRobotArguments,
    extra="robot",
)

SPEEDS = (0.5, 1.0, 2.0)
"""Peak speeds of the hand, m/s."""


TURNING_DEG = 200.0
"""Peak rate of the camera in the last row, °/s; the hand then moves with the first speed."""


@options
class EvaluateShutterArguments:
    """Arguments of ``glovetrack evaluate shutter``."""

    participants: int = field(
        default=4, metadata=argument("number of people (default: 4)", metavar="N")
    )
    seconds: float = field(
        default=20.0, metadata=argument("duration of each (default: 20)", metavar="S")
    )
    readout_ms: float = field(
        default=18.0,
        metadata=argument(
            "time from the first row's exposure to the last one's (default: 18)", metavar="MS"
        ),
    )
    speeds: tuple[float, ...] = field(
        default=SPEEDS,
        metadata=argument("peak speeds of the hand (default: 0.5 1 2)", nargs="+", metavar="M/S"),
    )
    turning_deg: float = field(
        default=TURNING_DEG,
        metadata=argument(
            "peak rate of the camera in the table's last row, °/s (default: 200; 0: no such row)",
            metavar="DEG",
        ),
    )
    trials: Trials = field(metadata=INCLUDED)


SHUTTER = Command(
    "evaluate shutter",
    "track fast hands, and hands in front of a turning camera, with a rolling shutter",
    deferred("extensions.evaluation.shutter.command:evaluate_shutter"),
    options=EvaluateShutterArguments,
)


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


@options
class EvaluateInertialArguments:
    """Arguments of ``glovetrack evaluate inertial``."""

    json: str | None = json_option()
    force: bool = force_option()
    broad: Path | None = field(
        default=None,
        metadata=argument("folder with recordings of the BROAD data set", metavar="DIR"),
    )
    seeds: int | None = field(
        default=None, metadata=argument("runs per case (default: 5)", type=_count, metavar="N")
    )
    rates: tuple[float, ...] | None = field(
        default=None,
        metadata=argument(
            "sampling rates (default: 100 1000)", type=_rate, nargs="+", metavar="HZ"
        ),
    )
    out: Path | None = field(
        default=None, metadata=argument("folder for figures (PNG)", metavar="DIR")
    )
    quick: bool = field(default=False, metadata=argument("fewer durations and seeds, 100 Hz only"))


INERTIAL = Command(
    "evaluate inertial",
    "estimate finger angles from IMUs, following the protocol of Lemak et al. 2020",
    deferred("extensions.evaluation.inertial.report:evaluate_inertial_command"),
    options=EvaluateInertialArguments,
)


@options
class EvaluateHandsArguments:
    """Arguments of ``glovetrack evaluate hands``."""

    pairs: int = field(
        default=20, metadata=argument("number of pairs of hands (default: 20)", metavar="N")
    )
    seconds: float = field(
        default=20.0, metadata=argument("duration per pair (default: 20)", metavar="S")
    )
    engine: str = field(default="chain", metadata=argument("chain or vist"))
    fps: float = field(
        default=60.0, metadata=argument("frame rate of the camera, Hz (default: 60)")
    )
    session: str = field(
        default="",
        metadata=argument(
            "other sessions: " + ", ".join(f"{name} ({what})" for name, what in SESSIONS.items()),
            choices=("", *SESSIONS),
        ),
    )
    seed: int = field(default=0, metadata=argument("random seed of the first pair"))
    processes: int = field(
        default=1, metadata=argument("number of worker processes (default: 1)", metavar="N")
    )
    json: str | None = json_option()
    force: bool = force_option()


HANDS = Command(
    "evaluate hands",
    "track two simulated hands that cross and occlude each other; compare with each hand alone, "
    "and with each hand occluded by a hand without markers",
    deferred("extensions.evaluation.hands.command:evaluate_hands"),
    options=EvaluateHandsArguments,
)


@options
class EvaluateVistArguments:
    """Arguments of ``glovetrack evaluate vist``."""

    options: VistOptions = field(metadata=INCLUDED)
    json: str | None = json_option()
    force: bool = force_option()
    out: Path | None = field(
        default=None, metadata=argument("folder for figures and an HTML report", metavar="DIR")
    )


VIST = Command(
    "evaluate vist",
    "track simulated hands in the three experiments of Lee et al. 2021",
    deferred("extensions.evaluation.vist.command:run"),
    options=EvaluateVistArguments,
)


@options
class EvaluateFingersArguments:
    """Arguments of ``glovetrack evaluate fingers``."""

    sessions: tuple[str, ...] = field(
        metadata=argument("session with the true hand, as simulated", metavar="SESSION")
    )
    colours: str = field(
        default="",
        metadata=argument(
            "colour profile that includes the glove's cloth (default: the recorded profile)",
            metavar="PROFILE",
        ),
    )
    distal: tuple[str, ...] = field(
        default=(),
        metadata=argument(
            "sessions of the same motion with a glove with patches on the end segments",
            nargs="+",
            metavar="SESSION",
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


FINGERS = Command(
    "evaluate fingers",
    "track sessions with and without the glove's cloth; compare each fingertip with the true hand",
    deferred("extensions.evaluation.fingers.command:evaluate_fingers"),
    options=EvaluateFingersArguments,
)
