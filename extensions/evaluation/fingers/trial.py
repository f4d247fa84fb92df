"""Tracks a session with and without the glove's cloth and compares the fingertips with the
truth."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.hand.names import FINGERS
from tracker.messages import Array, Estimate, Validity
from tracker.offline.options import TrackOptions
from tracker.offline.track import track
from tracker.session.reader import SessionReader

TIPS = tuple(f"{digit}_tip" for digit in ("thumb", *FINGERS))
SETTLED = 2.0
"""s from the start of the session that are not compared."""


class TipErrors(NamedTuple):
    """For one fingertip at n instants at which it has a position: error (n,) m, standard deviation
    (n,) m per axis, and whether it is reported as measured (n,)."""

    error: Array
    sd: Array
    measured: NDArray[np.bool_]


def tips_of(
    session: Path, colours: str, with_cloth: bool, progress: Callable[[float], None]
) -> dict[str, TipErrors]:
    """Errors of each fingertip of a session that is tracked with this version's settings.

    Raises ConfigError for a session without a true hand, and FileError if it cannot be tracked.
    """
    with SessionReader(session) as reader:
        names, start = reader.info.keypoint_names, reader.anchor.monotonic(reader.span_ns[0])
        truth = {_instant(e): e for e in reader.truth(start + SETTLED)}
    if not truth:
        raise ConfigError(notice("evaluation.no_truth", file=session.name))
    with tempfile.TemporaryDirectory() as folder:
        settings, out = Path(folder) / "settings.toml", Path(folder) / "tracked.mcap"
        settings.write_text(f"[chain.cloth]\nfingers = {str(with_cloth).lower()}\n")
        options = TrackOptions(settings=str(settings), colours=colours)
        track(session, out, options, progress)
        with SessionReader(out) as reader:
            estimates = [e for e in reader.messages((Estimate,)) if isinstance(e, Estimate)]
    pairs = [(e, truth[_instant(e)]) for e in estimates if _instant(e) in truth]
    return errors_of(pairs, names)


def errors_of(
    pairs: Sequence[tuple[Estimate, Estimate]], names: Sequence[str]
) -> dict[str, TipErrors]:
    """Errors of the fingertips among the keypoints ``names``, for pairs of estimate and truth."""
    out = {}
    for tip in TIPS:
        if tip not in names or not pairs:
            continue
        k = list(names).index(tip)
        error = [np.linalg.norm(e.keypoints[k] - true.keypoints[k]) for e, true in pairs]
        sd = np.array([e.keypoint_sd[k] for e, _ in pairs])
        measured = np.array([e.keypoint_state[k] == Validity.MEASURED for e, _ in pairs])
        known = np.isfinite(error)
        out[tip] = TipErrors(np.array(error)[known], sd[known], measured[known])
    return out


def _instant(estimate: Estimate) -> int:
    return round(estimate.t * 1e6)
