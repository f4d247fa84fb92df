"""The results of an accuracy report as JSON: mm, degrees, m/s."""

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
from extensions.reference.statistics import Agreement, Icc


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
