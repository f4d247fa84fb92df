"""One hand of a session next to its reference, instant by instant."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from extensions.reference.angles import angles_of
from extensions.reference.session import Described, at_instants, read_imported
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.messages import Array, IntArray, Validity
from tracker.session.export.series import recorded_series
from tracker.session.motion import instants
from tracker.session.reader import SessionReader
from tracker.session.ros import topics

APERTURES = tuple(("thumb_tip", f"{f}_tip") for f in ("index", "middle", "ring", "little"))


@dataclass(frozen=True, eq=False)
class Quantity:
    """A scalar that both methods measure: ``ours`` and ``theirs`` (N,) in rad or m."""

    name: str
    is_angle: bool
    ours: Array
    theirs: Array


@dataclass(frozen=True, eq=False)
class Pairs:
    """N instants at t (N,) s of a session, K keypoints of ``names``: ``ours``, ``rigid`` and
    ``theirs`` (N, K, 3) m in G: the estimate, the reference registered rigidly, and that with
    marker offsets; NaN where either is unknown. ``R_GH`` (N, 3, 3) axes of the hand (the dorsum's).
    ``state``, ``sd`` (N, K), ``speed`` (N, K) m/s of the reference. ``path`` of the session;
    ``linked``: reports may name it."""

    name: str
    person: str
    side: str
    engine: str
    version: str
    simulated: bool
    about: Described
    t: Array
    names: tuple[str, ...]
    ours: Array
    rigid: Array
    theirs: Array
    R_GH: Array
    state: IntArray
    sd: Array
    speed: Array
    path: Path
    linked: bool = True

    def errors(self, offsets: bool = True) -> Array:
        """(N, K, 3) m in the hand's axes (x to the fingers, y to the left, z dorsal)."""
        e = self.ours - (self.theirs if offsets else self.rigid)
        return np.asarray(np.einsum("nji,nkj->nki", self.R_GH, e))

    def quantities(self, offsets: bool = True) -> list[Quantity]:
        """Joint angles and apertures of both."""
        reference = self.theirs if offsets else self.rigid
        both = np.isfinite(self.ours + reference)
        ours, theirs = (np.where(both, x, np.nan) for x in (self.ours, reference))
        a, b = (angles_of(self.names, x, self.side) for x in (ours, theirs))
        out = [Quantity(name, True, a[name], _nearest(b[name], a[name])) for name in a]
        for first, second in APERTURES:
            if {first, second} <= set(self.names):
                i, j = self.names.index(first), self.names.index(second)
                x, y = (np.linalg.norm(v[:, i] - v[:, j], axis=1) for v in (ours, theirs))
                out.append(Quantity(f"{first} - {second}", False, x, y))
        return out


def _nearest(angle: Array, to: Array) -> Array:
    """The same angles, by whole turns as near as possible to others."""
    return np.asarray(to + (angle - to + np.pi) % (2 * np.pi) - np.pi)


def read_pairs(path: Path) -> list[Pairs]:
    """For each hand of a session that has a reference. Raises FileError if none has."""
    with SessionReader(path) as reader:
        sides = reader.sides or ("",)
        imported = [
            s for s in sides if topics.reference_about(s or reader.info.side) in reader.attachments
        ]
    if not imported:
        raise FileError(notice("reference.none", session=path))
    return [_read(path, side) for side in imported]


def _read(path: Path, side: str) -> Pairs:
    with SessionReader(path, side=side) as reader:
        info, series, imported = reader.info, recorded_series(reader, False), read_imported(reader)
        t = instants(reader, series)
        start = reader.anchor.monotonic(reader.span_ns[0])
        at = np.array([reader.anchor.monotonic(int(s)) for s in imported.stamp_ns]) - start
    names = imported.about.keypoints
    columns = [series.keypoint_names.index(n) for n in names]
    state, sd = series.state[:, columns], series.sd[:, columns]
    ours = np.where((state == Validity.LOST)[:, :, None], np.nan, series.keypoints[:, columns])
    rigid = at_instants(at, imported.points, t)
    R_GB = so3.matrix_from_quat(series.q[:, columns])
    R_GH = so3.matrix_from_quat(series.q[:, series.keypoint_names.index("wrist")])
    theirs = imported.about.corrected(rigid, R_GB)
    return Pairs(
        f"{path.stem} {info.side}", info.participant, info.side, info.engine, info.version,
        info.simulated, imported.about, t, names, ours, rigid, theirs, R_GH, state, sd,
        _speeds(t, rigid), path,
    )  # fmt: skip


def _speeds(t: Array, points: Array) -> Array:
    """(N, K) m/s; NaN next to a hole."""
    rising = np.maximum.accumulate(t + np.arange(len(t)) * 1e-9)
    velocity = np.gradient(points, rising, axis=0)
    return np.asarray(np.linalg.norm(velocity, axis=2))


def anonymized(pairs: Sequence[Pairs]) -> list[Pairs]:
    """The same with numbers in place of the names of people, recordings and reference files."""
    people = list(dict.fromkeys(p.person for p in pairs if p.person))
    return [
        replace(
            p,
            name=f"recording {n} {p.side}",
            linked=False,
            person=f"person {people.index(p.person) + 1}" if p.person else "",
            about=replace(p.about, file="reference"),
        )
        for n, p in enumerate(pairs, 1)
    ]
