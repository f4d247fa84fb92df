"""The commands ``simulate``, ``track``, ``crop``, ``light`` and ``colours``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.arguments import add_options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import add_force, add_json
from tracker.offline.options import SimulateOptions, TrackOptions


def _add_simulate(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("-o", "--out", type=Path, required=True, help="the new session (.mcap)")
    add_options(parser, SimulateOptions)
    add_force(parser)


def _add_track(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "sources", type=Path, nargs="+", metavar="IN", help="sessions or folders of sessions"
    )
    parser.add_argument(
        "-o",
        "--out",
        type=Path,
        required=True,
        help="the new session; for several inputs, a folder",
    )
    add_options(parser, TrackOptions)
    add_json(parser)
    parser.add_argument(
        "--jobs", type=int, metavar="N", help="number of worker processes (default: one per core)"
    )
    parser.add_argument("--dask", default="", metavar="ADDRESS", help="run on this Dask cluster")


def _add_crop(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", type=Path, metavar="IN", help="session file")
    parser.add_argument("-o", "--out", type=Path, required=True, help="the new session")
    parser.add_argument(
        "--start",
        type=float,
        default=0.0,
        metavar="S",
        help="start, in seconds from the beginning (default: 0)",
    )
    parser.add_argument(
        "--stop",
        type=float,
        default=None,
        metavar="S",
        help="end, in seconds from the beginning (default: the end)",
    )
    add_json(parser)


def _add_light(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, metavar="FILE", help="session with images")
    parser.add_argument(
        "--colours", default="", help="colour profile name or file (default: the session's profile)"
    )
    add_json(parser)


def _add_colours_fit(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "-o", "--out", type=Path, required=True, help="the new colour profile (.toml)"
    )
    _add_coloured(parser)
    add_force(parser)


def _add_colours_check(parser: argparse.ArgumentParser) -> None:
    _add_coloured(parser)
    add_json(parser)


def _add_coloured(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", type=Path, metavar="SESSION", help="session with images")
    parser.add_argument(
        "--colours", default="", help="colour profile name or file (default: the session's profile)"
    )


SIMULATE = Command(
    "simulate",
    "simulate a session with known truth",
    deferred("tracker.offline.command_runs:run_simulate"),
    add=_add_simulate,
)


TRACK = Command(
    "track",
    "track a recorded session again",
    deferred("tracker.offline.command_runs:run_track"),
    add=_add_track,
)


CROP = Command(
    "crop",
    "copy part of a session to a new session",
    deferred("tracker.offline.command_runs:run_crop"),
    add=_add_crop,
)


LIGHT = Command(
    "light",
    "assess the lighting of a recording and suggest improvements",
    deferred("tracker.offline.command_runs:run_light"),
    add=_add_light,
)


COLOURS = Command[argparse.Namespace]("colours", "fit colours to a recording, or check them")


COLOURS_FIT = Command(
    "colours fit",
    "fit colours to the images of a recording",
    deferred("tracker.offline.command_runs:run_fit_colours"),
    add=_add_colours_fit,
)


COLOURS_CHECK = Command(
    "colours check",
    "report found, missed and conflicting markers of each hue",
    deferred("tracker.offline.command_runs:run_check_colours"),
    add=_add_colours_check,
)


def _add_gaps(gaps: argparse.ArgumentParser) -> None:
    gaps.add_argument("source", type=Path, metavar="SESSION", help="session file")
    _add_limit(gaps)
    add_json(gaps)


def _add_fill(fill: argparse.ArgumentParser) -> None:
    fill.add_argument("source", type=Path, metavar="SESSION", help="session file")
    fill.add_argument("-o", "--out", type=Path, required=True, help="the new session")
    fill.add_argument(
        "--max-gap", type=float, default=0.2, metavar="S", help="longest gap to fill (default: 0.2)"
    )
    fill.add_argument(
        "--method",
        default="linear",
        choices=("linear", "cubic", "smooth"),
        help="linear: straight lines and great arcs; cubic: also matches the speeds at both "
        "ends; smooth: tracks the session's sensor data again and smooths the result",
    )
    fill.add_argument(
        "--kinds",
        default="hole,lost",
        metavar="A,B",
        help="kinds of gaps to fill: hole (no estimates), lost, inferred (default: hole,lost)",
    )
    fill.add_argument(
        "--gaps",
        type=Path,
        metavar="FILE",
        help="fill only gaps listed in this output of `gaps --json`",
    )
    fill.add_argument(
        "--by", default="", metavar="NAME", help="name of the editor (default: the current user)"
    )
    _add_limit(fill)
    add_json(fill)


def _add_limit(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--inferred",
        type=float,
        default=0.5,
        metavar="S",
        help="treat points inferred for longer than this as gaps (default: 0.5)",
    )


GAPS = Command(
    "gaps",
    "list where and why a hand is not measured",
    deferred("tracker.offline.gap_commands:run_gaps"),
    add=_add_gaps,
)


FILL = Command(
    "fill",
    "interpolate gaps of a session and save the result as a new session",
    deferred("tracker.offline.gap_commands:run_fill"),
    add=_add_fill,
)


def _add(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "session",
        type=Path,
        metavar="SESSION",
        help="recording of the glove alone in free motion, two minutes",
    )
    parser.add_argument(
        "--set", type=Path, metavar="OUT", dest="target", help="write the fitted glove file"
    )
    parser.add_argument(
        "--name", metavar="NAME", help="save it as your own glove NAME, for --glove NAME"
    )
    add_json(parser)


FIT_GLOVE = Command[argparse.Namespace](
    "fit-glove",
    "fit a glove file to a glove: marker positions and IMU mountings",
    deferred("tracker.offline.fit_glove_command:run"),
    add=_add,
    description="Measures from a recording of free motion where the markers and IMUs of this "
    "glove are, with standard deviations, and writes a copy of its glove file. Record one hand in "
    "front of a stereo camera for two minutes: bend and stretch all fingers and the thumb, and "
    "show the hand from all sides.",
)


def _add_rig(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("folder", type=Path, help="folder for the device files and camera.yml")
    parser.add_argument(
        "--hands",
        choices=("right", "left", "both"),
        default="right",
        help="hands with a glove; if both, the devices are glove_left and glove_right",
    )
    parser.add_argument(
        "--lenses",
        choices=("one", "both", "apart"),
        default="both",
        help="one or both lenses in one stream; apart: two cameras, camera_left.mjpeg and "
        "camera_right.mjpeg, the right one with smaller images",
    )
    parser.add_argument(
        "--right-late-ms",
        type=float,
        default=0.0,
        metavar="MS",
        help="with --lenses apart: delay of the right camera's exposure",
    )
    parser.add_argument(
        "--camera-errors",
        default="all",
        metavar="LIST",
        help="errors of the camera, all (default), none, or a list of lenses, calibration, "
        "shutter, stamps and flicker",
    )
    parser.add_argument(
        "--board", action="store_true", help="start with a calibration board in front of the camera"
    )
    parser.add_argument(
        "--led",
        action="store_true",
        help="show an LED in place of the first motor in the images, for `glovetrack loop-back`",
    )
    parser.add_argument(
        "--fps", type=float, default=30.0, help="frame rate of the camera, Hz (default: 30)"
    )
    parser.add_argument("--seed", type=int, default=1, help="random seed of the wearer")
    parser.add_argument("--duration", type=float, metavar="S", help="stop after this time")
    add_force(parser)
    parser.epilog = (
        "Commands on standard input: 'unplug left' and 'plug left' (or right) disconnect and "
        "reconnect a glove; 'fault right KIND' starts an electrical fault (brown-out, flexed "
        "cable, loose select, motor reset, usb suspend, wrong baud, port busy, port denied) and "
        "'fault right' ends it; 'board' shows a calibration board to the camera, 'hand' the hand."
    )


RIG = Command(
    "rig",
    "simulate a glove and a camera as devices of this computer",
    deferred("tracker.offline.rig_command:run_rig"),
    add=_add_rig,
)


def _add_line_time(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "session", type=Path, metavar="SESSION", help="recording of a hand that moves fast"
    )
    parser.add_argument(
        "--set",
        type=Path,
        metavar="OUT",
        dest="target",
        help="write the recording's camera calibration with this line time",
    )
    add_json(parser)


LINE_TIME = Command[argparse.Namespace](
    "line-time",
    "estimate the line time of a camera with a rolling shutter from a recording",
    deferred("tracker.offline.line_time_command:run"),
    add=_add_line_time,
    description="Tracks the recording with several readout times and finds the one with which "
    "markers are nearest to their predictions, together with the time offset of the camera. Swing "
    "the hand in all directions in front of the camera for 20 s, as fast as possible "
    "without leaving the view.",
)


def _add_imu_noise(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "session",
        type=Path,
        metavar="SESSION",
        help="recording of a glove at rest, 1 minute or more",
    )
    parser.add_argument(
        "-o", "--out", type=Path, metavar="CSV", help="write the Allan deviations as a table"
    )
    parser.add_argument(
        "--glove", type=Path, metavar="FILE", help="glove file to start from (with --set)"
    )
    parser.add_argument(
        "--set", type=Path, metavar="OUT", dest="target", help="write a copy of it with the noise"
    )
    add_json(parser)


IMU_NOISE = Command[argparse.Namespace](
    "imu-noise",
    "measure the noise of a glove's IMUs from a recording at rest",
    deferred("tracker.offline.imu_noise_command:run"),
    add=_add_imu_noise,
    description="Computes the Allan deviation of the longest rest in a recording, fits white "
    "noise, bias instability and random walk, and can write them into a glove file. A recording of "
    "ten minutes on a table gives the bias instability to about 20 percent.",
)


def _add_axes(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "session", type=Path, metavar="SESSION", help="recording of a glove at rest in 6 positions"
    )
    _add_files(parser)


def _add_drift(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "sessions",
        type=Path,
        nargs="+",
        metavar="SESSION",
        help="recordings with temperatures, each with rests of three seconds or more",
    )
    _add_files(parser)


def _add_files(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--glove", type=Path, metavar="FILE", help="glove file to start from (with --set)"
    )
    parser.add_argument(
        "--set", type=Path, metavar="OUT", dest="target", help="write a copy of it with the result"
    )
    add_json(parser)


IMU_AXES = Command[argparse.Namespace](
    "imu-axes",
    "estimate scale and cross-axis errors of a glove's IMUs from rests in several positions",
    deferred("tracker.offline.imu_values_command:run_axes"),
    add=_add_axes,
    description="Fasten the glove to a box, record, and lay the box on each of its six sides and "
    "on some edges, with two seconds of rest each. Gravity gives the accelerometers' errors, and "
    "the rotations between the rests those of the gyroscopes.",
)


IMU_DRIFT = Command[argparse.Namespace](
    "imu-drift",
    "learn how the biases of a glove's IMUs change with the temperature",
    deferred("tracker.offline.imu_values_command:run_drift"),
    add=_add_drift,
    description="Uses the rests in recordings of a glove that reports its temperatures (firmware "
    "1.3). Earlier results in the glove file are improved by further recordings.",
)


def _add_import(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "sources", type=Path, nargs="+", metavar="IN", help="CSV or .mat files, or x-IMU3 folders"
    )
    parser.add_argument("-o", "--out", type=Path, required=True, help="the new session (.mcap)")
    parser.add_argument("--glove", default="", help="glove name or file")
    parser.add_argument(
        "--hand", default="", help="hand name or file (default: the hand of the glove file)"
    )
    parser.add_argument(
        "--imu",
        action="append",
        default=[],
        metavar="GLOVE=FILE",
        help="assign a file to an IMU of the glove, such as dorsum=hand_right; can be repeated",
    )
    add_json(parser)


IMPORT = Command(
    "import",
    "create a session from another program's raw IMU data",
    deferred("tracker.offline.imports.command:run_import"),
    add=_add_import,
)
