"""Robot hands of other makes, written for tests: numbered links, other names, other formats.

All are right hands whose base has z to the fingers, x out of the palm and y to the index finger.
Lengths in m, of the bones from the knuckle on.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

BONES = (0.05, 0.035, 0.025)
THUMB = (0.05, 0.04, 0.03)
FLEX, SPREAD = "0 1 0", "1 0 0"
TO_THE_SIDE = "-1.5707963267948966 0 0"  # rpy: a chain along z points to y


def urdf(name: str, parts: Iterable[str]) -> str:
    return f'<robot name="{name}">\n' + "\n".join(parts) + "\n</robot>\n"


def link(name: str, shape: str = "") -> str:
    both = "".join(f"<{k}><geometry>{shape}</geometry></{k}>" for k in ("visual", "collision"))
    mass = '<inertial><mass value="0.02"/><inertia ixx="1e-5" iyy="1e-5" izz="1e-5" '
    mass += 'ixy="0" ixz="0" iyz="0"/></inertial>'
    return f'<link name="{name}">{mass}{both if shape else ""}</link>'


def joint(
    name: str, parent: str, child: str, xyz: str, axis: str = "", turn: str = "0 0 0",
    limit: tuple[float, float] = (0.0, 1.6), more: str = "",
) -> str:  # fmt: skip
    kind = "revolute" if axis else "fixed"
    out = f'<joint name="{name}" type="{kind}"><origin xyz="{xyz}" rpy="{turn}"/>'
    out += f'<parent link="{parent}"/><child link="{child}"/>'
    if axis:
        out += f'<axis xyz="{axis}"/><limit lower="{limit[0]}" upper="{limit[1]}" '
        out += 'effort="10" velocity="7"/>'
    return out + f"{more}</joint>"


def numbered(side: int = 1) -> str:
    """Four fingers with numbered links and joints, as Allegro's; ``side`` -1: a left hand. Its
    meshes are in a missing package."""
    mesh = '<mesh filename="package://some_hand/meshes/part.dae"/>'
    parts = [link("base_link", '<box size="0.03 0.1 0.1"/>')]
    for f, y in enumerate((0.045, 0.0, -0.045)):
        parts += _numbered_finger(4 * f, f"0 {side * y} 0.09", "0 0 0", BONES, mesh)
    turn = TO_THE_SIDE if side > 0 else TO_THE_SIDE[1:]
    parts += _numbered_finger(12, f"0.01 {side * 0.02} 0.03", turn, THUMB, mesh)
    return urdf("numbered", parts)


def _numbered_finger(
    first: int, at: str, turn: str, bones: tuple[float, ...], mesh: str
) -> list[str]:
    names = ["base_link", *(f"link_{first + k}.0" for k in range(4)), f"link_{first + 3}.0_tip"]
    places = [at, "0 0 0", *(f"0 0 {b}" for b in bones)]
    out = []
    for k, name in enumerate(names[1:]):
        tip = k == 4
        out.append(link(name, "" if tip else mesh))
        axis, limit = ("", (0.0, 0.0)) if tip else (FLEX, (-0.1, 1.6))
        if k == 0:
            axis, limit = SPREAD, (-0.4, 0.4)
        label = f"joint_{first + 3}.0_tip" if tip else f"joint_{first + k}.0"
        out.append(joint(label, names[k], name, places[k], axis, turn, limit))
        turn = "0 0 0"
    return out


def lettered() -> str:
    """Five fingers named FF, MF, RF, LF, TH on a wrist and an arm, with a camera next to the arm;
    the last joint of each finger mimics the one before it."""
    parts = [link("pedestal"), link("arm", '<box size="0.1 0.1 0.4"/>'), link("camera")]
    parts += [joint("arm_joint", "pedestal", "arm", "0 0 0.5", SPREAD)]
    parts += [joint("camera_joint", "pedestal", "camera", "0.3 0 0.5", "0 0 1")]
    parts += [link("rh_wrist"), joint("rh_WRJ2", "arm", "rh_wrist", "0 0 0.2", SPREAD)]
    parts += [link("rh_palm", '<box size="0.02 0.08 0.09"/>')]
    parts += [joint("rh_WRJ1", "rh_wrist", "rh_palm", "0 0 0.03", FLEX)]
    for name, y in (("RF", -0.011), ("LF", -0.033), ("FF", 0.033), ("MF", 0.011)):
        parts += _lettered_finger(name, f"0 {y} 0.095", "0 0 0", BONES)
    parts += _lettered_finger("TH", "0.01 0.034 0.03", TO_THE_SIDE, THUMB)
    return urdf("lettered", parts)


def _lettered_finger(name: str, at: str, turn: str, bones: tuple[float, ...]) -> list[str]:
    rod = '<cylinder radius="0.008" length="0.03"/>'
    places = [at, "0 0 0", f"0 0 {bones[0]}", f"0 0 {bones[1]}"]
    names = ["rh_palm", *(f"rh_{name}{part}" for part in ("knuckle", "prox", "middle", "distal"))]
    out = []
    for k, here in enumerate(names[1:]):
        out.append(link(here, rod if k else ""))
        mimic = f'<mimic joint="rh_{name}J2" multiplier="0.9" offset="0.02"/>' if k == 3 else ""
        axis, limit = (FLEX, (0.0, 1.6)) if k else (SPREAD, (-0.3, 0.3))
        out.append(joint(f"rh_{name}J{4 - k}", names[k], here, places[k], axis, turn, limit, mimic))
        turn = "0 0 0"
    out += [link(f"rh_{name}tip")]
    out += [joint(f"rh_{name}_fix", names[4], f"rh_{name}tip", f"0 0 {bones[2]}")]
    return out


def unnamed_mjcf() -> str:
    """An MJCF hand of five fingers called a to e, whose flexion joints have MuJoCo's default axis
    (z), on a table with a lamp; one finger's last joint is tied to the one before it."""
    fingers = [("c", 0.0), ("b", 0.025), ("a", 0.05), ("d", -0.025)]
    chains = [_mjcf_finger(n, f"0 {y} 0.09", "0.5 -0.5 -0.5 -0.5", BONES) for n, y in fingers]
    chains.append(_mjcf_finger("e", "0.01 0.05 0.02", "0 0.7071068 0.7071068 0", THUMB))
    return f"""<mujoco model="unnamed"><compiler angle="radian"/>
<worldbody>
  <body name="lamp" pos="1 0 0"><geom size="0.1"/><joint name="lamp"/></body>
  <body name="stand"><geom type="box" size="0.02 0.02 0.1" pos="0 0 -0.2"/>
    <body name="metacarpus" pos="0 0 0.1"><joint name="turn" axis="0 0 1" range="-1 1"/>
      <geom type="box" size="0.01 0.05 0.045" pos="0 0 0.045"/>
      {"".join(chains)}
    </body>
  </body>
</worldbody>
<equality><joint joint1="a3" joint2="a2" polycoef="0 1 0 0 0"/></equality>
<actuator><position name="m" joint="b2" kp="3" forcerange="-0.7 0.7"/></actuator>
</mujoco>
"""


def _mjcf_finger(name: str, at: str, quat: str, bones: tuple[float, ...]) -> str:
    """Along its own x; its joints turn about its z."""
    inner = ""
    for k in (3, 2, 1):
        bone = bones[k - 1]
        inner = f"""<body name="{name}_{k}" pos="{bones[k - 2] if k > 1 else 0} 0 0">
<joint name="{name}{k}" range="0 1.5" damping="0.05" armature="0.001"/>
<geom type="capsule" size="0.008" fromto="0 0 0 {bone} 0 0" contype="1" conaffinity="0"/>
{f'<site name="{name}_end_tip" pos="{bone} 0 0"/>' if k == 3 else inner}</body>"""
    return f"""<body name="{name}_0" pos="{at}" quat="{quat}">
<joint name="{name}0" axis="0 1 0" range="-0.3 0.3" damping="0.05" armature="0.001"/>
<geom size="0.009" contype="0" conaffinity="0"/>{inner}</body>"""


def written(folder: Path, name: str) -> Path:
    """One of these hands as a file."""
    texts = {
        "numbered.urdf": numbered, "left.urdf": lambda: numbered(-1), "lettered.urdf": lettered,
        "unnamed.xml": unnamed_mjcf,
    }  # fmt: skip
    path = folder / name
    path.write_text(texts[name]())
    return path
