"""Hand files (TOML, schema 1)."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from tracker.base.notices import notice
from tracker.base.toml_reader import TomlTable, read_text, read_toml
from tracker.geometry import so3
from tracker.hand.model import HandModel, Joint, Segment, Synergy
from tracker.hand.names import AXES, FIST, LENGTH_ALONG, SEGMENTS, STIFF

ROOT = "dorsum"


def load_hand(path: Path) -> HandModel:
    """Read a hand file. Raises FileError with file, key and line."""
    return parse_hand(read_text(Path(path)), str(path))


def parse_hand(text: str, name: str = "hand.toml") -> HandModel:
    """A hand from the text of its file; ``name`` replaces the file name in messages."""
    root = read_toml(text, name)
    if root.integer("schema") != 1:
        raise root.fail("schema", notice("toml.schema", expected=1))
    hand_name = root.text("name")
    side = root.text("side", among=("right", "left"))
    length = root.number("length", low=0.05, high=0.5)
    tables = root.tables("segments")
    raw = {n: _segment(root, n, t) for n, t in tables.items()}
    segments = _sorted(root, raw)
    length_to = root.text("length_to", [n for n in LENGTH_ALONG if n in raw][-1], among=raw)
    joints = _joints(root, raw)
    hand = HandModel(hand_name, side, length, length_to, segments, joints, ())
    hand = replace(hand, synergies=_synergies(root, hand))
    root.finish()
    if root.has("length_to") or length_to == LENGTH_ALONG[-1]:
        _check_length(root, hand)
    return hand


def _segment(root: TomlTable, name: str, t: TomlTable) -> Segment:
    if name not in SEGMENTS:
        raise root.fail("segments", notice("hand.unknown_segment", segment=name))
    is_root = name == ROOT
    segment = Segment(
        name=name,
        parent=None if is_root else t.text("parent"),
        origin=np.zeros(3) if is_root else t.vector("origin", 3, limit=0.5),
        R_rest=np.eye(3) if is_root else so3.matrix_from_quat(_rest(t)),
        length=t.number("length", low=1e-3, high=0.3),
        radius=t.number("radius", low=1e-3, high=0.05),
        width=t.number("width", low=1e-3, high=0.3) if is_root else 0.0,
    )
    t.finish()
    return segment


def _rest(t: TomlTable) -> np.ndarray:
    return t.unit("rest_xyzw", 4) if t.has("rest_xyzw") else np.array([0.0, 0, 0, 1])


def _sorted(root: TomlTable, raw: dict[str, Segment]) -> tuple[Segment, ...]:
    """Parents first, otherwise in the conventions' order; raises for loops and orphans."""
    if ROOT not in raw:
        raise root.fail("segments", notice("hand.no_root", root=ROOT))
    for s in raw.values():
        if s.parent is not None and s.parent not in raw:
            raise root.fail(
                "segments", notice("hand.unknown_parent", segment=s.name, parent=s.parent)
            )
    out: list[Segment] = []
    placed: set[str] = set()
    while len(out) < len(raw):
        ready = [
            n
            for n in SEGMENTS
            if n in raw and n not in placed and (n == ROOT or raw[n].parent in placed)
        ]
        if not ready:
            loop = sorted(set(raw) - placed)
            raise root.fail("segments", notice("hand.loop", names=loop))
        out += [raw[n] for n in ready]
        placed |= set(ready)
    return tuple(sorted(out, key=lambda s: (_depth(raw, s), SEGMENTS.index(s.name))))


def _depth(raw: dict[str, Segment], s: Segment) -> int:
    return 0 if s.parent is None else 1 + _depth(raw, raw[s.parent])


def _joints(root: TomlTable, segments: dict[str, Segment]) -> tuple[Joint, ...]:
    joints: list[Joint] = []
    seen: set[str] = set()
    for name, t in root.tables("joints").items():
        child = t.text("child", among=[s for s in segments if s != ROOT])
        if child in seen:
            raise t.fail("child", notice("hand.two_joints", segment=child))
        seen.add(child)
        axes = t.names("axes", AXES)
        axes = tuple(a for a in ("flexion", "abduction", "twist") if a in axes)
        limits_deg = t.table("limits_deg")
        limits = {a: _limit(limits_deg, a) for a in axes}
        limits_deg.finish()
        can_be_stiff = "abduction" in axes and "twist" not in axes
        stiff = t.names("stiff", ("abduction",), list(STIFF.get(child, ())) if can_be_stiff else [])
        if stiff and not can_be_stiff:
            raise t.fail("stiff", notice("hand.abduction"))
        fist = t.number("fist", FIST[child], low=0, high=1)
        t.finish()
        joints.append(Joint(name, child, axes, limits, stiff, fist))
    return tuple(joints)


def _limit(t: TomlTable, axis: str) -> tuple[float, float]:
    low, high = t.vector(axis, 2, limit=360)
    if low >= high:
        raise t.fail(axis, notice("hand.limits"))
    return float(np.deg2rad(low)), float(np.deg2rad(high))


def _synergies(root: TomlTable, hand: HandModel) -> tuple[Synergy, ...]:
    out: list[Synergy] = []
    for angle, t in root.tables("synergies").items():
        if angle not in hand.angle_index:
            raise root.fail("synergies", notice("hand.unknown_angle", angle=angle))
        of = t.text("of", among=hand.joint_names)
        ratio = t.number("ratio", low=-10, high=10)
        offset = np.deg2rad(t.number("offset_deg", 0.0, low=-180, high=180))
        t.finish()
        out.append(Synergy(angle, of, ratio, float(offset)))
    source = {s.angle: s.of for s in out}
    for s in out:
        seen, angle = {s.angle}, s.of
        while angle in source:
            if angle in seen:
                raise root.fail("synergies", notice("hand.loop", names=(angle,)))
            seen.add(angle)
            angle = source[angle]
    return tuple(out)


def _check_length(root: TomlTable, hand: HandModel) -> None:
    parts = [hand.segments[row] for row in hand.length_path]
    total = sum(s.length for s in parts)
    if abs(total / hand.length - 1) > 0.02:
        raise root.fail(
            "length",
            notice(
                "hand.length_sum",
                length_m=hand.length,
                segments=[s.name for s in parts],
                sum_m=total,
            ),
        )
