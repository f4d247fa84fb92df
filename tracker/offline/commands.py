"""The commands ``simulate``, ``track``, ``crop``, ``light`` and ``colours``."""

from __future__ import annotations

import argparse
from dataclasses import field
from pathlib import Path

from tracker.base.arguments import INCLUDED, argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option, json_option
from tracker.offline.options import SimulateOptions, TrackOptions


@options
class SimulateArguments:
    """Arguments of ``glovetrack simulate``."""

    out: Path = field(metadata=argument("the new session (.mcap)", "-o", "--out"))
    options: SimulateOptions = field(metadata=INCLUDED)
    force: bool = force_option()


SIMULATE = Command(
    "simulate",
    "simulate a session with known truth",
    deferred("tracker.offline.command_runs:run_simulate"),
    options=SimulateArguments,
)


@options
class TrackArguments:
    """Arguments of ``glovetrack track``."""

    sources: tuple[Path, ...] = field(
        metadata=argument("sessions or folders of sessions", metavar="IN")
    )
    out: Path = field(
        metadata=argument("the new session; for several inputs, a folder", "-o", "--out")
    )
    options: TrackOptions = field(metadata=INCLUDED)
    json: str | None = json_option()
    force: bool = force_option()
    jobs: int | None = field(
        default=None,
        metadata=argument("number of worker processes (default: one per core)", metavar="N"),
    )
    dask: str = field(default="", metadata=argument("run on this Dask cluster", metavar="ADDRESS"))


TRACK = Command(
    "track",
    "track a recorded session again",
    deferred("tracker.offline.command_runs:run_track"),
    options=TrackArguments,
)


@options
class CropArguments:
    """Arguments of ``glovetrack crop``."""

    source: Path = field(metadata=argument("session file", metavar="IN"))
    out: Path = field(metadata=argument("the new session", "-o", "--out"))
    start: float = field(
        default=0.0,
        metadata=argument("start, in seconds from the beginning (default: 0)", metavar="S"),
    )
    stop: float | None = field(
        default=None,
        metadata=argument("end, in seconds from the beginning (default: the end)", metavar="S"),
    )
    json: str | None = json_option()
    force: bool = force_option()


CROP = Command(
    "crop",
    "copy part of a session to a new session",
    deferred("tracker.offline.command_runs:run_crop"),
    options=CropArguments,
)


@options
class LightArguments:
    """Arguments of ``glovetrack light``."""

    file: Path = field(metadata=argument("session with images", metavar="FILE"))
    colours: str = field(
        default="",
        metadata=argument("colour profile name or file (default: the session's profile)"),
    )
    json: str | None = json_option()
    force: bool = force_option()


LIGHT = Command(
    "light",
    "assess the lighting of a recording and suggest improvements",
    deferred("tracker.offline.command_runs:run_light"),
    options=LightArguments,
)

COLOURS = Command[argparse.Namespace]("colours", "fit colours to a recording, or check them")


@options
class ColoursFitArguments:
    """Arguments of ``glovetrack colours fit``."""

    out: Path = field(metadata=argument("the new colour profile (.toml)", "-o", "--out"))
    source: Path = field(metadata=argument("session with images", metavar="SESSION"))
    colours: str = field(
        default="",
        metadata=argument("colour profile name or file (default: the session's profile)"),
    )
    force: bool = force_option()


COLOURS_FIT = Command(
    "colours fit",
    "fit colours to the images of a recording",
    deferred("tracker.offline.command_runs:run_fit_colours"),
    options=ColoursFitArguments,
)


@options
class ColoursCheckArguments:
    """Arguments of ``glovetrack colours check``."""

    source: Path = field(metadata=argument("session with images", metavar="SESSION"))
    colours: str = field(
        default="",
        metadata=argument("colour profile name or file (default: the session's profile)"),
    )
    json: str | None = json_option()
    force: bool = force_option()


COLOURS_CHECK = Command(
    "colours check",
    "report found, missed and conflicting markers of each hue",
    deferred("tracker.offline.command_runs:run_check_colours"),
    options=ColoursCheckArguments,
)


@options
class GapsArguments:
    """Arguments of ``glovetrack gaps``."""

    source: Path = field(metadata=argument("session file", metavar="SESSION"))
    inferred: float = field(
        default=0.5,
        metadata=argument(
            "treat points inferred for longer than this as gaps (default: 0.5)", metavar="S"
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


GAPS = Command(
    "gaps",
    "list where and why a hand is not measured",
    deferred("tracker.offline.gap_commands:run_gaps"),
    options=GapsArguments,
)


@options
class FillArguments:
    """Arguments of ``glovetrack fill``."""

    source: Path = field(metadata=argument("session file", metavar="SESSION"))
    out: Path = field(metadata=argument("the new session", "-o", "--out"))
    max_gap: float = field(
        default=0.2, metadata=argument("longest gap to fill (default: 0.2)", metavar="S")
    )
    method: str = field(
        default="linear",
        metadata=argument(
            "linear: straight lines and great arcs; cubic: also matches the speeds at both "
            "ends; smooth: tracks the session's sensor data again and smooths the result",
            choices=("linear", "cubic", "smooth"),
        ),
    )
    kinds: str = field(
        default="hole,lost",
        metadata=argument(
            "kinds of gaps to fill: hole (no estimates), lost, inferred (default: hole,lost)",
            metavar="A,B",
        ),
    )
    gaps: Path | None = field(
        default=None,
        metadata=argument("fill only gaps listed in this output of `gaps --json`", metavar="FILE"),
    )
    by: str = field(
        default="",
        metadata=argument("name of the editor (default: the current user)", metavar="NAME"),
    )
    inferred: float = field(
        default=0.5,
        metadata=argument(
            "treat points inferred for longer than this as gaps (default: 0.5)", metavar="S"
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


FILL = Command(
    "fill",
    "interpolate gaps of a session and save the result as a new session",
    deferred("tracker.offline.gap_commands:run_fill"),
    options=FillArguments,
)


@options
class FitGloveArguments:
    """Arguments of ``glovetrack fit-glove``."""

    session: Path = field(
        metadata=argument(
            "recording of the glove alone in free motion, two minutes", metavar="SESSION"
        )
    )
    target: Path | None = field(
        default=None, metadata=argument("write the fitted glove file", "--set", metavar="OUT")
    )
    name: str | None = field(
        default=None,
        metadata=argument("save it as your own glove NAME, for --glove NAME", metavar="NAME"),
    )
    json: str | None = json_option()
    force: bool = force_option()


FIT_GLOVE = Command(
    "fit-glove",
    "fit a glove file to a glove: marker positions and IMU mountings",
    deferred("tracker.offline.fit_glove:run"),
    options=FitGloveArguments,
    description="Measures from a recording of free motion where the markers and IMUs of this "
    "glove are, with standard deviations, and writes a copy of its glove file. Record one hand in "
    "front of a stereo camera for two minutes: bend and stretch all fingers and the thumb, and "
    "show the hand from all sides.",
)


@options
class RigArguments:
    """Arguments of ``glovetrack rig``."""

    folder: Path = field(metadata=argument("folder for the device files and camera.yml"))
    hands: str = field(
        default="right",
        metadata=argument(
            "hands with a glove; if both, the devices are glove_left and glove_right",
            choices=("right", "left", "both"),
        ),
    )
    lenses: str = field(
        default="both",
        metadata=argument(
            "one or both lenses in one stream; apart: two cameras, camera_left.mjpeg and "
            "camera_right.mjpeg, the right one with smaller images",
            choices=("one", "both", "apart"),
        ),
    )
    right_late_ms: float = field(
        default=0.0,
        metadata=argument(
            "with --lenses apart: delay of the right camera's exposure", metavar="MS"
        ),
    )
    camera_errors: str = field(
        default="all",
        metadata=argument(
            "errors of the camera, all (default), none, or a list of lenses, calibration, "
            "shutter, stamps and flicker",
            metavar="LIST",
        ),
    )
    board: bool = field(
        default=False, metadata=argument("start with a calibration board in front of the camera")
    )
    led: bool = field(
        default=False,
        metadata=argument(
            "show an LED in place of the first motor in the images, for `glovetrack loop-back`"
        ),
    )
    fps: float = field(
        default=30.0, metadata=argument("frame rate of the camera, Hz (default: 30)")
    )
    seed: int = field(default=1, metadata=argument("random seed of the wearer"))
    duration: float | None = field(
        default=None, metadata=argument("stop after this time", metavar="S")
    )
    force: bool = force_option()


RIG = Command(
    "rig",
    "simulate a glove and a camera as devices of this computer",
    deferred("tracker.offline.rig_command:run_rig"),
    options=RigArguments,
    epilog="Commands on standard input: 'unplug left' and 'plug left' (or right) disconnect and "
    "reconnect a glove; 'fault right KIND' starts an electrical fault (brown-out, flexed "
    "cable, loose select, motor reset, usb suspend, wrong baud, port busy, port denied) and "
    "'fault right' ends it; 'board' shows a calibration board to the camera, 'hand' the hand.",
)


@options
class LineTimeArguments:
    """Arguments of ``glovetrack line-time``."""

    session: Path = field(
        metadata=argument("recording of a hand that moves fast", metavar="SESSION")
    )
    target: Path | None = field(
        default=None,
        metadata=argument(
            "write the recording's camera calibration with this line time", "--set", metavar="OUT"
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


LINE_TIME = Command(
    "line-time",
    "estimate the line time of a camera with a rolling shutter from a recording",
    deferred("tracker.offline.line_time:run"),
    options=LineTimeArguments,
    description="Tracks the recording with several readout times and finds the one with which "
    "markers are nearest to their predictions, together with the time offset of the camera. Swing "
    "the hand in all directions in front of the camera for 20 s, as fast as possible "
    "without leaving the view.",
)


@options
class ImuNoiseArguments:
    """Arguments of ``glovetrack imu-noise``."""

    session: Path = field(
        metadata=argument("recording of a glove at rest, 1 minute or more", metavar="SESSION")
    )
    out: Path | None = field(
        default=None,
        metadata=argument("write the Allan deviations as a table", "-o", "--out", metavar="CSV"),
    )
    glove: Path | None = field(
        default=None, metadata=argument("glove file to start from (with --set)", metavar="FILE")
    )
    target: Path | None = field(
        default=None, metadata=argument("write a copy of it with the noise", "--set", metavar="OUT")
    )
    json: str | None = json_option()
    force: bool = force_option()


IMU_NOISE = Command(
    "imu-noise",
    "measure the noise of a glove's IMUs from a recording at rest",
    deferred("tracker.offline.imu_noise:run"),
    options=ImuNoiseArguments,
    description="Computes the Allan deviation of the longest rest in a recording, fits white "
    "noise, bias instability and random walk, and can write them into a glove file. A recording of "
    "ten minutes on a table gives the bias instability to about 20 percent.",
)


@options
class ImuAxesArguments:
    """Arguments of ``glovetrack imu-axes``."""

    session: Path = field(
        metadata=argument("recording of a glove at rest in 6 positions", metavar="SESSION")
    )
    glove: Path | None = field(
        default=None, metadata=argument("glove file to start from (with --set)", metavar="FILE")
    )
    target: Path | None = field(
        default=None,
        metadata=argument("write a copy of it with the result", "--set", metavar="OUT"),
    )
    json: str | None = json_option()
    force: bool = force_option()


IMU_AXES = Command(
    "imu-axes",
    "estimate scale and cross-axis errors of a glove's IMUs from rests in several positions",
    deferred("tracker.offline.imu_values:run_axes"),
    options=ImuAxesArguments,
    description="Fasten the glove to a box, record, and lay the box on each of its six sides and "
    "on some edges, with two seconds of rest each. Gravity gives the accelerometers' errors, and "
    "the rotations between the rests those of the gyroscopes.",
)


@options
class ImuDriftArguments:
    """Arguments of ``glovetrack imu-drift``."""

    sessions: tuple[Path, ...] = field(
        metadata=argument(
            "recordings with temperatures, each with rests of three seconds or more",
            metavar="SESSION",
        )
    )
    glove: Path | None = field(
        default=None, metadata=argument("glove file to start from (with --set)", metavar="FILE")
    )
    target: Path | None = field(
        default=None,
        metadata=argument("write a copy of it with the result", "--set", metavar="OUT"),
    )
    json: str | None = json_option()
    force: bool = force_option()


IMU_DRIFT = Command(
    "imu-drift",
    "learn how the biases of a glove's IMUs change with the temperature",
    deferred("tracker.offline.imu_values:run_drift"),
    options=ImuDriftArguments,
    description="Uses the rests in recordings of a glove that reports its temperatures (firmware "
    "1.3). Earlier results in the glove file are improved by further recordings.",
)


@options
class ImportArguments:
    """Arguments of ``glovetrack import``."""

    sources: tuple[Path, ...] = field(
        metadata=argument("CSV or .mat files, or x-IMU3 folders", metavar="IN")
    )
    out: Path = field(metadata=argument("the new session (.mcap)", "-o", "--out"))
    glove: str = field(default="", metadata=argument("glove name or file"))
    hand: str = field(
        default="", metadata=argument("hand name or file (default: the hand of the glove file)")
    )
    imu: tuple[str, ...] = field(
        default=(),
        metadata=argument(
            "assign a file to an IMU of the glove, such as dorsum=hand_right; can be repeated",
            action="append",
            metavar="GLOVE=FILE",
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


IMPORT = Command(
    "import",
    "create a session from another program's raw IMU data",
    deferred("tracker.offline.imports.run:run_import"),
    options=ImportArguments,
)
