"""A wearer profile as a file: the parameters of the person, which do not depend on one donning.

A TOML file of schema 1: bone scales relative to the hand file, offsets of finger bases (m),
individual synergies (ratio, offset and lateral in rad), and their covariances in the order in which
they are listed. What changes with each donning (mountings, markers) or from day to day (biases) is
not stored: a reader starts those from the prior.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w

from tracker.base.errors import FileError
from tracker.base.files import write_with_folder
from tracker.base.notices import notice
from tracker.base.toml_reader import parse_toml, read_text
from tracker.fusion.chain.distal import OWN, DistalSegments, Synergies
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import PriorParams, SynergyParams
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.profile import WearerProfile, profile_of
from tracker.fusion.chain.reports import calibration_of
from tracker.fusion.chain.state import SCALE_LIMITS, initial_state
from tracker.messages import Array, Calibration

SCHEMA = 1
MOST_OFFSET = 0.05  # m, of a finger base; divided by 0.05, rad of a synergy


@dataclass(frozen=True, eq=False)
class WearerFile:
    """What was learned about a wearer with the hand and glove of ``layout``."""

    layout: ChainLayout
    profile: WearerProfile
    calibration: Calibration


def write_wearer(path: Path, wearer: WearerFile) -> None:
    """Writes the file atomically. Raises FileError with a readable message."""
    write_with_folder(path, wearer_text(wearer))


def wearer_text(wearer: WearerFile) -> str:
    """The text of the file."""
    profile, layout, hand = wearer.profile, wearer.layout, wearer.layout.hand
    bases = [name for name, b in zip(layout.names, layout.base_of, strict=True) if b >= 0]
    table: dict[str, Any] = {
        "schema": SCHEMA,
        "hand": hand.name,
        "glove": layout.glove.name,
        "bones": {
            name: {"length": float(length), "girth": float(girth)}
            for name, (length, girth) in zip(layout.names, profile.scale, strict=True)
        },
        "bases": dict(zip(bases, profile.joint.tolist(), strict=True)),
        "certainty": {"bones": _bones(profile.P, layout).tolist()},
    }
    if profile.synergies is not None:
        digits = DistalSegments(layout, SynergyParams()).digits
        table["synergies"] = {
            hand.synergies[d.link].angle: dict(
                zip(("ratio", "offset", "aside"), value.tolist(), strict=True)
            )
            for d, value in zip(digits, profile.synergies.value, strict=True)
        }
        table["certainty"]["synergies"] = profile.synergies.P.tolist()
    return tomli_w.dumps(table)


def is_for(path: Path, layout: ChainLayout) -> bool:
    """False where the file names another hand or glove; reads only its first lines.

    A damaged file counts as matching: `read_wearer` reports what is wrong with it.
    """
    try:
        head = read_text(path).split("\n[", 1)[0]
        return not _is_of_another(parse_toml(head, path.name), layout)
    except FileError:
        return True


def _is_of_another(table: dict[str, Any], layout: ChainLayout) -> bool:
    names = str(table.get("hand", "")), str(table.get("glove", ""))
    return all(names) and names != (layout.hand.name, layout.glove.name)


def read_wearer(path: Path, layout: ChainLayout) -> WearerFile:
    """Raises FileError where the file is not a wearer profile, or is for another hand or glove."""
    try:
        table = parse_toml(read_text(path), path.name)
    except FileError as error:
        raise FileError(notice("wearer.invalid", file=path.name, why=error)) from error
    if _is_of_another(table, layout):
        names, ours = (table["hand"], table["glove"]), (layout.hand.name, layout.glove.name)
        raise FileError(
            notice(
                "wearer.other_hand",
                file=path.name,
                hand=names[0],
                glove=names[1],
                our_hand=ours[0],
                our_glove=ours[1],
            )
        )
    try:
        return _parsed(table, layout)
    except (KeyError, TypeError, ValueError) as error:
        raise FileError(notice("wearer.damaged", file=path.name)) from error


def _parsed(table: dict[str, Any], layout: ChainLayout) -> WearerFile:
    """Raises KeyError, TypeError or ValueError where the table is invalid."""
    if table["schema"] != SCHEMA:
        raise ValueError("another version wrote it")
    state = initial_state(layout)
    state.P = initial_covariance(layout, PriorParams())
    bones = [table["bones"][name] for name in layout.names]
    state.scale = _numbers([[b["length"], b["girth"]] for b in bones], state.scale.shape)
    bases = [table["bases"][n] for n, b in zip(layout.names, layout.base_of, strict=True) if b >= 0]
    state.joint = _numbers(bases, state.joint.shape)
    block = slice(layout.blocks.scale, layout.blocks.marker)
    known = _bones(state.P[layout.n_dynamic :, layout.n_dynamic :], layout)
    state.P[block, block] = _covariance(table["certainty"]["bones"], len(known))
    low, high = SCALE_LIMITS
    inside = np.all((state.scale >= low) & (state.scale <= high))
    if not inside or np.abs(state.joint).max(initial=0.0) > MOST_OFFSET:
        raise ValueError("no hand is like that")
    profile = replace(profile_of(state, layout), synergies=_synergies(table, layout))
    return WearerFile(layout, profile, calibration_of(layout, state))


def _synergies(table: dict[str, Any], layout: ChainLayout) -> Synergies | None:
    if "synergies" not in table:
        return None
    distal = DistalSegments(layout, SynergyParams())
    tables = [table["synergies"][layout.hand.synergies[d.link].angle] for d in distal.digits]
    rows = [[t["ratio"], t["offset"], t["aside"]] for t in tables]
    value = _numbers(rows, (len(rows), OWN))
    if np.abs(value).max(initial=0.0) > 2 * np.pi:
        raise ValueError("no joint bends like that")
    return Synergies(value, _covariance(table["certainty"]["synergies"], value.size))


def _bones(P: Array, layout: ChainLayout) -> Array:
    """The block of scales and finger bases of a calibration's covariance."""
    n = layout.n_dynamic
    block = slice(layout.blocks.scale - n, layout.blocks.marker - n)
    return P[block, block]


def _numbers(value: Any, shape: tuple[int, ...]) -> Array:
    out = np.array(value, float).reshape(-1, *shape[1:])
    if out.shape != shape or not np.isfinite(out).all():
        raise ValueError("numbers are missing")
    return out


def _covariance(value: Any, size: int) -> Array:
    out = _numbers(value, (size, size))
    if size and (not np.allclose(out, out.T) or np.linalg.eigvalsh(out).min() < -1e-9):
        raise ValueError("no covariance")
    return out
