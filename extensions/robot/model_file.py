"""Reads a robot hand from an MJCF or a URDF file as a MuJoCo specification.

A URDF has no bodies without joints after MuJoCo has read it, unless options keep them:
fingertips are often such links. Meshes are looked for next to the file and in the folders of ROS
packages (package://); what MuJoCo cannot read (glTF, Collada) or does not find is left out, and a
link without any shape gets capsules along its bones.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.files import read_bounded
from tracker.base.notices import notice

MOST_BYTES = 20_000_000  # of a hand's file, without the meshes
READABLE = (".stl", ".obj", ".msh")
COMPILER = {
    "fusestatic": "false",
    "discardvisual": "false",
    "strippath": "false",
    "balanceinertia": "true",
    "boundmass": "0.002",  # kg
    "boundinertia": "1e-6",  # kg m²
}
BONE_RADIUS = 0.007  # m
SHORTEST = 0.004  # m: shorter bones get no capsule
EFFORT = (0.05, 2.0)  # N m: URDF files often have placeholders for the effort of finger joints
ARMATURE, DAMPING = 1e-3, 0.05  # kg m², N m s/rad: of joints without any, which would oscillate
SOLID, PASSIVE = 1, 0  # contact with objects and table, but not among the hand's own links


def read_model(path: Path) -> Any:
    """The specification (`mujoco.MjSpec`) of the file. Raises ConfigError for one that is too
    large, ValueError for one that MuJoCo cannot read."""
    if path.stat().st_size > MOST_BYTES:
        raise ConfigError(notice("robot.too_large", file=path.name, limit_bytes=MOST_BYTES))
    data = read_bounded(path, MOST_BYTES, "a robot hand")
    root = _xml(data)
    spec = _urdf(root, path) if root.tag == "robot" else _mjcf(path)
    for joint in spec.joints:
        if joint.armature == 0 and not np.any(joint.damping):
            joint.armature, joint.damping = ARMATURE, [DAMPING, 0.0, 0.0]
    return spec


def _xml(data: bytes) -> ET.Element:
    try:
        return ET.fromstring(data)
    except ET.ParseError as error:
        raise ValueError(f"not an XML file: {error}") from error


def _mjcf(path: Path) -> Any:
    spec = mujoco.MjSpec.from_file(str(path))
    spec.meshdir = str((path.parent / spec.meshdir).resolve())
    spec.texturedir = str((path.parent / spec.texturedir).resolve())
    return spec


def _urdf(root: ET.Element, path: Path) -> Any:
    _keep_links(root)
    _find_meshes(root, path.resolve())
    try:
        spec = _compiled(root)
    except ValueError as error:
        if root.find(".//mesh") is None:
            raise
        _drop_meshes(root, lambda _mesh: True)  # one that MuJoCo cannot use
        try:
            spec = _compiled(root)
        except ValueError:
            raise error from None
    _add_bones(spec)
    for geom in spec.geoms:
        geom.contype, geom.conaffinity = SOLID, PASSIVE
    return spec


def _compiled(root: ET.Element) -> Any:
    spec = mujoco.MjSpec.from_string(ET.tostring(root, encoding="unicode"))
    spec.compile()
    return spec


def _keep_links(root: ET.Element) -> None:
    """Set MuJoCo's options for URDF in the file's element for them."""
    options = root.find("mujoco")
    if options is None:
        options = ET.SubElement(root, "mujoco")
    compiler = options.find("compiler")
    if compiler is None:
        compiler = ET.SubElement(options, "compiler")
    compiler.attrib.pop("meshdir", None)
    compiler.attrib.update(COMPILER)


def _find_meshes(root: ET.Element, path: Path) -> None:
    """Give meshes absolute names; drop those that do not exist or that MuJoCo cannot read."""
    for mesh in root.iter("mesh"):
        found = mesh_path(mesh.get("filename", ""), path)
        mesh.set("filename", "" if found is None else str(found))
    _drop_meshes(root, lambda mesh: not mesh.get("filename"))


def _drop_meshes(root: ET.Element, unwanted: Any) -> None:
    for link in root.iter("link"):
        for shape in [*link.findall("visual"), *link.findall("collision")]:
            mesh = shape.find("geometry/mesh")
            if mesh is not None and unwanted(mesh):
                link.remove(shape)


def mesh_path(name: str, urdf: Path) -> Path | None:
    """The file of a mesh in the form that MuJoCo reads; None if there is none.

    ``package://NAME/…`` is looked for in folders called NAME above the URDF, and relative to the
    folders above it, as checkouts rename packages.
    """
    scheme, separator, rest = name.partition("://")
    inside = rest if separator else name
    if not inside:
        return None
    package, _, below = inside.partition("/")
    candidates = [urdf.parent / inside]
    for folder in urdf.parents if scheme == "package" else ():
        candidates.append(folder / inside)
        candidates.append(folder / below)
        if folder.name == package:
            candidates.append(folder / below)
    for candidate in candidates:
        for suffix in (candidate.suffix, *READABLE):
            file = candidate.with_suffix(suffix)
            if suffix.lower() in READABLE and file.is_file():
                return file.resolve()
    return None


def _add_bones(spec: Any) -> None:
    """Add capsules to moving links without a shape: from the joint to those of their children."""
    for body in spec.bodies:
        if body.name == "world" or len(body.geoms):
            continue
        for child in body.bodies:
            end = np.array(child.pos)
            if np.linalg.norm(end) < SHORTEST:
                continue
            body.add_geom(
                type=mujoco.mjtGeom.mjGEOM_CAPSULE,
                fromto=[0.0, 0.0, 0.0, *end],
                size=[BONE_RADIUS, 0.0, 0.0],
                density=0.0,
            )


def effort(low_high: Any) -> float:
    """N m of a joint's limit of effort, within what a finger's motor has."""
    return float(np.clip(np.abs(low_high).max(), *EFFORT))
