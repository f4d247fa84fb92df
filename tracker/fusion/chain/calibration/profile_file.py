"""A wearer's profile as a file: what was learned, of which glove, and how it looked then.

A NumPy archive (.npz) without pickled objects: the arrays of `WearerProfile`, those of the
`Calibration` of that moment for comparing, and the names that both belong to.
"""

from __future__ import annotations

import io
import zipfile
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np

from tracker.errors import FileError
from tracker.files import write_kept
from tracker.fusion.chain.calibration.control import fits
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.profile import WearerProfile
from tracker.messages import Calibration

SCHEMA = 1
_PROFILE = tuple(f.name for f in fields(WearerProfile))
_CALIBRATION = tuple(f.name for f in fields(Calibration) if f.name != "segments")


@dataclass(frozen=True, eq=False)
class WearerFile:
    """``hand`` and ``glove`` are the models' names."""

    hand: str
    glove: str
    profile: WearerProfile
    calibration: Calibration


def write_wearer(path: Path, wearer: WearerFile) -> None:
    """Replace the file as a whole. Raises FileError in words."""
    values: dict[str, Any] = {
        "schema": SCHEMA,
        "hand": wearer.hand,
        "glove": wearer.glove,
        "segments": np.array(wearer.calibration.segments),
        **{f"profile_{k}": getattr(wearer.profile, k) for k in _PROFILE},
        **{f"calibration_{k}": getattr(wearer.calibration, k) for k in _CALIBRATION},
    }
    packed = io.BytesIO()
    np.savez_compressed(packed, allow_pickle=False, **values)
    write_kept(path, packed.getvalue())


def read_wearer(path: Path, layout: ChainLayout) -> WearerFile:
    """Raises FileError where it is none, or of another hand or glove."""
    try:
        with np.load(path, allow_pickle=False) as archive:
            values = {name: archive[name] for name in archive.files}
        wearer = _parse(values)
    except OSError as error:
        reason = error.strerror or "it cannot be read"
        raise FileError(f"{path.name} is no profile of a wearer: {reason}.") from error
    except (ValueError, KeyError, EOFError, zipfile.BadZipFile) as error:
        raise FileError(f"{path.name} is no profile of a wearer, or it is damaged.") from error
    ours = layout.hand.name, layout.glove.name
    if (wearer.hand, wearer.glove) != ours or not fits(wearer.profile, layout):
        raise FileError(
            f"{path.name} is of hand {wearer.hand} with glove {wearer.glove}; "
            f"this is hand {ours[0]} with glove {ours[1]}."
        )
    return wearer


def _parse(values: dict[str, Any]) -> WearerFile:
    if int(values["schema"]) != SCHEMA:
        raise ValueError("another version wrote it")
    profile = {k: np.asarray(values[f"profile_{k}"], float) for k in _PROFILE}
    if not all(np.isfinite(v).all() for v in profile.values()):
        raise ValueError("it holds values that are no numbers")
    calibration: dict[str, Any] = {
        k: _plain(np.asarray(values[f"calibration_{k}"], float)) for k in _CALIBRATION
    }
    return WearerFile(
        str(values["hand"]),
        str(values["glove"]),
        WearerProfile(**profile),
        Calibration(segments=tuple(str(s) for s in values["segments"]), **calibration),
    )


def _plain(value: Any) -> Any:
    """A float for an array without dimensions."""
    return float(value) if value.ndim == 0 else value
