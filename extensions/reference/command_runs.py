"""The commands ``import-reference`` and ``accuracy``."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from extensions.reference.accuracy import (
    MULTIPLES,
    Bin,
    Measured,
    PointRow,
    ScalarRow,
    expected,
    headline,
    summary,
)
from extensions.reference.angles import MODEL
from extensions.reference.command import AccuracyArguments, ImportReferenceArguments
from extensions.reference.importing import ReferenceImportOptions, import_reference
from extensions.reference.remarks import remarks
from extensions.reference.report import write_report
from extensions.reference.statistics import Agreement, Icc
from tracker.base.terminal import check_json, finish
from tracker.session.overview import sessions_in


def import_reference_command(args: ImportReferenceArguments) -> int:
    """Write the session with its reference, and report alignment and registration."""
    files = [args.reference, args.session]
    check_json(args, files)
    options = ReferenceImportOptions(
        args.mapping,
        args.by,
        args.pulse,
        args.start,
        args.hand,
        not args.no_drift,
        args.register,
    )
    about = import_reference(args.reference, args.session, args.output, options, args.force)
    timing = about.timing
    lines = [f"{about.file}: {about.kind}, {len(about.keypoints)} keypoints, {about.rate:g} Hz."]
    line = f"Time: starts at {timing.offset:+.4f} s of the session, by {timing.by}"
    if timing.parts:
        line += f"; residual {1e3 * timing.residual:.2f} ms of {timing.parts} parts"
    if timing.drift_sd == timing.drift_sd:
        line += f"; drift {1e6 * timing.drift:+.1f} ± {1e6 * timing.drift_sd:.1f} ppm"
    lines.append(f"{line}.")
    lines.append(
        f"Registration: residual {1e3 * about.rigid.residual:.2f} mm rigid, "
        f"{1e3 * about.with_offsets.residual:.2f} mm with marker offsets."
    )
    lines += [str(remark) for remark in remarks(about, options.with_drift)]
    finish(args, about.as_json(), lines, [*files, args.output])
    return 0


def accuracy_command(args: AccuracyArguments) -> int:
    """Write the page, and print the line that can be quoted."""
    paths = [path for path, _ in sessions_in(args.sessions)]
    check_json(args, paths)
    measured = write_report(
        paths, args.output, not args.without_offsets, args.anonymous, args.force
    )
    finish(args, as_json(measured), [headline(measured)], [*paths, args.output])
    return 0


# ---- the results of an accuracy report as JSON: mm, degrees, m/s


def as_json(measured: Sequence[Measured]) -> dict[str, Any]:
    """``summary`` over people, and ``recordings``, a list."""
    return {
        "headline": headline(measured),
        "angle_model": MODEL,
        "summary": {
            f"{row.name} ({row.unit})": {
                "mean": row.pooled.mean,
                "ci95": list(row.pooled.ci),
                "sd_between_people": row.pooled.between,
                "sd_within_people": row.pooled.within,
                "people": row.pooled.people,
                "recordings": row.pooled.recordings,
            }
            for row in summary(measured)
        },
        "recordings": [_recording(m) for m in measured],
    }


def _recording(m: Measured) -> dict[str, Any]:
    about = m.pairs.about
    return {
        "name": m.pairs.name,
        "participant": m.pairs.person,
        "engine": m.pairs.engine,
        "version": m.pairs.version,
        "reference": about.file,
        "format": about.kind,
        "offset_ms": 1e3 * about.timing.offset,
        "drift_ppm": 1e6 * about.timing.drift,
        "time_residual_ms": 1e3 * about.timing.residual,
        "residual_rigid_mm": 1e3 * about.rigid.residual,
        "residual_with_offsets_mm": 1e3 * about.with_offsets.residual,
        "marker_offsets_mm": {
            name: [1e3 * v for v in row]
            for name, row in zip(about.keypoints, about.with_offsets.offsets.tolist(), strict=True)
        },
        "keypoints": {r.name: _point(r) for r in m.points},
        "angles": {r.name: _scalar(r) for r in m.scalars if r.is_angle},
        "apertures": {r.name: _scalar(r) for r in m.scalars if not r.is_angle},
        "by_speed": {b.name: _bin(b) for b in m.speeds},
        "by_state": {b.name: _bin(b) for b in m.states},
        "calibration": {
            f"{k:g}": {"share": share, "expected": float(e)}
            for k, share, e in zip(MULTIPLES, m.calibration, expected(), strict=True)
        },
        "nees_per_dof": m.nees,
        "worst": [
            {"t_s": w.t, "keypoint": w.keypoint, "error_mm": 1e3 * w.error, "state": w.state,
             "claimed_sd_mm": 1e3 * w.sd, "speed_m_s": w.speed}
            for w in m.worst
        ],
    }  # fmt: skip


def _point(r: PointRow) -> dict[str, Any]:
    return {
        "n": r.n,
        "n_effective": r.n_effective,
        "rmse_mm": 1e3 * r.rmse,
        "rmse_ci95_mm": [1e3 * v for v in r.rmse_ci],
        "rmse_without_offsets_mm": 1e3 * r.rmse_rigid,
        "p95_mm": 1e3 * r.p95,
        "axes_mm": {axis: _agreement(a, 1e3) for axis, a in zip("xyz", r.axes, strict=True)},
        "icc": _icc(r.icc),
    }


def _scalar(r: ScalarRow) -> dict[str, Any]:
    scale, unit = (float(np.rad2deg(1.0)), "deg") if r.is_angle else (1e3, "mm")
    return {f"rmse_{unit}": scale * r.rmse, **_agreement(r.agreement, scale), "icc": _icc(r.icc)}


def _agreement(a: Agreement, scale: float) -> dict[str, Any]:
    return {
        "bias": scale * a.bias,
        "bias_ci95": [scale * v for v in a.bias_ci],
        "sd": scale * a.sd,
        "limits": [scale * a.low, scale * a.high],
        "n_effective": a.n_effective,
    }


def _icc(i: Icc) -> dict[str, Any]:
    return {"value": i.value, "ci95": list(i.ci)}


def _bin(b: Bin) -> dict[str, float]:
    return {"share": b.share, "rmse_mm": 1e3 * b.rmse, "p95_mm": 1e3 * b.p95}
