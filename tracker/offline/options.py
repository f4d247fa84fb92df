"""Options of simulating a session and of tracking one again, for the API and the command line.

Quick to import.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from tracker.base.arguments import argument, thousandths
from tracker.base.registry import names_of

USUAL = "usual"  # instead of a settings file: the defaults of this version
LENSES_BY_NUMBER = {"2": "both", "1": "one", "0": "none"}
"""Alternative values of `SimulateOptions.lenses` on the command line."""


@dataclass(frozen=True)
class SimulateOptions:
    """What to simulate."""

    glove: str = field(
        default="",
        metadata=argument("glove name or file (default: the standard glove for that side)"),
    )
    hand: str = field(
        default="", metadata=argument("hand name or file (default: the hand of the glove file)")
    )
    motion: str = field(
        default="",
        metadata=argument(
            "recorded hand motion (Qualisys TSV, Leap or BVH file), or motion for an application: "
            "show:touch, show:arm, show:swarm or show:place (default: random postures)"
        ),
    )
    seed: int = field(default=0, metadata=argument("random seed"))
    duration: float = field(default=60.0, metadata=argument("duration in seconds (default: 60)"))
    fps: float = field(
        default=60.0, metadata=argument("frame rate of the camera, Hz (default: 60)")
    )
    images: bool = field(
        default=True, metadata=argument("write blobs instead of images", "--blobs-only")
    )
    jpeg_quality: int = 90
    scene: str = field(
        default="plain",
        metadata=argument(
            "background; desk also simulates the room lighting and the camera's noise and blur",
            choices=("plain", "painted", "photo", "desk", *names_of("scenes")),
        ),
    )
    photo: str = field(
        default="", metadata=argument("background image for --scene photo", metavar="FILE")
    )
    light: str = field(
        default="",
        metadata=argument(
            "lighting of the desk: daylight from a window (default), a 2700 K lamp, LEDs, or a "
            "dim room",
            choices=("window", "lamp", "led", "dim"),
        ),
    )
    hands: str = field(
        default="right",
        metadata=argument(
            "hands to simulate; if both, they touch and cross", choices=("left", "right", "both")
        ),
    )
    person: int | None = field(
        default=None,
        metadata=argument(
            "simulate the same person as the session with --seed SEED, after putting the glove on "
            "again",
            metavar="SEED",
        ),
    )
    guided: str = field(
        default="",
        metadata=argument(
            "start with guided poses, announced in /events and held well (default) or badly",
            nargs="?",
            const="well",
            choices=("well", "badly"),
        ),
    )
    right_late: float = field(
        default=0.0,
        metadata=argument(
            "delay of the right camera's exposure after the left one's",
            "--right-late-ms",
            type=thousandths,
            metavar="MS",
        ),
    )
    """s"""
    readout: float | None = field(
        default=None,
        metadata=argument(
            "rolling shutter: time from the first row's exposure to the last one's, 0 for all rows "
            "at once (default: 11, with one lens 18)",
            "--readout-ms",
            type=thousandths,
            metavar="MS",
        ),
    )
    """s"""
    camera_errors: str = field(
        default="all",
        metadata=argument(
            "errors of the camera, all (default), none or a list: lenses (distortion), calibration "
            "(0.3 px, baseline 0.3 percent), shutter (rolling), stamps (jitter of 0.5 ms, with one "
            "lens 4 ms), flicker (of lamps)",
            metavar="LIST",
        ),
    )
    lenses: str = field(
        default="both",
        metadata=argument(
            "number of lenses: both (or 2), one (or 1), or none (or 0), a glove without a camera",
            choices=(*LENSES_BY_NUMBER.values(), *LENSES_BY_NUMBER),
        ),
    )
    camera: str = field(
        default="stand",
        metadata=argument(
            "fixed on a stand; on the wearer's head with a known pose (head); or on the head with "
            "only its own IMU (head-imu)",
            choices=("stand", "head", "head-imu"),
        ),
    )


@dataclass(frozen=True)
class TrackOptions:
    """Names or paths; empty: those of the session."""

    engine: str = field(
        default="",
        metadata=argument(
            f"{', '.join(names_of('engines'))}; default: the recorded engine, or inertial "
            "(needs no camera) for a session without a camera"
        ),
    )
    hand: str = field(
        default="", metadata=argument("hand name or file (default: the recorded hand)")
    )
    glove: str = field(
        default="", metadata=argument("glove name or file (default: the recorded glove)")
    )
    colours: str = field(
        default="",
        metadata=argument("colour profile name or file (default: the recorded profile)"),
    )
    with_sensors: bool = field(default=False, metadata=argument("also copy the sensor topics"))
    settings: str = field(
        default="",
        metadata=argument(
            "settings file (.toml), or the word default for the defaults of this version; without "
            "this option, the recorded settings are used",
            metavar="FILE|default",
        ),
    )
    """Path of a TOML file of `tracker.engine.settings.Settings`, or `USUAL`."""
    smooth: bool = field(
        default=False, metadata=argument("smooth the result, using later data as well")
    )
    guided: bool = field(
        default=True,
        metadata=argument("do not calibrate from guided poses in the session"),
    )
    wearer: str = field(
        default="",
        metadata=argument(
            "wearer's profile (.toml); for both hands, two files separated by a comma",
            metavar="FILE",
        ),
    )
    keep_wearer: str = field(
        default="",
        metadata=argument(
            "save the wearer's profile; for both hands, FILE_left and FILE_right", metavar="FILE"
        ),
    )
    hand_length: float = field(
        default=0.0,
        metadata=argument(
            "length of the wearer's hand, measured with a ruler", type=thousandths, metavar="MM"
        ),
    )
    """m; 0 if unknown."""
    lenses: str = field(
        default="",
        metadata=argument("use only the images of this lens", choices=("left", "right")),
    )
