"""`import_reference` adds a laboratory's recording to a session as a reference."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

import numpy as np

from extensions.reference.formats.read import read_reference
from extensions.reference.mapping import LEAST, PointMapping, as_keypoints, read_mapping
from extensions.reference.recording import ReferenceRecording
from extensions.reference.registration import (
    Registration,
    register,
    register_offsets,
    with_inferred,
)
from extensions.reference.session import Described, at_instants, write_with_reference
from extensions.reference.timing import ReferenceTiming, by_clock, by_movement, by_pulse, refined
from tracker.base.clock import NS
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import check_target
from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.messages import Array, Event, Validity
from tracker.session.edits import Mask
from tracker.session.export.series import EstimateSeries, recorded_series
from tracker.session.motion import instants
from tracker.session.overview import WITHOUT_POSITION
from tracker.session.reader import SessionReader

REGISTRATIONS = ("offsets", "rigid", "none")
"""With marker offsets; rigid alone; none for a reference in the session's own frame."""
_REFINEMENTS = 5  # of the time alignment by the registered points, at most
_CONVERGED = 2e-7  # change of the drift
_READ, _FITTED = 0.4, 0.6  # shares of the progress
_FEW = 100  # instants with measured points; with fewer, inferred ones are used too


@dataclass(frozen=True)
class ReferenceImportOptions:
    """``mapping``: a file; ``by``: one of `timing.WAYS`; ``pulse``: names of the reference's events
    or of a channel, empty: all events; ``start``: wall clock of the reference's t = 0 (ISO 8601);
    ``register``: one of `REGISTRATIONS`."""

    mapping: Path | None = None
    by: str = "movement"
    pulse: str = ""
    start: str = ""
    side: str = ""
    with_drift: bool = True
    register: str = "offsets"


def import_reference(
    reference: Path, session: Path, out: Path, options: ReferenceImportOptions | None = None,
    force: bool = False, watch: Callable[[float], None] = lambda share: None,
) -> Described:  # fmt: skip
    """Write ``out``, the session with the reference of one hand. ``watch`` receives the share done.

    Raises FileError if a file is not readable or they do not match, ConfigError for options.
    """
    options = options or ReferenceImportOptions()
    check_target(out, force, [reference, session])
    mapping = PointMapping() if options.mapping is None else read_mapping(options.mapping)
    whole = read_reference(reference, mapping, options.pulse)
    watch(_READ / 2)
    with SessionReader(session, side=options.side) as reader:
        series = recorded_series(reader, segments=False)
        names = reader.info.keypoint_names
        recording = as_keypoints(whole, names, reader.info.side, mapping, reference)
        t = instants(reader, series)
        watch(_READ)
        timing = _timing(reader, series, t, recording, options)
        about = _Pairs.of(series, t, recording).described(timing, options, reference)
        watch(_FITTED)
        start = reader.anchor.monotonic(reader.span_ns[0])
        at = about.timing.session_time(recording.t)
        stamps = np.array([reader.anchor.wall(start + s) for s in at], np.int64)
        inside = (at >= t[0] - 1.0) & (at <= t[-1] + 1.0)
        points = about.rigid.world(recording.points)
        write_with_reference(reader, out, about, stamps[inside], points[inside], force,
                             lambda share: watch(_FITTED + (1 - _FITTED) * share))  # fmt: skip
    return about


def _timing(
    reader: SessionReader,
    series: EstimateSeries,
    t: Array,
    recording: ReferenceRecording,
    options: ReferenceImportOptions,
) -> ReferenceTiming:
    if options.by == "clock":
        found = by_clock(_start_ns(recording, options, reader.path), reader.span_ns[0])
    elif options.by == "pulse":
        start = reader.anchor.monotonic(reader.span_ns[0])
        events = [m for m in reader.messages((Event,)) if isinstance(m, Event)]
        ours = [e.t - start for e in events if e.kind == "pulse"]
        theirs = [p.t for p in recording.pulses if options.pulse in ("", p.name)]
        found = by_pulse(ours, theirs)
    else:
        columns = [series.keypoint_names.index(n) for n in recording.names]
        placeless = reader.info.engine == WITHOUT_POSITION
        points = series.keypoints[:, columns]
        found = by_movement(t, points, recording.t, recording.points, placeless, options.with_drift)
    at = found.session_time(recording.t)
    if at[-1] < t[0] or at[0] > t[-1]:
        raise FileError(notice("reference.no_overlap", session=reader.path))
    return found


def _start_ns(recording: ReferenceRecording, options: ReferenceImportOptions, session: Path) -> int:
    """For the reference's t = 0; a time without a zone is this computer's local time."""
    start = recording.start
    if options.start:
        try:
            start = datetime.fromisoformat(options.start)
        except ValueError as error:
            raise ConfigError(notice("reference.bad_start", text=options.start)) from error
    if start is None:
        raise FileError(notice("reference.no_clock", session=session))
    return round(start.timestamp() * 1e6) * (NS // 1_000_000)


@dataclass(frozen=True, eq=False)
class _Pairs:
    """The keypoints that both know: x_G (N, K, 3) m where they were measured and x_any where they
    were known, at t (N,) s, and the axes of their segments R_GB (N, K, 3, 3); ``missing``: the
    hand's other keypoints."""

    t: Array
    x_G: Array
    x_any: Array
    R_GB: Array
    recording: ReferenceRecording
    missing: tuple[str, ...]

    @classmethod
    def of(cls, series: EstimateSeries, t: Array, recording: ReferenceRecording) -> _Pairs:
        columns = [series.keypoint_names.index(n) for n in recording.names]
        state, points = series.state[:, columns], series.keypoints[:, columns]
        known = state != Validity.LOST
        used = state == Validity.MEASURED
        if (used.sum(axis=0) >= _FEW).sum() < LEAST:
            used = known
        x_G, x_any = (np.where(rows[:, :, None], points, np.nan) for rows in (used, known))
        missing = tuple(n for n in series.keypoint_names if n not in recording.names)
        R_GB = so3.matrix_from_quat(series.q[:, columns])
        return cls(t, x_G, x_any, R_GB, recording, missing)

    def described(
        self, timing: ReferenceTiming, options: ReferenceImportOptions, path: Path
    ) -> Described:
        """The registrations, with the time alignment that they refine."""
        how = options.register
        rigid, with_offsets = self.registered(timing, how, path)
        for _ in range(_REFINEMENTS if options.by == "movement" else 0):
            before = timing
            timing = self.refined(before, with_offsets, options.with_drift)
            rigid, with_offsets = self.registered(timing, how, path)
            if abs(timing.drift - before.drift) < _CONVERGED:
                break
        x_L = self.reference(timing)
        residuals = np.array([self.residuals(x_L, r) for r in (rigid, with_offsets)])
        covered = float(np.mean(np.isfinite(x_L).all(axis=2).sum(axis=1) > 0))
        of = self.recording
        return Described(path.name, of.kind, of.rate, of.names, timing, rigid, with_offsets,
                         residuals, covered, self.missing)  # fmt: skip

    def residuals(self, x_L: Array, registration: Registration) -> Array:
        """(K,) rms distances in m of registered points; of keypoints that are hardly measured, of
        the inferred ones; NaN where none is known."""
        x_G = np.where(self.hardly_measured[:, None], self.x_any, self.x_G)
        squared = ((registration.keypoints(x_L, self.R_GB) - x_G) ** 2).sum(axis=2)
        known = np.isfinite(squared)
        count = known.sum(axis=0)
        total = np.where(known, squared, 0.0).sum(axis=0)
        return np.asarray(np.sqrt(total / np.where(count > 0, count, np.nan)))

    def reference(self, timing: ReferenceTiming) -> Array:
        """(N, K, 3) m in the laboratory's frame."""
        at = timing.session_time(self.recording.t)
        return at_instants(at, self.recording.points, self.t)

    def registered(
        self, timing: ReferenceTiming, how: str, path: Path
    ) -> tuple[Registration, Registration]:
        """The rigid registration, and that with marker offsets."""
        x_L = self.reference(timing)
        if how == "none":
            unmoved = _unmoved(x_L, self.x_G)
            return unmoved, unmoved
        rigid = register(x_L, self.x_G, path.name)
        if how == "rigid":
            return rigid, rigid
        found = register_offsets(x_L, self.x_G, self.R_GB, rigid)
        return rigid, with_inferred(found, x_L, self.x_any, self.R_GB, self.hardly_measured)

    @property
    def hardly_measured(self) -> Mask:
        """(K,)"""
        return np.asarray(np.isfinite(self.x_G).all(axis=2).sum(axis=0) < _FEW)

    def refined(
        self, timing: ReferenceTiming, registration: Registration, with_drift: bool
    ) -> ReferenceTiming:
        theirs = registration.keypoints(self.reference(timing), self.R_GB)
        return refined(timing, self.t, self.x_G, theirs, with_drift)


def _unmoved(x_L: Array, x_G: Array) -> Registration:
    none = np.zeros((x_L.shape[1], 3))
    residual = float(np.sqrt(np.nanmean(((x_L - x_G) ** 2).sum(axis=2))))
    return Registration(np.eye(3), np.zeros(3), residual, 1.0, none, none)
