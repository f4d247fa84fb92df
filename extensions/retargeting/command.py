"""``glovetrack retargeting-config``: a configuration of dex-retargeting for a robot hand.

Functions import what they need, so that ``glovetrack --help`` is fast.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from extensions.robot.library import SHADOW, model_path, need_mujoco
from extensions.robot.teleop_command import add_fingers
from tracker.base.command import Command
from tracker.base.files import check_target, write_whole
from tracker.base.terminal import add_force

GLOVES = {"right": "vist-small", "left": "vist-small-left"}


def add_config(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "model",
        metavar="MODEL",
        nargs="?",
        default=SHADOW,
        help="a robot hand: the path of an MJCF or URDF file (default: shadow)",
    )
    parser.add_argument(
        "--type",
        dest="kind",
        choices=("vector", "position", "dexpilot"),
        default="vector",
        help="algorithm (default: vector)",
    )
    add_fingers(parser)
    parser.add_argument(
        "--hand",
        default="",
        help="hand file of the wearer, for the scaling factor (default: the reference hand)",
    )
    parser.add_argument(
        "-o", "--out", type=Path, required=True, metavar="FILE.yml", help="configuration to write"
    )
    add_force(parser)


def write_config(args: argparse.Namespace) -> None:
    """Write the configuration and, if the file is not a URDF whose links end at the fingertips,
    the URDF that it names."""
    from extensions.retargeting.config import config_text, dex_hand, links_suffice
    from extensions.robot.finger_map import map_given
    from extensions.robot.hand import load_hand, read_hand
    from extensions.robot.settings import RobotSettings
    from extensions.robot.urdf import robot_urdf
    from tracker.glove import library

    need_mujoco()
    urdf = args.out.with_suffix(".urdf")
    path, fingers = model_path(args.model), map_given(args.fingers)
    check_target(args.out, args.force, [path])
    file = read_hand(path, fingers)
    side = file.anatomy.side
    own = path.suffix.lower() == ".urdf" and links_suffice(file)
    wearer, _ = library.load(GLOVES[side], args.hand or f"reference-{side}")
    name = str(path.resolve()) if own else urdf.name
    text = config_text(dex_hand(file, name, own), args.kind, wearer)
    if not own:
        check_target(urdf, args.force, [path])
        hand = load_hand(RobotSettings(args.model, side, fingers.text))
        write_whole(urdf, robot_urdf(hand, tips=True), args.force)
    write_whole(args.out, text, args.force)
    print(f"{args.out}: {args.kind} retargeting of a {side} hand")


CONFIG = Command(
    "retargeting-config",
    "write a dex-retargeting configuration for a robot hand",
    write_config,
    add=add_config,
    description="Writes the configuration file of dex-retargeting (vector, position or DexPilot) "
    "for the robot hand in an MJCF or URDF file: links, landmarks, scaling factor, and the "
    "rotation to the hand's base. For an MJCF file, a URDF is written next to it.",
    extra="robot",
)
