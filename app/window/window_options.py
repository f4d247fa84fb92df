"""Options of the command line for the window; imported without Qt."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from app.engines.demo_camera import HANDS, LENSES, SCENES
from tracker.base.arguments import argument
from tracker.sensors.protocol import BAUDS
from tracker.streaming.publisher import JOINT_SETS
from tracker.streaming.registry import stream_kinds
from tracker.streaming.remote.registry import door_kinds


@dataclass(frozen=True)
class WindowOptions:
    """Options of ``glovetrack window``, ``demo`` and ``devices``, for this run alone."""

    session: Path | None = field(default=None, metadata=argument("session to replay", "session"))
    at: float | None = field(
        default=None,
        metadata=argument("pause the replay at this time of the session", metavar="SECONDS"),
    )
    demo: bool = field(default=False, metadata=argument("start a simulated glove and camera"))
    devices: bool = field(default=False, metadata=argument("connect to the glove and the camera"))
    baud: int | None = field(
        default=None,
        metadata=argument(
            "baud rate of the glove for this run (default: from the settings)", choices=BAUDS
        ),
    )
    stream: str = field(
        default="",
        metadata=argument(
            f"streams to enable for this run: {', '.join(stream_kinds())}", metavar="NAME[:PORT],…"
        ),
    )
    stream_host: str = field(
        default="",
        metadata=argument("destination or listening address of the streams", metavar="HOST"),
    )
    stream_joints: str = field(
        default="",
        metadata=argument(
            "joints to stream: Glovetrack's keypoints, or OpenXR's 26 joints",
            choices=("", *JOINT_SETS),
            metavar="|".join(JOINT_SETS),
        ),
    )
    remote: str = field(
        default="",
        metadata=argument(
            f"enable remote control for this run: {', '.join(door_kinds())}",
            metavar="NAME[:PORT],…",
        ),
    )
    remote_host: str = field(
        default="", metadata=argument("listening address for remote control", metavar="HOST")
    )
    wearer: Path | None = field(
        default=None,
        metadata=argument("import this wearer's profile and use it from the start", metavar="FILE"),
    )
    fps: float = field(
        default=30.0, metadata=argument("frame rate of the simulated camera, Hz (default: 30)")
    )
    hands: str = field(
        default="right", metadata=argument("hands to simulate in the demo", choices=HANDS)
    )
    motion: str = field(
        default="",
        metadata=argument("hand motion in the demo: a recording, or show:NAME for an application"),
    )
    lenses: str = field(
        default="both",
        metadata=argument("lenses of the simulated camera, or none for no camera", choices=LENSES),
    )
    camera_errors: str = field(
        default="all",
        metadata=argument(
            "errors of the simulated camera, all (default), none, or a list of lenses, "
            "calibration, shutter, stamps and flicker",
            metavar="LIST",
        ),
    )
    scene: str = field(
        default="auto",
        metadata=argument(
            "background in the demo; auto: a desk if the computer can render it fast enough",
            choices=SCENES,
        ),
    )
    independent_fingers: bool = field(
        default=False,
        metadata=argument("in the demo, only the finger of a pinch bends, and no other"),
    )
    headless_report: float | None = field(
        default=None,
        metadata=argument(
            "run without a window for this long and write a report to --out", metavar="SECONDS"
        ),
    )
    out: Path = field(
        default=Path("demo"), metadata=argument("folder for the report (default: demo)")
    )
    force: bool = field(default=False, metadata=argument("overwrite an earlier report"))
