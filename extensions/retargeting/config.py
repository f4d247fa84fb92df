"""Configurations of dex-retargeting (dexsuite, MIT; Qin et al. 2023) for any robot hand.

Its algorithms move a robot's links like landmarks of the wearer, given in MediaPipe's order and in
the operator frame (x out of the palm, z to the fingers), or vectors between landmarks. Keys are
those of its `RetargetingConfig`; it reads the table ``retargeting`` alone, so the table
``glovetrack`` has what else a program needs: the rotation from the operator frame to the axes of
the hand's base, in which the links are.

Vectors are those from each finger's knuckle to its tip and from the thumb's tip to the others:
unlike vectors from the wrist, they do not depend on where the base link is.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import mujoco
import numpy as np

from extensions.retargeting.command import RetargetingConfigArguments
from extensions.robot.finger_map import PALM, map_given
from extensions.robot.fingers import joint_ranges, plain
from extensions.robot.hand import HandFile, load_hand, read_hand
from extensions.robot.library import model_path, need_mujoco
from extensions.robot.settings import RobotSettings
from extensions.robot.urdf import joint_link, robot_urdf, tip_link
from extensions.robot.wearer_hand import FINGERS, PARTS
from glovetrack.conventions import MEDIAPIPE, R_B_OPERATOR, in_order
from tracker.base.files import check_target, write_whole
from tracker.glove import library
from tracker.hand.model import HandModel
from tracker.messages import Array

VECTOR, POSITION, DEXPILOT = TYPES = ("vector", "position", "dexpilot")
LOW_PASS = 0.2
SAME_PLACE = 1e-4  # m


@dataclass(frozen=True, eq=False)
class DexHand:
    """A robot hand as dex-retargeting has it: ``urdf`` is the name of its file; links and lengths
    (m, from the knuckle) by finger; reach (n,) m from the wrist link to each straight tip."""

    urdf: str
    wrist: str
    tips: dict[str, str]
    knuckles: dict[str, str]
    lengths: dict[str, float]
    reach: Array
    R_base_operator: Array


def links_suffice(file: HandFile) -> bool:
    """Whether the origin of each fingertip's link is the fingertip, as in most URDF files."""
    model = file.whole
    return all(
        model.body_weldid[body] != body and np.linalg.norm(model.body_pos[body]) > SAME_PLACE
        for body in file.found.links.values()
    )


def dex_hand(file: HandFile, urdf: str, own: bool) -> DexHand:
    """Links of a hand; ``own``: in the file itself, not in a URDF written by us."""
    model, anatomy = file.model, file.anatomy
    data = mujoco.MjData(model)
    data.qpos[:] = np.clip(0.0, *joint_ranges(model).T)
    mujoco.mj_kinematics(model, data)
    palm = file.fingers.links[PALM]
    wrist = np.array(data.xpos[model.body(palm).id])
    tips, knuckles, reach = {}, {}, []
    for finger in anatomy.fingers:
        joint = _knuckle(data, finger.joints)
        body = model.body(int(model.jnt_bodyid[joint])).name
        knuckles[finger.name] = body if own else joint_link(model, joint)
        tips[finger.name] = file.fingers.links[finger.name] if own else tip_link(finger)
        at = data.xpos[finger.body] + data.xmat[finger.body].reshape(3, 3) @ finger.tip
        reach.append(float(np.linalg.norm(at - wrist)))
    lengths = {f.name: f.length for f in anatomy.fingers}
    R = anatomy.R_WP @ R_B_OPERATOR if own else R_B_OPERATOR
    return DexHand(urdf, palm if own else plain(palm), tips, knuckles, lengths, np.array(reach), R)


def _knuckle(data: mujoco.MjData, joints: tuple[int, ...]) -> int:
    """The third joint from the tip; of joints at one point the last one."""
    apart: list[int] = []
    for j in joints:
        if apart and np.linalg.norm(data.xanchor[j] - data.xanchor[apart[-1]]) < SAME_PLACE:
            apart.pop()
        apart.append(j)
    return apart[-3:][0]


def config_text(hand: DexHand, kind: str, wearer: HandModel) -> str:
    """The YAML of one of `TYPES` for the wearer's hand, whose size decides the scaling factor."""
    rows = {VECTOR: _vectors, POSITION: _positions, DEXPILOT: _dexpilot}[kind](hand, wearer)
    lines = [f"  {key}: {value}" for key, value in rows.items()]
    numbers = [[f"{round(x, 6) + 0.0:.6f}" for x in row] for row in hand.R_base_operator.tolist()]
    rotation = "[" + ", ".join(f"[{', '.join(row)}]" for row in numbers) + "]"
    head = {
        "landmarks": _word("MediaPipe's 21, from the wrist, in the operator frame"),
        "wearer": _word(wearer.name),
        "fingers": _list(hand.tips),
        "R_base_operator": rotation,
    }
    return "\n".join(
        [
            "# For dex-retargeting. Points of the hand's base: R_base_operator @ landmark.",
            "retargeting:", f"  type: {kind}", f"  urdf_path: {_word(hand.urdf)}", *lines,
            "glovetrack:", *(f"  {key}: {value}" for key, value in head.items()), "",
        ]
    )  # fmt: skip


def _vectors(hand: DexHand, wearer: HandModel) -> dict[str, str]:
    others = [f for f in hand.tips if f != "thumb"]
    origins = [*hand.knuckles.values(), *([hand.tips["thumb"]] * len(others))]
    tasks = [*hand.tips.values(), *(hand.tips[f] for f in others)]
    starts = [*(landmark(f, 0) for f in hand.tips), *([landmark("thumb", -1)] * len(others))]
    ends = [*(landmark(f, -1) for f in hand.tips), *(landmark(f, -1) for f in others)]
    lengths = finger_lengths(wearer)
    scale = np.mean(list(hand.lengths.values())) / np.mean([lengths[f] for f in hand.tips])
    return {
        "target_origin_link_names": _list(origins),
        "target_task_link_names": _list(tasks),
        "target_link_human_indices": f"[{starts}, {ends}]",
        "scaling_factor": f"{scale:.3f}",
        "low_pass_alpha": f"{LOW_PASS}",
    }


def _positions(hand: DexHand, _wearer: HandModel) -> dict[str, str]:
    indices = [*(landmark(f, -1) for f in hand.tips), *(landmark(f, 0) for f in hand.tips)]
    return {
        "target_link_names": _list([*hand.tips.values(), *hand.knuckles.values()]),
        "target_link_human_indices": f"{indices}",
        "add_dummy_free_joint": "true",
        "low_pass_alpha": "1",
    }


def _dexpilot(hand: DexHand, wearer: HandModel) -> dict[str, str]:
    points = straight_landmarks(wearer)
    reach = np.linalg.norm(points[[landmark(f, -1) for f in hand.tips]], axis=1)
    return {
        "wrist_link_name": _word(hand.wrist),
        "finger_tip_link_names": _list(hand.tips.values()),
        "scaling_factor": f"{hand.reach.mean() / reach.mean():.3f}",
        "low_pass_alpha": f"{LOW_PASS}",
    }


def landmark(finger: str, part: int) -> int:
    """Index of a finger's landmark, from its base (0) to its tip (-1)."""
    return MEDIAPIPE.index(PARTS[finger][part])


def straight_landmarks(wearer: HandModel) -> Array:
    """(21, 3) m of the straight hand, from the wrist."""
    R, p = wearer.forward(np.zeros(len(wearer.joint_names)), np.eye(3), np.zeros(3))
    points = in_order(wearer.keypoints(R, p), wearer.keypoint_names, MEDIAPIPE)
    return np.asarray(points - points[0])


def finger_lengths(wearer: HandModel) -> dict[str, float]:
    """m from the base of each finger to its tip, along its bones."""
    points = straight_landmarks(wearer)
    rows = {f: [MEDIAPIPE.index(k) for k in PARTS[f]] for f in FINGERS}
    return {
        f: float(np.linalg.norm(np.diff(points[r], axis=0), axis=1).sum()) for f, r in rows.items()
    }


def _word(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _list(words: Iterable[str]) -> str:
    return "[" + ", ".join(map(_word, words)) + "]"


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
