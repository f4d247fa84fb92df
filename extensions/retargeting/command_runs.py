"""``glovetrack retargeting-config``: a configuration of dex-retargeting for a robot hand."""

from __future__ import annotations

from extensions.retargeting.command import RetargetingConfigArguments
from extensions.retargeting.config import config_text, dex_hand, links_suffice
from extensions.robot.finger_map import map_given
from extensions.robot.hand import load_hand, read_hand
from extensions.robot.library import model_path, need_mujoco
from extensions.robot.settings import RobotSettings
from extensions.robot.urdf import robot_urdf
from tracker.base.files import check_target, write_whole
from tracker.glove import library

GLOVES = {"right": "vist-small", "left": "vist-small-left"}


def write_config(args: RetargetingConfigArguments) -> None:
    """Write the configuration and, if the file is not a URDF whose links end at the fingertips,
    the URDF that it names."""
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
