"""A motion from a file, by what kind of file it is."""

from __future__ import annotations

from pathlib import Path

from tracker.base.errors import FileError
from tracker.base.toml_reader import read_text
from tracker.hand.model import HandModel
from tracker.messages import CameraPose
from tracker.simulation.recorded.bvh import read_bvh
from tracker.simulation.recorded.fit import fit_hand
from tracker.simulation.recorded.leap import read_leap
from tracker.simulation.recorded.qualisys import read_qualisys
from tracker.simulation.recorded.spline import SplineMotion, in_working_volume
from tracker.simulation.recorded.track import PointTrack, mirrored, resampled

RATE_HZ = 50.0
"""Of the fit; with a cut-off of 7 Hz more would add nothing."""


def load_motion(path: Path, hand: HandModel, camera: CameraPose | None = None) -> SplineMotion:
    """Recorded motion in the camera's working volume, for a hand of either side.

    Qualisys ``.tsv``, decoded Leap ``.npz`` or ``.bvh``. Raises FileError.
    """
    path = Path(path)
    track = resampled(mirrored(read_track(path), hand.side), RATE_HZ)
    fit = fit_hand(hand, track)
    return in_working_volume(hand, fit, track.up, track.t, camera)


def read_track(path: Path) -> PointTrack:
    """The recorded points of a file. Raises FileError."""
    kind = path.suffix.lower()
    if kind == ".npz":
        return read_leap(path).checked(str(path))
    if kind == ".tsv":
        return read_qualisys(path, read_text(path, 100_000_000)).checked(str(path))
    if kind == ".bvh":
        return read_bvh(path, read_text(path, 100_000_000)).checked(str(path))
    raise FileError(f"{path} is no motion that can be read: .tsv (Qualisys), .npz (Leap) or .bvh.")
